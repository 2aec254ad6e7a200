"""Writes run folders as LTD leaves them, around synthetic bags: small, and with numbers that a test knows."""
import csv
import os
from typing import Dict, Optional, Tuple

import numpy as np

from synthetic_bag import RESOLVED, write_bag
from train_viz.paper_values import REPORT_PLACES_KM
from train_viz.summary import COLUMNS

PERIOD_S = 0.2  # coarse: a run is a thousand rows
MODEL_LIMIT_N = {'1d': 460.1e3, '2d': 400e3, '3d': 416e3}
RESIDUAL_RELATIVE = 3.25e-8

MORE = '''
description: synthetic %(key)s
locomotive_model: %(model)s
run: {start_location_km: 3.0}
adhesion: {friction: {B_s_per_m: 0.275}, reduction: {k0: 0.075}}
steps: {macro_step_s: 0.002, micro_step_s: 0.001}
'''

Values = Dict[Tuple[str, float], float]  # by quantity and place [km]


def write_run_folder(directory: str, key: str, changed: Optional[Values] = None, slip: float = 0.075,
                     outcome: str = 'finished', **options) -> str:
    """A run of the paper's case; `key` as in paper_KEY. Returns its folder.

    @param options of write_bag; `changed_scenario`: what to replace in its text, and by what
    @param changed values of the leading locomotive in summary.csv that differ from those of the bag
    """
    model, folder = key[:2], os.path.join(directory, key)
    os.makedirs(folder)
    wheels = model != '1d'
    locos, wagons, scenario = 3, options.pop('wagons', 105), f'paper_{key}'
    resolved = ((RESOLVED + MORE) % locals()).replace(*options.pop('changed_scenario', ('', '')))
    rows = write_bag(os.path.join(folder, f'{scenario}.bag'), scenario, locos, wagons, resolved=resolved,
                     with_wheels=(1,) if wheels else (), period_s=PERIOD_S, slip=slip if wheels else 0.0,
                     end_km=4.51, **{'limit_N': MODEL_LIMIT_N[model], **options})
    with open(os.path.join(folder, 'summary.csv'), 'w', encoding='utf-8', newline='') as file:
        csv.writer(file, lineterminator='\n').writerows([COLUMNS, *_summary(model, rows, changed or {})])
    with open(os.path.join(folder, 'outcome.yaml'), 'w', encoding='utf-8') as file:
        file.write(f'outcome: {outcome}\nreason: "test"\nstep: 4711\nexchange_digest: "cafe{key}"\n')
    return folder


def _summary(model: str, rows: Dict, changed: Values) -> list:
    slip = 0.9 * (rows['rim'] - rows['work'])  # as in synthetic_bag
    at_places = (('traction_force', 'N', rows['traction']), ('speed', 'm/s', rows['speed']), ('time', 's', rows['time']),
                 ('energy_rail', 'J', rows['work']), ('energy_rim', 'J', rows['rim']), ('energy_slip', 'J', slip))
    table = []
    for place in REPORT_PLACES_KM:
        for vehicle in (1, 2):
            for quantity, unit, values in at_places:
                value = np.interp(1e3 * place, rows['location'], values)
                if vehicle == 1:
                    value = changed.get((quantity, place), value)
                else:
                    value = -1.0  # nobody must read another locomotive's
                table.append([model, vehicle, quantity, unit, place, repr(float(value))])
    account = {'account_traction_rail': 3.0 * rows['work'][-1], 'account_traction_rim': 3.0 * rows['rim'][-1],
               'account_slip_loss': 3.0 * slip[-1], 'account_propulsion_resistance': rows['resistance_work'][-1],
               'account_curving_resistance': 0.0, 'account_potential': 0.0, 'account_coupler_loss': 0.0,
               'account_coupler_stored': 0.0, 'account_kinetic': 3.0 * rows['work'][-1] - rows['resistance_work'][-1],
               'account_residual': 48.75}
    table += [[model, '', name, 'J', '', repr(float(value))] for name, value in account.items()]
    table += [[model, '', 'energy_residual_relative', '1', '', RESIDUAL_RELATIVE],
              [model, '', 'final_time', 's', '', repr(float(rows['time'][-1]))],
              [model, '', 'final_speed', 'm/s', '', repr(float(rows['speed'][-1]))],
              [model, '', 'final_location', 'm', '', repr(float(rows['location'][-1]))],
              [model, '', 'rotary_inertia', '1', '', 0], [model, '', 'real_time_factor', '1', '', 94.25]]
    return table
