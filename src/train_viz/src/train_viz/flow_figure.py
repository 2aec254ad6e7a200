"""The energy account of the whole train as a flow picture, from the motors to where the energy ends; widths are energies."""
from typing import List, Tuple

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import sankey
from train_viz.account_figure import BRAKED, BRAKE_RAIL, SINKS, SOURCES
from train_viz.energy_stages import final_MJ
from train_viz.run import Run
from train_viz.sankey import Flow, Outlet

BEFORE_RAIL = SOURCES[1:]  # what leaves between rim and rail
RIM_COLOUR = SOURCES[0][2]
SPIN = f'given back: {BRAKED[-1][1]}'  # goes to the brakes without passing the rail
FOUR_LINES = 0.24  # of the whole height, chosen: four lines of text and their edges
X_SOURCES, X_RAIL, X_BRAKES, X_SINKS = 0.0, 0.42, 0.74, 1.0


def draw_energy_flow(run: Run) -> Figure:
    """What a term gives back (a negative one) comes in from the left, beside the motors."""
    sources, losses, sinks, braked = flows_of(run)
    figure, axes = plt.subplots(figsize=(11.0, 6.4 + 0.4 * max(len(losses + sinks + braked) - 8, 0)))
    total = max(sum(flow[2] for flow in flows) for flows in (sources, losses + sinks)) or 1.0
    spin = sum(flow[2] for flow in sources if flow[0] == SPIN)
    lost = sum(flow[2] for flow in losses)
    rail_in = sum(flow[2] for flow in sources) - lost - spin
    rail_low = total - lost - rail_in  # level with the motors, so that the losses pass above
    sankey.node(axes, X_RAIL, rail_low, rail_in, RIM_COLOUR)
    brakes_low = _draw_sinks(axes, (losses, sinks, braked), (rail_low + rail_in, spin), total)
    low = _draw_sources(axes, sources, losses, (rail_low + rail_in, brakes_low), total)
    _name_rail(axes, _rail_words(rail_in, final_MJ(run)['traction_rail']), (rail_low, low), total)
    axes.set_xlim(-0.38, 1.5)
    axes.axis('off')
    axes.set_title(f'Energy flow of the whole train, {run.label}', pad=14)
    axes.text(0.5, -0.02, f'at the end: {run.location_km[-1]:.3f} km, {run.time_s[-1]:.1f} s, {run.end_kmph:.2f} '
              f'km/h;   residual {sankey.signed_number(1e6 * final_MJ(run)["residual"])} J', transform=axes.transAxes, ha='center', va='top')
    return figure


def _rail_words(all_MJ: float, traction_MJ: float) -> List[str]:
    """Lines: what passes the rail, and the traction's part where something else gives, too."""
    words = ['at the rail', f'{sankey.number(all_MJ)} MJ']
    if traction_MJ <= sankey.DRAWN_FROM * all_MJ or abs(all_MJ - traction_MJ) < 1e-3 * all_MJ:
        return words
    return words + ['of it traction', f'{sankey.number(traction_MJ)} MJ']


def _name_rail(axes: Axes, words: List[str], lows: Tuple[float, float], total: float) -> None:
    """Below the node, where no ribbon is: neither of the sources on the left nor of what leaves to the right.

    @param lows lower edge of the rail, and of the lowest ribbon to the left of it
    """
    top = min(lows) - 0.5 * sankey.GAP * total
    axes.text(X_RAIL + sankey.NODE_WIDTH, top, '\n'.join(words), ha='right', va='top', fontsize=12, zorder=4)
    axes.set_ylim(bottom=min(axes.get_ylim()[0], top - sankey.LINE * len(words) * total))


def flows_of(run: Run) -> Tuple[List[Flow], List[Flow], List[Flow], List[Flow]]:
    """Sources, what leaves between rim and rail, where the rest ends, and what the locomotives' brakes turn theirs into.

    All positive; sources = losses + sinks but for the residual, and the last of the sinks, if there is a fourth list, is its
    sum. Wheels that slow down in braking give back their spin: it goes to the brakes as a source does.
    """
    final = final_MJ(run)
    sources, losses, sinks, braked = [], [], [], []
    for (name, words, colour), end in [(('traction_rim', 'motors, at the rim', RIM_COLOUR), sources)] + [
            (term, losses) for term in BEFORE_RAIL] + [(term, sinks) for term in SINKS] + [
            (BRAKE_RAIL, sinks)] + [(term, braked) for term in BRAKED]:
        value = final[name]
        if value > 0.0:
            end.append((words, colour, value))
        elif value < 0.0 and end is sources:
            sinks.append(('motors, braking at the rim', colour, -value))
        elif value < 0.0:
            sources.append((f'given back: {words}', colour, -value))
    return _closed(*sankey.drawn(sources, losses, sinks, braked))


def _closed(sources: List[Flow], losses: List[Flow], sinks: List[Flow], braked: List[Flow]) -> Tuple:
    """The brakes' band is as wide as what they turn it into, with what the wheels' spin adds to it."""
    if not braked:
        return sources, losses, sinks, braked
    _, words, colour = BRAKE_RAIL
    rest = [flow for flow in sinks if flow[0] != words]
    return sources, losses, rest + [(words, colour, sum(flow[2] for flow in braked))], braked


def _draw_sources(axes: Axes, sources: List[Flow], losses: List[Flow], ends: Tuple[float, float], total: float) -> float:
    """Top down; what the losses take leaves from the top of the first source.

    @param ends upper edge of the rail, lower edge of the brakes
    @return lower edge of the lowest ribbon where the rail's name stands
    """
    lost = sum(flow[2] for flow in losses)
    top, (rail_top, brakes_low), lowest = total, ends, total
    for i, (words, colour, energy) in enumerate(sources):
        sankey.node(axes, X_SOURCES, top - energy, energy, colour)
        sankey.label(axes, X_SOURCES - 0.03, top - energy / 2.0, words, energy, 'right')
        to_rail = energy - (lost if i == 0 else 0.0)
        if words == SPIN:
            sankey.band(axes, (X_SOURCES, top - energy), (X_BRAKES, brakes_low), energy, colour)
            lowest = min(lowest, top - energy, brakes_low)
        else:
            sankey.band(axes, (X_SOURCES, top - energy), (X_RAIL, rail_top - to_rail), to_rail, colour)
            rail_top -= to_rail
            lowest = min(lowest, 0.5 * (rail_top + top - energy))  # more than it has risen where the name begins
        top -= max(energy, sankey.SLOT * total) + sankey.GAP * total
    return lowest


def _draw_sinks(axes: Axes, flows: Tuple[List[Flow], List[Flow], List[Flow]], at_rail: Tuple[float, float],
                total: float) -> float:
    """Losses on top, straight from the first source; then what the rail gives, top down; last the locomotives' brakes, which
    have a node of their own.

    @param at_rail upper edge of the rail, what reaches the brakes beside it
    @return lower edge of the brakes
    """
    losses, sinks, braked = flows
    ends = losses + (sinks[:-1] if braked else sinks) + braked
    lows, bottom, top = sankey.place_sinks(ends, total)
    motors, rail, brakes, brakes_low = Outlet(X_SOURCES, total), Outlet(X_RAIL, at_rail[0]), None, 0.0
    for i, (flow, low) in enumerate(zip(ends, lows)):
        if i == len(ends) - len(braked):
            brakes, brakes_low = _draw_brakes(axes, sinks[-1], rail, low + flow[2], (at_rail[1], total))
            bottom = min(bottom, brakes_low - 3.0 * sankey.LINE * total * (sinks[-1][2] < FOUR_LINES * total))
        outlet = motors if i < len(losses) else brakes or rail
        sankey.draw_sink(axes, flow, outlet.take(flow[2]), (X_SINKS, low))
    axes.set_ylim(min(bottom, 0.0), top + sankey.GAP * total)
    return brakes_low


def _draw_brakes(axes: Axes, flow: Flow, rail: Outlet, top: float, sizes: Tuple[float, float]) -> Tuple[Outlet, float]:
    """The node of the locomotives' brakes, as high as the first of its sinks; its number, on a wide band and else below the
    node, is what they take at the rail.

    @param sizes what the wheels' spin gives, the whole picture's energy
    """
    _, colour, energy = flow
    spin, total = sizes
    low, taken = top - energy, energy - spin
    sankey.band(axes, rail.take(taken), (X_BRAKES, top - taken), taken, colour)
    sankey.node(axes, X_BRAKES, low, energy, colour)
    number = f'{sankey.number(taken)} MJ'
    if energy > FOUR_LINES * total:
        axes.text(X_BRAKES - 0.02, top - taken / 2.0, f"locomotives'\nbrakes,\nat the rail\n{number}", ha='right',
                  va='center', fontsize=12, zorder=4)
    else:
        axes.text(X_BRAKES + sankey.NODE_WIDTH, low - 0.01 * total, f"locomotives'\nbrakes, at the\nrail {number}", ha='right',
                  va='top', fontsize=12, zorder=4)
    return Outlet(X_BRAKES, top), low
