#!/usr/bin/env python3
"""A wheelset's distance from the track's centre is found again from where it is in the locomotive's frame."""
import unittest

import numpy as np
import rosunit

from train_viz.track_shape import TrackShape

LISTS = '''
track:
  curves:
    - {start_km: 1, radius_m: 300, direction: %s, transition_in_m: 50, circular_m: 200, transition_out_m: 50, cant_mm: %s}
'''
TABLE = '''
track:
  between_rows: {grade: constant, curvature: linear}
  table: |
    # radius: left +
    chainage_km, grade_permille, radius_m, cant_mm, speed_limit_kmph
    0.00, 0,   0,  0, 80
    1.00, 0,   0,  0, 80
    1.05, 0, 300, 60, 80
    1.25, 0, 300, 60, 80
    1.30, 0,   0,  0, 80
'''
AHEAD_M = np.array([8.5, 4.8, -6.6, -8.5])
LATERAL_M = np.array([-6e-3, 1e-3, 3e-3, 0.0])
HEIGHT_M = np.full(4, 0.5335)


def distances(resolved, place_m, x_m, y_m):
    return TrackShape(resolved).lateral_m(np.full(4, place_m), x_m, y_m, HEIGHT_M)


class TrackShapeTest(unittest.TestCase):
    def test_on_straight_track_it_is_the_lateral_coordinate(self):
        for resolved in ('', '{}', LISTS % ('left', 0), TABLE):
            np.testing.assert_allclose(distances(resolved, 500.0, AHEAD_M, LATERAL_M), LATERAL_M, atol=1e-15)

    def test_on_a_circle_what_the_track_has_turned_is_taken_off(self):
        for way, sign in (('left', 1.0), ('right', -1.0)):
            angle = AHEAD_M / 300.0
            x = 300.0 * np.sin(angle) - sign * LATERAL_M * np.sin(angle)
            y = sign * 300.0 * (1.0 - np.cos(angle)) + LATERAL_M * np.cos(angle)
            self.assertGreater(np.abs(y).max(), 0.11)
            # 1e-6: trapezoids of 0.2 m
            np.testing.assert_allclose(distances(LISTS % (way, 0), 1150.0, x, y), LATERAL_M, atol=1e-6)

    def test_in_a_transition_it_bends_with_the_cube(self):
        # kappa = s / (300 * 50): from its start on y = s^3/6 of that, and nothing behind
        y = np.where(AHEAD_M > 0.0, AHEAD_M ** 3 / 6.0 / 15000.0, 0.0)
        for resolved in (LISTS % ('left', 0), TABLE.replace(' 60,', ' 0,')):
            np.testing.assert_allclose(distances(resolved, 1000.0, AHEAD_M, y), 0.0, atol=1e-5)

    def test_a_track_that_leans_more_further_on_does_not_count(self):
        # left curve: the right rail goes up, so what stands above the track there is moved to the left in the first frame
        y = np.where(AHEAD_M > 0.0, AHEAD_M ** 3 / 6.0 / 15000.0, 0.0)
        lean = np.where(AHEAD_M > 0.0, AHEAD_M / 50.0 * 0.060 / 1.5, 0.0)
        for resolved in (LISTS % ('left', 60), TABLE):
            np.testing.assert_allclose(distances(resolved, 1000.0, AHEAD_M, y + 0.5335 * lean), 0.0, atol=1e-5)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_track_shape', TrackShapeTest)
