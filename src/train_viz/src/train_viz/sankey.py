"""Pieces of a flow picture: nodes, bands whose widths are energies, and the column of sinks on the right."""
from typing import List, Tuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path

Flow = Tuple[str, str, float]  # words, colour, energy [MJ] > 0

NODE_WIDTH = 0.025
SLOT = 0.07         # of the whole height: the least room for a line of text, chosen
LINE = 0.045        # of the whole height: a line of several of text, chosen
GAP = 0.02          # of the whole height, chosen
DRAWN_FROM = 3e-5   # of the largest flow, chosen: a fiftieth of a pixel; the account has its number


class Outlet:
    """The right side of a node, from which bands leave top down."""

    def __init__(self, x: float, top: float):
        self._x, self._top = x, top

    def take(self, energy: float) -> Tuple[float, float]:
        """Where the next band starts: the node's left edge and the band's lower edge."""
        self._top -= energy
        return self._x, self._top


def place_sinks(flows: List[Flow], total: float) -> Tuple[List[float], float, float]:
    """Lower edges of the sinks, top down, each with room for a line; then bottom and top of the column."""
    top = first = total + sum(max(SLOT * total - flow[2], 0.0) + GAP * total for flow in flows) / 2.0
    lows = []
    for _, _, energy in flows:
        slot = max(energy, SLOT * total)
        lows.append(top - slot / 2.0 - energy / 2.0)
        top -= slot + GAP * total
    return lows, top, first


def draw_sink(axes: Axes, flow: Flow, start: Tuple[float, float], end: Tuple[float, float]) -> None:
    words, colour, energy = flow
    band(axes, start, end, energy, colour)
    node(axes, *end, energy, colour)
    label(axes, end[0] + NODE_WIDTH + 0.02, end[1] + energy / 2.0, words, energy, 'left')


def drawn(*lists: List[Flow]) -> Tuple[List[Flow], ...]:
    """The lists without flows too thin to be any."""
    least = DRAWN_FROM * max([flow[2] for flows in lists for flow in flows], default=0.0)
    return tuple([flow for flow in flows if flow[2] > least] for flows in lists)


def label(axes: Axes, x: float, y: float, words: str, energy: float, side: str) -> None:
    axes.text(x, y, f'{words}{": " if side == "left" else chr(10)}{number(energy)} MJ', ha=side, va='center', fontsize=12)


def number(energy: float) -> str:
    return f'{energy:.1f}' if abs(energy) >= 10.0 else f'{round(energy, 6) + 0.0:.3g}'  # to 1 J: less is round-off


def signed_number(value: float) -> str:
    """With three digits, and never as a power of ten where it is 1000 or more."""
    return f'{value:+.0f}' if abs(value) >= 1000.0 else f'{value:+.3g}'


def node(axes: Axes, x: float, low: float, height: float, colour: str) -> None:
    axes.add_patch(Rectangle((x, low), NODE_WIDTH, height, facecolor=colour, edgecolor='none', zorder=3))


def band(axes: Axes, start: Tuple[float, float], end: Tuple[float, float], width: float, colour: str) -> None:
    """A band of constant height; `start` and `end` are the nodes' left edge and the band's lower edge there."""
    x0, x1, (y0, y1) = start[0] + NODE_WIDTH, end[0], (start[1], end[1])
    middle = (x0 + x1) / 2.0
    lower = [(x0, y0), (middle, y0), (middle, y1), (x1, y1)]
    upper = [(x, y + width) for x, y in reversed(lower)]
    codes = [Path.MOVETO] + 3 * [Path.CURVE4] + [Path.LINETO] + 3 * [Path.CURVE4] + [Path.CLOSEPOLY]
    path = Path(np.array(lower + upper + [lower[0]]), codes)
    axes.add_patch(PathPatch(path, facecolor=colour, alpha=0.45, edgecolor=colour, linewidth=0.6, zorder=2))
