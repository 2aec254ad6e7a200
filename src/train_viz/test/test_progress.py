#!/usr/bin/env python3
"""Long reads tell how far they are, and keep no more rows than a picture shows: yet its peaks, its first row and its end."""
import io
import os
import tempfile
import unittest
from unittest import mock

import numpy as np
import rosunit

from synthetic_bag import write_bag
from train_viz import row_store
from train_viz.bag_reader import read_bag
from train_viz.progress import Progress
from train_viz.row_store import RowStore, slot_width


class Screen(io.StringIO):
    def __init__(self, terminal):
        super().__init__()
        self.terminal = terminal

    def isatty(self):
        return self.terminal


class LongReadTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.path = os.path.join(directory.name, 'run.bag')

    def tell(self, terminal, seconds, total=100):
        """All of `total`, evenly over that time."""
        screen, now = Screen(terminal), [0.0]
        progress = Progress('reading', total, screen, lambda: now[0])
        for done in range(total):
            now[0] = seconds * done / total
            progress.tell(done)
        progress.close()
        return screen.getvalue()

    def test_short_reads_are_silent(self):
        self.assertEqual(self.tell(True, 1.9), '')
        self.assertEqual(self.tell(False, 9.9), '')

    def test_terminal_gets_one_line_with_percent_and_time_left_that_is_wiped(self):
        lines = self.tell(True, 40.0).split('\r')
        self.assertNotIn('\n', ''.join(lines))
        self.assertEqual(lines[1], 'reading: [#.......................]   5 %, 38 s left')
        self.assertEqual(lines[-2:], [' ' * len(lines[-3].rstrip()), ''])
        self.assertIn('25 %, 30 s left', ''.join(lines))

    def test_elsewhere_a_line_every_ten_seconds(self):
        self.assertEqual(self.tell(False, 400.0).splitlines()[:2],
                         ['reading: 3 %, 6 min left', 'reading: 6 %, 6 min left'])
        self.assertEqual(len(self.tell(False, 50.0).splitlines()), 4)

    def test_few_rows_are_all_kept_and_many_in_slots_of_whole_rows(self):
        self.assertEqual(slot_width(row_store.MOST_ROWS, 10**12), 1)
        self.assertEqual(slot_width(200_001, 200_000 * 20_000_000), 11 * 20_000_000)

    def test_slot_keeps_its_last_row_or_the_heaviest(self):
        last, heaviest = RowStore(1000, 10), RowStore(1000, 10)
        for i, stamp in enumerate(range(1000, 1026, 5)):
            last.add(stamp, i)
            heaviest.add(stamp, i, weight=-i)
        self.assertEqual(last.rows(), {1000: 0, 1010: 2, 1020: 4, 1025: 5})
        self.assertEqual(heaviest.rows(), {1000: 0, 1005: 1, 1015: 3, 1025: 5})

    def test_thinned_bag_keeps_start_end_sums_and_peaks(self):
        written = write_bag(self.path, duration_s=20.0, with_wheels=(1,))
        whole = read_bag(self.path)
        with mock.patch.object(row_store, 'MOST_ROWS', 100):
            thin = read_bag(self.path)
        rows = [0] + list(range(11, 1001, 11)) + [1000]
        self.assertEqual(thin.recorded, 1001)
        np.testing.assert_array_equal(thin.time_s, written['time'][rows])
        np.testing.assert_array_equal(thin.account['kinetic'], whole.account['kinetic'][rows])
        slot = whole.coupler_force_N[12:23]  # of the third row
        largest = slot[np.abs(slot).argmax(axis=0), range(slot.shape[1])]
        np.testing.assert_array_equal(thin.coupler_force_N[2], largest)
        self.assertEqual(np.abs(thin.coupler_force_N).max(), np.abs(whole.coupler_force_N).max())
        self.assertLessEqual(len(thin.adhesion.time_s), 102)
        self.assertEqual(thin.adhesion.creep.max(), whole.adhesion.creep.max())


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_progress', LongReadTest)
