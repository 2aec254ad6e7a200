#!/usr/bin/env python3
"""The figures of the 3D locomotive's wheels show every wheel once, with units, and where contacts come and go."""
import dataclasses
import os
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt

from synthetic_bag import AXLES, write_bag
from train_viz.bag_reader import read_bag
from train_viz.displacement_figure import draw_wheelset_displacement
from train_viz.guiding_figures import bogies, draw_guiding_forces, draw_wheel_contacts


def legend_texts(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


class GuidingFiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, 'run.bag')
            write_bag(path, '3d', duration_s=60.0, with_wheels=(1,), contacts=True)
            cls.run_3d = read_bag(path)
            cls.wheels = cls.run_3d.adhesion.wheels

    def setUp(self):
        self.addCleanup(plt.close, 'all')

    def assert_wheels(self, panels, values):
        """A line for each wheel of the bogie's three: left, right, left, ..."""
        for axes, first in zip(panels, (0, 3)):
            lines = [line for line in axes.get_lines() if len(line.get_xdata()) > 2]
            self.assertEqual([line.get_linestyle() for line in lines], ['-', '--'] * 3)
            for i, line in enumerate(lines):
                np.testing.assert_allclose(line.get_ydata(), values[:, first + i // 2, i % 2], rtol=1e-12)
                np.testing.assert_allclose(line.get_xdata(), self.run_3d.adhesion.location_km, rtol=1e-12)
            self.assertEqual(len({line.get_color() for line in lines}), 3)
        self.assertEqual(panels[0].get_ylim(), panels[1].get_ylim())

    def test_guiding_force_in_kN_and_its_ratio_for_every_wheel(self):
        figure = draw_guiding_forces(self.run_3d)
        self.assert_wheels(figure.axes[:2], self.wheels.guiding_force_N / 1e3)
        self.assert_wheels(figure.axes[2:], self.wheels.lateral_over_vertical)
        self.assertEqual([figure.axes[i].get_ylabel() for i in (0, 2)], ['guiding force Y [kN]', 'Y/Q, L/V [-]'])
        self.assertEqual([axes.get_title() for axes in figure.axes[:2]], ['wheelsets 1 to 3', 'wheelsets 4 to 6'])
        self.assertIn('outward > 0', figure.legends[0].get_title().get_text())
        self.assertEqual(legend_texts(figure), ['first wheelset of the bogie', 'second wheelset of the bogie',
                                                'third wheelset of the bogie', 'left wheel', 'right wheel'])

    def test_t_gamma_and_where_contacts_are_not_one(self):
        figure = draw_wheel_contacts(self.run_3d)
        self.assert_wheels(figure.axes[:2], self.wheels.t_gamma_N / 1e3)
        place = self.run_3d.adhesion.location_km
        front, rear = ([path.get_extents() for bars in axes.collections for path in bars.get_paths()]
                       for axes in figure.axes[2:])
        (two,), (none,) = front, rear
        np.testing.assert_allclose((two.x0, two.x1, two.y0, two.y1), (place[100], place[200], 0.62, 1.38), rtol=1e-9)
        np.testing.assert_allclose((none.x0, none.x1, none.y0, none.y1), (place[300], place[-1], 3.62, 4.38), rtol=1e-9)
        self.assertEqual([label.get_text() for label in figure.axes[2].get_yticklabels()],
                         ['1 left', '1 right', '2 left', '2 right', '3 left', '3 right'])
        self.assertEqual(legend_texts(figure)[-2:], ['no contact', 'two contacts'])

    def test_wheelsets_are_drawn_at_their_own_places_in_mm_to_the_left(self):
        figure = draw_wheelset_displacement(self.run_3d)
        wheels = self.run_3d.adhesion
        place_m = np.interp(wheels.wheelsets.time_s, wheels.time_s, wheels.location_m)
        np.testing.assert_allclose(wheels.wheelsets.time_s, wheels.time_s[::10], atol=1e-9)
        for bogie, axes in enumerate(figure.axes):
            lines = [line for line in axes.get_lines() if len(line.get_xdata()) > 2]
            self.assertEqual([line.get_label() for line in lines], [f'wheelset {3 * bogie + i}' for i in (1, 2, 3)])
            straight = place_m < 3280.0  # the bag's poses are those of straight track
            self.assertGreater(straight.sum(), 100)
            for i, line in enumerate(lines):
                axle = 3 * bogie + i
                np.testing.assert_allclose(line.get_xdata(), (place_m + 7.0 - 3.0 * axle) / 1e3, rtol=1e-12)
                np.testing.assert_allclose(line.get_ydata()[straight], (1e-2 * np.arange(len(place_m)) + axle)[straight],
                                           rtol=1e-9, atol=1e-9)
            self.assertEqual(axes.get_ylabel(), 'to the left [mm]')
        self.assertIn('to the right < 0', figure.legends[0].get_title().get_text())

    def test_displacement_axis_holds_every_wheelset_and_does_not_enlarge_round_off(self):
        place_m = self.run_3d.adhesion.wheelsets.location_m
        axes = draw_wheelset_displacement(self.run_3d).axes[0]
        np.testing.assert_allclose(axes.get_xlim(), (place_m.min() / 1e3, place_m.max() / 1e3), rtol=1e-12)
        flat = dataclasses.replace(self.run_3d.adhesion.wheelsets, lateral_m=np.full_like(place_m, 1e-7))
        run = dataclasses.replace(self.run_3d, adhesion=dataclasses.replace(self.run_3d.adhesion, wheelsets=flat))
        self.assertEqual(draw_wheelset_displacement(run).axes[0].get_ylim(), (-1.0, 1.0))

    def test_wheels_with_one_contact_all_the_time_get_no_empty_panel(self):
        one = dataclasses.replace(self.wheels, contacts=np.ones_like(self.wheels.contacts))
        run = dataclasses.replace(self.run_3d, adhesion=dataclasses.replace(self.run_3d.adhesion, wheels=one))
        figure = draw_wheel_contacts(run)
        self.assertEqual(len(figure.axes), 2)
        self.assertIn('one contact all the time', figure.legends[0].get_title().get_text())

    def test_six_axles_are_two_bogies(self):
        self.assertEqual([list(axles) for axles in bogies(self.run_3d.adhesion)], [[0, 1, 2], [3, 4, 5]])
        self.assertEqual(AXLES, 6)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_guiding_figures', GuidingFiguresTest)
