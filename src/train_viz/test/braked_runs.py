"""A run that pulls and then brakes, with a supply, and one without either: what tests of figures look at."""
import os
import tempfile
import unittest

from matplotlib import pyplot as plt

from synthetic_bag import write_bag
from train_viz.bag_reader import read_bag

BRAKE_FROM_S = 40.0


class BrakedRunsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, 'run.bag')
            cls.written = write_bag(path, slip=0.1, limit_N=50e3, brake_from_s=BRAKE_FROM_S, air_brake=True, supply=True)
            cls.braked = read_bag(path)
            write_bag(path, duration_s=10.0)
            cls.plain = read_bag(path)

    def setUp(self):
        self.addCleanup(plt.close, 'all')
