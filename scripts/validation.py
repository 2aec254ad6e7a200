#!/usr/bin/env python3
"""Writes docs/validation.md from the results of the tests: every figure that a test verifies, with what was computed.

usage: scripts/validation.py FOLDER... > docs/validation.md
FOLDER holds gtest's XML files: build/test_results after scripts/test.sh.
"""

import glob
import os
import sys
import xml.etree.ElementTree as ElementTree

HEAD = """# Validation

Written by `scripts/validation.py build/test_results > docs/validation.md` after `./scripts/test.sh`; do not edit. Every line is a figure that a test
asks for: the test fails beyond the tolerance. *Independent model*: a second implementation of the same physics by other hands.

"""
TITLES = {
    1: "Rest and free rolling",
    2: "Resistances, closed form, couplers",
    3: "Creep forces",
    4: "Wheels that race without control",
    5: "Moments and vertical forces at every instant",
    6: "Modes of the 2D locomotive",
    7: "Drift and accounts",
    8: "Steps",
    9: "3D on straight track, lateral modes, held wheelsets",
    10: "Steady curving, Klingel",
    11: "Contact geometry",
    12: "Hunting",
    13: "Rails that lie off",
    14: "Brakes",
}


def fail(message):
    sys.exit("validation: " + message)


def read(folders):
    """Rows (case, what, source, unit, expected, computed, tolerance, reason, test), each once."""
    rows = {}
    for folder in folders:
        for path in sorted(glob.glob(os.path.join(folder, "**", "*.xml"), recursive=True)):
            try:
                root = ElementTree.parse(path).getroot()
            except ElementTree.ParseError as error:
                fail("%s: is not XML: %s" % (path, error))
            for case in root.iter("testcase"):
                test = "%s.%s" % (case.get("classname"), case.get("name"))
                for item in case.iter("property"):
                    if not item.get("name").startswith("verification_"):
                        continue
                    parts = item.get("value").split("|")
                    if len(parts) != 8:
                        fail("%s: %s: %r has %d parts instead of 8" % (path, test, item.get("value"), len(parts)))
                    number, what, source, unit, expected, computed, tolerance, reason = parts
                    try:
                        row = (int(number), what, source, unit, float(expected), float(computed), float(tolerance), reason, test)
                    except ValueError as error:
                        fail("%s: %s: %r: %s" % (path, test, item.get("value"), error))
                    rows[(number, what, source, test)] = row
    return list(rows.values())


def figure(value):
    return "0" if value == 0 else "%.6g" % value


def deviation(expected, computed):
    if expected == 0:
        return figure(computed)
    return "%+.2g %%" % (100.0 * (computed - expected) / abs(expected)) if computed != expected else "0"


def write(rows, out):
    out.write(HEAD)
    for number in sorted({row[0] for row in rows}):
        out.write("## %d. %s\n\n" % (number, TITLES.get(number, "")))
        out.write("| what | source | expected | computed | deviation | tolerance | because | test |\n|---|---|---|---|---|---|---|---|\n")
        for _, what, source, unit, expected, computed, tolerance, reason, test in sorted(r for r in rows if r[0] == number):
            unit = "" if unit == "1" else " " + unit
            cells = (what, source, figure(expected) + unit, figure(computed) + unit, deviation(expected, computed), figure(tolerance) + unit, reason, "`%s`" % test)
            out.write("| " + " | ".join(cells) + " |\n")
        out.write("\n")


def main():
    folders = sys.argv[1:]
    if not folders or folders[0].startswith("-"):
        fail(__doc__.split("\n\n")[1])
    for folder in folders:
        if not os.path.isdir(folder):
            fail("%s: no such folder" % folder)
    rows = read(folders)
    if not rows:
        fail("no verified figure in the XML files of %s: run scripts/test.sh first" % " ".join(folders))
    write(rows, sys.stdout)


if __name__ == "__main__":
    main()
