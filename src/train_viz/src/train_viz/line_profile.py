"""The line in elevation, from the resolved scenario: height above the track's start, and the curvature beside it."""
import csv
from typing import List, Optional, Tuple

import numpy as np

from train_viz.resolved_scenario import read_value
from train_viz.track_shape import TrackShape

STEP_M = 5.0  # chosen: finer than a pixel of a line of 10 km


def height_profile(resolved: str, from_m: float, to_m: float) -> Optional[Tuple[np.ndarray, np.ndarray]]:
    """Places [m] and heights [m] above the first; None if the scenario's grades are not understood."""
    try:
        points = _grades(resolved)
    except (KeyError, TypeError, ValueError):
        return None
    if not points:
        return None
    s_m, grade = (np.array(column) for column in zip(*points))
    place = np.linspace(from_m, to_m, max(int((to_m - from_m) / STEP_M), 200) + 1)
    place = np.unique(np.concatenate((place, s_m[(s_m > from_m) & (s_m < to_m)])))
    middle = 0.5 * (place[1:] + place[:-1])  # between break points the grade is linear: its middle is its mean
    return place, np.concatenate(([0.0], np.cumsum(np.interp(middle, s_m, grade) * np.diff(place))))


def curvature_profile(resolved: str, from_m: float, to_m: float) -> Tuple[np.ndarray, np.ndarray]:
    """Places [m] and curvature [1/m], + left; straight if the scenario's curves are not understood."""
    try:
        shape = TrackShape(resolved)
        s_m, curvature = shape.s_m, shape.curvature_1pm
    except (KeyError, TypeError, ValueError):
        s_m, curvature = np.zeros(1), np.zeros(1)
    inside = (s_m > from_m) & (s_m < to_m)
    return (np.concatenate(([from_m], s_m[inside], [to_m])),
            np.concatenate(([np.interp(from_m, s_m, curvature)], curvature[inside], [np.interp(to_m, s_m, curvature)])))


def _grades(resolved: str) -> List[Tuple[float, float]]:
    """Break points of the grade [-], linear between them; steps are two points at one place."""
    text = read_value(resolved, 'track', 'table')
    if text is None:
        entries = [(1e3 * float(entry['from_km']), 1e-3 * float(entry['grade_permille']))
                   for entry in read_value(resolved, 'track', 'grades') or []]
        linear = False
    else:
        rows = csv.DictReader((line for line in text.splitlines() if line.strip() and not line.lstrip().startswith('#')),
                              skipinitialspace=True)
        entries = [(1e3 * float(row['chainage_km']), 1e-3 * float(row['grade_permille'])) for row in rows]
        linear = read_value(resolved, 'track', 'between_rows', 'grade') == 'linear'
    points: List[Tuple[float, float]] = []
    for s, grade in entries:
        if points and not linear:
            points.append((s - 1e-6, points[-1][1]))  # np.interp needs places that rise
        points.append((s, grade))
    return points
