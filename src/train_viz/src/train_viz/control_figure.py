"""Adhesion control over place: creep, torque before and after the controller, and where it acts."""
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.adhesion import Adhesion, true_stretches
from train_viz.adhesion_figures import LINEAR_TO_PERCENT, draw_axles, finish_place_panels, mark_slip_limit, races
from train_viz.run import Run


def draw_adhesion_control(run: Run) -> Figure:
    """Creep, torque before and after the controller, and where it acts, over place."""
    wheels = run.adhesion
    heights = [3.0, 3.0] + ([0.5 + 0.2 * wheels.axles] if wheels.controller_active.any() else [])
    figure, panels = plt.subplots(len(heights), 1, figsize=(9.0, 1.0 + 1.1 * sum(heights)), sharex=True,
                                  gridspec_kw={'height_ratios': heights})
    _draw_creep(panels[0], run)
    _draw_torque(panels[1], wheels)
    if len(panels) > 2:
        _draw_active(panels[2], wheels)
    else:
        panels[1].set_title('no controller takes torque away', fontsize=11)
    finish_place_panels(figure, panels, run, 'Adhesion control')
    return figure


def _draw_creep(axes: Axes, run: Run) -> None:
    draw_axles(axes, run.adhesion, 100.0 * run.adhesion.creep)
    mark_slip_limit(axes, axes.axhline, run)
    axes.set_ylabel('creep [%]')
    if races(run.adhesion):
        axes.set_yscale('symlog', linthresh=LINEAR_TO_PERCENT)
        axes.yaxis.set_major_formatter('{x:g}')
        axes.set_ylabel(f'creep [%]\n(logarithmic beyond {LINEAR_TO_PERCENT:g} %)')


def _draw_active(axes: Axes, wheels: Adhesion) -> None:
    for axle in range(wheels.axles):
        axes.broken_barh(true_stretches(wheels.location_km, wheels.controller_active[:, axle]), (axle + 0.65, 0.7),
                         color=plot_style.axle_style(axle)['color'])
    axes.set_ylim(wheels.axles + 0.6, 0.4)  # the front axle on top
    axes.set_yticks(range(1, wheels.axles + 1))
    axes.grid(axis='y', visible=False)
    axes.set_ylabel('axle')
    axes.set_title('bars: the controller takes torque away', fontsize=11)


def _draw_torque(axes: Axes, wheels: Adhesion) -> None:
    """Applied to each axle; demanded in one line where all axles are asked for the same, otherwise one for each."""
    draw_axles(axes, wheels, wheels.torque_applied_N_m / 1e3, labels=False)
    if wheels.shoe_torque_N_m.any():
        axes.plot(wheels.location_km, wheels.shoe_torque_N_m.mean(axis=1) / 1e3, color='0.45', linestyle='-.', linewidth=1.6,
                  label='torque of shoes')
    axes.set_ylabel('torque on the wheelset [kN m]')
    demand = wheels.torque_demanded_N_m / 1e3
    if np.ptp(demand, axis=1).max() <= 1e-6 * np.abs(demand).max():
        axes.plot(wheels.location_km, demand[:, 0], color='black', linestyle=':', linewidth=1.8,
                  label='torque demanded')
    else:
        for axle in range(wheels.axles):
            axes.plot(wheels.location_km, demand[:, axle], ':', label=f'demanded, axle {axle + 1}',
                      **plot_style.axle_style(axle))
