#!/usr/bin/env python3
"""The figures over place show what the bag holds, with units, and the limits that a force comes near."""
import os
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt

from synthetic_bag import RESOLVED, write_bag
from train_viz.bag_reader import read_bag
from train_viz.place_figures import draw_energy, draw_speed_notch, draw_traction_force


class PlaceFiguresTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.addCleanup(plt.close, 'all')
        self.bag = os.path.join(directory.name, 'run.bag')

    def test_locomotive_asked_for_is_drawn_and_named(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag, 2)
        run.traction_N[:, 1] = 7e3
        run.loco_energy_rail_J[:, 1] = 5e6
        traction, energy = draw_traction_force([run]).axes[0], draw_energy([run])
        self.assertEqual(set(traction.get_lines()[0].get_ydata()), {7.0})
        self.assertEqual(traction.get_title(), 'Traction force of locomotive 2')
        self.assertEqual(set(energy.axes[0].get_lines()[0].get_ydata()), {5.0})
        self.assertEqual(energy._suptitle.get_text(), 'Energy of locomotive 2')

    def test_rail_sections_are_shaded_and_named(self):
        write_bag(self.bag, duration_s=60.0, resolved='rail_sections: [{from_km: 3.02, to_km: 3.05, adhesion: {name: wet}}]')
        axes = draw_traction_force([read_bag(self.bag)]).axes[0]
        self.assertEqual([text.get_text() for text in axes.texts], ['wet'])
        spans = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
        for span in spans:
            np.testing.assert_allclose((span.x0, span.x1), (3.02, 3.05), rtol=1e-9)
        self.assertEqual(len(spans), 2)

    def test_energy_has_one_mark_where_a_run_ends_at_the_end_of_a_curve(self):
        for beyond_m, marks in ((0.2, 1), (40.0, 2)):
            write_bag(self.bag, duration_s=1.0)
            run = read_bag(self.bag)
            run.location_m[:] = np.linspace(3000.0, 3600.0 + beyond_m, len(run.location_m))
            line, points = draw_energy([run]).axes[0].get_lines()
            self.assertEqual((len(points.get_xdata()), line.get_label().count(' MJ at ')), (marks, marks))

    def test_traction_is_in_kN_over_km_with_the_limit(self):
        written = write_bag(self.bag, duration_s=60.0)
        axes = draw_traction_force([read_bag(self.bag)]).axes[0]
        traction, limit = axes.get_lines()
        np.testing.assert_allclose(traction.get_xdata(), written['location'] / 1e3, rtol=1e-12)
        np.testing.assert_allclose(traction.get_ydata(), written['traction'] / 1e3, rtol=1e-12)
        np.testing.assert_allclose(limit.get_ydata(), 460.089, rtol=1e-12)

    def test_adhesion_limit_is_marked_on_the_sides_that_come_near_it(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag)
        for low, high, marks, words in ((0.0, 460e3, [460.089], 'adhesion limit 0.35 m g = 460.1 kN'),
                                        (-300e3, 460e3, [460.089, -460.089], 'adhesion limit \u00b10.35 m g = \u00b1460.1 kN'),
                                        (-300e3, 0.0, [-460.089], 'adhesion limit -0.35 m g = -460.1 kN'),
                                        (-100e3, 0.0, [], 'adhesion limit 0.35 m g = 460.1 kN, beyond the axis')):
            run.traction_N[:, 0] = np.linspace(low, high, len(run.time_s))
            figure = draw_traction_force([run])
            axes = figure.axes[0]
            drawn = [line for line in axes.get_lines() if line.get_linestyle() == '--']
            np.testing.assert_allclose([line.get_ydata()[0] for line in drawn], marks, rtol=1e-12)
            self.assertIn(words, [text.get_text() for text in figure.legends[0].get_texts()])
            self.assertEqual('braking < 0' in axes.get_ylabel(), low < 0.0)
            for mark in marks:
                self.assertTrue(axes.get_ylim()[0] <= mark <= axes.get_ylim()[1])
            self.assertEqual(axes.get_ylim()[1] < 460.0, 460.089 not in marks)

    def test_run_without_traction_has_no_energy_picture_and_speed_alone(self):
        write_bag(self.bag, duration_s=10.0)
        run = read_bag(self.bag)
        self.assertEqual(len(draw_speed_notch([run]).axes), 2)
        for values in (run.loco_energy_rail_J, run.loco_energy_rim_J, run.notch):
            values[:] = 0.0
        self.assertIsNone(draw_energy([run]))
        speed, = draw_speed_notch([run]).axes
        self.assertIn('notch is 0', speed.get_title())

    def test_names_of_many_curves_stand_upright_and_none_is_missing(self):
        curve = '    - {start_km: %.3f, radius_m: %d, direction: left, circular_m: 10}\n'
        head, end = RESOLVED % {'scenario': 's', 'locos': 3, 'wagons': 5}, 3.5
        head = head[:head.index('    - {start_km')]
        for count, rotation in ((3, 0.0), (18, 90.0)):
            write_bag(self.bag, end_km=end, resolved=head + ''.join(
                curve % (3.02 + 0.46 / count * i, 300 + i) for i in range(count)))
            figure = draw_traction_force([read_bag(self.bag)])
            names = [text for text in figure.axes[0].texts if text.get_text().startswith('R3')]
            self.assertEqual([text.get_text() for text in names], [f'R{300 + i}' for i in range(count)])
            self.assertEqual({text.get_rotation() for text in names}, {rotation})
            figure.draw_without_rendering()
            boxes = [text.get_window_extent() for text in names]
            for one, other in zip(boxes, [*boxes[1:], figure.axes[0].title.get_window_extent()]):
                self.assertFalse(one.overlaps(other))

    def test_axis_says_where_axles_meet_other_rail_of_runs_with_wheels(self):
        bodies = 'bodies: {bogie_frames: {x_m: 6.5}, wheelsets: {x_m: [1.5, 0.0, -1.5]}}, '
        wet = (RESOLVED % {'scenario': 's', 'locos': 3, 'wagons': 5}).replace('mass_kg: 134000', bodies + 'mass_kg: 134000')
        for place, wheels, noted in ((3.2, (1,), True), (3.2, (), False), (7.0, (1,), False)):
            write_bag(self.bag, with_wheels=wheels, resolved=wet + f'rail_sections: [{{from_km: {place}, to_km: {place + 0.1}}}]\n')
            label = draw_traction_force([read_bag(self.bag)]).axes[0].get_xlabel()
            self.assertEqual('its axles meet the hatched rail at their own places, up to 8.0 m earlier or later' in label, noted)

    def test_energy_is_in_MJ_and_kWh(self):
        written = write_bag(self.bag, duration_s=60.0)
        figure = draw_energy([read_bag(self.bag)])
        figure.canvas.draw()
        place, speed = figure.axes[:2]
        for axes, x in ((place, written['location'] / 1e3), (speed, written['speed'] * 3.6)):
            np.testing.assert_allclose(axes.get_lines()[0].get_xdata(), x, rtol=1e-12)
            np.testing.assert_allclose(axes.get_lines()[0].get_ydata(), written['work'] / 1e6, rtol=1e-12)
        kwh, = speed.child_axes
        np.testing.assert_allclose(kwh.get_ylim(), np.array(speed.get_ylim()) * 1e6 / 3.6e6, rtol=1e-12)

    def test_energy_shows_the_rim_only_where_it_differs(self):
        for slip, lines in ((0.0, ['-']), (0.1, ['-', '--'])):
            write_bag(self.bag, slip=slip, limit_N=50e3, duration_s=60.0)
            drawn = draw_energy([read_bag(self.bag)]).axes[0].get_lines()
            self.assertEqual([line.get_linestyle() for line in drawn if line.get_linestyle() != 'None'], lines)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_place_figures', PlaceFiguresTest)
