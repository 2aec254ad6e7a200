"""A trip over place: speed below the line's limit, what the driver does, and the line itself."""
from typing import List, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.line_profile import curvature_profile, height_profile
from train_viz.run import Run

PASCALS_PER_BAR = 1e5
FLATTEST_M = 2.0  # chosen: a line that rises less keeps this scale, lest round-off look like hills


def draw_trip(run: Run) -> Figure:
    """Of one run; panels only for what it has: pipe pressure needs an air brake, heights a track that we understand."""
    panels = [(3.0, _draw_speed), (1.8, _draw_notches)]
    if run.has_air_brake():
        panels.append((1.6, _draw_pressures))
    panels.append((2.0, _draw_line))
    heights = [height for height, _ in panels]
    figure, axes = plt.subplots(len(panels), 1, figsize=(10.0, 1.2 + 1.15 * sum(heights)), sharex=True,
                                gridspec_kw={'height_ratios': heights})
    for i, (panel, (_, draw)) in enumerate(zip(axes, panels)):
        plot_style.shade_curves(panel, [run], labels=i == 0)
        draw(panel, run)
    plot_style.set_place_axis(axes[-1], [run])
    figure.suptitle(f'Trip, {run.label}')
    figure.align_ylabels(axes)
    return figure


def _draw_speed(axes: Axes, run: Run) -> None:
    known = run.speed_limit_mps > 0.0  # a run's first row has none: nobody has looked yet
    axes.step(run.location_km[known], 3.6 * run.speed_limit_mps[known], where='post', color=plot_style.VERMILION, linewidth=1.4,
              label='lowest speed limit under the train')
    axes.plot(run.location_km, run.speed_kmph, color=plot_style.BLUE, linewidth=2.0, label='speed')
    first, last = plot_style.place_range_km([run])
    for place, seconds in stops(run):
        share = (place / 1e3 - first) / (last - first)
        axes.annotate(f'stands {seconds:.0f} s', (place / 1e3, 0.0), xytext=(0, 12), textcoords='offset points',
                      ha='left' if share < 0.05 else 'right' if share > 0.95 else 'center',
                      fontsize=10, arrowprops={'arrowstyle': '-', 'color': '0.5'})
    axes.set_ylim(0.0, 1.12 * 3.6 * max(run.speed_mps.max(), run.speed_limit_mps.max(), 1.0))
    axes.set_ylabel('speed [km/h]')
    axes.legend(loc='best', ncol=2, fontsize=10)


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
    axes.legend(loc='center left', bbox_to_anchor=(1.0, 0.5), fontsize=10)


def _draw_line(axes: Axes, run: Run) -> None:
    """Height to the left, curvature to the right."""
    first, last = (1e3 * km for km in plot_style.place_range_km([run]))
    axes.set_ylabel('height [m]')
    profile = height_profile(run.resolved, first, last)
    if profile is not None:
        place, height = profile
        low, high = height.min(), height.max()
        spare = max(FLATTEST_M - (high - low), 0.2 * (high - low)) / 2.0
        axes.fill_between(place / 1e3, low - 2.0 * spare, height, color='0.75', linewidth=0)
        axes.plot(place / 1e3, height, color='0.3', linewidth=1.5)
        axes.set_ylim(low - 2.0 * spare, high + spare)
    place, curvature = curvature_profile(run.resolved, first, last)
    if np.any(curvature):
        right = axes.twinx()
        right.plot(place / 1e3, 1e3 * curvature, color=plot_style.PURPLE, linewidth=1.3)
        reach = 1.25e3 * np.abs(curvature).max()
        right.set_ylim(-reach, reach)
        right.grid(False)
        right.spines['right'].set_visible(True)
        right.set_ylabel('curvature [1/km]\n+ left', color=plot_style.PURPLE)
