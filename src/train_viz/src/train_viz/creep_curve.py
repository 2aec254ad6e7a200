"""Adhesion over creep at constant speed, of the 2D model's contact: computed by creep_force from the resolved scenario."""
import dataclasses
import functools
import subprocess
import sys
from typing import List, Optional, Tuple

import numpy as np

from train_viz.resolved_scenario import read_locomotive_value, read_value
from train_viz.run import Run

PROGRAM = ('rosrun', 'loco_dynamics', 'creep_force')
DEADLINE_S = 30.0
PLACES_KM = (3.15, 3.45)  # of the paper's case, where it states forces
SHARES = (0.1, 0.5, 1.0)  # chosen: of the largest speed, for other runs
FINEST = 1e-4             # creep [-], chosen: the curve's first point beside 0
COLUMNS = ('curvature_along_1pm', 'curvature_across_1pm', 'E_GPa', 'nu', 'G_GPa', 'N_N', 'V_mps', 'mu0', 'A', 'B_s_per_m', 'k0',
           'alpha_inf', 'beta', 'kA', 'kS', 'creep_x', 'creep_y', 'spin_rad_per_m')


@dataclasses.dataclass(frozen=True)
class CreepCurve:
    """Adhesion of an axle with the mean load at one speed, on the rail of the whole line (not of a rail section)."""
    speed_mps: float
    creep: np.ndarray     # [-], from 0
    adhesion: np.ndarray  # [-]
    label: str


def creep_curves(run: Run, speeds_mps: Tuple[float, ...], largest_creep: float) -> List[CreepCurve]:
    """Empty, with a word on standard error, where they cannot be had; empty for other models than 2d, whose ellipses move."""
    if run.adhesion is None or run.adhesion.wheels is not None:
        return []
    wheel_N = float(run.adhesion.normal_force_N.mean()) / 2.0
    rail, sand = _rail(run)
    contact = _contact(run.resolved, run.adhesion.locomotive, rail)
    if contact is None:
        return []
    creep = np.concatenate(([0.0], np.geomspace(FINEST, largest_creep, 80)))
    sections = ', outside rail sections' if read_value(run.resolved, 'rail_sections') else ''
    curves = []
    for speed in speeds_mps:
        values, method = contact
        adhesion = _adhesion(values, method, wheel_N, speed, tuple(creep))
        if adhesion is None:
            return []
        curves.append(CreepCurve(speed, creep, np.array(adhesion),
                                 f'creep curve at {3.6 * speed:.1f} km/h, 2D, mean axle load{sand}{sections}'))
    return curves


def _rail(run: Run) -> Tuple[str, str]:
    """The scenario's key of the rail that the wheels had most of the time, with or without sand, and words if there are both."""
    with_sand, without = (read_value(run.resolved, key, 'friction', 'mu0') for key in ('sanded_adhesion', 'adhesion'))
    if with_sand is None or without is None:
        return 'adhesion', ''
    found = float(np.median(run.adhesion.static_friction))
    sanded = abs(found - float(with_sand)) < abs(found - float(without))
    return ('sanded_adhesion', ', under sand') if sanded else ('adhesion', ', without sand')


def speeds_of(run: Run) -> Tuple[float, ...]:
    """Where the paper states forces, if the run passes there; otherwise parts of its largest speed. In m/s."""
    wheels = run.adhesion
    if read_value(run.resolved, 'name') == 'paper_2d' and wheels.location_km[0] <= PLACES_KM[0] and \
            wheels.location_km[-1] >= PLACES_KM[-1]:
        speeds = [np.interp(1e3 * place, wheels.location_m, wheels.speed_mps) for place in PLACES_KM]
        return (*map(float, speeds), float(wheels.speed_mps[-1]))
    return tuple(float(share * wheels.speed_mps.max()) for share in SHARES)


def _contact(resolved: str, locomotive: int, rail: str) -> Optional[Tuple[dict, str]]:
    """Columns of creep_force that do not depend on load, speed and creep; and its method. None if anything is missing.

    @param rail the scenario's key of its adhesion
    """
    def of_locomotive(*path):
        return float(read_locomotive_value(resolved, locomotive, *path))

    def of_rail(*path):
        return float(read_value(resolved, rail, *path))

    method = read_value(resolved, rail, 'method')
    try:
        values = {'curvature_along_1pm': 1.0 / of_locomotive('bodies', 'wheel_radius_m'),
                  'curvature_across_1pm': 1.0 / of_locomotive('contact', 'rail_crown_radius_m') +
                  of_locomotive('contact', 'wheel_transverse_curvature_1pm'),
                  'E_GPa': 1e-9 * of_locomotive('contact', 'young_modulus_Pa'), 'nu': of_locomotive('contact', 'poisson_ratio'),
                  'G_GPa': 1e-9 * of_locomotive('contact', 'shear_modulus_Pa'), 'mu0': of_rail('friction', 'mu0'),
                  'A': of_rail('friction', 'A'), 'B_s_per_m': of_rail('friction', 'B_s_per_m')}
        reduced, polach = method in ('modfastsim', 'closed'), method == 'polach'
        values.update({name: of_rail('reduction', name) if reduced else 1.0 for name in ('k0', 'alpha_inf', 'beta')})
        values.update({name: of_rail('polach', key) if polach else 1.0 for name, key in (('kA', 'k_A'), ('kS', 'k_S'))})
    except (TypeError, ValueError):
        return None
    return values, 'closed' if method == 'modfastsim' else method  # as the 2D model: exact without spin


def _adhesion(values: dict, method: str, wheel_N: float, speed_mps: float, creep: Tuple[float, ...]) -> Optional[list]:
    """CONTACT's signs: a driving wheel's material moves backwards, creep_x < 0, and the force on it is > 0."""
    row = {**values, 'N_N': wheel_N, 'V_mps': speed_mps, 'creep_y': 0.0, 'spin_rad_per_m': 0.0}
    lines = [','.join(COLUMNS)] + [','.join(repr(float(-one if name == 'creep_x' else row[name])) for name in COLUMNS)
                                   for one in creep]
    answer = _run_program(method, '\n'.join(lines) + '\n')
    if answer is None:
        return None
    return [float(line.split(',')[len(COLUMNS)]) / wheel_N for line in answer.splitlines()[1:]]


@functools.lru_cache(maxsize=None)
def _run_program(method: str, text: str) -> Optional[str]:
    try:
        done = subprocess.run([*PROGRAM, '--method', method], input=text, capture_output=True, text=True, timeout=DEADLINE_S,
                              check=True)
    except subprocess.CalledProcessError as error:
        print(f'train_viz: no creep curves, {" ".join(PROGRAM)}: {error.stderr.strip().splitlines()[:1]}', file=sys.stderr)
    except (OSError, subprocess.TimeoutExpired) as error:
        print(f'train_viz: no creep curves, {" ".join(PROGRAM)} did not run: {error}', file=sys.stderr)
    else:
        return done.stdout
    return None
