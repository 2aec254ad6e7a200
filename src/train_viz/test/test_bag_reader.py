#!/usr/bin/env python3
"""A bag becomes arrays with the numbers that were written; bags that are no use are refused with a reason."""
import os
import tempfile
import unittest

import numpy as np
import rosbag
import rosunit
from std_msgs.msg import String

from synthetic_bag import AXLES, write_bag
from train_viz.bag_reader import read_bag
from train_viz.run import ReportError, join_parts
from train_viz.run_labels import labels_of


class BagReaderTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.path = os.path.join(directory.name, 'run.bag')
        self.other = os.path.join(directory.name, 'other.bag')

    def assert_refused(self, path, *words):
        with self.assertRaises(ReportError) as caught:
            read_bag(path)
        message = str(caught.exception)
        self.assertNotIn('\n', message)
        for word in (path,) + words:
            self.assertIn(word, message)

    def test_missing_file_is_refused(self):
        self.assert_refused(self.path, 'no such file')

    def test_empty_file_is_refused(self):
        open(self.path, 'w').close()
        self.assert_refused(self.path, 'empty file')

    def test_text_file_is_refused(self):
        with open(self.path, 'w') as file:
            file.write('not a bag\n' * 100)
        self.assert_refused(self.path, 'not a readable bag')

    def test_bag_that_was_never_closed_is_refused(self):
        write_bag(self.path, duration_s=1.0)
        os.truncate(self.path, os.path.getsize(self.path) // 2)
        self.assert_refused(self.path, 'rosbag reindex')

    def test_bag_without_messages_is_refused(self):
        rosbag.Bag(self.path, 'w').close()
        self.assert_refused(self.path, '/train/state')

    def test_bag_of_something_else_is_refused(self):
        with rosbag.Bag(self.path, 'w') as bag:
            bag.write('/chatter', String('hello'))
        self.assert_refused(self.path, '/train/configuration', '/train/state', '/train/energy')

    def test_other_message_definition_is_refused(self):
        write_bag(self.path, duration_s=1.0)
        with rosbag.Bag(self.path) as old, rosbag.Bag(self.other, 'w') as new:
            for topic, message, stamp in old.read_messages():
                new.write(topic, String() if topic == '/train/state' else message, stamp)
        self.assert_refused(self.other, '/train/state', 'another definition')

    def test_other_format_version_is_refused(self):
        write_bag(self.path, format_version=7, duration_s=1.0)
        self.assert_refused(self.path, 'format_version 7')

    def test_single_instant_is_refused(self):
        write_bag(self.path, duration_s=0.0)
        self.assert_refused(self.path, '1 instant')

    def test_arrays_are_what_was_written(self):
        written = write_bag(self.path, locos=2, wagons=4, limit_N=50e3, slip=0.1, duration_s=60.0)
        run = read_bag(self.path)
        self.assertEqual((run.label, run.run_id, run.files), ('synthetic', 1, (self.path,)))
        for read, name in ((run.time_s, 'time'), (run.location_m, 'location'), (run.speed_mps, 'speed'),
                           (run.coupler_force_N, 'coupler_force')):
            np.testing.assert_array_equal(read, written[name])
        for read, name in ((run.notch, 'notch'), (run.traction_N, 'traction'), (run.loco_energy_rail_J, 'work'),
                           (run.loco_energy_rim_J, 'rim')):
            np.testing.assert_array_equal(read, np.column_stack([written[name]] * 2))
        np.testing.assert_allclose(run.loco_energy_slip_J, np.column_stack([0.9 * (written['rim'] - written['work'])] * 2))
        np.testing.assert_array_equal(run.account['traction_rail'], 2 * written['work'])
        self.assertNotIn('loco_energy_rail', run.account)
        self.assertTrue(run.rim_differs())

    def test_adhesion_is_that_of_the_first_locomotive_with_the_topic(self):
        written = write_bag(self.path, duration_s=5.0, with_wheels=(3, 2))
        adhesion = read_bag(self.path).adhesion
        self.assertEqual((adhesion.locomotive, adhesion.axles), (2, 6))
        np.testing.assert_array_equal(adhesion.time_s, written['time'].round(9))
        np.testing.assert_array_equal(adhesion.location_m, written['location'] - 22.0)
        np.testing.assert_array_equal(adhesion.speed_mps, written['speed'])
        for name, column in (('creep', 'creep'), ('adhesion', 'adhesion'), ('friction', 'friction'),
                             ('static_friction', 'static_friction'), ('normal_force_N', 'normal_force'),
                             ('torque_demanded_N_m', 'torque_demanded'), ('torque_applied_N_m', 'torque_applied'),
                             ('controller_active', 'controller_active'), ('frictional_power_W', 'frictional_power'),
                             ('t_gamma_N', 't_gamma')):
            np.testing.assert_array_equal(getattr(adhesion, name), written['axles'][column], err_msg=name)

    def test_run_of_1d_locomotives_has_no_adhesion(self):
        write_bag(self.path, duration_s=1.0)
        self.assertIsNone(read_bag(self.path).adhesion)

    def test_other_definition_of_adhesion_is_refused(self):
        write_bag(self.path, duration_s=1.0)
        with rosbag.Bag(self.path, 'a') as bag:
            bag.write('/loco_1/adhesion', String())
        self.assert_refused(self.path, '/loco_1/adhesion', 'another definition')

    def test_axles_that_change_in_number_are_refused(self):
        write_bag(self.path, duration_s=1.0, with_wheels=(1,))
        with rosbag.Bag(self.path) as old, rosbag.Bag(self.other, 'w') as new:
            for i, (topic, message, stamp) in enumerate(old.read_messages()):
                if topic == '/loco_1/adhesion' and i > 50:
                    message.axles.pop()
                new.write(topic, message, stamp)
        self.assert_refused(self.other, 'number of axles', 'locomotive 1')

    def test_state_without_energy_at_the_cut_end_is_left_out(self):
        write_bag(self.path, duration_s=1.0)
        with rosbag.Bag(self.path) as whole, rosbag.Bag(self.other, 'w') as cut:
            messages = list(whole.read_messages())
            for topic, message, stamp in messages[:-1]:
                cut.write(topic, message, stamp)
        self.assertEqual(len(read_bag(self.other).time_s), len(read_bag(self.path).time_s) - 1)

    def test_vehicle_alone_has_no_couplers(self):
        write_bag(self.path, locos=1, wagons=0, duration_s=1.0)
        run = read_bag(self.path)
        self.assertEqual(run.coupler_force_N.shape, (len(run.time_s), 0))

    def test_value_at_a_place_is_linear_between_rows(self):
        write_bag(self.path, duration_s=20.0)
        run = read_bag(self.path)
        middle = (run.location_m[500] + run.location_m[501]) / 2.0
        self.assertAlmostEqual(run.at_location(run.time_s, middle), (run.time_s[500] + run.time_s[501]) / 2.0, places=9)

    def test_overlapping_parts_of_one_run_join_to_the_whole(self):
        first = write_bag(self.path, duration_s=10.0, with_wheels=(1,))
        whole = write_bag(self.other, duration_s=20.0, rows_from=400, with_wheels=(1,))
        run, = join_parts([read_bag(self.other), read_bag(self.path)])
        np.testing.assert_array_equal(run.time_s, whole['time'])
        np.testing.assert_array_equal(run.coupler_force_N, whole['coupler_force'])
        self.assertEqual(len(run.account['kinetic']), len(whole['time']))
        np.testing.assert_array_equal(run.adhesion.location_m, whole['location'])
        np.testing.assert_array_equal(run.adhesion.creep, whole['axles']['creep'])
        self.assertLess(len(first['time']), len(whole['time']))

    def test_equal_bag_names_are_told_apart_by_their_folders(self):
        folders = [os.path.join(os.path.dirname(self.path), name) for name in ('dry', 'wet')]
        paths = [os.path.join(folder, 'same.bag') for folder in folders]
        for run_id, path in enumerate(paths, start=1):
            os.makedirs(os.path.dirname(path))
            write_bag(path, run_id=run_id, duration_s=1.0)
        self.assertEqual([run.label for run in join_parts([read_bag(path) for path in paths])],
                         ['synthetic (dry)', 'synthetic (wet)'])

    def test_runs_of_a_sweep_are_told_apart_by_the_values_that_differ(self):
        def labels(*scenarios):
            return labels_of([('s', text, f'{i:03}/s.bag') for i, text in enumerate(scenarios, start=1)])

        self.assertEqual(labels('a: {mu: 0.25, list: [1, 2]}', 'a: {mu: 0.30, list: [1, 2]}'), ['s (mu 0.25)', 's (mu 0.3)'])
        self.assertEqual(labels('{a: {x: 1}, b: {x: 2}}', '{a: {x: 1}, b: {x: 3}}', '{a: {x: 4}, b: {x: 3}}'),
                         ['s (a.x 1, b.x 2)', 's (a.x 1, b.x 3)', 's (a.x 4, b.x 3)'])
        self.assertEqual(labels('x: 1', '{x: 1, y: 2}'), ['s (y -)', 's (y 2)'])
        folders = ['s (001)', 's (002)']
        self.assertEqual(labels('{x: 1, y: 2, z: 3}', '{x: 2, y: 3, z: 4}'), folders)  # too many to read
        self.assertEqual(labels('table: "0,0"', 'table: "0,0,1,1,2,2,3,3,4,4"'), folders)
        self.assertEqual(labels('x: 1', 'x: 1'), folders)  # of two builds

    def test_labels_given_are_in_order_and_one_for_each_run(self):
        write_bag(self.path, run_id=1, duration_s=1.0)
        write_bag(self.other, run_id=2, duration_s=1.0)
        parts = [read_bag(self.path), read_bag(self.other)]
        self.assertEqual([run.label for run in join_parts(parts, ['b', 'a'])], ['b', 'a'])
        for names in (['a'], ['a', 'a'], ['a', ''], ['a', 'b', 'c']):
            with self.assertRaisesRegex(ReportError, '--label'):
                join_parts(parts, names)

    def test_wheels_of_a_locomotive_asked_for(self):
        write_bag(self.path, duration_s=8.0, with_wheels=(1, 3), contacts=True)
        run = read_bag(self.path, 3)
        self.assertEqual((run.locomotive, run.adhesion.locomotive, run.whose), (3, 3, 'locomotive 3'))
        self.assertAlmostEqual(run.location_m[0] - run.adhesion.location_m[0], 44.0, places=9)
        self.assertIsNone(read_bag(self.path, 2).adhesion)
        with self.assertRaisesRegex(ReportError, 'no locomotive 4: the train has 3'):
            read_bag(self.path, 4)

    def test_wheels_have_both_sides_and_sums_over_their_contacts(self):
        write_bag(self.path, duration_s=8.0, with_wheels=(1,), contacts=True)
        wheels = read_bag(self.path).adhesion.wheels
        np.testing.assert_allclose(wheels.guiding_force_N[0], [[1e3 * n, 2e3 * n] for n in range(1, AXLES + 1)], rtol=1e-12)
        np.testing.assert_allclose(wheels.lateral_over_vertical[0, 1], (0.02, 0.05), rtol=1e-12)
        self.assertTrue(np.isnan(wheels.lateral_over_vertical[300, -1, 0]))
        self.assertEqual(wheels.contacts[[99, 100, 199, 200], 0, 1].tolist(), [1, 2, 2, 1])
        self.assertEqual(wheels.contacts[[299, 300], -1, 0].tolist(), [1, 0])
        np.testing.assert_allclose(wheels.t_gamma_N[100, 0], (90.0, 180.0), rtol=1e-12)  # |1e3 (-0.07) - 2e3 0.01|

    def test_parts_of_a_run_join_their_wheels(self):
        write_bag(self.path, duration_s=8.0, with_wheels=(1,), contacts=True)
        write_bag(self.other, duration_s=10.0, rows_from=200, with_wheels=(1,), contacts=True)
        run, = join_parts([read_bag(self.path), read_bag(self.other)])
        self.assertEqual(run.adhesion.wheels.contacts.shape, (len(run.adhesion.time_s), AXLES, 2))
        self.assertEqual(run.adhesion.wheels.contacts[[199, 200, -1], 0, 1].tolist(), [2, 1, 1])

    def test_runs_of_one_scenario_get_labels_of_their_own(self):
        write_bag(self.path, run_id=1, duration_s=1.0)
        write_bag(self.other, run_id=2, duration_s=1.0)
        labels = [run.label for run in join_parts([read_bag(self.path), read_bag(self.other)])]
        self.assertEqual(labels, ['synthetic (run)', 'synthetic (other)'])


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_bag_reader', BagReaderTest)
