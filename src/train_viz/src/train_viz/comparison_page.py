"""report.html of the paper's comparison: every value beside the paper's, energies by stage, what made the runs."""
import itertools
from typing import Dict, List

from train_viz import page
from train_viz import paper_values as paper
from train_viz.comparison import PREDICTED, Comparison, Row, Stages
from train_viz.comparison_setup import identified_values, reproduction, setup
from train_viz.comparison_verdict import verdict
from train_viz.page import Badge, Section
from train_viz.resolved_scenario import read_value
from train_viz.run import RESIDUAL_WORDS
from train_viz.run_folder import RunFolder

TITLE = "The paper's three simulations, ours beside it"

CAPTIONS = {
    'fig3_adhesion_creep': 'Fig. 3. Adhesion that each axle uses over its creep. The controller holds the slip limit; '
                           'along it adhesion falls with the friction as speed rises.',
    'fig6_traction_force': 'Fig. 6. Diamonds: values that the paper states.',
    'fig7_friction_adhesion': 'Fig. 7. What the rail offers and what is used of it. Diamonds: the forces that the '
                              "paper states over the locomotive's weight.",
    'fig8_energy': 'Fig. 8. Energy by Eq. (4), final speed and time beside it; below, the difference in per cent and '
                   "the paper's percentages as diamonds.",
    'fig9_force_difference': 'Fig. 9. The rate of Eq. (4) is the force, so these are differences of force. Diamonds, '
                             'filled as the bars they belong to: values that the paper states, or that follow from the '
                             'forces that it states.',
}


def comparison_page(c: Comparison, pictures: Dict[str, str]) -> str:
    """@param pictures PNG file by name of the figure; those that these runs give"""
    labels = ', '.join(folder.label for folder in c.folders)
    lead = [page.paragraph(f'{paper.PAPER}. Shown here: {labels}; all values are of the leading locomotive.')]
    missing = [model.upper() for model in ('1d', '2d', '3d') if not c.of_model(model)]
    if missing:
        lead.append(page.notice(_missing_words(c, missing)))
    lead.append(page.bullets(verdict(c)))
    sections = [Section('Beside the paper', _beside_the_paper(c)),
                Section('Figures', [page.picture(pictures[name], caption, caption) for name, caption in
                                    sorted(CAPTIONS.items()) if name in pictures]),
                Section('Energy by stage', _energy_by_stage(c)),
                Section('At equal speed', _equal_speed(c, pictures)),
                Section('Energy account', _account(c)),
                Section('Configuration and build', setup(c)),
                Section('How to reproduce', reproduction(c))]
    builds = ', '.join(sorted({folder.run.build_id for folder in c.folders}))
    return page.make_page(TITLE, lead, sections, f'Made by train_viz paper_comparison from runs of build {builds}.')


def _missing_words(c: Comparison, missing: List[str]) -> str:
    words = f'There is no run of {" and ".join(missing)} here, so the paper\'s values for it have nothing beside them.'
    if not c.has_3d:
        words += " The paper takes all its differences against 3D; these are left out."
        if c.base:
            words += ' Instead 1D is compared with 2D, with what follows from the paper\'s statements for that pair.'
    return words


def _beside_the_paper(c: Comparison) -> List[str]:
    pieces = [page.paragraph('Kind "fitted": P, F_max, B and the contact patch of 2D were identified from the forces '
                             'and energy ratios of 1D and 2D, so agreement there is no evidence. "Predicted": follows '
                             'from 3D, which no parameter was tuned to. "Points" are percentage points.')]
    for (quantity, unit), rows in itertools.groupby(c.rows(), lambda row: (row.quantity, row.unit)):
        cells = [[row.place, row.whose, format(row.paper, PAPER_FORMATS[unit]), format(row.ours, FORMATS[unit]),
                  *_deviation(row), Badge(row.kind, outlined=row.kind == PREDICTED), row.why] for row in rows]
        pieces.append(page.table([f'{quantity} [{UNITS[unit]}]', 'model', 'paper', 'here', 'deviation', 'relative', 'kind',
                                  'why'], cells, (0, 1, 6, 7), 'even'))
    pieces += [page.paragraph('The values that were identified, as these runs used them:'), identified_values(c)]
    pieces += [page.paragraph(_largest_words(c))] if c.has_3d and len(c.folders) > 1 else []
    pieces += [page.notice(words) for folder in c.of_model('3d') for words in _curve_words(c, folder)]
    pieces.append(page.paragraph("The paper's text gives 9.6 % for 1D against 3D at 3.15 km: that is relative to 1D. "
                                 'Its forces of 460 and 416 kN give 10.6 % relative to 3D.'))
    return pieces


UNITS = {'kN': 'kN', '%': '%', '1': '-'}
PAPER_FORMATS = {'kN': '.0f', '%': '+.1f', '1': '.3f'}  # digits as stated
FORMATS = {'kN': '.1f', '%': '+.1f', '1': '.4f'}


def _deviation(row: Row) -> List[str]:
    """In the unit; and relative, but of a percentage whether its sign is another."""
    words = {'kN': f'{_signed(row.deviation, 2)} kN', '%': f'{_signed(row.deviation, 2)} points',
             '1': _signed(row.deviation, 4)}[row.unit]
    if row.unit == '%':
        return [words, 'opposite sign' if row.paper * row.ours < 0.0 else '']
    return [words, f'{_signed(100.0 * row.deviation / row.paper, 2)} %']


def _signed(value: float, digits: int) -> str:
    return f'{round(value, digits) + 0.0:+.{digits}f}'  # + 0.0: no minus before a zero


def _curve_words(c: Comparison, folder: RunFolder) -> List[str]:
    """Why the signs differ, if force changes the other way into the curve than in the paper."""
    outside, inside = sorted(paper.FORCE_KN)
    change = c.force_kN(folder, inside) - c.force_kN(folder, outside)
    if change * (paper.FORCE_KN[inside]['3d'] - paper.FORCE_KN[outside]['3d']) >= 0.0:
        return []
    count = c.wheels_with_more_contacts(folder, inside)
    contacts = '' if count is None else (f' At {inside:g} km {count or "none"} of the leading locomotive\'s wheels '
                                         f'{"has" if count in (0, 1) else "have"} more than one contact.')
    return [f'{folder.label}: force {"rises" if change > 0.0 else "falls"} into the curve, the paper\'s '
            f'{"falls" if change > 0.0 else "rises"}; hence the opposite signs of 2D against 3D there and of the energies.'
            f'{contacts} The force in the curve depends on the profiles, on the size of the contact ellipses there (a smaller '
            'one carries less at the same creep) and on where a second contact takes over; the paper gives none of them. '
            'Nothing was tuned towards its values.']


def _largest_words(c: Comparison) -> str:
    words = []
    for base in c.of_model('3d'):
        for folder in c.of_model('1d') + c.of_model('2d'):
            place, value = c.largest_difference(folder, base)
            paper_place, paper_value = paper.LARGEST_AGAINST_3D[folder.model]
            words.append(f'{folder.label} against {base.label} {value:+.1f} % at {place:g} km (paper {paper_value:+.1f} '
                         f'% at {paper_place:g} km)')
    places = ', '.join(f'{place:g}' for place in paper.FIG9_PLACES_KM)
    return f'Largest differences of force at {places} km: ' + '; '.join(words) + '.'


STAGE_HEADER = ['at the rail, Eq. (4) [MJ]', 'slip loss [MJ]', 'spin-up and other storage [MJ]', 'at the rim [MJ]']


def _stage_cells(s: Stages) -> List[str]:
    return [f'{value / 1e6:.2f}' for value in (s.rail_J, s.slip_J, s.stored_J, s.rim_J)]


def _against(s: Stages, base: Stages) -> List[str]:
    if s == base:
        return ['-', '-']
    return [f'{100.0 * (s.rail_J / base.rail_J - 1.0):+.1f} %', f'{100.0 * (s.rim_J / base.rim_J - 1.0):+.1f} %']


def _against_header(c: Comparison) -> List[str]:
    return [f'at the rail against {c.base.label}', f'at the rim against {c.base.label}'] if c.base else []


def _energy_by_stage(c: Comparison) -> List[str]:
    rows = []
    for place in sorted(paper.ENERGY_AGAINST_3D):
        for folder in c.folders:
            s = c.stages(folder, place)
            rows.append([f'{place:g} km', folder.label, f'{s.time_s:.2f}', f'{3.6 * s.speed_mps:.2f}', *_stage_cells(s),
                         *(_against(s, c.stages(c.base, place)) if c.base else [])])
    header = ['from 3.0 km to', 'model', 'time [s]', 'speed [km/h]', *STAGE_HEADER, *_against_header(c)]
    return [page.table(header, rows, (0, 1)),
            page.paragraph('Eq. (4) counts the force at the rail times the way. What the motors pay at the rim is '
                           'more: it also covers the slip loss and the energy that spins up the wheels. A 1D '
                           'locomotive has no wheels, so both are the same.'),
            *[page.paragraph(words) for words in _k0_words(c)],
            *([page.paragraph('A 3D locomotive makes its curving resistance itself, in its contacts: Eq. (6) is not '
                              'applied to it, as it is in 1D and 2D.')] if c.has_3d else []),
            page.notice('Less energy at one place is not a saving: the train with less energy is slower there, and '
                        'lacks kinetic energy. See the comparison at equal speed.')]


def _k0_words(c: Comparison) -> List[str]:
    """Nothing where no run has wheels that slip."""
    if all(folder.model == '1d' for folder in c.folders):
        return []
    values = sorted({str(value) for value in (
        read_value(folder.run.resolved, 'adhesion', 'reduction', 'k0') for folder in c.folders) if value is not None})
    given = f'k0 = {", ".join(values)}' if values else 'k0'
    if values == ['0.075']:
        given += " (Table 1; the initial creep stiffness is 13 times softer than Kalker's)"
    return [f'The slip loss depends on {given}: a stiffer contact carries the same force with less creep, and loses less.']


def _equal_speed(c: Comparison, pictures: Dict[str, str]) -> List[str]:
    speed = 3.6 * c.equal_speed_mps
    slowest = min(c.folders, key=lambda folder: folder.run.speed_mps[-1])
    rows = []
    for folder in c.folders:
        s = c.stages_at_equal_speed(folder)
        rows.append([folder.label, f'{s.time_s:.2f}', f'{s.location_m / 1e3:.3f}', *_stage_cells(s),
                     *(_against(s, c.stages_at_equal_speed(c.base)) if c.base else [])])
    pieces = [page.paragraph(f'Equal speed is {speed:.3f} km/h, the final speed of the slowest run ({slowest.label}). '
                             'Each row gives the energy since the start, and time and place, where the leading '
                             'locomotive first reaches it. All trains then have the same kinetic energy but for what '
                             'couplers still move; they have come different ways, so resistances took different shares.'),
              page.table(['model', 'time [s]', 'place [km]', *STAGE_HEADER, *_against_header(c)], rows)]
    pieces += [page.paragraph(words) for words in _k0_words(c)]
    if 'equal_speed' in pictures:
        pieces.append(page.picture(pictures['equal_speed'], 'Energy of the leading locomotive over speed',
                                   'Energy over speed, and by stage at equal speed: rail + slip + storage.'))
    return pieces


ACCOUNT_ROWS = (('account_traction_rim', 'traction at the rim'), ('account_slip_loss', 'slip loss'),
                ('account_traction_rail', 'traction at the rail'), ('account_kinetic', 'kinetic, change'),
                ('account_propulsion_resistance', 'propulsion resistance'),
                ('account_curving_resistance', 'curving resistance'),
                ('account_potential', 'potential, change'), ('account_coupler_loss', 'coupler loss'),
                ('account_coupler_stored', 'coupler springs, change'))


def _account(c: Comparison) -> List[str]:
    of = [folder.summary.of_run for folder in c.folders]
    rows = [[f'{words} [MJ]'] + [f'{get(name, "J") / 1e6:.3f}' for get in of] for name, words in ACCOUNT_ROWS]
    rows += [['residual [J]'] + [f'{get("account_residual", "J"):+.3g}' for get in of],
             [RESIDUAL_WORDS] + [f'{get("energy_residual_relative", "1"):+.1e}' for get in of],
             ['time at the end [s]'] + [f'{get("final_time", "s"):.2f}' for get in of],
             ['speed at the end [km/h]'] + [f'{3.6 * get("final_speed", "m/s"):.3f}' for get in of],
             ['place at the end [km]'] + [f'{get("final_location", "m") / 1e3:.3f}' for get in of]]
    return [page.paragraph('Of the whole train from start to end. The residual is what traction at the rail leaves '
                           'over when all that it became is taken away.'),
            page.table(['whole train', *(folder.label for folder in c.folders)], rows)]
