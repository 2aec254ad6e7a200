#!/usr/bin/env python3
"""Tests of validation.py on made-up result files; scripts/check.sh runs them."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).with_name('validation.py')
REST = '1|speed after 1 s|exact|m/s|0|2e-12|1e-9|round-off'
FORCE = '4|force left over|independent model|N|200|201|2|1 % is given'
RATIO = '4|adhesion|exact|1|0.35|0.35|1e-6|round-off'


class ValidationTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name)

    def write(self, path, *values, name='Holds', key='verification_0'):
        properties = ''.join(f'<property name="{key}" value="{value}"/>' for value in values)
        case = f'<testcase classname="Suite" name="{name}"><properties>{properties}</properties></testcase>'
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f'<testsuites><testsuite name="s">{case}</testsuite></testsuites>')

    def run_script(self, *folders):
        return subprocess.run([sys.executable, str(SCRIPT), *map(str, folders or [self.root])], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True)

    def lines(self, *folders):
        """The page's tables without their heads."""
        run = self.run_script(*folders)
        self.assertEqual(0, run.returncode, run.stderr)
        self.assertTrue(run.stdout.startswith('# Validation\n'))
        return [line for line in run.stdout.splitlines()
                if line.startswith(('#', '|')) and line != '# Validation' and not line.startswith(('| what', '|---'))]

    def assert_refused(self, words, *folders):
        run = self.run_script(*folders)
        self.assertEqual((1, ''), (run.returncode, run.stdout))
        self.assertIn(words, run.stderr)
        self.assertNotIn('Traceback', run.stderr)

    def test_every_figure_stands_under_its_case_in_order(self):
        self.write('b/x.xml', FORCE, RATIO, name='Races')
        self.write('a/deep/y.xml', REST)
        self.assertEqual([
            '## 1. Rest and free rolling',
            '| speed after 1 s | exact | 0 m/s | 2e-12 m/s | 2e-12 | 1e-09 m/s | round-off | `Suite.Holds` |',
            '## 4. Wheels that race without control',
            '| adhesion | exact | 0.35 | 0.35 | 0 | 1e-06 | round-off | `Suite.Races` |',
            '| force left over | independent model | 200 N | 201 N | +0.5 % | 2 N | 1 % is given | `Suite.Races` |',
        ], self.lines())

    def test_a_deviation_has_the_sign_of_computed_minus_expected(self):
        self.write('x.xml', '4|a|s|N|-200|-199|2|r', '4|b|s|N|200|199|2|r')
        rows = self.lines()
        self.assertIn('| +0.5 % |', rows[1])
        self.assertIn('| -0.5 % |', rows[2])

    def test_the_same_figure_of_two_builds_stands_once_and_that_of_two_tests_twice(self):
        self.write('build/x.xml', FORCE)
        self.write('plain/x.xml', FORCE)
        self.assertEqual(2, len(self.lines(self.root / 'build', self.root / 'plain')))
        self.write('plain/y.xml', FORCE, name='Other')
        self.assertEqual(3, len(self.lines()))

    def test_other_properties_are_left_alone(self):
        self.write('x.xml', FORCE)
        self.write('y.xml', 'a|b', key='seed')
        self.assertEqual(2, len(self.lines()))

    def test_a_malformed_property_is_named_with_its_file_and_test(self):
        self.write('x.xml', FORCE.rsplit('|', 1)[0])
        self.assert_refused('x.xml: Suite.Holds: ')
        self.assert_refused('has 7 parts instead of 8')

    def test_a_figure_that_is_no_number_is_named_too(self):
        self.write('x.xml', FORCE.replace('|201|', '|much|'))
        self.assert_refused("x.xml: Suite.Holds: ")
        self.assert_refused("much")

    def test_no_results(self):
        self.assert_refused('no verified figure')
        self.write('x.xml')
        self.assert_refused('no verified figure')

    def test_a_result_file_that_is_no_xml(self):
        (self.root / 'x.xml').write_text('<testsuites>')
        self.assert_refused('x.xml: ')

    def test_folders_must_be_given_and_be_there(self):
        self.assert_refused('no such folder', self.root / 'absent')
        self.assert_refused('usage: ', '--help')


if __name__ == '__main__':
    unittest.main()
