"""The energy between fuel and rail, stage by stage (docs/energy.md): parted into driving and braking, closed by sums.

Nothing here knows ROS or matplotlib.
"""
from typing import Dict, List, Optional

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
    """All energies of (F12) at the end, by TrainEnergy's names without loco_, of the locomotives with a supply together; None
    if none has one. And the energy through the shaft, what is stored since the start, litres."""
    columns = [i - 1 for i in supplied(run)]
    if not columns:
        return None
    total = {name: float(values[-1, columns].sum()) / J_PER_MJ for name, values in run.locos.items()}
    total.update(litres=total['litres'] * J_PER_MJ, shaft=total['generator'] + total['generator_loss'],
                 stored_change=total['stored'] - total['stored_start'])
    return total
