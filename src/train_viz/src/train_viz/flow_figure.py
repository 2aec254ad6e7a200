"""The energy account of the whole train as a flow picture, from the motors to where the energy ends; widths are energies."""
from typing import List, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path

from train_viz.account_figure import SINKS, SOURCES, final_MJ
from train_viz.run import Run

Flow = Tuple[str, str, float]  # words, colour, energy [MJ] > 0

BEFORE_RAIL = SOURCES[1:]  # what leaves between rim and rail
RIM_COLOUR = SOURCES[0][2]
X_SOURCES, X_RAIL, X_SINKS, NODE_WIDTH = 0.0, 0.42, 1.0, 0.025
SLOT = 0.07         # of the whole height: the least room for a line of text, chosen
DRAWN_FROM = 1e-6   # of the largest flow, chosen: less is a zero of the account (a level line's potential)


def draw_energy_flow(run: Run) -> Figure:
    """What a term gives back (a negative one) comes in from the left, beside the motors."""
    sources, losses, sinks = flows_of(run)
    figure, axes = plt.subplots(figsize=(11.0, 6.4))
    total = max(sum(flow[2] for flow in flows) for flows in (sources, losses + sinks)) or 1.0
    rail_MJ = final_MJ(run)['traction_rail']
    rail_in = sum(flow[2] for flow in sources) - sum(flow[2] for flow in losses)
    rail_low = (total - rail_in) / 2.0
    _node(axes, X_RAIL, rail_low, rail_in, RIM_COLOUR)
    axes.text(X_RAIL - 0.02, rail_low + rail_in / 2.0, f'at the rail\n{_number(rail_MJ)} MJ', ha='right', va='center',
              fontsize=12, zorder=4)
    _draw_sources(axes, sources, losses, rail_low, total)
    _draw_sinks(axes, sinks, losses, (rail_low, rail_in), total)
    axes.set_xlim(-0.38, 1.5)
    axes.axis('off')
    axes.set_title(f'Energy flow of the whole train, {run.label}', pad=14)
    axes.text(0.5, -0.02, f'at the end: {run.location_km[-1]:.3f} km, {run.time_s[-1]:.1f} s, {run.speed_kmph[-1]:.2f} '
              f'km/h;   residual {1e6 * final_MJ(run)["residual"]:+.3g} J', transform=axes.transAxes, ha='center', va='top')
    return figure


def flows_of(run: Run) -> Tuple[List[Flow], List[Flow], List[Flow]]:
    """Sources, what leaves between rim and rail, and where the rest ends; all positive, balanced but for the residual."""
    final = final_MJ(run)
    sources, losses, sinks = [], [], []
    for (name, words, colour), end in [(('traction_rim', 'motors, at the rim', RIM_COLOUR), sources)] + [
            (term, losses) for term in BEFORE_RAIL] + [(term, sinks) for term in SINKS]:
        value = final[name]
        if value > 0.0:
            end.append((words, colour, value))
        elif value < 0.0 and end is sources:
            sinks.append(('motors, braking at the rim', colour, -value))
        elif value < 0.0:
            sources.append((f'given back: {words}', colour, -value))
    least = DRAWN_FROM * max([flow[2] for flow in sources + losses + sinks], default=0.0)
    return tuple([flow for flow in flows if flow[2] > least] for flows in (sources, losses, sinks))


def _draw_sources(axes: Axes, sources: List[Flow], losses: List[Flow], rail_low: float, total: float) -> None:
    """Top down; what the losses take leaves from the top of the first source."""
    lost = sum(flow[2] for flow in losses)
    top, rail_top = total, rail_low + sum(flow[2] for flow in sources) - lost
    for i, (words, colour, energy) in enumerate(sources):
        _node(axes, X_SOURCES, top - energy, energy, colour)
        to_rail = energy - (lost if i == 0 else 0.0)
        _band(axes, (X_SOURCES, top - energy), (X_RAIL, rail_top - to_rail), to_rail, colour)
        _label(axes, X_SOURCES - 0.03, top - energy / 2.0, words, energy, 'right')
        top -= max(energy, SLOT * total) + 0.02 * total
        rail_top -= to_rail


def _draw_sinks(axes: Axes, sinks: List[Flow], losses: List[Flow], rail: Tuple[float, float], total: float) -> None:
    """Losses on top, straight from the first source; then what the rail gives, top down."""
    rail_low, rail_in = rail
    out_top, rail_top = total, rail_low + rail_in
    extra = sum(max(SLOT * total - flow[2], 0.0) + 0.02 * total for flow in losses + sinks)
    top = total + extra / 2.0
    for i, (words, colour, energy) in enumerate(losses + sinks):
        slot = max(energy, SLOT * total)
        low = top - slot / 2.0 - energy / 2.0
        if i < len(losses):
            _band(axes, (X_SOURCES, out_top - energy), (X_SINKS, low), energy, colour)
            out_top -= energy
        else:
            _band(axes, (X_RAIL, rail_top - energy), (X_SINKS, low), energy, colour)
            rail_top -= energy
        _node(axes, X_SINKS, low, energy, colour)
        _label(axes, X_SINKS + NODE_WIDTH + 0.02, low + energy / 2.0, words, energy, 'left')
        top -= slot + 0.02 * total
    axes.set_ylim(min(top, 0.0), total + extra / 2.0 + 0.02 * total)


def _label(axes: Axes, x: float, y: float, words: str, energy: float, side: str) -> None:
    axes.text(x, y, f'{words}{": " if side == "left" else chr(10)}{_number(energy)} MJ', ha=side, va='center', fontsize=12)


def _number(energy: float) -> str:
    return f'{energy:.1f}' if abs(energy) >= 10.0 else f'{energy:.3g}'


def _node(axes: Axes, x: float, low: float, height: float, colour: str) -> None:
    axes.add_patch(Rectangle((x, low), NODE_WIDTH, height, facecolor=colour, edgecolor='none', zorder=3))


def _band(axes: Axes, start: Tuple[float, float], end: Tuple[float, float], width: float, colour: str) -> None:
    """A band of constant height; `start` and `end` are the nodes' left edge and the band's lower edge there."""
    x0, x1, (y0, y1) = start[0] + NODE_WIDTH, end[0], (start[1], end[1])
    middle = (x0 + x1) / 2.0
    lower = [(x0, y0), (middle, y0), (middle, y1), (x1, y1)]
    upper = [(x, y + width) for x, y in reversed(lower)]
    codes = [Path.MOVETO] + 3 * [Path.CURVE4] + [Path.LINETO] + 3 * [Path.CURVE4] + [Path.CLOSEPOLY]
    path = Path(np.array(lower + upper + [lower[0]]), codes)
    axes.add_patch(PathPatch(path, facecolor=colour, alpha=0.45, edgecolor=colour, linewidth=0.6, zorder=2))
