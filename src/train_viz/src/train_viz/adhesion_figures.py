"""What the wheels of a locomotive do on the rail: adhesion over creep, axle loads, friction over place."""
from typing import Callable, List, Optional, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.adhesion import Adhesion
from train_viz.creep_curve import CreepCurve, creep_curves, speeds_of
from train_viz.resolved_scenario import read_slip_limit
from train_viz.run import Run

RACING = 1.0  # creep [-], chosen: beyond it a linear axis hides the part that the wheels should stay in
LINEAR_TO_PERCENT = 10.0  # chosen: holds every usual slip limit
CURVE_LINES = ('-', (0, (6, 2)), (0, (2, 1.5)))  # of the creep curves, from the first speed on


def draw_adhesion_creep(run: Run) -> Figure:
    """Adhesion used over creep, a panel for each axle, and the friction that the rail offers; as Fig. 3.

    Behind the points of the 2D model stands its contact's curve at some speeds; in 3D the ellipses move with the wheelsets.
    """
    wheels = run.adhesion
    limits = [side * (read_slip_limit(run.resolved) or 0.0) for side in slip_limit_sides(run)]
    low, high = min(wheels.creep.min(), *limits, 0.0), max(wheels.creep.max(), *limits, 0.0)
    behind = creep_curves(run, speeds_of(run), min(1.08 * max(high, -low if wheels.brakes else 0.0, 1e-3), RACING))
    columns = min(3, wheels.axles)
    rows = -(-wheels.axles // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(3.2 + 3.0 * columns, 1.6 + 2.7 * rows), sharex=True, sharey=True,
                                  squeeze=False)
    for axle, axes in enumerate(panels.flat):
        if axle >= wheels.axles:
            axes.set_visible(False)
            continue
        draw_creep_curves(axes, behind, mirrored=wheels.brakes)
        points = _draw_axle(axes, wheels, axle)
        mark_slip_limit(axes, axes.axvline, run)
        axes.set_title(f'axle {axle + 1}', fontsize=11)
        axes.xaxis.set_tick_params(labelbottom=axle + columns >= wheels.axles)
    panels[0, 0].set_xlim(100.0 * min(1.08 * low, -0.02 * min(high, 0.1)), 100.0 * max(1.08 * high, 1e-3))
    if races(wheels):
        panels[0, 0].set_xscale('symlog', linthresh=LINEAR_TO_PERCENT)
        panels[0, 0].xaxis.set_major_formatter('{x:g}')
    plot_style.start_at_zero(panels[0, 0])
    bar = figure.colorbar(points, ax=panels, pad=0.02)
    bar.set_label('speed [km/h]')
    scale = f'   (logarithmic beyond {LINEAR_TO_PERCENT:g} %)' if races(wheels) else ''
    figure.supxlabel(f'creep [%]{scale}', fontsize=12)
    figure.supylabel('coefficient of adhesion or friction [-]', fontsize=12)
    figure.suptitle(f'Adhesion over creep, {whose(run)}')
    plot_style.legend_below(figure, panels[0, 0], marker_scale=2.0)
    return figure


def _draw_axle(axes: Axes, wheels: Adhesion, axle: int):
    """Points as an image, also in the SVG: there are tens of thousands of them."""
    creep = 100.0 * wheels.creep[:, axle]
    style = {'c': wheels.speed_kmph, 'cmap': 'viridis', 'linewidths': 0.0, 'rasterized': True}
    offered = wheels.friction[:, axle]
    if wheels.brakes:
        offered = np.where(creep < 0.0, -offered, offered)
    axes.scatter(creep, offered, s=2.0, label='thin: friction offered at the slip', **style)
    return axes.scatter(creep, wheels.adhesion[:, axle], s=11.0, label='thick: adhesion used', **style)


def draw_creep_curves(axes: Axes, curves: List[CreepCurve], colour: str = '0.25', mirrored: bool = False) -> None:
    """@param mirrored also to the left of zero, for braking"""
    for curve, dashes in zip(curves, CURVE_LINES):
        for sign in (1.0, -1.0)[:2 if mirrored else 1]:
            axes.plot(sign * 100.0 * curve.creep, sign * curve.adhesion, linestyle=dashes, color=colour, linewidth=1.3,
                      zorder=3, label=curve.label if sign > 0.0 else None)


def races(wheels: Adhesion) -> bool:
    return bool(np.abs(wheels.creep).max() > RACING)


def mark_slip_limit(axes: Axes, line: Callable, run: Run) -> None:
    """@param line axes.axhline or axes.axvline"""
    limit = read_slip_limit(run.resolved)
    if limit is not None:
        plot_style.mark_limit(axes, line, 100.0 * limit, slip_limit_sides(run), f'slip limit {{sign}}{100.0 * limit:g} %')


def slip_limit_sides(run: Run) -> List[float]:
    """Of zero, where creep comes near the limit; none without a limit."""
    limit = read_slip_limit(run.resolved)
    return [] if limit is None else plot_style.sides_near(limit, run.adhesion.creep.min(), run.adhesion.creep.max())


def draw_axle_loads(run: Run) -> Figure:
    """Normal force of each axle, and what its slip costs by time and by distance, over place."""
    wheels = run.adhesion
    figure, panels = plt.subplots(3, 1, figsize=(9.0, 9.0), sharex=True)
    for axes, values, words in ((panels[0], wheels.normal_force_N / 1e3, 'axle load [kN]'),
                                (panels[1], wheels.frictional_power_W / 1e3, 'frictional power [kW]'),
                                (panels[2], wheels.t_gamma_N / 1e3, 'T-gamma [kN = kJ/m]')):
        draw_axles(axes, wheels, values, labels=axes is panels[0])
        axes.set_ylabel(words)
    for axes in panels[1:]:
        plot_style.start_at_zero(axes)
    finish_place_panels(figure, panels, run, 'Axle loads and slip losses')
    return figure


def draw_axles(axes: Axes, wheels: Adhesion, values: np.ndarray, labels: bool = True) -> None:
    for axle in range(wheels.axles):
        axes.plot(wheels.location_km, values[:, axle], label=f'axle {axle + 1}' if labels else None,
                  **plot_style.axle_style(axle))


def finish_place_panels(figure: Figure, panels: np.ndarray, run: Run, title: str) -> None:
    for axes in panels:
        plot_style.shade_curves(axes, [run], axes is panels[0], place_range_km([run]))
    set_place_axis(panels[-1], [run])
    figure.suptitle(f'{title}, {whose(run)}')
    figure.align_ylabels(panels)
    plot_style.legend_below(figure, panels)


def draw_friction_adhesion(runs: List[Run]) -> Optional[Figure]:
    """Static friction, friction at the slip and adhesion used over place; as Fig. 7. None for runs without wheels."""
    shown = [(i, run) for i, run in enumerate(runs) if run.adhesion is not None]
    if not shown:
        return None
    with_wheels = [run for _, run in shown]
    colours = [plot_style.line_style(i)['color'] for i, _ in shown]  # of a run in the other figures, too
    figure, axes = plt.subplots(figsize=(9.0, 5.6))
    names_pt = plot_style.shade_curves(axes, with_wheels, range_km=place_range_km(with_wheels))
    for run, colour in zip(with_wheels, colours):
        _draw_friction_of(axes, run, colour)
    plot_style.start_at_zero(axes)
    _add_friction_keys(axes, with_wheels, colours)
    title = f'Friction and adhesion, {_which(with_wheels)}' + (f', {with_wheels[0].label}' if len(shown) == 1 else '')
    axes.set_title(title, pad=plot_style.title_pad(names_pt))
    axes.set_ylabel('coefficient of friction or adhesion [-]')
    set_place_axis(axes, with_wheels)
    absent = [run.label for run in runs if run.adhesion is None]
    note = f'Not shown, no adhesion topic in the bag (1D has none): {", ".join(absent)}' if absent else ''
    plot_style.legend_below(figure, axes, plot_style.wrapped(note, 90))
    return figure


# Means over the axles: field of Adhesion, words, line
FRICTION_LINES = (
    ('static_friction', 'static friction', {'linestyle': '--', 'linewidth': 1.5}),
    ('friction', 'friction offered at the slip', {'linestyle': '-.', 'linewidth': 1.5}),
    ('adhesion', 'adhesion used, mean of the axles', {'linestyle': '-', 'linewidth': 2.0}),
)
RANGE_STYLE = {'alpha': 0.25, 'linewidth': 0}


def _draw_friction_of(axes: Axes, run: Run, colour: str) -> None:
    wheels = run.adhesion
    axes.fill_between(wheels.location_km, wheels.adhesion.min(axis=1), wheels.adhesion.max(axis=1), color=colour,
                      **RANGE_STYLE)
    for name, _, style in FRICTION_LINES:
        mean = getattr(wheels, name).mean(axis=1)
        axes.plot(wheels.location_km, mean, color=colour, **style)
        if name != 'adhesion' and wheels.brakes:  # what braking may use
            axes.plot(wheels.location_km, np.where(wheels.adhesion.mean(axis=1) < 0.0, -mean, np.nan), color=colour, **style)


def _add_friction_keys(axes: Axes, runs: List[Run], colours: List[str]) -> None:
    """The legend says once what the lines mean, and of several runs which colour is whose."""
    if len(runs) > 1:
        for run, colour in zip(runs, colours):
            axes.plot([], [], color=colour, linewidth=2.0, label=run.label)
    grey_or_own = colours[0] if len(runs) == 1 else '0.3'
    for _, words, style in FRICTION_LINES:
        axes.plot([], [], color=grey_or_own, label=words, **style)
    axes.fill_between([], [], [], color=grey_or_own, label='its range over the axles', **RANGE_STYLE)


def place_range_km(runs: List[Run]) -> Tuple[float, float]:
    """Of the locomotives shown: that of the other figures for the leading one, a locomotive's own if it is behind."""
    ranges = [plot_style.place_range_km([run]) if run.adhesion.locomotive == 1 else
              (float(run.adhesion.location_km.min()), float(run.adhesion.location_km.max())) for run in runs]
    return min(first for first, _ in ranges), max(last for _, last in ranges)


def set_place_axis(axes: Axes, runs: List[Run]) -> None:
    plot_style.set_place_axis(axes, runs)
    if any(run.adhesion.locomotive != 1 for run in runs):
        axes.set_xlim(*place_range_km(runs))
        axes.set_xlabel(f'place of {_which(runs)} [km]' + plot_style.axles_note(runs, place_range_km(runs)))


def whose(run: Run) -> str:
    return f'{run.label}, {_which([run])}'


def _which(runs: List[Run]) -> str:
    numbers = sorted({run.adhesion.locomotive for run in runs})
    return 'the leading locomotive' if numbers == [1] else f'locomotive {" or ".join(str(n) for n in numbers)}'
