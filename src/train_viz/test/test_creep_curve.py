#!/usr/bin/env python3
"""Creep curves come from creep_force, asked with what the resolved scenario says; without it there are none."""
import contextlib
import dataclasses
import io
import os
import sys
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt

from synthetic_bag import RESOLVED, write_bag
from train_viz import creep_curve
from train_viz.adhesion_figures import draw_adhesion_creep
from train_viz.bag_reader import read_bag

VEHICLE = '''mass_kg: 134000, adhesion_limit: 0.35, bodies: {wheel_radius_m: 0.5}, contact: {rail_crown_radius_m: 0.25,
        wheel_transverse_curvature_1pm: -2.5, young_modulus_Pa: 210.0e9, poisson_ratio: 0.28, shear_modulus_Pa: 82.0e9}'''
RAIL = '''
adhesion: {method: %s, friction: {mu0: 0.35, A: 0.4, B_s_per_m: 0.275}, reduction: {k0: 0.075, alpha_inf: 0.001, beta: 0.3}}
'''
# Answers with a force of N times 4 creep, and leaves what it was asked in a file
STAND_IN = '''
import csv, sys
text = sys.stdin.read()
open(%r, 'w').write(' '.join(sys.argv[1:]) + chr(10) + text)
rows = list(csv.DictReader(text.splitlines()))
print(text.splitlines()[0] + ',Fx_N,Fy_N')
for line, row in zip(text.splitlines()[1:], rows):
    print(line + ',' + repr(-4.0 * float(row['N_N']) * float(row['creep_x'])) + ',0')
'''


class CreepCurveTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.addCleanup(plt.close, 'all')
        self.addCleanup(setattr, creep_curve, 'PROGRAM', creep_curve.PROGRAM)
        creep_curve._run_program.cache_clear()
        self.asked, self.directory = os.path.join(directory.name, 'asked'), directory.name
        creep_curve.PROGRAM = (sys.executable, '-c', STAND_IN % self.asked)

    def read(self, method='modfastsim', **options):
        locos, wagons, scenario = 3, 5, '2d'
        text = RESOLVED % locals()
        text = text.replace('mass_kg: 134000, adhesion_limit: 0.35', VEHICLE, 1) + RAIL % method
        path = os.path.join(self.directory, 'run.bag')
        write_bag(path, scenario, resolved=text, duration_s=20.0, with_wheels=(1,), **options)
        return read_bag(path)

    def test_what_creep_force_is_asked_is_in_the_scenario_and_the_bag(self):
        run = self.read()
        curve, = creep_curve.creep_curves(run, (5.0,), 0.08)
        with open(self.asked, encoding='utf-8') as file:
            command, header, _, second, *_ = file.read().splitlines()
        self.assertEqual(command, '--method closed')  # as the 2D model computes modfastsim
        row = dict(zip(header.split(','), map(float, second.split(','))))
        wheel_N = run.adhesion.normal_force_N.mean() / 2.0
        wanted = {'curvature_along_1pm': 2.0, 'curvature_across_1pm': 1.5, 'E_GPa': 210.0, 'nu': 0.28, 'G_GPa': 82.0,
                  'N_N': wheel_N, 'V_mps': 5.0, 'mu0': 0.35, 'A': 0.4, 'B_s_per_m': 0.275, 'k0': 0.075, 'alpha_inf': 0.001,
                  'beta': 0.3, 'kA': 1.0, 'kS': 1.0, 'creep_x': -1e-4, 'creep_y': 0.0, 'spin_rad_per_m': 0.0}
        self.assertEqual(set(row), set(wanted))
        for name, value in wanted.items():
            self.assertAlmostEqual(row[name], value, delta=1e-12 * max(1.0, abs(value)), msg=name)
        self.assertAlmostEqual(curve.creep[-1], 0.08, places=12)
        np.testing.assert_allclose(curve.adhesion, 4.0 * curve.creep, rtol=1e-12)

    def test_curves_stand_in_every_panel_behind_the_points_with_their_speed(self):
        run = self.read()
        figure = draw_adhesion_creep(run)
        for axes in figure.axes[:6]:
            lines = [line for line in axes.get_lines() if len(line.get_xdata()) > 2]
            self.assertEqual(len(lines), 3)
            for line in lines:
                np.testing.assert_allclose(line.get_ydata(), 0.04 * line.get_xdata(), rtol=1e-9)
        labels = [text.get_text() for text in figure.legends[0].get_texts()]
        self.assertIn(f'creep curve at {run.adhesion.speed_kmph.max():.1f} km/h, 2D, mean axle load', labels)

    def test_the_label_says_that_rail_sections_have_curves_of_their_own(self):
        run = self.read()
        run = dataclasses.replace(run, resolved=run.resolved + 'rail_sections: [{from_km: 3.1, to_km: 3.2}]')
        curve, = creep_curve.creep_curves(run, (10.0,), 0.08)
        self.assertEqual(curve.label, 'creep curve at 36.0 km/h, 2D, mean axle load, outside rail sections')

    def test_curves_are_of_the_rail_that_the_wheels_had_with_or_without_sand(self):
        run = self.read()  # static friction 0.35
        text = run.resolved[run.resolved.index('adhesion: {'):]
        for with_sand, without, words in (('0.35', '0.20', ', under sand'), ('0.50', '0.35', ', without sand')):
            rails = text.replace('0.35', without) + 'sanded_' + text.replace('0.35', with_sand)
            both = dataclasses.replace(run, resolved=run.resolved.replace(text, rails))
            curve, = creep_curve.creep_curves(both, (10.0,), 0.08)
            self.assertEqual(curve.label, 'creep curve at 36.0 km/h, 2D, mean axle load' + words)
            with open(self.asked, encoding='utf-8') as file:
                _, header, first, *_ = file.read().splitlines()
            self.assertEqual(dict(zip(header.split(','), first.split(',')))['mu0'], '0.35')

    def test_other_methods_are_asked_for_as_they_are(self):
        creep_curve.creep_curves(self.read('fastsim'), (5.0,), 0.08)
        with open(self.asked, encoding='utf-8') as file:
            self.assertEqual(file.readline().strip(), '--method fastsim')

    def test_contacts_of_3d_and_scenarios_without_a_contact_have_none(self):
        self.assertEqual(creep_curve.creep_curves(self.read(contacts=True), (5.0,), 0.08), [])
        path = os.path.join(self.directory, 'other.bag')
        write_bag(path, 'x', duration_s=20.0, with_wheels=(1,))
        self.assertEqual(creep_curve.creep_curves(read_bag(path), (5.0,), 0.08), [])
        self.assertFalse(os.path.exists(self.asked))

    def test_a_program_that_fails_or_is_not_there_leaves_the_figure_without_and_says_so(self):
        run = self.read()
        for program in ((sys.executable, '-c', 'import sys; sys.exit("broken")'), ('no_such_program',)):
            creep_curve.PROGRAM = program
            creep_curve._run_program.cache_clear()
            errors = io.StringIO()
            with contextlib.redirect_stderr(errors):
                self.assertEqual(creep_curve.creep_curves(run, (5.0,), 0.08), [])
            self.assertIn('no creep curves', errors.getvalue())


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_creep_curve', CreepCurveTest)
