"""Lateral displacement of each wheelset over place, of the model 3d."""
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.adhesion_figures import whose
from train_viz.run import Run

LEAST_AXIS_M = 1e-3  # chosen, a seventh of the way to the flange: less is round-off of a straight line, not a motion


def draw_wheelset_displacement(run: Run) -> Figure:
    """Against the middle of the track as designed, every wheelset at its own place; a panel a bogie where there are two."""
    wheels, sets = run.adhesion, run.adhesion.wheelsets
    range_km = sets.location_m.min() / 1e3, sets.location_m.max() / 1e3  # the first wheelset is 9 m ahead of the middle
    half = wheels.axles // 2 if wheels.axles >= 4 and wheels.axles % 2 == 0 else wheels.axles
    bogies = [range(first, first + half) for first in range(0, wheels.axles, half)]
    figure, panels = plt.subplots(len(bogies), 1, figsize=(9.0, 1.6 + 3.1 * len(bogies)), sharex=True, sharey=True,
                                  squeeze=False)
    for axes, axles in zip(panels[:, 0], bogies):
        plot_style.shade_curves(axes, [run], axes is panels[0, 0], range_km)
        axes.axhline(0.0, color='0.3', linewidth=0.8)
        for axle in axles:
            axes.plot(sets.location_m[:, axle] / 1e3, 1e3 * sets.lateral_m[:, axle], label=f'wheelset {axle + 1}',
                      **plot_style.axle_style(axle))
        axes.set_ylabel('to the left [mm]')
    if np.abs(sets.lateral_m).max() < LEAST_AXIS_M:
        panels[0, 0].set_ylim(-1e3 * LEAST_AXIS_M, 1e3 * LEAST_AXIS_M)
    plot_style.set_place_axis(panels[-1, 0], [run])
    panels[-1, 0].set_xlim(*range_km)
    panels[-1, 0].set_xlabel(f'place of each wheelset of {"the leading locomotive" if wheels.locomotive == 1 else whose(run)} [km]')
    figure.suptitle(f'Lateral displacement of the wheelsets, {whose(run)}')
    plot_style.legend_below(figure, panels[:, 0], 'From the middle of the track as designed; to the right < 0. A row every '
                            f'{sets.time_s[1] - sets.time_s[0]:g} s.' if len(sets.time_s) > 1 else '')
    return figure
