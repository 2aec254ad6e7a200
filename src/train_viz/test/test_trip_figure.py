#!/usr/bin/env python3
"""The figure of a trip: panels for what changes under this run, and nothing else."""
import dataclasses
import os
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt

from synthetic_bag import write_bag
from train_viz.bag_reader import read_bag
from train_viz.line_profile import height_profile
from train_viz.trip_figure import draw_trip, stops


class TripFigureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, 'run.bag')
            cls.written = write_bag(path, slip=0.1, limit_N=50e3, brake_from_s=40.0, air_brake=True)
            cls.braked = read_bag(path)
            write_bag(path, duration_s=10.0)
            cls.plain = read_bag(path)

    def setUp(self):
        self.addCleanup(plt.close, 'all')

    def test_trip_has_speed_limit_notches_pressures_and_the_line(self):
        there = dataclasses.replace(self.braked, location_m=self.braked.location_m + 200.0,  # into the curve
                                    speed_limit_mps=self.braked.speed_limit_mps.copy())
        there.speed_limit_mps[:5] = 70.0 / 3.6  # a limit that changes
        speed, notch, pressure, line = draw_trip(there).axes
        drawn, limit = speed.get_lines()[:2]
        self.assertEqual(set(np.round(limit.get_ydata(), 9)), {70.0, 80.0})
        np.testing.assert_allclose(drawn.get_ydata(), 3.6 * self.written['speed'], rtol=1e-12)
        self.assertEqual({value for line in notch.get_lines()[:2] for value in line.get_ydata()},
                         {0.0, 1.0, 2.0, 3.0, 4.0, -5.0, -0.0})
        self.assertEqual([text.get_text() for text in pressure.get_legend().get_texts()],
                         ['pipe, vehicle 1', 'pipe, vehicle 8', 'cylinder, vehicle 4', 'cylinder, vehicle 8'])
        self.assertEqual(line.get_ylabel()[:9], 'curvature')  # no heights: the track has no grades
        self.assertEqual([axes.get_ylabel() for axes in draw_trip(self.plain).axes], ['speed [km/h]', 'notch'])

    def test_trip_leaves_out_what_does_not_change_and_says_so(self):
        run = dataclasses.replace(self.plain, resolved=self.plain.resolved.replace('  curves:', '  grades: [{from_km: 0, '
                                  'grade_permille: 0}]\n  curves:'), notch=np.zeros_like(self.plain.notch))
        figure = draw_trip(run)
        speed, = figure.axes
        self.assertIn('level and straight', figure._suptitle.get_text())
        self.assertEqual([text.get_text() for text in speed.get_legend().get_texts()],
                         ['speed', 'speed limit 80 km/h all the way, beyond the axis'])
        self.assertLess(speed.get_ylim()[1], 20.0)
        self.assertNotIn('level', draw_trip(dataclasses.replace(run, resolved=''))._suptitle.get_text())  # not understood
        near = dataclasses.replace(run, speed_mps=run.speed_mps + 20.0).speed_mps
        speed, = draw_trip(dataclasses.replace(run, speed_mps=near)).axes
        self.assertIn('lowest speed limit under the train', [text.get_text() for text in speed.get_legend().get_texts()])

    def test_trip_on_a_grade_has_heights_and_in_a_curve_on_the_level_curvature_alone(self):
        graded = self.plain.resolved.replace('  curves:', '  grades: [{from_km: 0, grade_permille: 10}]\n  curves:')
        *_, line = draw_trip(dataclasses.replace(self.plain, resolved=graded)).axes
        self.assertEqual(line.get_ylabel(), 'height [m]')
        level = graded.replace('permille: 10', 'permille: 0')
        there = dataclasses.replace(self.plain, resolved=level, location_m=self.plain.location_m + 360.0)
        *_, line = draw_trip(there).axes
        self.assertEqual(line.get_ylabel()[:9], 'curvature')
        np.testing.assert_allclose(max(line.get_lines()[0].get_ydata()), 1e3 / 300.0, rtol=1e-6)

    def test_stops_are_told_with_their_length(self):
        speed = self.braked.speed_mps.copy()
        speed[500:1000] = 0.0
        (place, seconds), = stops(dataclasses.replace(self.braked, speed_mps=speed))
        self.assertAlmostEqual(place, self.braked.location_m[500], places=9)
        self.assertAlmostEqual(seconds, 499 * 0.02, places=9)

    def test_heights_are_the_integral_of_the_grades(self):
        listed = 'track: {grades: [{from_km: 0, grade_permille: 10}, {from_km: 1, grade_permille: -5}]}'
        tabled = ('track: {between_rows: {grade: linear}, table: "chainage_km,grade_permille\\n0,0\\n1,10\\n2,10\\n"}')
        for resolved, place_m, height_m in ((listed, 1500.0, 7.5), (tabled, 1000.0, 5.0), (tabled, 1500.0, 10.0)):
            place, height = height_profile(resolved, 0.0, 2000.0)
            self.assertAlmostEqual(np.interp(place_m, place, height), height_m, delta=1e-3)
        self.assertIsNone(height_profile('', 0.0, 1.0))


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_trip_figure', TripFigureTest)
