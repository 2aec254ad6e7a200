"""The energy account of the whole train: sources against sinks as bars, all numbers in a table."""
from typing import List, Optional, Tuple

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style, sankey
from train_viz.energy_stages import final_MJ, supply_MJ
from train_viz.run import RESIDUAL_WORDS, Run

SHOES_COLOUR = '#A6611A'  # of locomotives

# What the traction gives, and where it goes: (field of TrainEnergy or of `final_MJ`, words, colour)
SOURCES = (
    ('traction_rail', 'traction at the rail', '0.35'),
    ('slip_driving', 'slip loss', '0.60'),
    ('shoes_driving', "locomotives' shoes, pulled against", SHOES_COLOUR),
    ('rest_driving', 'wheel spin-up and other storage', '0.80'),
)
SINKS = (
    ('kinetic', 'kinetic, change', plot_style.BLUE),
    ('propulsion_resistance', 'propulsion resistance', plot_style.ORANGE),
    ('curving_resistance', 'curving resistance', plot_style.GREEN),
    ('potential', 'potential, change', plot_style.SKY),
    ('coupler_loss', 'coupler loss', plot_style.VERMILION),
    ('coupler_stored', 'coupler springs, change', plot_style.PURPLE),
    ('air_brake', "air brake, wagons' shoes", '#7F3B08'),
)
# What the locomotives' brakes take at the rail, and what they turn it into
BRAKE_RAIL = ('brake_rail', "locomotives' brakes, at the rail", '0.45')
BRAKED = (
    ('recovered_rim', 'recovered by motors, at the rim', '#1B7837'),
    ('shoes_braking', "locomotives' shoes, braking", SHOES_COLOUR),
    ('slip_braking', 'slip loss, braking', '0.60'),
    ('rest_braking', 'wheel spin, braking', '0.80'),
)


def draw_energy_account(runs: List[Run]) -> Figure:
    """Bars to compare by eye, one pair a run; below, the numbers with place, time and speed at the end."""
    braking = any(run.brakes() for run in runs)
    bars_height = 0.9 + (1.2 if braking else 0.85) * len(runs)  # all sizes in inches
    columns = _table_rows(runs)
    header = [plot_style.wrapped(run.label, 15) for run in runs]
    header_rows = 0.4 + 0.6 * max(text.count('\n') + 1 for text in header)  # in heights of the others
    table_height = 0.31 * (len(columns[0]) + header_rows)
    figure, (bars, table) = plt.subplots(2, 1, figsize=(max(9.5, 4.2 + 1.8 * len(runs)), bars_height + table_height + 1.2),
                                         gridspec_kw={'height_ratios': (bars_height, table_height)})
    _draw_bars(bars, runs, braking)
    _draw_table(table, columns, header, header_rows)
    figure.suptitle('Energy account of the whole train')
    return figure


def _draw_bars(axes: Axes, runs: List[Run], braking: bool) -> None:
    largest = max(abs(final_MJ(run)[name]) for run in runs for name, _, _ in SOURCES + SINKS)
    for i, run in enumerate(runs):
        final = final_MJ(run)
        stacks = (SOURCES, SINKS + (BRAKE_RAIL,), BRAKED)[:3 if braking else 2]
        height = 0.76 / len(stacks)
        for j, terms in enumerate(stacks):
            y = i - 0.38 + height * (j + 0.5)
            _stack(axes, [(final[name], colour) for name, _, colour in terms], y, 0.95 * height)
            if max(abs(final[name]) for name, _, _ in terms) < 1e-4 * largest:  # chosen: no pixel
                axes.text(0.0, y, ' nothing', va='center', fontsize=10, color='0.3')
    axes.set_yticks(range(len(runs)))
    axes.set_yticklabels([plot_style.wrapped(run.label, 24) for run in runs])
    axes.set_ylim(len(runs) - 0.5, -0.5)
    low, high = axes.dataLim.intervalx
    axes.set_xlim(min(1.05 * low, 0.0), max(1.05 * high, 1e-3))
    _clip_racing(axes, runs)
    axes.set_title('upper bar: what the motors give, middle: where it goes from the rail,\n'
                   "lower: what the locomotives' brakes turn theirs into" if braking else
                   'upper bar: what the motors give, lower bar: where it goes from the rail', fontsize=11)
    axes.axvline(0.0, color='black', linewidth=0.8)
    axes.grid(axis='y', visible=False)
    axes.set_xlabel('energy since the start of the run [MJ]   (left of zero: given back)')


def _clip_racing(axes: Axes, runs: List[Run]) -> None:
    """The slip loss of racing wheels leaves the frame, lest it flatten the other bars."""
    ends = [sum(max(final_MJ(run)[name], 0.0) for name, _, _ in SOURCES) for run in runs]
    rails = [final_MJ(run)['traction_rail'] for run in runs]
    slips = [final_MJ(run)['slip_driving'] for run in runs]
    # 2, 0.5 and 1.25, chosen: as in the energy figure
    races = [end > 2.0 * max(rail, 0.0) + 1.0 and slip > 0.5 * (end - max(rail, 0.0))
             for end, rail, slip in zip(ends, rails, slips)]
    if not any(races):
        return
    top = max(1.25 * max(rail if race else end for end, rail, race in zip(ends, rails, races)), 1e-3)
    axes.set_xlim(right=top)
    for i, (end, race) in enumerate(zip(ends, races)):
        if race and end > top:
            axes.text(top, i - 0.19, f'on to {end:.0f} MJ \u2192 ', ha='right', va='center', fontsize=11,
                      bbox={'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.85, 'pad': 1.5})


def _stack(axes: Axes, terms: List[Tuple[float, str]], y: float, height: float) -> None:
    """Positive terms to the right of zero, negative ones to the left."""
    right = left = 0.0
    for value, colour in terms:
        axes.barh(y, value, height=height, left=right if value >= 0.0 else left, color=colour)
        right, left = right + max(value, 0.0), left + min(value, 0.0)


Row = Tuple[str, str, str]  # of the table: words, colour or '', value


def _table_rows(runs: List[Run]) -> List[List[Row]]:
    """A list a run, all of the same terms: those of brakes and supplies only if any run has some."""
    terms = [('traction_rim', 'traction at the rim', ''), *SOURCES, *SINKS]
    if any(run.brakes() for run in runs):
        terms += [BRAKE_RAIL, *BRAKED]
    else:
        terms = [term for term in terms if term[0] not in ('shoes_driving', 'air_brake')]
    supplies = [supply_MJ(run) for run in runs]
    return [[*_energy_rows(run, terms), *(_supply_rows(supply) if any(supplies) else []), *_end_rows(run)]
            for run, supply in zip(runs, supplies)]


def _energy_rows(run: Run, terms: List[Tuple[str, str, str]]) -> List[Row]:
    final = final_MJ(run)
    return [(f'{words} [MJ]', colour, _number(final[name])) for name, words, colour in terms]


def _supply_rows(supply: Optional[dict]) -> List[Row]:
    """Of locomotives with a supply; a run without any has no numbers."""
    terms = (('fuel', 'fuel burnt [MJ]'), ('litres', 'fuel burnt [l]'), ('line_drawn', 'drawn from the line [MJ]'),
             ('line_returned', 'returned to the line [MJ]'), ('storage_out', 'out of the storage, at the link [MJ]'),
             ('storage_in', 'into the storage, at the link [MJ]'), ('to_resistors', 'into resistors, at the link [MJ]'),
             ('auxiliaries', 'auxiliaries, at the link [MJ]'))
    return [(words, '', _number(supply[name]) if supply else '-') for name, words in terms]


def _number(value: float) -> str:
    return f'{round(value, 3) + 0.0:.3f}'  # + 0.0: no minus before a zero


def _end_rows(run: Run) -> List[Row]:
    final = final_MJ(run)
    return [
        ('residual [J]', '', sankey.signed_number(1e6 * final['residual'])),
        (RESIDUAL_WORDS, '', f'{run.account["residual_relative"][-1]:+.1e}'),
        ('traction at the rail [kWh]', '', _number(final['traction_rail'] / 3.6)),
        ('place at the end [km]', '', f'{run.location_km[-1]:.3f}'),
        ('time at the end [s]', '', f'{run.time_s[-1]:.2f}'),
        ('speed at the end [km/h]', '', f'{run.end_kmph:.3f}'),
    ]


def _draw_table(axes: Axes, columns: List[List[Row]], header: List[str], header_rows: float) -> None:
    """A column a run; the first two columns are the bars' legend."""
    cells = [['', words] + [column[i][2] for column in columns] for i, (words, _, _) in enumerate(columns[0])]
    widths = [0.03, 0.37] + [0.6 / max(len(columns), 2)] * len(columns)
    table = axes.table(cellText=cells, colLabels=['', ''] + header, colWidths=widths, cellLoc='right', colLoc='right',
                       bbox=(0.0, 0.0, sum(widths), 1.0))
    table.auto_set_font_size(False)
    table.set_fontsize(11)
    for (row, column), cell in table.get_celld().items():
        colour = columns[0][row - 1][1] if row > 0 and column == 0 else ''
        cell.visible_edges = 'closed' if colour else 'B'  # only closed cells are filled
        cell.set_facecolor(colour or 'none')
        cell.set_edgecolor('0.9')
        if column == 1:
            cell.set_text_props(ha='left')
        if row == 0:
            cell.set_height(header_rows * cell.get_height())
    axes.axis('off')
