#!/usr/bin/env python3
"""Tests of count_tests.py on made-up result files; scripts/check.sh runs them."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).with_name('count_tests.py')
PASSED = '<testcase classname="Suite" name="{}"/>'
FAILED = '<testcase classname="Suite" name="{}"><failure message="short">{}</failure></testcase>'


class CountTestsTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name).resolve()
        self.source = self.root / 'src'
        self.source.mkdir()
        self.lists = {}
        self.build('build')

    def build(self, name, status=0):
        self.lists.setdefault(name, [])
        (self.root / name / 'test_results').mkdir(parents=True, exist_ok=True)
        (self.root / name / 'ctest_status').write_text(str(status))

    def results(self, build='build'):
        return self.root / build / 'test_results'

    def write(self, path, *cases):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'<testsuites><testsuite name="s">{"".join(cases)}</testsuite></testsuites>')

    def catkin_test(self, xml, *cases):
        """A test of catkin in package pkg whose result file is xml; without cases it has left none."""
        path = self.results() / 'pkg' / xml
        self.lists['build'].append({'name': f'_ctest_pkg_{xml}', 'command': [
            '/usr/bin/env', '/usr/share/catkin/cmake/test/run_tests.py', str(path), '--return-code', 'program']})
        if cases:
            self.write(path, *cases)

    def plain_test(self, name, *cases):
        self.lists['plain'].append({'name': name, 'command': [f'/somewhere/{name}']})
        if cases:
            self.write(self.results('plain') / f'{name}.xml', *cases)

    def count(self):
        """(last line, exit code, everything printed)"""
        for name, tests in self.lists.items():
            (self.root / name / 'test_list.json').write_text(json.dumps({'tests': tests}))
        command = [sys.executable, str(SCRIPT), '--source', str(self.source)] + [str(self.root / n) for n in self.lists]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        return run.stdout.splitlines()[-1], run.returncode, run.stdout

    def assert_count(self, line, code):
        last, returncode, output = self.count()
        self.assertEqual((line, code), (last, returncode), output)
        return output

    def test_nothing_ran(self):
        self.assert_count('0 passed, 1 failed', 1)

    def test_build_without_tests(self):
        self.build('plain')
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.assertIn('FAILED plain: test list', self.assert_count('1 passed, 1 failed', 1))

    def test_passed_failed_error(self):
        self.catkin_test('gtest-a.xml', PASSED.format('x'), FAILED.format('y', 'one is not two'),
                         '<testcase classname="Suite" name="z"><error>boo</error></testcase>')
        output = self.assert_count('1 passed, 2 failed', 1)
        self.assertIn('FAILED a: Suite.y', output)
        self.assertIn('one is not two', output)

    def test_skipped_and_disabled(self):
        self.catkin_test('gtest-a.xml', PASSED.format('x'), '<testcase name="y"><skipped message="no"/></testcase>',
                         '<testcase name="z" status="notrun"/>')
        self.assert_count('1 passed, 0 failed, 2 skipped', 0)

    def test_only_skipped_is_not_passed(self):
        self.catkin_test('gtest-a.xml', '<testcase name="y"><skipped/></testcase>')
        self.assert_count('0 passed, 0 failed, 1 skipped', 1)

    def test_crash_counts_once_although_catkin_leaves_a_mark(self):
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.catkin_test('gtest-crash.xml')
        self.write(self.results() / 'pkg' / 'MISSING-gtest-crash.xml', FAILED.format('test_ran', ''))
        (self.root / 'build/ctest.xml').write_text(
            '<testsuite><testcase name="_ctest_pkg_gtest-crash.xml"><failure/><system-out>Segmentation fault</system-out>'
            '</testcase></testsuite>')
        self.assertIn('Segmentation fault', self.assert_count('1 passed, 1 failed', 1))

    def test_result_file_that_is_empty_or_broken(self):
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.catkin_test('gtest-b.xml', ' ')
        self.catkin_test('gtest-c.xml', '<testcase')
        self.assert_count('1 passed, 2 failed', 1)

    def test_same_gtest_in_two_builds_counts_once(self):
        self.build('plain')
        self.catkin_test('gtest-a.xml', PASSED.format('x'), PASSED.format('y'))
        self.plain_test('a', PASSED.format('x'), PASSED.format('y'))
        self.plain_test('only_plain', PASSED.format('x'))
        self.assert_count('3 passed, 0 failed', 0)

    def test_failure_in_one_of_two_builds_is_a_failure(self):
        self.build('plain')
        self.catkin_test('gtest-a.xml', PASSED.format('x'), PASSED.format('y'))
        self.plain_test('a', PASSED.format('x'), FAILED.format('y', 'differs'))
        self.assertIn('FAILED a: Suite.y   [plain]', self.assert_count('1 passed, 1 failed', 1))

    def test_rostest_counts_the_cases_inside(self):
        self.catkin_test('rostest-node.xml', '<testcase classname="rostest.runner.RosTest" name="testnode"/>')
        self.write(self.results() / 'pkg' / 'rosunit-node.xml', PASSED.format('x'), FAILED.format('y', ''))
        self.assert_count('1 passed, 1 failed', 1)

    def test_rostest_that_crashed_or_ran_out_of_time(self):
        self.catkin_test('rostest-node.xml', '<testcase name="testnode"><error>max time allotted</error></testcase>')
        self.assertIn('max time allotted', self.assert_count('0 passed, 1 failed', 1))

    def test_rostest_that_passed_without_cases_inside(self):
        self.catkin_test('rostest-node.xml', '<testcase name="testnode"/>')
        self.assert_count('0 passed, 1 failed', 1)

    def test_two_rostests_with_one_test_name(self):
        self.catkin_test('rostest-a.xml', '<testcase name="testnode"/>')
        self.catkin_test('rostest-b.xml', '<testcase name="testnode"/>')
        self.write(self.results() / 'pkg' / 'rosunit-node.xml', PASSED.format('x'))
        self.assertIn('used by two rostests', self.assert_count('1 passed, 1 failed', 1))

    def test_failure_that_only_ctest_saw(self):
        self.build('build', status=8)
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.assert_count('1 passed, 1 failed', 1)
        self.catkin_test('gtest-b.xml', PASSED.format('x'))
        self.catkin_test('gtest-c.xml', FAILED.format('x', 'why'))
        ctest_cases = [f'<testcase name="_ctest_pkg_gtest-{x}.xml"><failure/></testcase>' for x in 'bc']
        (self.root / 'build/ctest.xml').write_text(f'<testsuite>{"".join(ctest_cases)}</testsuite>')
        self.assertIn('FAILED b: whole program', self.assert_count('2 passed, 2 failed', 1))

    def test_program_that_is_no_gtest(self):
        self.build('plain')
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.plain_test('smoke')
        ctest = self.root / 'plain/ctest.xml'
        ctest.write_text('<testsuite><testcase name="smoke" status="run"/></testsuite>')
        self.assert_count('2 passed, 0 failed', 0)
        ctest.unlink()
        self.assert_count('1 passed, 1 failed', 1)

    def test_test_sources_that_nothing_runs(self):
        self.catkin_test('gtest-a.xml', PASSED.format('x'))
        self.lists['build'].append({'name': 'py', 'command': ['run_tests.py', str(self.results() / 'pkg/unittest-p.xml'),
                                                             'python3 /x/test_known.py; rostest /x/known.test']})
        self.write(self.results() / 'pkg/unittest-p.xml', PASSED.format('p'))
        test_directory = self.source / 'pkg/test/node'
        test_directory.mkdir(parents=True)
        for name in ('known_test.cpp', 'forgotten_test.cpp', 'test_known.py', 'test_forgotten.py', 'forgotten.test'):
            (test_directory / name).write_text('')
        (test_directory / 'test_launched.py').write_text('')
        (test_directory / 'known.test').write_text('<test type="test_launched.py"/>')
        (self.root / 'build/compile_commands.json').write_text(json.dumps([{'file': str(test_directory / 'known_test.cpp')}]))
        self.assert_count('2 passed, 3 failed', 1)


if __name__ == '__main__':
    unittest.main()
