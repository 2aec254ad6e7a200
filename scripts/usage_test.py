#!/usr/bin/env python3
"""Tests of the arguments of scripts that take few or none; scripts/check.sh runs them.

The scripts run as copies in a folder of their own, with a PATH that has next to nothing, so that one which does not
refuse comes to a halt instead of building or installing.
"""
import filecmp
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).parent
WITHOUT_ARGUMENTS = ('benchmark.sh', 'install_dependencies.sh')


class UsageTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = pathlib.Path(directory.name)
        for folder in ('scripts', 'bin', 'config/tracks'):
            (self.root / folder).mkdir(parents=True)
        for name in (*WITHOUT_ARGUMENTS, 'environment.sh', 'mine_to_port.py'):
            shutil.copy(SCRIPTS / name, self.root / 'scripts')
        for tool in ('bash', 'dirname', 'sed'):
            (self.root / 'bin' / tool).symlink_to(shutil.which(tool))

    def run_script(self, name, *arguments):
        command = [sys.executable if name.endswith('.py') else shutil.which('bash'), str(self.root / 'scripts' / name)]
        return subprocess.run([*command, *map(str, arguments)], env={'PATH': str(self.root / 'bin')},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=60)

    def written(self):
        return [path.name for path in sorted((self.root / 'config/tracks').iterdir())]

    def test_an_argument_where_none_is_taken_is_refused_and_named(self):
        for name in WITHOUT_ARGUMENTS:
            run = self.run_script(name, '--bogus')
            self.assertEqual(2, run.returncode, name + run.stderr)
            self.assertIn('takes no arguments, got "--bogus"', run.stderr)

    def test_help_says_what_the_script_does_and_does_nothing(self):
        for name, word in (('benchmark.sh', 'measures'), ('install_dependencies.sh', 'Installs'),
                           ('mine_to_port.py', 'usage')):
            run = self.run_script(name, '--help')
            self.assertEqual(0, run.returncode, name + run.stderr)
            self.assertIn(word, run.stdout)
        self.assertEqual([], self.written())

    def test_the_synthetic_line_refuses_options_and_what_is_no_folder(self):
        for arguments, word in ((['--bogus'], '--bogus'), ([self.root / 'none'], 'none: is no folder'),
                                ([self.root, 'b'], 'arguments: b')):
            run = self.run_script('mine_to_port.py', *arguments)
            self.assertEqual(2, run.returncode, run.stderr)
            self.assertIn('usage: mine_to_port.py', run.stderr)
            self.assertIn(word, run.stderr)
        self.assertEqual([], self.written())

    def test_the_synthetic_line_is_the_one_in_config(self):
        names = ['mine_to_port.csv', 'port_to_mine.csv']
        for folder in ([], [self.root / 'config/tracks']):
            self.assertEqual(0, self.run_script('mine_to_port.py', *folder).returncode)
            self.assertEqual(names, self.written())
            for name in names:
                self.assertTrue(filecmp.cmp(SCRIPTS.parent / 'config/tracks' / name,
                                            self.root / 'config/tracks' / name, shallow=False), name)
                (self.root / 'config/tracks' / name).unlink()


if __name__ == '__main__':
    unittest.main()
