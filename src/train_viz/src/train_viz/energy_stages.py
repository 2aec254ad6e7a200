"""The energy between fuel and rail, stage by stage (docs/energy.md): parted into driving and braking, closed by sums.

Nothing here knows ROS or matplotlib.
"""
from typing import Any, Dict, List, Optional

import numpy as np

from train_viz.resolved_scenario import read_locomotive_value
from train_viz.run import Run

J_PER_MJ = 1e6


def final_MJ(run: Run) -> Dict[str, float]:
    """The account at the end by field, and what lies between rim and rail, parted by `between_rim_and_rail`."""
    final = {name: float(values[-1]) / J_PER_MJ for name, values in run.account.items()}
    for name, values in between_rim_and_rail(run).items():
        final[name] = float(values[-1].sum()) / J_PER_MJ
    return final


def between_rim_and_rail(run: Run) -> Dict[str, np.ndarray]:
    """Slip loss and the rest (spin of wheels, motion of bodies) while driving and while braking, cumulative [row, locomotive].

        rim       = rail       + slip_driving + rest_driving
        brake rail = recovered + shoes + slip_braking + rest_braking

    A locomotive brakes from one row to the next where its brakes take more at the rail than its motors give there.
    """
    books = run.locos
    slip, braking = books['energy_slip'], _braking(run)
    slip_braking = _sum_where(slip, braking)
    return {'slip_driving': slip - slip_braking, 'slip_braking': slip_braking,
            'rest_driving': books['energy_rim'] - books['energy_rail'] - (slip - slip_braking),
            'rest_braking': books['brake_rail'] - books['recovered_rim'] - books['shoes'] - slip_braking}


def _braking(run: Run) -> np.ndarray:
    taken, given = (np.diff(run.locos[name], axis=0, prepend=0.0) for name in ('brake_rail', 'energy_rail'))
    return taken > np.maximum(given, 0.0)  # the wheels of a coasting locomotive take a little without a brake


def _sum_where(cumulative: np.ndarray, flags: np.ndarray) -> np.ndarray:
    return np.cumsum(np.where(flags, np.diff(cumulative, axis=0, prepend=0.0), 0.0), axis=0)


def supplied(run: Run) -> List[int]:
    """Locomotives with a supply, from 1."""
    count = run.traction_N.shape[1]
    return [i for i in range(1, count + 1) if read_locomotive_value(run.resolved, i, 'supply') is not None]


def supply_MJ(run: Run) -> Optional[Dict[str, float]]:
    """All energies of (F12) at the end, of the locomotives with a supply together; None if none has one.

    The bag holds what enters and leaves the link; the losses between follow from the efficiencies in the scenario.
    """
    total: Dict[str, float] = {}
    for locomotive in supplied(run):
        for name, value in _supply_of(run, locomotive).items():
            total[name] = total.get(name, 0.0) + value / J_PER_MJ
    return total or None


def _supply_of(run: Run, locomotive: int) -> Dict[str, float]:
    books = {name: float(values[-1, locomotive - 1]) for name, values in run.locos.items()}
    drivetrain = _number(run, locomotive, 1.0, 'drivetrain_efficiency')
    generator = _number(run, locomotive, 1.0, 'generator_efficiency')
    line = _number(run, locomotive, 1.0, 'line', 'efficiency')
    line_steps = np.diff(run.locos['line'][:, locomotive - 1], prepend=0.0)  # the bag has the difference of the two
    drawn, returned = float(line_steps.clip(min=0.0).sum()), float(-line_steps.clip(max=0.0).sum())
    to_motors, from_motors = books['energy_rim'] / drivetrain, books['recovered_rim'] * drivetrain
    asked = to_motors + books['auxiliaries'] + books['storage_in'] + books['to_resistors'] + returned / line
    rest = asked - from_motors - books['storage_out'] - drawn * line
    has_engine = read_locomotive_value(run.resolved, locomotive, 'supply', 'engine') is not None
    from_generator = max(rest, 0.0) if has_engine else 0.0
    shaft = from_generator / generator
    stored_start = float(run.locos['stored'][0, locomotive - 1])
    return {
        'fuel': books['fuel'], 'engine_loss': books['fuel'] - shaft, 'shaft': shaft, 'generator_loss': shaft - from_generator,
        'generator': from_generator, 'drawn': drawn, 'line_loss': drawn * (1.0 - line) + returned * (1.0 / line - 1.0),
        'returned': returned, 'storage_out': books['storage_out'], 'storage_in': books['storage_in'],
        'stored_change': books['stored'] - stored_start,
        'storage_loss': books['storage_in'] - books['storage_out'] - (books['stored'] - stored_start),
        'recovered': books['recovered_rim'], 'recovered_loss': books['recovered_rim'] - from_motors,
        'motored': books['energy_rim'], 'motored_loss': to_motors - books['energy_rim'],
        'auxiliaries': books['auxiliaries'], 'resistors': books['to_resistors'], 'unserved': rest - from_generator,
        'litres': books['litres'] * J_PER_MJ,
    }


def _number(run: Run, locomotive: int, fallback: float, *path: Any) -> float:
    value = read_locomotive_value(run.resolved, locomotive, 'supply', *path)
    return fallback if value is None else float(value)
