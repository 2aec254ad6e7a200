"""From fuel, storage or line to the wheel rims: the stages before the account of the train, as a flow picture."""
from typing import Dict, List, Optional, Tuple

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style, sankey
from train_viz.energy_stages import supplied, supply_MJ
from train_viz.run import Run
from train_viz.sankey import Flow, Outlet

ENGINE_COLOUR, LINK_COLOUR, RIM_COLOUR, LOST = '0.25', plot_style.BLUE, '0.35', '0.70'
RECOVERED_COLOUR = '#1B7837'  # as in the account
X_SOURCES, X_SHAFT, X_LINK, X_SINKS = 0.0, 0.28, 0.56, 1.0

# What enters the link beside the engine's, and what leaves it: (term of supply_MJ, words, colour)
ENTERS = (
    ('line_drawn', 'drawn from the line', plot_style.PURPLE),
    ('storage_out', 'out of the storage, at the link', plot_style.SKY),
    ('recovered_rim', 'recovered, at the rim', RECOVERED_COLOUR),
    ('unserved', 'unserved', plot_style.VERMILION),
)
LEAVES = (
    ('energy_rim', 'motors, at the rim', RIM_COLOUR),
    ('drivetrain', 'drivetrain loss, both ways', LOST),
    ('auxiliaries', 'auxiliaries, at the link', plot_style.ORANGE),
    ('storage_in', 'into the storage, at the link', plot_style.SKY),
    ('to_resistors', 'resistors, at the link', plot_style.VERMILION),
    ('line_returned', 'returned to the line', plot_style.PURPLE),
    ('line_loss', 'line loss', LOST),
)


def draw_energy_supply(run: Run) -> Optional[Figure]:
    """Of all locomotives with a supply together; None if none has one."""
    supply = supply_MJ(run)
    if supply is None:
        return None
    engine_losses, sources, sinks = supply_flows(supply)
    if not sources:
        return None
    figure, axes = plt.subplots(figsize=(11.5, 6.4 + 0.4 * max(len(engine_losses + sinks) - 8, 0)))
    total = sum(flow[2] for flow in sources)
    _draw(axes, supply, (engine_losses, sources, sinks), total)
    axes.set_xlim(-0.42, 1.5)
    axes.axis('off')
    axes.set_title(f'Energy supply, from its sources to the rim: {_which(run)}, {run.label}', pad=14)
    axes.text(0.5, -0.02, _foot(supply), transform=axes.transAxes, ha='center', va='top')
    return figure


def supply_flows(supply: Dict[str, float]) -> Tuple[List[Flow], List[Flow], List[Flow]]:
    """What the engine and the generator lose, all sources (the fuel first), and what leaves the link; balanced."""
    supply = dict(supply, drivetrain=supply['motored_loss'] + supply['recovered_loss'])
    losses = [('engine, lost', LOST, supply['engine_loss']), ('generator, lost', LOST, supply['generator_loss'])]
    sources = [('fuel', ENGINE_COLOUR, supply['fuel'])] + [(words, colour, supply[name]) for name, words, colour in ENTERS]
    return sankey.drawn(losses, sources, [(words, colour, supply[name]) for name, words, colour in LEAVES])


def _draw(axes: Axes, supply: Dict[str, float], flows: Tuple[List[Flow], List[Flow], List[Flow]], total: float) -> None:
    losses, sources, sinks = flows
    link_in = total - sum(flow[2] for flow in losses)
    lows, link_top, (bottom, top) = _place(supply, flows, total)
    sankey.node(axes, X_LINK, link_top - link_in, link_in, LINK_COLOUR)
    axes.text(X_LINK, link_top - link_in - 0.5 * sankey.GAP * total, f'link\n{sankey.number(link_in)} MJ', ha='center', va='top',
              fontsize=12)
    entry, left = Outlet(X_LINK, link_top), Outlet(X_SOURCES, total)
    y = total
    for flow in sources:
        words, colour, energy = flow
        sankey.node(axes, X_SOURCES, y - energy, energy, colour)
        sankey.label(axes, X_SOURCES - 0.03, y - energy / 2.0, words, energy, 'right')
        if flow[0] == 'fuel':
            _draw_shaft(axes, supply, (left, entry), list(zip(losses, lows)), y - energy)
        else:
            sankey.band(axes, (X_SOURCES, y - energy), entry.take(energy), energy, colour)
        y -= max(energy, sankey.SLOT * total) + sankey.GAP * total
    outlet = Outlet(X_LINK, link_top)
    for flow, low in zip(sinks, lows[len(losses):]):
        sankey.draw_sink(axes, flow, outlet.take(flow[2]), (X_SINKS, low))
    axes.set_ylim(min(bottom, y, link_top - link_in - 4.0 * sankey.GAP * total), top + sankey.GAP * total)


def _place(supply: Dict[str, float], flows: Tuple[List[Flow], List[Flow], List[Flow]],
           total: float) -> Tuple[List[float], float, Tuple[float, float]]:
    """Where the sinks stand, the losses first, and the link's upper edge; bottom and top of the sinks.

    With a shaft the link's upper edge is below the shaft's, so that the generator's loss passes over the link, and what comes
    from other sources below the shaft.
    """
    losses, sources, sinks = flows
    lows, bottom, top = sankey.place_sinks(losses + sinks, total)
    link_top = lows[len(losses)] + sinks[0][2] if sinks else total
    if sources[0][0] != 'fuel':
        return lows, link_top, (bottom, top)
    lower = min(total - supply['engine_loss'] - supply['generator_loss'] - sankey.GAP * total - link_top, 0.0)
    return lows[:len(losses)] + [low + lower for low in lows[len(losses):]], link_top + lower, (bottom + lower, top)


def _draw_shaft(axes: Axes, supply: Dict[str, float], ends: Tuple[Outlet, Outlet], losses: List[Tuple[Flow, float]],
                low: float) -> None:
    """Fuel to shaft to link; the engine loses before the shaft, the generator after it."""
    left, entry = ends
    shaft, height = supply['shaft'], low + supply['shaft']
    after = Outlet(X_SHAFT, height)
    for flow, end in losses:
        start = left if flow[0].startswith('engine') else after
        sankey.draw_sink(axes, flow, start.take(flow[2]), (X_SINKS, end))
    sankey.band(axes, (X_SOURCES, low), (X_SHAFT, low), shaft, ENGINE_COLOUR)
    sankey.node(axes, X_SHAFT, low, shaft, ENGINE_COLOUR)
    axes.text(X_SHAFT - 0.02, low + shaft / 2.0, f'shaft\n{sankey.number(shaft)} MJ', ha='right', va='center', fontsize=12,
              zorder=4)
    sankey.band(axes, after.take(supply['generator']), entry.take(supply['generator']), supply['generator'], ENGINE_COLOUR)


def _which(run: Run) -> str:
    numbers = supplied(run)
    if len(numbers) == run.traction_N.shape[1]:
        return 'all locomotives' if len(numbers) > 1 else 'the locomotive'
    return 'locomotives ' + ', '.join(map(str, numbers)) if len(numbers) > 1 else f'locomotive {numbers[0]}'


def _foot(supply: Dict[str, float]) -> str:
    words = [f'{supply["litres"]:.1f} l of fuel'] * (supply['litres'] > 0.0)
    if supply['storage_in'] + supply['storage_out'] > 0.0:
        words.append(f'stored: {sankey.signed_number(supply["stored_change"])} MJ since the start, lost in the storage: '
                     f'{sankey.number(supply["storage_loss"])} MJ')
    return ';   '.join(words)
