#!/usr/bin/env python3
"""The program `contact_plot` from the outside, and what it takes from its tables."""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import rosunit

from train_viz.contact_figure import jumps_of, main_contacts, nominal_radius, parted, point_on_wheel
from train_viz.contact_table import read_contacts, read_sections

PLOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'scripts', 'contact_plot')
HEADER = ('side,y_mm,yaw_mrad,patch,y_rail_mm,z_rail_mm,angle_rad,rolling_radius_mm,normal_force_N,a_mm,b_mm,area_mm2,'
          'p_max_MPa\n')
# a cone 1:20 whose taping line is 10 mm inside the rail's top
SECTIONS = 'body,y_mm,z_mm\n' + ''.join(f'wheel,{y - 10},{-y / 20}\nrail,{y},{y * y / 600}\n' for y in range(-30, 31))
CONTACTS = HEADER + ('left,0,0,1,-15,0.375,0.05,500.25,100000,6,6,113,1000\nright,0,0,1,-15,0.375,0.05,500.25,100000,6,6,113,1000\n'
                     'left,2,0,1,-15,0.375,0.05,500.15,100000,6,6,113,1000\nright,2,0,1,-15,0.375,0.05,500.35,60000,6,6,113,1000\n'
                     'right,2,0,2,-36,9,1.0,505,40000,6,6,113,1000\n')


class ContactPlotTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name
        self.contacts = self.write('contacts.csv', CONTACTS)
        self.sections = self.write('sections.csv', SECTIONS)

    def write(self, name, text):
        path = os.path.join(self.directory, name)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
        return path

    def plot(self, *arguments):
        return subprocess.run([sys.executable, PLOT, *arguments], capture_output=True, text=True, check=False)

    def test_draws_png_and_svg(self):
        result = self.plot(self.contacts, '--sections', self.sections, '--out', self.directory, '--name', 'cone')
        self.assertEqual(result.returncode, 0, result.stderr)
        for suffix in ('png', 'svg'):
            self.assertGreater(os.path.getsize(os.path.join(self.directory, f'cone.{suffix}')), 10000)

    def test_names_what_it_cannot_read(self):
        bad = self.write('bad.csv', CONTACTS.replace('500.35', 'x'))
        for arguments, words in (((bad, '--sections', self.sections), 'bad.csv: line 5: rolling_radius_mm = x'),
                                 ((self.sections, '--sections', self.sections), 'no column side'),
                                 ((self.contacts, '--sections', 'absent.csv'), 'absent.csv: cannot be read')):
            result = self.plot(*arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(words, result.stderr)

    def test_contacts_lie_on_the_wheel(self):
        contacts, sections = read_contacts(self.contacts), read_sections(self.sections)
        radius = nominal_radius(contacts, sections)
        self.assertAlmostEqual(radius, 500.0, places=6)
        # the right wheel is 2 mm further out, so the point is 2 mm nearer to its flange
        np.testing.assert_allclose(point_on_wheel(contacts[3], sections['wheel'], radius), [-17.0, 0.35], atol=0.01)
        np.testing.assert_allclose(point_on_wheel(contacts[2], sections['wheel'], radius), [-13.0, 0.15], atol=0.01)

    def test_the_contact_with_more_load_counts(self):
        y_mm, right = main_contacts(read_contacts(self.contacts), 'right')
        self.assertEqual(list(y_mm), [0.0, 2.0])
        self.assertEqual([contact.rolling_radius_mm for contact in right], [500.25, 500.35])

    def test_lines_are_parted_where_the_contact_jumps(self):
        y_mm, right = main_contacts(read_contacts(self.contacts), 'right')
        self.assertEqual(list(jumps_of(y_mm, right)), [False])
        for other in (right[1]._replace(angle_rad=right[0].angle_rad + 0.4), right[1]._replace(y_rail_mm=-30.0)):
            self.assertEqual(list(jumps_of(y_mm, [right[0], other])), [True])
        x, y = parted(np.array([0.0, 1.0, 2.0]), [5.0, 6.0, 9.0], np.array([False, True]))
        np.testing.assert_array_equal(x, [0.0, 1.0, np.nan, 2.0])
        np.testing.assert_array_equal(y, [5.0, 6.0, np.nan, 9.0])


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_contact_plot', ContactPlotTest)
