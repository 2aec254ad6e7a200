"""A trip over place: speed below the line's limit, what the driver does, and the line itself."""
from typing import Dict, List, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.line_profile import curvature_profile, height_profile
from train_viz.run import Run

PASCALS_PER_BAR = 1e5
FLATTEST_M = 2.0  # chosen: a line that rises less keeps this scale, lest it look like hills
LEVEL_M = 0.01    # chosen: less is level
FAR_LIMIT = 1.3   # chosen: a constant speed limit this many times above the speed would squeeze it
CURVATURE_COLOUR = '#A5437C'  # plot_style.PURPLE, darker: it is text, too


def draw_trip(run: Run) -> Figure:
    """Of one run; panels only for what it has: notches where any is set, pipe pressure with an air brake, the line unless it is
    level and straight or not understood."""
    panels = [(3.0, _draw_speed)]
    if run.notch[:, run.locomotive - 1].any() or run.brake_notch[:, run.locomotive - 1].any():
        panels.append((1.8, _draw_notches))
    if run.has_air_brake():
        panels.append((1.6, _draw_pressures))
    profiles = _line_profiles(run)
    if profiles:
        panels.append((2.0, lambda axes, _: _draw_line(axes, profiles)))
    heights = [height for height, _ in panels]
    figure, axes = plt.subplots(len(panels), 1, figsize=(10.0, 1.6 + 1.15 * sum(heights)), sharex=True, squeeze=False,
                                gridspec_kw={'height_ratios': heights})
    for i, (panel, (_, draw)) in enumerate(zip(axes[:, 0], panels)):
        names_pt = plot_style.shade_curves(panel, [run], labels=i == 0)
        draw(panel, run)
        if panel.get_legend_handles_labels()[0]:
            plot_style.legend_above(panel, 4, names_pt)
    plot_style.set_place_axis(axes[-1, 0], [run])
    understood = height_profile(run.resolved, 0.0, 1.0) is not None
    figure.suptitle(f'Trip, {run.label}' + ': the line is level and straight' * (understood and not profiles))
    figure.align_ylabels(axes)
    return figure


def _draw_speed(axes: Axes, run: Run) -> None:
    axes.plot(run.location_km, run.speed_kmph, color=plot_style.BLUE, linewidth=2.0, label='speed')
    top = max(3.6 * run.speed_mps.max(), 3.6)
    known = run.speed_limit_mps > 0.0  # bags of before format 4 have none in the first row
    limits = 3.6 * run.speed_limit_mps[known]
    if len(limits) and np.ptp(limits) == 0.0 and limits[0] > FAR_LIMIT * top:
        axes.plot([], [], linestyle='none', label=f'speed limit {limits[0]:g} km/h all the way, beyond the axis')
    elif len(limits):
        axes.step(run.location_km[known], limits, where='post', color=plot_style.VERMILION, linewidth=1.4,
                  label='lowest speed limit under the train')
        top = max(top, limits.max())
    first, last = plot_style.place_range_km([run])
    for place, seconds in stops(run):
        share = (place / 1e3 - first) / (last - first)
        side, shift = ('left', (28, 5)) if share < 0.05 else ('right', (-12, 12)) if share > 0.95 else ('center', (0, 12))
        axes.annotate(f'stands {seconds:.0f} s', (place / 1e3, 0.0), xytext=shift, textcoords='offset points',
                      ha=side, fontsize=10, arrowprops={'arrowstyle': '-', 'color': '0.5'}, zorder=6)
    axes.set_ylim(0.0, 1.12 * top)
    axes.set_ylabel('speed [km/h]')


def stops(run: Run) -> List[Tuple[float, float]]:
    """Where the train stands for 5 s (chosen) or longer, and how long [m, s]."""
    standing = np.abs(run.speed_mps) < 0.05  # m/s, chosen
    edges = np.flatnonzero(np.diff(np.concatenate(([False], standing, [False])).astype(int)))
    found = [(run.location_m[first], run.time_s[last - 1] - run.time_s[first]) for first, last in zip(edges[0::2], edges[1::2])]
    return [(float(place), float(seconds)) for place, seconds in found if seconds >= 5.0]


def _draw_notches(axes: Axes, run: Run) -> None:
    """Traction upwards, the dynamic brake downwards."""
    shown = run.locomotive - 1
    _fill_steps(axes, run.location_km, run.notch[:, shown], plot_style.GREEN)
    if run.brake_notch[:, shown].any():
        _fill_steps(axes, run.location_km, -run.brake_notch[:, shown], plot_style.VERMILION)
    low, high = min(-run.brake_notch[:, shown].max(), 0.0), max(run.notch[:, shown].max(), 1.0)
    axes.set_ylim(low - 0.5, high + 0.5)
    axes.yaxis.set_major_locator(plt.MaxNLocator(integer=True))
    axes.yaxis.set_major_formatter(lambda value, _: f'{abs(value):g}')
    axes.axhline(0.0, color='0.3', linewidth=0.8)
    axes.set_ylabel('brake | notch' if low < 0.0 else 'notch')


def _fill_steps(axes: Axes, place: np.ndarray, values: np.ndarray, colour: str) -> None:
    turns = np.unique(np.concatenate(([0], np.flatnonzero(np.diff(values)) + 1, [len(values) - 1])))
    place, values = place[turns], values[turns]  # an area is not thinned on its way to the SVG
    axes.fill_between(place, 0.0, values, step='post', color=colour, alpha=0.35, linewidth=0)
    axes.step(place, values, where='post', color=colour, linewidth=1.2)


def _draw_pressures(axes: Axes, run: Run) -> None:
    """At both ends of the train, of cylinders that are filled at all: the maps over vehicle and time show those in between."""
    filled = np.flatnonzero(run.cylinder_pressure_Pa.any(axis=0))
    ends = (filled[0], filled[-1]) if len(filled) else (0, -1)
    for pressure, words, colour, vehicles in ((run.pipe_pressure_Pa, 'pipe', plot_style.BLUE, (0, -1)),
                                              (run.cylinder_pressure_Pa, 'cylinder', plot_style.ORANGE, ends)):
        for vehicle, dashes in zip(vehicles, ('-', '--')):
            axes.plot(run.location_km, pressure[:, vehicle] / PASCALS_PER_BAR, dashes, color=colour, linewidth=1.5,
                      label=f'{words}, vehicle {range(pressure.shape[1])[vehicle] + 1}')
    axes.set_ylim(bottom=-0.1)
    axes.set_ylabel('pressure [bar]')


Profile = Tuple[np.ndarray, np.ndarray]  # places [m], heights [m] or curvatures [1/m]


def _line_profiles(run: Run) -> Dict[str, Profile]:
    """Height and curvature under the leading locomotive, each only if it is understood and changes."""
    first, last = (1e3 * km for km in plot_style.place_range_km([run]))
    height, curvature = height_profile(run.resolved, first, last), curvature_profile(run.resolved, first, last)
    profiles = {}
    if height is not None and np.ptp(height[1]) > LEVEL_M:
        profiles['height'] = height
    if np.any(curvature[1]):
        profiles['curvature'] = curvature
    return profiles


def _draw_line(axes: Axes, profiles: Dict[str, Profile]) -> None:
    """Height to the left, curvature to the right, or to the left where the line is level."""
    if 'height' in profiles:
        place, height = profiles['height']
        low, high = height.min(), height.max()
        spare = max(FLATTEST_M - (high - low), 0.2 * (high - low)) / 2.0
        axes.fill_between(place / 1e3, low - 2.0 * spare, height, color='0.75', linewidth=0)
        axes.plot(place / 1e3, height, color='0.3', linewidth=1.5)
        axes.set_ylim(low - 2.0 * spare, high + spare)
        axes.set_ylabel('height [m]')
    if 'curvature' not in profiles:
        return
    beside = 'height' in profiles
    right = axes.twinx() if beside else axes
    place, curvature = profiles['curvature']
    right.plot(place / 1e3, 1e3 * curvature, color=CURVATURE_COLOUR, linewidth=1.5)
    low, high = 1e3 * min(curvature.min(), 0.0), 1e3 * max(curvature.max(), 0.0)
    reach = 1.25 * max(-low, high)
    right.set_ylim(*(-reach, reach) if beside else (low - 0.1 * (high - low), high + 0.15 * (high - low)))
    right.set_ylabel('curvature [1/km]\n+ left', color=CURVATURE_COLOUR if beside else 'black')
    if beside:
        right.grid(False)
        right.spines['right'].set_visible(True)
