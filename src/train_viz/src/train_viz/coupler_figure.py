"""In-train forces as a map over time and coupler."""
from typing import Optional, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.coupler_peaks import read_coupler_peaks
from train_viz.run import Run

COLUMNS = 1600  # of the map, chosen: about one a pixel of the PNG


def draw_coupler_forces(run: Run) -> Optional[Figure]:
    """Coupler forces of one run, draft red and buff blue; None for a train without couplers."""
    couplers = run.coupler_force_N.shape[1]
    if couplers == 0:
        return None
    edges_s, force_kN = bin_extremes(run.time_s, run.coupler_force_N / 1e3)
    limit = max(np.max(np.abs(force_kN)), 1.0)
    figure, axes = plt.subplots(figsize=(9.5, 6.0))
    image = axes.pcolormesh(edges_s, np.arange(couplers + 1) + 0.5, force_kN.T, cmap='RdBu_r', vmin=-limit, vmax=limit,
                            rasterized=True)
    bar = figure.colorbar(image, ax=axes, pad=0.02)
    bar.set_label('coupler force [kN]   buff < 0 < draft')
    axes.grid(False)
    axes.set_ylim(couplers + 0.5, 0.5)  # the head of the train on top
    axes.set_yticks(plot_style.whole_ticks(couplers))
    axes.set_ylabel('coupler, counted from the head')
    axes.set_xlabel('time since the start of the run [s]')
    axes.set_title(f'In-train forces, {run.label}\n{_largest_words(run)}', pad=10)
    _add_places(axes, run)
    return figure


def _largest_words(run: Run) -> str:
    """Of every step, if the run's folder has couplers.csv; a bag has only its samples, between which a shock may be higher."""
    peaks = read_coupler_peaks(run)
    if peaks is None:
        draft, buff = max(run.coupler_force_N.max(), 0.0), max(-run.coupler_force_N.min(), 0.0)
        return f'largest of the recorded samples: draft {draft / 1e3:.0f} kN, buff {buff / 1e3:.0f} kN'
    return 'largest of every step: ' + ', '.join(
        f'{words} {values.max() / 1e3:.0f} kN' + f' (coupler {int(values.argmax()) + 1})' * bool(values.any())
        for words, values in (('draft', peaks.draft_N), ('buff', peaks.buff_N)))


def bin_extremes(time_s: np.ndarray, values: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """At most COLUMNS bins of rows with the value farthest from zero in each, so that no recorded peak is lost.

    @return edges of the bins, one more than bins, and [bin, column]
    """
    starts = np.unique(np.linspace(0, len(time_s), min(COLUMNS, len(time_s)), endpoint=False).astype(int))
    high, low = np.maximum.reduceat(values, starts), np.minimum.reduceat(values, starts)
    return np.append(time_s[starts], time_s[-1] + (time_s[-1] - time_s[-2])), np.where(high >= -low, high, low)


def _add_places(axes: Axes, run: Run) -> None:
    """A second time axis on top, marked where the leading locomotive passes round places."""
    first, last = run.location_km[0], run.location_km[-1]
    if last - first < 0.05:
        return  # too short for round places
    places = [p for p in plt.MaxNLocator(8).tick_values(first, last) if first <= p <= last]
    times = [run.at_location(run.time_s, 1000.0 * place) for place in places]
    top = axes.secondary_xaxis('top')
    kept = []
    for place, when in zip(places, times):
        if not kept or when - kept[-1][1] > 0.07 * run.time_s[-1]:  # room for its number
            kept.append((place, when))
    top.set_xticks([when for _, when in kept])
    digits = max(len(f'{place:.6g}'.partition('.')[2]) for place, _ in kept)
    top.set_xticklabels([f'{place:.{digits}f}' for place, _ in kept])
    top.set_xlabel('place of the leading locomotive [km]')
