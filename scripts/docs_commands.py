#!/usr/bin/env python3
"""Lists the shell commands of README.md and docs/*.md, and how each is tested.

    docs_commands.py          page:line, the command, and behind it what is run instead of it and why
A command is a line of a fenced block without language, or `code` in a line, that begins with one of PROGRAMS and has an
argument. `$ command` in a block is followed by what it must print. src/ltd_sim/test/node/docs_commands_test.py runs them:
as they stand, those of LIVE against a running train, and those of INSTEAD by something cheaper.
"""
import collections
import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parents[1]
PROGRAMS = ('roslaunch rosrun rosservice rostopic rosbag rosmsg rossrv rosparam rostest roscore rviz catkin_make colcon cmake '
            'source unshare ltd_offline').split()
SCRIPT = re.compile(r'(\./)?scripts/\w+\.(sh|py)$')
WITHOUT_ARGUMENT = ('roscore',)  # a command even alone; other names alone are names
Command = collections.namedtuple('Command', 'page line text printed')

# Commands that need a running train.
LIVE = re.compile(r'rosservice call|rostopic echo (?!-b)')
# Commands that make up a graph by hand: those of one page are started together.
BY_HAND = re.compile(r'roscore|rosrun ltd_sim ltd_node|rosrun loco_dynamics loco_node')
MISTYPED = ('hodl:=true',)  # shown as a mistake

# (command, what is run instead of it, why); \1 is the first group. `launch ARGUMENTS` is the test's own check of a launch: the
# file and its arguments exist, and the scenario that they come to.
INSTEAD = [
    (r'(?:\./)?scripts/(demo|test|check)\.sh.*', r'scripts/\1.sh --help', 'runs for minutes'),
    (r'(?:\./)?scripts/(build|benchmark)\.sh', r'bash -n scripts/\1.sh', 'builds'),
    (r'scripts/validation\.py .*', 'test -x scripts/validation.py', 'reads the results of all tests'),
    (r'catkin_make .*', 'command -v catkin_make', 'builds; scripts/build.sh does the same'),
    (r'colcon build --base-paths (\S+) .*', r'test -d \1', 'builds; scripts/check.sh does the same'),
    (r'cmake -S (\S+) -B .*', r'test -f \1/CMakeLists.txt', 'builds; scripts/test.sh does the same'),
    (r'source .*', 'test -n "$CMAKE_PREFIX_PATH"', 'the test runs in this environment'),
    (r'unshare .* roslaunch (.*)\'', r'launch \1', 'containers may forbid it'),
    (r'roslaunch ltd_sim (.*)', r'launch launch/\1', 'runs for minutes; scripts/check.sh runs it installed'),
    (r'roslaunch (--.*)', r'roslaunch \1', ''),
    (r'roslaunch (.*)', r'launch \1', 'runs for minutes; launch_test.py and graph_test.py launch'),
    (r'rviz -d FILE', 'test -f config/rviz/train.rviz', 'needs a screen'),
    (r'rosbag play (-\S+).*', r'rosbag play --help | grep -e "\1"', 'plays in real time'),
    (r'rosrun (\S+ \S+)', r'rosrun \1 --help', 'names a program'),
    (r'rosbag (reindex)', r'rosbag \1 --help', 'names no bag'),
    (r'rostopic pub -1 \S+ (\S+) .*', r'rosmsg show \1', 'needs rviz'),
    (r'rosrun train_viz report BAG\.\.\. --out DIR', 'rosrun train_viz report results/paper_1d/paper_1d.bag --out DIR', 'pattern'),
    (r'rosrun train_viz paper_comparison .*', 'rosrun train_viz paper_comparison --help', 'wants whole runs; demo.sh compares'),
    (r'(.*ltd_offline .*)--set steps.micro_step_s=\.\.\.', r'\1--out results/dots --set run.end_time_s=0.2', 'pattern'),
    (r'(.*ltd_offline config/\S+ .*)', r'\1 --set run.end_time_s=0.2', 'runs for seconds to minutes'),
    (r'(.*ltd_offline bad/.*)', '', 'its files are faulty ones that the page does not show'),
]


def is_command(text):
    words = text.split()
    if not words or not (words[0] in PROGRAMS or SCRIPT.match(words[0])):
        return False
    return len(words) > 1 or words[0] in WITHOUT_ARGUMENT or bool(SCRIPT.match(words[0]) and words[0].endswith('.sh'))


def strip_comment(line):
    return re.sub(r'\s+#\s.*$', '', line).rstrip()


def spell_out(code):
    """`... hold:=true` and `... STOP 0` go on from a command before; `hold:=true` alone is an argument of a launch."""
    rest = code[4:] if code.startswith('... ') else code
    if re.match(r'\w+:=', rest) and rest not in MISTYPED:
        return 'roslaunch ANY ' + rest
    return 'rosservice call /train/step_lock ' + rest if code.startswith('... ') else code


def of_block(page, first_line, lines):
    """Commands of a fenced block; one goes on in the next line after a backslash."""
    found = []
    number = 0
    while number < len(lines):
        start, text = number, lines[number]
        while text.endswith('\\') and number + 1 < len(lines):
            number += 1
            text = text[:-1].rstrip() + ' ' + lines[number].strip()
        number += 1
        printed = None
        if text.startswith('$ '):
            text, printed = text[2:], []
            while number < len(lines) and not lines[number].startswith('$ '):
                printed.append(lines[number])
                number += 1
        text = strip_comment(text)
        if is_command(text):
            found.append(Command(page, first_line + start, text, printed))
    return found


def of_page(page, text):
    """All commands of a page, in its order."""
    found, block, since, language = [], None, 0, ''
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith('```'):
            if block is None:
                block, since, language = [], number + 1, line[3:].strip()
            else:
                if language in ('', 'sh', 'bash'):
                    found += of_block(page, since, block)
                block = None
        elif block is not None:
            block.append(line)
        else:
            for code in re.findall(r'`([^`]+)`', line):
                code = spell_out(code)
                if is_command(code):
                    found.append(Command(page, number, code, None))
    return found


def files_of_page(text):
    """{path: content} of the fenced blocks that begin with `# path`: examples to copy."""
    blocks = re.findall(r'^```\w+\n(# (\S+/\S+\.(?:yaml|csv))\n.*?)^```', text, re.M | re.S)
    return {path: content for content, path in blocks}


def pages():
    return [REPO / 'README.md'] + sorted((REPO / 'docs').glob('*.md'))


def all_commands():
    return [command for page in pages() for command in of_page(str(page.relative_to(REPO)), page.read_text())]


def instead(text):
    """(what to run, why): the command itself and '' if it is not in the table."""
    for pattern, replacement, why in INSTEAD:
        match = re.fullmatch(pattern, text)
        if match:
            return match.expand(replacement), why
    return text, ''


def main():
    for command in all_commands():
        run, why = instead(command.text)
        if LIVE.match(command.text) or BY_HAND.match(command.text):
            run, why = 'the same', 'with a train of its own'
        print(f'{command.page}:{command.line}: {command.text}' + (f'\n    -> {run or "nothing"}: {why}' if why else ''))
    return 0


if __name__ == '__main__':
    sys.exit(main())
