"""Whether a run is one of the paper's case: its train, its line and where it starts. Nothing here knows ROS."""
import itertools
from typing import List, Tuple

from train_viz import paper_values as paper
from train_viz.resolved_scenario import read_curves, read_value, read_vehicles

Sets = List[Tuple[int, float]]  # number of vehicles and mass of each [kg], from the head


def differences(resolved: str) -> List[str]:
    """What is not as in the paper's case, in words; nothing of a run that is one, with whatever model of locomotive."""
    found = []
    train = _sets(resolved)
    if train != paper.TRAIN:
        found.append(f'its train is {_train_words(train)}, not {_train_words(paper.TRAIN)}')
    curves = [(curve.start_m / 1e3, curve.end_m / 1e3, curve.radius_m) for curve in read_curves(resolved)]
    if curves != paper.CURVES:
        found.append(f'its line has {_curves_words(curves)}, not {_curves_words(paper.CURVES)}')
    start = _number(read_value(resolved, 'run', 'start_location_km'))
    if start != paper.START_KM:
        found.append(f'it starts at {start:g} km, not {paper.START_KM:g} km')
    return found


def _sets(resolved: str) -> Sets:
    vehicles = [(count, _number(vehicle.get('mass_kg'))) for count, vehicle in read_vehicles(resolved)]
    return [(sum(count for count, _ in those), mass) for mass, those in itertools.groupby(vehicles, lambda pair: pair[1])]


def _number(value) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return float('nan')


def _train_words(train: Sets) -> str:
    if len(train) > 4:
        return f'{sum(count for count, _ in train)} vehicles of {len({mass for _, mass in train})} masses'
    return ' + '.join(f'{count} x {mass / 1e3:g} t' for count, mass in train) or 'not understood'


def _curves_words(curves: List[Tuple[float, float, float]]) -> str:
    if len(curves) > 2:
        return f'{len(curves)} curves'
    return ' and '.join(f'R{radius:.0f} from {start:g} to {end:g} km' for start, end, radius in curves) or 'no curve'
