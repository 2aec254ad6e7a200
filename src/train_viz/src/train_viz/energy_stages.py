"""The energy between fuel and rail, stage by stage (docs/energy.md): parted into driving and braking, closed by sums.

Nothing here knows ROS or matplotlib.
"""
from typing import Dict, List, Optional

import numpy as np

from train_viz.resolved_scenario import read_locomotive_value
from train_viz.run import Run

J_PER_MJ = 1e6
LEAST_J = 1e3  # chosen: less than a locomotive needs to move at all


def final_MJ(run: Run) -> Dict[str, float]:
    """The account at the end by field, and what lies between rim and rail, parted by `between_rim_and_rail`."""
    final = {name: float(values[-1]) / J_PER_MJ for name, values in run.account.items()}
    for name, values in between_rim_and_rail(run).items():
        final[name] = float(values[-1].sum()) / J_PER_MJ
    return final


def between_rim_and_rail(run: Run) -> Dict[str, np.ndarray]:
    """Slip loss, shoes and the rest (spin of wheels, motion of bodies), driving and braking, cumulative [row, locomotive].

        rim        = rail      + shoes_driving + slip_driving + rest_driving
        brake rail = recovered + shoes_braking + slip_braking + rest_braking

    A locomotive brakes from one row to the next where its brakes take more at the rail than its motors give there. Its shoes
    get from its motors what these give and neither rail nor slip takes, as far as the shoes' heat goes; in 1D that is exact.
    """
    books = run.locos
    slip_braking = _sum_where(books['energy_slip'], _braking(run))
    slip_driving = books['energy_slip'] - slip_braking
    over, heat = (np.diff(values, axis=0, prepend=0.0) for values in
                  (books['energy_rim'] - books['energy_rail'] - slip_driving, books['shoes']))
    shoes_driving = np.cumsum(np.clip(over, 0.0, np.maximum(heat, 0.0)), axis=0)
    shoes_braking = books['shoes'] - shoes_driving
    return {'slip_driving': slip_driving, 'slip_braking': slip_braking,
            'shoes_driving': shoes_driving, 'shoes_braking': shoes_braking,
            'rest_driving': books['energy_rim'] - books['energy_rail'] - shoes_driving - slip_driving,
            'rest_braking': books['brake_rail'] - books['recovered_rim'] - shoes_braking - slip_braking}


def rim_words(runs: List[Run]) -> str:
    """What the rim pays that the rail does not get, as far as these runs have it."""
    words = ['slip loss, which depends on the contact stiffness assumed (k0), and wheel spin-up'] * any(
        np.any(run.slip_J) for run in runs)
    words += ["the heat of the locomotive's own shoes while it pulls against them"] * any(
        between_rim_and_rail(run)['shoes_driving'][-1, run.locomotive - 1] > LEAST_J for run in runs)
    return '; '.join(words) or 'what is stored between the two'


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
