"""What the figures need from the resolved scenario text: the track's curves, the adhesion limit and the slip limit.

The program that ran the scenario has checked it strictly; here whatever is not found is left out.
"""
import csv
import dataclasses
import functools
from typing import Any, Iterator, List, Optional, Tuple

import yaml

GRAVITY_MPS2 = 9.81  # as in rail_core/constants.hpp


@dataclasses.dataclass(frozen=True)
class Curve:
    """A curve by chainage [m] in running direction. The transitions are start-full_from and full_to-end."""
    start_m: float
    full_from_m: float
    full_to_m: float
    end_m: float
    radius_m: float  # of the tightest part, > 0

    @property
    def label(self) -> str:
        return f'R{self.radius_m:.0f}'


def read_curves(resolved: str) -> List[Curve]:
    """All curves of the scenario's track, in order; none if the text has no track that we understand."""
    track = _lookup(_load(resolved), 'track')
    try:
        if _lookup(track, 'curves') is not None:
            return [_curve_from_list_entry(entry) for entry in track['curves']]
        if _lookup(track, 'table') is not None:
            return _curves_from_table(track['table'], _lookup(track, 'between_rows', 'curvature'))
    except (KeyError, TypeError, ValueError):
        pass
    return []


def read_rail_sections(resolved: str) -> List[Tuple[float, float, str]]:
    """Stretches with a rail of their own: from [m], to [m], the name of the adhesion as far as its first comma."""
    try:
        return [(1000.0 * float(section['from_km']), 1000.0 * float(section['to_km']),
                 str(_lookup(section, 'adhesion', 'name') or 'other rail').split(',')[0].strip())
                for section in _lookup(_load(resolved), 'rail_sections') or []]
    except (KeyError, TypeError, ValueError):
        return []


def read_adhesion_limit(resolved: str, locomotive: int = 1) -> Optional[Tuple[float, float]]:
    """A locomotive's adhesion limit as (coefficient [-], force [N]), or None.

    @param locomotive from 1 at the head
    """
    groups = _lookup(_load(resolved), 'train', 'groups')
    try:  # float(), as PyYAML takes 1.34e5 for a text
        vehicle = _locomotive(groups, locomotive)
        coefficient = float(_lookup(vehicle, 'adhesion_limit'))
        mass_kg = float(_lookup(vehicle, 'mass_kg'))
    except (TypeError, ValueError):
        return None
    return coefficient, coefficient * mass_kg * GRAVITY_MPS2


def read_slip_limit(resolved: str) -> Optional[float]:
    """The creep that adhesion control holds [-], > 0, or None without such a controller."""
    try:
        return float(_lookup(_load(resolved), 'control', 'slip_limit'))
    except (TypeError, ValueError):
        return None


def read_value(resolved: str, *path: Any) -> Any:
    """The value at a path of keys and indices, or None; numbers as YAML's reader gives them."""
    return _lookup(_load(resolved), *path)


def read_locomotive_value(resolved: str, locomotive: int, *path: Any) -> Any:
    """The value at a path within a locomotive, from 1 at the head, or None."""
    try:
        return _lookup(_locomotive(_lookup(_load(resolved), 'train', 'groups'), locomotive), *path)
    except (TypeError, ValueError):
        return None


def read_axle_reach(resolved: str, locomotive: int) -> Optional[float]:
    """How far a locomotive's outermost axles are from its middle [m], or None without bodies that we understand."""
    bodies = read_locomotive_value(resolved, locomotive, 'bodies')
    try:
        return float(_lookup(bodies, 'bogie_frames', 'x_m')) + max(map(float, _lookup(bodies, 'wheelsets', 'x_m')))
    except (TypeError, ValueError):
        return None


def read_vehicles(resolved: str) -> List[Tuple[int, Any]]:
    """Count and vehicle of each group from the head; none if the text has no train that we understand."""
    try:
        found = list(_vehicles(_lookup(_load(resolved), 'train', 'groups')))
    except (TypeError, ValueError):
        return []
    return found if all(isinstance(vehicle, dict) for _, vehicle in found) else []


def _locomotive(groups: List[dict], number: int) -> Any:
    """The vehicle of the number-th locomotive; only locomotives have an adhesion limit."""
    for count, vehicle in _vehicles(groups):
        if _lookup(vehicle, 'adhesion_limit') is not None:
            if number <= count:
                return vehicle
            number -= count
    return None


def _vehicles(groups: List[dict]) -> Iterator[Tuple[int, Any]]:
    """Count and vehicle from the head; groups may repeat a list of groups."""
    for group in groups:
        inner = _lookup(group, 'groups')
        if isinstance(inner, list):
            for _ in range(int(_lookup(group, 'repeat') or 1)):
                yield from _vehicles(inner)
        else:
            yield int(_lookup(group, 'count') or 1), _lookup(group, 'vehicle')


@functools.lru_cache(maxsize=8)  # long tables of tracks take seconds
def _load(text: str) -> Any:
    try:
        return yaml.safe_load(text)
    except yaml.YAMLError:
        return None


def _lookup(node: Any, *path: Any) -> Any:
    """The node at a path of keys and indices, or None."""
    for key in path:
        try:
            node = node[key]
        except (KeyError, IndexError, TypeError):
            return None
    return node


def _curve_from_list_entry(entry: dict) -> Curve:
    start = 1000.0 * float(entry['start_km'])
    full_from = start + float(entry.get('transition_in_m', 0.0))
    full_to = full_from + float(entry['circular_m'])
    end = full_to + float(entry.get('transition_out_m', 0.0))
    return Curve(start, full_from, full_to, end, abs(float(entry['radius_m'])))


Piece = Tuple[float, float, float, float]  # from [m], to [m], curvature at either end [1/m]


def _curves_from_table(text: str, between_rows: Optional[str]) -> List[Curve]:
    """A curve is a row of consecutive pieces that bend to one side."""
    curves: List[Curve] = []
    bend: List[Piece] = []
    for piece in _table_pieces(text, between_rows == 'linear'):
        _, _, k0, k1 = piece
        if bend and bend[-1][3] * (k0 + k1) <= 0.0:
            curves.append(_curve_from_pieces(bend))
            bend = []
        if k0 or k1:
            bend.append(piece)
    return curves + ([_curve_from_pieces(bend)] if bend else [])


def _table_pieces(text: str, linear: bool) -> Iterator[Piece]:
    """The table's curvature from row to row: ramped if `linear`, otherwise a row's value holds until the next."""
    rows = csv.DictReader((line for line in text.splitlines() if line.strip() and not line.lstrip().startswith('#')),
                          skipinitialspace=True)
    points = [(1000.0 * float(row['chainage_km']), float(row['radius_m'])) for row in rows]
    points = [(s, 1.0 / radius if radius else 0.0) for s, radius in points]
    for (s0, k0), (s1, k1) in zip(points, points[1:]):
        if s1 == s0:
            continue  # a jump, not a piece
        k1 = k1 if linear else k0
        if k0 * k1 < 0.0:  # from a left to a right curve or back: part it where it is straight
            middle = s0 + (s1 - s0) * k0 / (k0 - k1)
            yield s0, middle, k0, 0.0
            s0, k0 = middle, 0.0
        yield s0, s1, k0, k1


def _curve_from_pieces(pieces: List[Piece]) -> Curve:
    tightest = max(abs(k) for _, _, k0, k1 in pieces for k in (k0, k1))
    full = [s for s0, s1, k0, k1 in pieces for s, k in ((s0, k0), (s1, k1)) if abs(k) == tightest]
    return Curve(pieces[0][0], min(full), max(full), pieces[-1][1], 1.0 / tightest)
