#!/usr/bin/env python3
"""The program `paper_comparison` from the outside: its files, and the folders that it takes and refuses."""
import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import rosunit

from synthetic_run import write_run_folder
from train_viz.run import ReportError
from train_viz.run_folder import read_run_folders

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'scripts', 'paper_comparison')


class PaperProgramTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = {key: write_run_folder(directory.name, key) for key in ('1d', '2d', '3d', '3d_two_point')}

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name
        self.out = os.path.join(directory.name, 'out')

    def run_program(self, *keys, folders=()):
        paths = [self.folder[key] for key in keys] + list(folders)
        return subprocess.run([sys.executable, PROGRAM, *paths, '--out', self.out], capture_output=True, text=True,
                              check=False)

    def assert_refused(self, result, *words):
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count('paper_comparison:'), 1, result.stderr)
        self.assertNotIn('Traceback', result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_program_writes_a_page_that_opens_offline(self):
        result = self.run_program('3d_two_point', '3d', '2d', '1d')
        self.assertEqual(result.returncode, 0, result.stderr)
        names = ('equal_speed', 'fig3_adhesion_creep', 'fig6_traction_force', 'fig7_friction_adhesion', 'fig8_energy',
                 'fig9_force_difference')
        self.assertEqual(sorted(os.listdir(os.path.join(self.out, 'figures'))),
                         sorted(f'{name}.{suffix}' for name in names for suffix in ('png', 'svg')))
        with open(os.path.join(self.out, 'report.html'), encoding='utf-8') as file:
            page = file.read()
        self.assertEqual(page.count('src="data:image/png;base64,iVBORw0KGgo'), 6)
        self.assertEqual(re.findall(r'src="(?!data:)|href="(?!#)|https?:|@import|url\(', page), [])
        with open(os.path.join(self.out, 'summary.csv'), encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        keys = {(row['model'], row['vehicle'], row['quantity'], row['location_km']) for row in rows}
        self.assertEqual(len(keys), len(rows))  # no value twice
        self.assertEqual({row['model'] for row in rows}, {'1d', '2d', '3d', '3d_two_point'})

    def test_one_run_alone_has_its_page_and_no_figures_of_earlier_ones(self):
        self.assertEqual(self.run_program('1d', '2d').returncode, 0)
        result = self.run_program('1d')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual({name.split('.')[0] for name in os.listdir(os.path.join(self.out, 'figures'))},
                         {'equal_speed', 'fig6_traction_force', 'fig8_energy'})

    def test_folders_that_are_no_finished_run_are_refused(self):
        self.assert_refused(self.run_program(folders=[os.path.join(self.directory, 'none')]), 'no such folder')
        self.assert_refused(self.run_program(folders=[self.directory]), 'outcome.yaml')
        stopped = write_run_folder(self.directory, '1d', outcome='stopped', duration_s=1.0)
        self.assert_refused(self.run_program(folders=[stopped]), 'did not finish', 'stopped')

    def test_the_same_model_twice_is_refused(self):
        self.assert_refused(self.run_program('1d', '1d'), 'both are a run of 1d')

    def test_runs_of_another_case_are_refused_before_any_bag_is_read(self):
        for options, words in (({'wagons': 20}, 'its train is 3 x 134 t + 20 x 120 t, not 3 x 134 t + 105 x 120 t'),
                               ({'changed_scenario': ('radius_m: 300', 'radius_m: 400')},
                                'its line has R400 from 3.3 to 3.6 km, not R300 from 3.3 to 3.6 km'),
                               ({'changed_scenario': ('start_location_km: 3.0', 'start_location_km: 2.5')},
                                'it starts at 2.5 km, not 3 km'),
                               ({'changed_scenario': ('curves', 'bends')}, 'its line has no curve')):
            with tempfile.TemporaryDirectory() as directory, mock.patch('train_viz.run_folder.read_bag') as read_bag:
                folder = write_run_folder(directory, '1d', duration_s=1.0, **options)
                os.remove(os.path.join(folder, 'summary.csv'))  # what the case is comes first
                with self.assertRaisesRegex(ReportError, re.escape(f"no run of the paper's case: {words}")):
                    read_run_folders([self.folder['2d'], folder])
                self.assertFalse(read_bag.called)

    def test_a_pair_of_one_model_is_refused_before_any_bag_is_read(self):
        with mock.patch('train_viz.run_folder.read_bag') as read_bag:
            with self.assertRaisesRegex(ReportError, 'both are a run of 1d'):
                read_run_folders([self.folder['1d'], self.folder['1d']])
        self.assertFalse(read_bag.called)

    def test_summary_of_another_unit_or_without_a_place_is_refused(self):
        for old, new, word in (('traction_force,N,3.45', 'traction_force,kN,3.45', 'is in kN'),
                               ('traction_force,N,3.45', 'traction_force,N,3.46', 'no traction_force at 3.45 km'),
                               ('model,vehicle', 'vehicle,model', 'columns'),
                               ('1d,1,traction_force,N,3.45,', '1d,1,traction_force,N,3.45,x', 'line ')):
            with tempfile.TemporaryDirectory() as directory:
                folder = write_run_folder(directory, '1d')
                path = os.path.join(folder, 'summary.csv')
                with open(path, encoding='utf-8') as file:
                    text = file.read()
                with open(path, 'w', encoding='utf-8') as file:
                    file.write(text.replace(old, new))
                self.assert_refused(self.run_program(folders=[folder]), path, word)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_paper_program', PaperProgramTest)
