"""The line in plan near a place, from the resolved scenario: what a body's distance from the track's centre is taken from."""
import csv
from typing import List, Tuple

import numpy as np

from train_viz.resolved_scenario import read_value

RAIL_DISTANCE_M = 1.5  # over which cant is measured, as in the locomotives
POINTS = 41            # chosen: from a locomotive's middle to its last axle every 0.2 m


class TrackShape:
    """Curvature (+ left) and the track's roll from cant (+ left rail up), both linear between break points."""

    def __init__(self, resolved: str):
        points = _from_lists(read_value(resolved, 'track', 'curves')) or _from_table(
            read_value(resolved, 'track', 'table'), read_value(resolved, 'track', 'between_rows', 'curvature') == 'linear')
        self.s_m, self.curvature_1pm, self.roll_rad = (np.array(column) for column in zip(*(points or [(0.0, 0.0, 0.0)])))

    def lateral_m(self, from_m: np.ndarray, x_m: np.ndarray, y_m: np.ndarray, z_m: np.ndarray) -> np.ndarray:
        """Distance + left from the centre line of points given in the track's frames at places `from_m`."""
        ahead_m = x_m
        for _ in range(3):  # the chord is shorter than the way by 1 mm in R300: each round finds the foot far more closely
            heading, along_m, across_m = self._stretch(from_m, ahead_m)
            ahead_m = ahead_m + (x_m - along_m) * np.cos(heading) + (y_m - across_m) * np.sin(heading)
        heading, along_m, across_m = self._stretch(from_m, ahead_m)
        roll = np.interp(from_m + ahead_m, self.s_m, self.roll_rad) - np.interp(from_m, self.s_m, self.roll_rad)
        return (y_m - across_m) * np.cos(heading) - (x_m - along_m) * np.sin(heading) + z_m * roll

    def _stretch(self, from_m: np.ndarray, ahead_m: np.ndarray) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Heading, and place along and across the first tangent, of the centre line ahead_m further on."""
        part = np.linspace(0.0, 1.0, POINTS)
        step_m = ahead_m[:, None] / (POINTS - 1)
        heading = _integral(np.interp(from_m[:, None] + ahead_m[:, None] * part, self.s_m, self.curvature_1pm), step_m)
        return heading[:, -1], _integral(np.cos(heading), step_m)[:, -1], _integral(np.sin(heading), step_m)[:, -1]


def _integral(values: np.ndarray, step_m: np.ndarray) -> np.ndarray:
    """From the first column as far as each, by the trapezoidal rule."""
    whole = np.zeros_like(values)
    whole[:, 1:] = np.cumsum(0.5 * (values[:, 1:] + values[:, :-1]) * step_m, axis=1)
    return whole


Points = List[Tuple[float, float, float]]


def _from_lists(curves) -> Points:
    points: Points = []
    for curve in curves or []:
        left = 1.0 if curve['direction'] == 'left' else -1.0
        full = (left / float(curve['radius_m']), -left * 1e-3 * float(curve.get('cant_mm', 0.0)) / RAIL_DISTANCE_M)
        s = 1e3 * float(curve['start_km'])
        for length, values in (('transition_in_m', (0.0, 0.0)), ('circular_m', full), ('transition_out_m', full)):
            points.append((s, *values))
            s += float(curve['circular_m'] if length == 'circular_m' else curve.get(length, 0.0))
            points.append((s, *(full if length != 'transition_out_m' else (0.0, 0.0))))
    return points


def _from_table(text, linear: bool) -> Points:
    rows = csv.DictReader((line for line in (text or '').splitlines() if line.strip() and not line.lstrip().startswith('#')),
                          skipinitialspace=True)
    points: Points = []
    for row in rows:
        radius = float(row['radius_m'])
        curvature = 1.0 / radius if radius else 0.0
        here = (1e3 * float(row['chainage_km']), curvature,
                -np.sign(curvature) * 1e-3 * float(row['cant_mm']) / RAIL_DISTANCE_M)
        if points and not linear:
            points.append((here[0], *points[-1][1:]))
        points.append(here)
    return points
