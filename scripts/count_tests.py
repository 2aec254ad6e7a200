#!/usr/bin/env python3
"""Counts the tests that scripts/test.sh ran, each once, and says which failed and why.

    count_tests.py --source SRC BUILD...

Reads from every BUILD what test.sh left there:
  test_list.json   the tests that exist (ctest --show-only=json-v1)
  test_results/    JUnit XML of gtest, rosunit and rostest; its <testcase> elements are what is counted
  ctest.xml        ctest's own JUnit XML: the output of a test that left no result (missing before CMake 3.21)
  ctest_status     exit code of ctest

No test may vanish: a test in the list without result file, a result file without <testcase>, a test source under SRC
that no build compiles or starts, and a failure that only ctest saw each count as one failed test.

One test, several files:
  - a gtest that runs in two builds: same executable, suite and name;
  - a rostest: rostest-FILE.xml has one case `testX` for each <test test-name="X">, rosunit-X.xml has the cases inside. The
    inner ones count; the outer one only if it failed (crash, time limit) or if there are no inner ones.
Not seen: unittest.skip under rosunit, which writes a skipped test like one that passed.

Last line: `N passed, M failed`, and `, K skipped` if K > 0. Exit code 1 if M > 0 or N = 0.
"""
import argparse
import collections
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

Case = collections.namedtuple('Case', 'group name outcome message')
RANK = {'skipped': 0, 'passed': 1, 'failed': 2}  # of one test in several builds, the highest holds
MESSAGE_LINES = 40
FORBIDDEN_IN_FILE_NAME = ' "\'&$!`/\\'  # rosunit replaces these in test names


def failed(group, name, message):
    return Case(group, name, 'failed', message)


def last_lines(text):
    return '\n'.join(text.strip().splitlines()[-MESSAGE_LINES:])


def outcome_of(element):
    """(outcome, message) of a <testcase> of gtest, rosunit or ctest."""
    problems = element.findall('failure') + element.findall('error')
    if problems:
        return 'failed', '\n'.join((p.text or '').strip() or p.get('message') or 'no message' for p in problems)
    if element.find('skipped') is not None or element.get('status') in ('notrun', 'disabled'):
        return 'skipped', ''
    return 'passed', ''


def group_of(path):
    """One name for gtest-X.xml of catkin and X.xml of the plain build; rosunit names are unique in a package only."""
    if path.stem.startswith('gtest-'):
        return path.stem[len('gtest-'):]
    return path.stem if path.parent.name == 'test_results' else f'{path.parent.name}/{path.stem}'


def read_cases(path):
    """All cases of one result file; a file that cannot be read or is empty is one failed case."""
    group = group_of(path)
    try:
        elements = list(ElementTree.parse(str(path)).getroot().iter('testcase'))
    except (ElementTree.ParseError, OSError) as error:
        return [failed(group, 'result file', f'{path}: {error}')]
    if not elements:
        return [failed(group, 'result file', f'{path}: holds no test case')]
    cases = []
    seen = collections.Counter()
    for element in elements:
        name = '.'.join(part for part in (element.get('classname'), element.get('name')) if part)
        seen[name] += 1
        if seen[name] > 1:
            name = f'{name} #{seen[name]}'
        cases.append(Case(group, name, *outcome_of(element)))
    return cases


class Build:
    """What one build directory says about its tests."""

    def __init__(self, directory):
        self.directory = directory
        self.tests = self._read_list()
        self.ctest = self._read_ctest()
        self.claimed = set()
        self.cases = []

    def _read_list(self):
        try:
            return json.loads((self.directory / 'test_list.json').read_text())['tests']
        except (OSError, ValueError, KeyError) as error:
            print(f'count_tests: {self.directory}/test_list.json: {error}: run scripts/test.sh\n0 passed, 1 failed')
            sys.exit(1)

    def _read_ctest(self):
        """{test: (outcome, output)} as ctest saw it."""
        try:
            root = ElementTree.parse(str(self.directory / 'ctest.xml')).getroot()
        except (ElementTree.ParseError, OSError):
            return {}
        return {element.get('name'): (outcome_of(element)[0], element.findtext('system-out') or '')
                for element in root.iter('testcase')}

    def result_path(self, test):
        """Where the test has to leave its result, and whether it is one of catkin's."""
        command = test.get('command', [])
        for index, argument in enumerate(command[:-1]):
            if pathlib.PurePath(argument).name == 'run_tests.py':
                return pathlib.Path(command[index + 1]), True
        executable = pathlib.PurePath(command[0]).name if command else test['name']
        return self.directory / 'test_results' / f'{executable}.xml', False

    def count(self):
        if not self.tests:
            self.cases.append(failed(self.directory.name, 'test list', 'holds no test: was the build configured with tests?'))
        for test in self.tests:
            path, is_catkin = self.result_path(test)
            self.claimed.add(path.with_name(f'MISSING-{path.name}'))  # catkin's mark for the same fact
            if path.is_file():
                self._claim_test(test, path)
            else:
                self.cases.append(self._case_without_result(test, path, is_catkin))
        for path in sorted((self.directory / 'test_results').rglob('*.xml')):
            self._claim(path)
        self._compare_with_ctest()
        return self.cases

    def _claim_test(self, test, path):
        before = len(self.cases)
        self._claim(path)
        outcome, output = self.ctest.get(test['name'], ('passed', ''))
        if outcome == 'failed' and not any(case.outcome == 'failed' for case in self.cases[before:]):
            self.cases.append(failed(group_of(path), 'whole program', 'failed though each of its test cases passed: it '
                                     f'crashed or hung after the last\n{last_lines(output)}'.strip()))

    def _claim(self, path):
        if path in self.claimed:
            return
        self.claimed.add(path)
        cases = read_cases(path)
        if path.name.startswith('rostest-'):
            for case in cases:
                self._claim_rostest(path, case)
        else:
            self.cases += cases

    def _claim_rostest(self, path, outer):
        test_name = outer.name.rpartition('.')[2][len('test'):]
        for character in FORBIDDEN_IN_FILE_NAME:
            test_name = test_name.replace(character, '_')
        inner = path.with_name(f'rosunit-{test_name}.xml')
        if inner in self.claimed:
            self.cases.append(failed(outer.group, outer.name, f'test-name "{test_name}" is used by two rostests of this '
                                     'package: one overwrites the results of the other; give each its own test-name'))
        elif inner.is_file():
            self._claim(inner)
            if outer.outcome == 'failed':
                self.cases.append(outer)
        elif outer.outcome == 'passed':
            self.cases.append(failed(outer.group, outer.name, f'{inner} is missing'))
        else:
            self.cases.append(outer)

    def _case_without_result(self, test, path, is_catkin):
        outcome, output = self.ctest.get(test['name'], ('failed', ''))
        if outcome != 'failed' and not is_catkin:
            return Case(test['name'], 'run by ctest', outcome, '')  # a program that is no gtest
        group = group_of(path)
        message = f'left no {path}: it crashed, hung, was not built or was not run'
        return failed(group, 'whole program', f'{message}\n{last_lines(output)}'.strip())

    def _compare_with_ctest(self):
        try:
            status = int((self.directory / 'ctest_status').read_text())
        except (OSError, ValueError):
            status = -1
        if status != 0 and not any(case.outcome == 'failed' for case in self.cases):
            self.cases.append(failed(self.directory.name, 'ctest', f'ended with {status} though every test case passed; '
                                     f'see {self.directory}/Testing/Temporary/LastTest.log'))


def unregistered_sources(source, builds):
    """Test sources that no build compiles or starts, as failed cases."""
    compiled = set()
    for build in builds:
        database = build.directory / 'compile_commands.json'
        if database.is_file():
            compiled |= {pathlib.Path(entry['file']).resolve() for entry in json.loads(database.read_text())}
    commands = ' '.join(' '.join(test.get('command', [])) for build in builds for test in build.tests)
    launched = commands + ' '.join(path.read_text() for path in source.glob('*/test/**/*.test'))
    cases = []
    for pattern, found in (('*_test.cpp', lambda path: path.resolve() in compiled),
                           ('*.test', lambda path: path.name in commands),
                           ('test_*.py', lambda path: path.name in launched)):
        for path in sorted(source.glob(f'*/test/**/{pattern}')):
            if not found(path):
                cases.append(failed('not registered', str(path.relative_to(source)),
                                    'no build compiles or starts it: add it to the CMakeLists.txt of its package'))
    return cases


def merge(cases_of_builds):
    """{(group, name): [case, builds]}; a test of several builds counts once, with its worst outcome."""
    merged = {}
    for build_name, cases in cases_of_builds:
        for case in cases:
            entry = merged.setdefault((case.group, case.name), [case, []])
            if RANK[case.outcome] > RANK[entry[0].outcome]:
                entry[0], entry[1] = case, []
            if case.outcome == entry[0].outcome:
                entry[1].append(build_name)
    return merged


def main():
    parser = argparse.ArgumentParser(description='Counts the tests that scripts/test.sh ran, each once.')
    parser.add_argument('--source', type=pathlib.Path, required=True, help='the packages, to find tests that do not run')
    parser.add_argument('builds', metavar='BUILD', type=pathlib.Path, nargs='+', help='build directory with test_list.json')
    arguments = parser.parse_args()

    builds = [Build(directory.resolve()) for directory in arguments.builds]
    cases_of_builds = [(build.directory.name, build.count()) for build in builds]
    print()
    for build, (name, cases) in zip(builds, cases_of_builds):
        print(f'{name}: {len(cases)} test cases of {len(build.tests)} programs and launch files')
    cases_of_builds.append(('sources', unregistered_sources(arguments.source.resolve(), builds)))

    merged = merge(cases_of_builds)
    for case, names in merged.values():
        if case.outcome == 'failed':
            print(f'\nFAILED {case.group}: {case.name}   [{", ".join(names)}]')
            print('\n'.join(f'    {line}' for line in case.message.splitlines()))
    totals = collections.Counter(case.outcome for case, _ in merged.values())
    skipped = f', {totals["skipped"]} skipped' if totals['skipped'] else ''
    print(f'\n{totals["passed"]} passed, {totals["failed"]} failed{skipped}', flush=True)
    return 1 if totals['failed'] or not totals['passed'] else 0


if __name__ == '__main__':
    sys.exit(main())
