"""report.html of any runs: their figures, what they used, and the configuration that made them."""
from typing import Dict, List

from train_viz import page
from train_viz.energy_stages import rim_words
from train_viz.page import Section
from train_viz.resolved_scenario import read_value
from train_viz.run import RESIDUAL_WORDS, Run
from train_viz.run_labels import file_name

TITLES = {  # by the beginning of a figure's name, in the order of the page
    'energy_flow': 'where the energy of the whole train goes, from the motors to the sinks',
    'energy_supply': 'from fuel, storage or line to the rim, of locomotives with a supply',
    'energy_account': 'the account of the whole train in bars and numbers',
    'traction_force': 'force at the rail over place',
    'energy': 'energy over place, and over speed where that only rises',
    'speed_notch': 'speed and notch over place',
    'trip': 'speed and limit; notches, pressures, height and curvature of the line as far as there are any',
    'brake_pressures': 'brake pipe and cylinders over time and vehicle',
    'brake_energy': 'what brakes take and where it goes, stores of the supply',
    'coupler_forces': 'in-train forces over time and coupler',
    'friction_adhesion': 'friction that the rail offers, adhesion used',
    'adhesion_creep': 'adhesion over creep, axle by axle',
    'adhesion_control': 'creep, torque and where the controller acts',
    'axle_loads': 'axle loads and slip losses',
    'wheelset_displacement': 'lateral displacement of each wheelset, at its own place',
    'guiding_forces': 'guiding force and its ratio to the vertical force, wheel by wheel',
    'wheel_contacts': 'slip loss and number of contacts, wheel by wheel',
}
MOST_COLUMNS = 7  # chosen: of a table 1000 pixels wide, whose heads are then still readable; more become rows
SECTIONS = (
    ('Energy', ('energy_flow', 'energy_supply', 'energy_account', 'energy')),
    ('Motion and forces', ('trip', 'traction_force', 'speed_notch', 'coupler_forces')),
    ('Brakes', ('brake_pressures', 'brake_energy')),
    ('Wheel and rail', ('friction_adhesion', 'adhesion_creep', 'adhesion_control', 'axle_loads',
                        'wheelset_displacement', 'guiding_forces', 'wheel_contacts')),
)
WHEELS, EVERY_WHEEL = 'no wheels on the rail in the bag: 2D and 3D have them', 'nothing of every wheel in the bag: 3D has it'
WHY = {  # a figure is left out, by the beginning of its name; those that compare runs first
    'energy': 'no motor gives any energy',
    'friction_adhesion': WHEELS,
    'energy_supply': 'no locomotive with a supply that gave or took any energy',
    'coupler_forces': 'no couplers',
    'brake_pressures': 'no air brake',
    'brake_energy': 'no brake took any energy, no supply',
    'adhesion_creep': WHEELS,
    'adhesion_control': WHEELS,
    'axle_loads': WHEELS,
    'wheelset_displacement': EVERY_WHEEL,
    'guiding_forces': EVERY_WHEEL,
    'wheel_contacts': EVERY_WHEEL,
}
COMPARING = ('energy', 'friction_adhesion')


def run_page(runs: List[Run], pictures: Dict[str, str]) -> str:
    """@param pictures PNG file by name of the figure"""
    title = ', '.join(run.label for run in runs)
    lead = [page.paragraph('The leading locomotive at the end of each run:' if runs[0].locomotive == 1 else
                           f'Energy of {runs[0].whose} and place of the leading one at the end of each run:'), _ends(runs)]
    if len(runs) > 1:
        lead.append(page.notice('Less energy at one place is not a saving where the train is slower: compare speed and '
                                'time, too.'))
    if any(run.rim_differs() for run in runs):
        lead.append(page.paragraph(f'The rim also pays {rim_words(runs)}.'))
    if any(run.slip_J.any() for run in runs):
        lead.append(page.paragraph('A stiffer contact (k0 in the configuration) carries the same force with less creep, and '
                                   'loses less.'))
    sections = []
    for heading, kinds in SECTIONS:
        pieces = [page.picture(pictures[name], f'{name}: {TITLES[kind]}', f'{name}: {TITLES[kind]}')
                  for kind in kinds for name in pictures if kind_of(name) == kind]
        if pieces:
            sections.append(Section(heading, pieces))
    absent = left_out(runs, pictures)
    if absent:
        sections.append(Section('Left out', [page.paragraph('Figures that would have nothing to show:'), page.bullets(absent)]))
    sections.append(Section('Configuration and build', _configuration(runs)))
    return page.make_page(title, lead, sections, 'Made by train_viz report.')


def left_out(runs: List[Run], pictures: Dict[str, str]) -> List[str]:
    """Which figures these runs do not give, and why: a sentence a reason."""
    found: Dict[str, Dict[str, List[str]]] = {}  # by reason and run
    for kind, why in WHY.items():
        for label, name in [('', kind)] if kind in COMPARING else [(run.label, f'{kind}_{file_name(run.label)}') for run in runs]:
            if name not in pictures:
                found.setdefault(why, {}).setdefault(label if len(runs) > 1 else '', []).append(kind)
    return [f'{", ".join(kinds)}{f" of {label}" if label else ""}: {why}' for why, those in found.items()
            for label, kinds in those.items()]


def kind_of(name: str) -> str:
    """The longest title's name that a figure's name begins with: energy_flow_RUN is no energy."""
    return max((kind for kind in TITLES if name.startswith(kind)), key=len)


def _ends(runs: List[Run]) -> str:
    columns = [('place [km]', lambda run: f'{run.location_km[-1]:.3f}'), ('time [s]', lambda run: f'{run.time_s[-1]:.2f}'),
               ('speed [km/h]', lambda run: f'{run.end_kmph:.2f}'),
               ('at the rail, Eq. (4) [MJ]', lambda run: f'{run.rail_J[-1] / 1e6:.2f}'),
               ('slip loss [MJ]', lambda run: f'{run.slip_J[-1] / 1e6:.2f}'),
               ('at the rim [MJ]', lambda run: f'{run.rim_J[-1] / 1e6:.2f}')]
    if any(run.brakes() for run in runs):
        columns += [('its brakes, at the rail [MJ]', lambda run: _shown_MJ(run, 'brake_rail')),
                    ('recovered, at the rim [MJ]', lambda run: _shown_MJ(run, 'recovered_rim')),
                    ('air brake of all wagons [MJ]', lambda run: f'{run.account["air_brake"][-1] / 1e6:.2f}')]
    if any(run.has_supply() for run in runs):
        columns.append(('its fuel [l]', lambda run: f'{run.locos["litres"][-1, run.locomotive - 1]:.2f}'))
    columns.append((RESIDUAL_WORDS, lambda run: f'{run.account["residual_relative"][-1]:+.1e}'))
    rows = [['run', *(words for words, _ in columns)], *([run.label, *(value(run) for _, value in columns)] for run in runs)]
    if len(columns) > MOST_COLUMNS:
        rows = list(zip(*rows))
    return page.table(rows[0], rows[1:])


def _shown_MJ(run: Run, name: str) -> str:
    return f'{run.locos[name][-1, run.locomotive - 1] / 1e6:.2f}'


def _configuration(runs: List[Run]) -> List[str]:
    rows = [['scenario', *(run.scenario for run in runs)],
            ['description', *(str(read_value(run.resolved, 'description') or '-') for run in runs)],
            ['build', *(run.build_id or '-' for run in runs)],
            ['run id', *(str(run.run_id) for run in runs)],
            ['bags', *(', '.join(run.files) for run in runs)],
            ['instants drawn of those recorded', *(f'{len(run.time_s)} of {run.recorded}' for run in runs)]]
    pieces = [page.table(['', *(run.label for run in runs)], rows, range(len(runs) + 1)),
              page.paragraph('The scenario with all files that it names, as one text that runs again on its own:')]
    return pieces + [page.folded(run.label, run.resolved) for run in runs]
