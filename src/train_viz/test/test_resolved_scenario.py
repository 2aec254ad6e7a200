#!/usr/bin/env python3
"""Curves and adhesion limit out of the resolved scenario text."""
import unittest

import rosunit

from train_viz.resolved_scenario import Curve, read_adhesion_limit, read_curves, read_rail_sections, read_slip_limit

TABLE = '''
track:
  name: line
  table: |
    # surveyed
    chainage_km,grade_permille,radius_m,cant_mm,speed_limit_kmph
    0.0,0,0,0,80
    1.0,0,0,0,80
    1.1,0,400,0,80
    1.3,0,400,0,80
    1.4,0,0,0,80
    2.0,0,-600,0,80
    2.5,0,0,0,80
    3.0,0,0,0,80
  between_rows: {grade: constant, curvature: %s}
'''


class ResolvedScenarioTest(unittest.TestCase):
    def assert_curve(self, curve, *expected):
        for value, wanted in zip((curve.start_m, curve.full_from_m, curve.full_to_m, curve.end_m, curve.radius_m), expected):
            self.assertAlmostEqual(value, wanted, places=6)

    def test_texts_without_what_is_sought_give_nothing(self):
        for text in ('', '[', 'track: {}', 'track: {curves: [{radius_m: 300}]}', 'track: {table: "a,b\\n1,2\\n3,4"}',
                     'track: {curves: 3}', 'train: {groups: []}', 'train: {groups: [{vehicle: {mass_kg: 134000}}]}'):
            self.assertEqual(read_curves(text), [], text)
            self.assertIsNone(read_adhesion_limit(text), text)
            self.assertIsNone(read_slip_limit(text), text)

    def test_listed_curve_has_transitions_inside(self):
        text = ('track: {curves: [{start_km: 3.3, radius_m: 300, direction: right, transition_in_m: 50, '
                'circular_m: 200, transition_out_m: 40}]}')
        curve, = read_curves(text)
        self.assert_curve(curve, 3300.0, 3350.0, 3550.0, 3590.0, 300.0)
        self.assertEqual(curve.label, 'R300')

    def test_table_with_linear_rows_ramps_and_parts_left_from_right(self):
        left, right = read_curves(TABLE % 'linear')
        self.assert_curve(left, 1000.0, 1100.0, 1300.0, 1400.0, 400.0)
        self.assert_curve(right, 1400.0, 2000.0, 2000.0, 2500.0, 600.0)

    def test_table_with_constant_rows_holds_until_the_next(self):
        left, right = read_curves(TABLE % 'constant')
        self.assert_curve(left, 1100.0, 1100.0, 1400.0, 1400.0, 400.0)
        self.assert_curve(right, 2000.0, 2000.0, 2500.0, 2500.0, 600.0)

    def test_ramp_from_left_to_right_is_parted_where_it_is_straight(self):
        text = TABLE.replace('    2.0,0,-600', '    1.4,0,300,0,80\n    1.7,0,-600') % 'linear'
        _, second, third = read_curves(text)
        self.assert_curve(second, 1400.0, 1400.0, 1400.0, 1600.0, 300.0)
        self.assertAlmostEqual(third.start_m, 1600.0, places=6)

    def test_adhesion_limit_is_that_of_the_first_vehicle(self):
        text = ('train: {groups: [{vehicle: {mass_kg: 1.34e5, adhesion_limit: 0.35}}, '
                '{vehicle: {mass_kg: 1, adhesion_limit: 9}}]}')
        coefficient, force_N = read_adhesion_limit(text)
        self.assertEqual(coefficient, 0.35)
        self.assertAlmostEqual(force_N, 460089.0, places=3)  # the paper's 460.09 kN

    def test_adhesion_limit_of_a_locomotive_behind_wagons_and_repeated_groups(self):
        loco = '{count: %d, vehicle: {mass_kg: %d, adhesion_limit: %g}}'
        wagon = '{count: 5, vehicle: {mass_kg: 120000}}'
        text = (f'train: {{groups: [{loco % (1, 100e3, 0.1)}, {{repeat: 2, groups: [{wagon}, {loco % (1, 100e3, 0.2)}]}}, '
                f'{loco % (2, 100e3, 0.3)}]}}')
        self.assertEqual([(read_adhesion_limit(text, number) or [None])[0] for number in range(1, 7)],
                         [0.1, 0.2, 0.2, 0.3, 0.3, None])

    def test_rail_sections_have_places_and_a_short_name(self):
        text = 'rail_sections: [{from_km: 3.38, to_km: 3.46, adhesion: {name: "wet, Table 1"}}, {from_km: 4, to_km: 5}]'
        self.assertEqual(read_rail_sections(text), [(3380.0, 3460.0, 'wet'), (4000.0, 5000.0, 'other rail')])
        for other in ('', 'a: [', 'rail_sections: 7', 'rail_sections: [{from_km: x}]'):
            self.assertEqual(read_rail_sections(other), [])

    def test_slip_limit_is_that_of_the_controller_if_there_is_one(self):
        self.assertEqual(read_slip_limit('control: {law: pi, slip_limit: 7e-2}'), 0.07)
        self.assertIsNone(read_slip_limit('control: {law: none, torque_lag_s: 0}'))

    def test_curves_are_hashable_for_the_union_over_runs(self):
        self.assertEqual(len({Curve(1.0, 2.0, 3.0, 4.0, 5.0), Curve(1.0, 2.0, 3.0, 4.0, 5.0)}), 1)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_resolved_scenario', ResolvedScenarioTest)
