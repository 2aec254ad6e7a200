#!/usr/bin/env python3
"""Tests of docs_commands.py on made-up pages; scripts/check.sh runs them."""
import sys
import unittest

sys.dont_write_bytecode = True
import docs_commands  # noqa: E402


def texts(page):
    return [command.text for command in docs_commands.of_page('page.md', page)]


class DocsCommandsTest(unittest.TestCase):
    def test_lines_of_a_block_without_comments_continued_by_a_backslash(self):
        page = '```\nrosrun a b c   # why\nF = m a\nrosrun a \\\n  --set x=1\n```\n'
        self.assertEqual(['rosrun a b c', 'rosrun a --set x=1'], texts(page))
        self.assertEqual([2, 4], [command.line for command in docs_commands.of_page('page.md', page)])

    def test_blocks_in_another_language_hold_no_commands(self):
        self.assertEqual([], texts('```yaml\nrosrun a b c\n```\n'))

    def test_what_a_command_prints(self):
        page = '```\n$ rosrun a b c\none\ntwo\n$ rosrun a b d\n```\n'
        self.assertEqual([['one', 'two'], []], [command.printed for command in docs_commands.of_page('page.md', page)])

    def test_code_in_a_line_is_a_command_if_it_has_an_argument(self):
        self.assertEqual(['rostopic echo /tf', './scripts/test.sh'],
                         texts('`ltd_offline` and `rostopic echo /tf` | `x` | `./scripts/test.sh` | `roslaunch`'))

    def test_arguments_alone_are_those_of_a_launch_and_dots_go_on(self):
        self.assertEqual(['roslaunch ANY hold:=true', 'roslaunch ANY model:=2d', 'rosservice call /train/step_lock STOP 0'],
                         texts('`hold:=true` `... model:=2d` `hodl:=true` `... STOP 0`'))

    def test_files_to_copy(self):
        page = '```yaml\n# mine/a.yaml\nx: 1\n```\n```yaml\n# only a comment\n```\n```csv\n# mine/b.csv\n1\n```\n'
        self.assertEqual({'mine/a.yaml': '# mine/a.yaml\nx: 1\n', 'mine/b.csv': '# mine/b.csv\n1\n'},
                         docs_commands.files_of_page(page))

    def test_what_is_run_instead_keeps_the_arguments(self):
        self.assertEqual('rosrun ltd_sim ltd_offline config/a.yaml --out x --set run.end_time_s=0.2',
                         docs_commands.instead('rosrun ltd_sim ltd_offline config/a.yaml --out x')[0])
        self.assertEqual('launch launch/a.launch b:=c', docs_commands.instead('roslaunch launch/a.launch b:=c')[0])
        self.assertEqual(('rosrun a b --c', ''), docs_commands.instead('rosrun a b --c'))

    def test_the_pages_have_commands_and_no_row_of_the_table_is_idle(self):
        commands = [command.text for command in docs_commands.all_commands()]
        self.assertGreater(len(commands), 50)
        used = {docs_commands.instead(text)[1] for text in commands}
        self.assertEqual(set(), {why for _, _, why in docs_commands.INSTEAD} - used)

    def test_the_page_about_rostests_quotes_the_example_that_is_run(self):
        page = (docs_commands.REPO / 'docs' / 'rostest.md').read_text()
        for name in ('example.test', 'example_rostest.py'):
            self.assertIn((docs_commands.REPO / 'src/ltd_sim/test/node' / name).read_text(), page)


if __name__ == '__main__':
    unittest.main()
