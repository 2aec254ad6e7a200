"""What all figures share: backend, colours, curve shading, saving."""
import math
import os
import textwrap
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

import matplotlib
import numpy as np

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

from train_viz.resolved_scenario import read_axle_reach, read_curves, read_rail_sections  # noqa: E402
from train_viz.run import Run  # noqa: E402

# Okabe and Ito (2008): distinguishable with every common colour blindness. Yellow is left out, too pale for a line.
BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY = '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9'
LINE_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, '#000000')
CURVE_COLOUR = '0.55'
SECTION_COLOUR = SKY
PNG_DPI = 160

plt.rcParams.update({
    'figure.constrained_layout.use': True,
    'font.size': 12,
    'axes.titlesize': 13,
    'axes.grid': True,
    'axes.axisbelow': True,
    'axes.spines.top': False,
    'axes.spines.right': False,
    'grid.color': '0.9',
    'legend.frameon': False,
    'legend.fontsize': 11,
    'savefig.bbox': 'tight',  # takes legends outside the frame in
    'svg.hashsalt': 'train_viz',  # the same bag gives the same SVG
})


def line_style(i: int) -> Dict[str, Any]:
    """Of the i-th run: thinner from run to run, so that a line shows under the next where they coincide."""
    return {'color': LINE_COLOURS[i % len(LINE_COLOURS)], 'linewidth': max(1.2, 2.6 - 0.6 * i)}


def axle_style(axle: int) -> Dict[str, Any]:
    """Of an axle, from 0 at the front: thinner towards the rear, so that a line shows under the next where they coincide."""
    return {'color': LINE_COLOURS[axle % len(LINE_COLOURS)], 'linewidth': max(1.0, 2.4 - 0.25 * axle)}


def start_at_zero(axes: Axes) -> None:
    low, high = axes.get_ylim()
    axes.set_ylim(0.0 if low > -0.1 * high else low, high)


def save(figure: Figure, directory: str, name: str) -> List[str]:
    """Writes NAME.png and NAME.svg, closes the figure and returns the paths."""
    paths = [os.path.join(directory, f'{name}.{suffix}') for suffix in ('png', 'svg')]
    figure.savefig(paths[0], dpi=PNG_DPI)
    figure.savefig(paths[1], dpi=PNG_DPI, metadata={'Date': None})  # of the parts that are images
    plt.close(figure)
    return paths


def legend_below(figure: Figure, panels: Union[Axes, Iterable[Axes]], note: str = '',
                 marker_scale: float = 1.0) -> None:
    """The legend of one or several axes under the whole figure, where it cannot hide a curve; in columns if its labels are
    short."""
    found = [axes.get_legend_handles_labels() for axes in np.ravel(panels)]
    handles, labels = (sum(lists, []) for lists in zip(*found))
    columns = max(1, min(4, 90 // (8 + max(len(label) for label in labels))))  # 90 characters fill a figure
    figure.legend(handles, labels, loc='upper center', bbox_to_anchor=(0.5, 0.0), ncol=columns, title=note or None,
                  markerscale=marker_scale)


def legend_above(axes: Axes, columns: int, names_pt: float) -> None:
    """The legend of one of several panels, between it and what is above, where it cannot hide a curve.

    @param names_pt height of the names of track curves, as `shade_curves` says
    """
    axes.legend(loc='lower left', bbox_to_anchor=(0.0, 1.0), ncol=columns, fontsize=10,
                borderaxespad=0.3 + names_pt / 10.0)  # in font sizes


def sides_near(limit: float, low: float, high: float) -> List[float]:
    """Signs of the sides of zero on which values from low to high come near a limit: beyond half of it (chosen)."""
    return [sign for sign, reached in ((1.0, high), (-1.0, -low)) if reached > 0.5 * limit]


def mark_limit(axes: Axes, line: Callable, limit: float, sides: List[float], words: str) -> None:
    """A line on each of these sides, which the axis then holds; of a limit far from all values the legend tells the number.

    @param line  axes.axhline or axes.axvline
    @param words for the legend, {sign} stands before the number
    """
    for i, side in enumerate(sides):
        sign = '\u00b1' if len(sides) > 1 else '-' if side < 0.0 else ''
        line(side * limit, label=words.format(sign=sign) if i == 0 else None, color='black', linestyle='--', linewidth=1.2)
    if not sides:
        axes.plot([], [], linestyle='none', label=words.format(sign='') + ', beyond the axis')


def whole_ticks(count: int) -> List[int]:
    """Of an axis that counts couplers or vehicles from 1: the first, the last, round numbers between."""
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 1000) if count <= 8 * s)
    return sorted({1, count} | set(range(step, count - step // 4, step)))


def align_zeros(left: Axes, right: Axes) -> None:
    """One zero for both scales of a panel; values of the right one are >= 0, so its numbers begin there."""
    low, high = left.get_ylim()
    low, high = min(low, 0.0), max(high, 0.0)
    top = right.get_ylim()[1]
    left.set_ylim(low, high)
    right.set_ylim(low / high * top, top)
    right.set_yticks([tick for tick in right.get_yticks() if 0.0 <= tick <= top])


def wrapped(label: str, width: int) -> str:
    """Breaks a label into lines, after underscores if there are any."""
    return '\n'.join(textwrap.wrap(label.replace('_', '_ '), width)).replace('_ ', '_')


def place_range_km(runs: List[Run]) -> Tuple[float, float]:
    """From the first to the last place of any run, widened to whole 10 m unless less than 1 m is beyond; never empty."""
    first = math.floor(100.0 * min(run.location_km.min() for run in runs) + 0.1) / 100.0
    last = math.ceil(100.0 * max(run.location_km.max() for run in runs) - 0.1) / 100.0
    return first, max(last, first + 0.01)


def set_place_axis(axes: Axes, runs: List[Run]) -> None:
    axes.set_xlim(*place_range_km(runs))
    axes.xaxis.set_major_locator(plt.MaxNLocator(nbins=7, steps=(1, 2, 3, 5, 10)))
    axes.set_xlabel('place of the leading locomotive [km]' + axles_note(runs, place_range_km(runs)))


def axles_note(runs: List[Run], range_km: Tuple[float, float]) -> str:
    """Why wheels feel other rail before and after the place of their locomotive; empty if no run has both."""
    reaches = [read_axle_reach(run.resolved, run.adhesion.locomotive) for run in runs if run.adhesion is not None and any(
        start < 1e3 * range_km[1] and end > 1e3 * range_km[0] for start, end, _ in read_rail_sections(run.resolved))]
    if not reaches:
        return ''
    far = f'up to {max(reaches):.1f} m earlier or later' if all(reaches) else 'the front ones earlier, the rear ones later'
    return f"\n(of its middle; its axles meet the hatched rail at their own places, {far})"


def shade_curves(axes: Axes, runs: List[Run], labels: bool = True,
                 range_km: Optional[Tuple[float, float]] = None) -> float:
    """Shades the curves of all runs' tracks, transitions paler; their names above the frame, upright where they would touch. And,
    hatched with the name at the bottom, stretches of other rail.

    @param range_km of the place axis; none: that of the leading locomotives
    @return height of the names above the frame [points], 0 if there are none
    """
    first, last = range_km or place_range_km(runs)
    _shade_sections(axes, runs, labels, (first, last))
    names = []
    for curve in sorted({curve for run in runs for curve in read_curves(run.resolved)}, key=lambda c: c.start_m):
        start, end = max(curve.start_m / 1000.0, first), min(curve.end_m / 1000.0, last)
        if start >= end:
            continue
        axes.axvspan(start, end, color=CURVE_COLOUR, alpha=0.14, linewidth=0, zorder=0)
        axes.axvspan(max(curve.full_from_m / 1000.0, first), min(curve.full_to_m / 1000.0, last),
                     color=CURVE_COLOUR, alpha=0.22, linewidth=0, zorder=0)
        names.append(((start + end) / 2.0, curve.label))
    return _name_curves(axes, names, last - first) if labels and names else 0.0


def _name_curves(axes: Axes, names: List[Tuple[float, str]], span_km: float) -> float:
    """@param names place [km] and name, rising
    @return height [points]"""
    places = [place for place, _ in names]
    upright = min(np.diff(places), default=span_km) < 0.06 * span_km  # 0.06: 'R1200' at this font size
    free_from = places[0]
    for place, name in names:
        if place >= free_from:
            axes.annotate(name, (place, 1.0), xycoords=('data', 'axes fraction'), xytext=(0, 3), textcoords='offset points',
                          ha='center', va='bottom', color='0.35', fontsize=10 if upright else 11, rotation=90 if upright else 0)
            free_from = place + (0.02 if upright else 0.06) * span_km  # 0.02: a line of this font size
    return 3.0 + 6.5 * max(len(name) for _, name in names) if upright else 15.0


def title_pad(names_pt: float) -> float:
    """Of a title over the names of curves, as high as `shade_curves` says."""
    return 7.0 + max(names_pt, 15.0)


def _shade_sections(axes: Axes, runs: List[Run], labels: bool, range_km: Tuple[float, float]) -> None:
    first, last = range_km
    sections = sorted({section for run in runs for section in read_rail_sections(run.resolved)})
    free_from = first
    for start, end, name in sections:
        start, end = max(start / 1000.0, first), min(end / 1000.0, last)
        if start >= end:
            continue
        axes.axvspan(start, end, facecolor=SECTION_COLOUR, alpha=0.22, linewidth=0, zorder=0)
        axes.axvspan(start, end, facecolor='none', edgecolor=SECTION_COLOUR, hatch='//', alpha=0.5, linewidth=0, zorder=0)
        if labels and (start + end) / 2.0 >= free_from:
            axes.annotate(name, ((start + end) / 2.0, 0.0), xycoords=('data', 'axes fraction'), xytext=(0, 4),
                          textcoords='offset points', ha='center', va='bottom', color='0.2', fontsize=11, zorder=7,
                          bbox={'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.8, 'pad': 1.0})
            free_from = (start + end) / 2.0 + 0.012 * len(name) * (last - first)  # 0.012: a letter at this font size


def curve_ends_m(runs: List[Run]) -> List[float]:
    """Where curves end within the runs' common stretch [m]."""
    first = max(run.location_m.min() for run in runs)
    last = min(run.location_m.max() for run in runs)
    ends = {curve.end_m for run in runs for curve in read_curves(run.resolved)}
    return sorted(end for end in ends if first < end < last)
