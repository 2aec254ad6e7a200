#!/usr/bin/env python3
"""Braking and supplies: the terms that a bag has are parted, drawn and closed; runs without them have no such figures."""
import dataclasses
import os
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path

from synthetic_bag import write_bag
from train_viz.account_figure import draw_energy_account
from train_viz.bag_reader import read_bag
from train_viz.brake_figures import draw_brake_energy, draw_brake_pressures, first_application_s
from train_viz.energy_stages import between_rim_and_rail, supply_MJ
from train_viz.flow_figure import SPIN, draw_energy_flow, flows_of
from train_viz.run_page import run_page
from train_viz.supply_figure import draw_energy_supply, supply_flows

BRAKE_FROM_S = 40.0


def texts(figure):
    return ' '.join(text.get_text() for text in figure.axes[0].texts)


def overlaps(axes):
    """Pairs of ribbons of a flow picture of which one's middle runs inside the other."""
    share = np.linspace(0.0, 1.0, 60)[1:-1, None]
    basis = ((1.0 - share) ** 3, 3.0 * share * (1.0 - share) ** 2, 3.0 * share ** 2 * (1.0 - share), share ** 3)
    ribbons = [patch.get_path() for patch in axes.patches if isinstance(patch, PathPatch)]
    ribbons = [r for r in ribbons if r.vertices[7, 1] - r.vertices[0, 1] > 1e-3 * np.ptp(axes.get_ylim())]  # not hairlines
    middles = [sum(b * (low + high) / 2.0 for b, low, high in zip(basis, ribbon.vertices[:4], ribbon.vertices[7:3:-1]))
               for ribbon in ribbons]
    return [(i, j) for i, middle in enumerate(middles) for j, other in enumerate(ribbons)
            if i != j and Path(other.to_polygons()[0]).contains_points(middle).any()]


def crossings(axes):
    """Pairs of a ribbon and a node of a flow picture that it passes through, between its ends."""
    ribbons = [patch.get_path() for patch in axes.patches if isinstance(patch, PathPatch)]
    nodes = [patch for patch in axes.patches if isinstance(patch, Rectangle)]
    found = []
    for ribbon in ribbons:
        outline = Path(ribbon.to_polygons()[0])
        for node in nodes:
            x, low, height = node.get_x() + node.get_width() / 2.0, node.get_y(), node.get_height()
            inside = [(x, y) for y in np.linspace(low, low + height, 101)[1:-1]]
            if outline.contains_points(inside).any():
                found.append((ribbon, node))
    return found


class BrakingFiguresTest(unittest.TestCase):
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

    def test_reader_has_the_brakes(self):
        last = {name: values[-1] for name, values in self.written.items() if isinstance(values, np.ndarray)}
        self.assertEqual(self.braked.locos['brake_rail'][-1].tolist(), [last['taken']] * 3)
        self.assertEqual(self.braked.locos['recovered_rim'][-1].tolist(), [last['recovered']] * 3)
        self.assertEqual(self.braked.account['air_brake'][-1], last['air'])
        self.assertEqual((self.braked.brake_notch[0, 1], self.braked.brake_notch[-1, 1], self.braked.notch[-1, 1]), (0.0, 5.0, 0.0))
        self.assertEqual((self.braked.pipe_pressure_Pa[0, 7], self.braked.pipe_pressure_Pa[-1, 7]), (5e5, 0.0))
        self.assertEqual(self.braked.cylinder_pressure_Pa[-1].tolist(), [0.0] * 3 + [3.8e5] * 5)
        self.assertEqual((self.braked.brakes(), self.braked.has_air_brake(), self.braked.has_supply()), (True, True, True))
        self.assertEqual((self.plain.brakes(), self.plain.has_air_brake(), self.plain.has_supply()), (False, False, False))

    def test_slip_is_parted_into_driving_and_braking(self):
        parted = {name: values[-1] for name, values in between_rim_and_rail(self.braked).items()}
        lost = self.written['rim'][-1] - self.written['work'][-1]
        self.assertGreater(lost, 1e5)
        np.testing.assert_allclose(parted['slip_driving'], 0.9 * lost, rtol=1e-9)
        np.testing.assert_allclose(parted['rest_driving'], 0.1 * lost, rtol=1e-9)
        np.testing.assert_allclose(parted['slip_braking'], 0.1 * self.written['taken'][-1], rtol=1e-9)
        np.testing.assert_allclose(parted['rest_braking'], 0.0, atol=1e-6 * lost)

    def test_shoes_that_a_locomotive_pulls_against_are_heated_by_its_motors(self):
        run = self.changed(self.plain)
        run.locos['energy_rim'][5:] += 3e6  # beside what the rail gets
        run.locos['shoes'][5:] += 3e6
        run.locos['shoes'][9:] += 2e6       # and while it brakes: from the rail
        run.locos['brake_rail'][9:] += 2e6
        parted = {name: values[-1] for name, values in between_rim_and_rail(run).items()}
        np.testing.assert_allclose(parted['shoes_driving'], 3e6, rtol=1e-9)
        np.testing.assert_allclose(parted['shoes_braking'], 2e6, rtol=1e-9)
        for rest in ('rest_driving', 'rest_braking'):  # in 1D no wheel spins
            np.testing.assert_allclose(parted[rest], 0.0, atol=1.0)

    def test_spin_of_wheels_stays_spin_where_shoes_take_less(self):
        run = self.changed(self.plain)
        run.locos['energy_rim'][5:] += 3e6
        run.locos['shoes'][5:] += 1e6
        parted = {name: values[-1] for name, values in between_rim_and_rail(run).items()}
        np.testing.assert_allclose((parted['shoes_driving'], parted['rest_driving']), ([1e6] * 3, [2e6] * 3), rtol=1e-9)

    def test_flow_and_account_name_shoes_pulled_against(self):
        run = self.changed(self.plain)
        for books, factor in ((run.locos, 1.0), (run.account, 3.0)):
            books['shoes'][5:] += factor * 3e6
        run.locos['energy_rim'][5:] += 3e6
        run.account['traction_rim'][5:] += 9e6
        _, losses, _, braked = flows_of(run)
        self.assertEqual([(flow[0], round(flow[2], 6)) for flow in losses], [("locomotives' shoes, pulled against", 9.0)])
        self.assertEqual(braked, [])
        cells = [cell.get_text().get_text() for cell in draw_energy_account([run]).axes[1].tables[0].get_celld().values()]
        self.assertEqual(cells[cells.index("locomotives' shoes, pulled against [MJ]") + 1], '9.000')
        self.assertNotIn('-0.000', cells)
        self.assertIn('own shoes while it pulls against them', run_page([run], {}))

    @staticmethod
    def changed(run):
        """A copy whose books may be written."""
        return dataclasses.replace(run, account={name: values.copy() for name, values in run.account.items()},
                                   locos={name: values.copy() for name, values in run.locos.items()})

    def test_rolling_back_at_a_start_is_no_braking(self):
        run = dataclasses.replace(self.plain, locos={name: values.copy() for name, values in self.plain.locos.items()})
        run.locos['energy_rail'][5:] -= 2e6
        run.locos['energy_slip'][5:] += 1e6
        parted = between_rim_and_rail(run)
        self.assertFalse(parted['slip_braking'].any() or parted['rest_braking'].any())
        np.testing.assert_allclose(parted['slip_driving'][-1], 1e6, rtol=1e-12)

    def test_flow_closes_at_rail_and_at_the_brakes(self):
        sources, losses, sinks, braked = flows_of(self.braked)
        self.assertEqual([flow[0] for flow in braked], ['recovered by motors, at the rim', 'slip loss, braking'])
        self.assertEqual(sinks[-1][0], "locomotives' brakes, at the rail")
        self.assertIn("air brake, wagons' shoes", [flow[0] for flow in sinks])
        total = [sum(flow[2] for flow in flows) for flows in (sources, losses, sinks, braked)]
        self.assertAlmostEqual(total[0], total[1] + total[2], delta=2e-3 * total[0])  # its balance is Euler's, to 1e-3
        self.assertAlmostEqual(sinks[-1][2], total[3], places=12)
        self.assertAlmostEqual(total[3], 3e-6 * self.written['taken'][-1], delta=1e-9 * total[3])
        words = texts(draw_energy_flow(self.braked))
        for part in ('at the rail\n', 'of it traction\n', 'at the rim: ', "locomotives'\nbrakes,\nat the rail"):
            self.assertIn(part, words)

    def test_name_of_the_rail_stands_below_its_node_and_beside_all_ribbons(self):
        run = self.changed(self.braked)
        run.account['traction_rim'][:], run.account['traction_rail'][:] = 0.0, 0.0  # the train's motion gives all
        run.account['kinetic'][-1], run.account['air_brake'][-1] = -3e9, 2.9e9
        run.locos['energy_rim'][:], run.locos['energy_rail'][:], run.locos['energy_slip'][:] = 0.0, 0.0, 0.0
        for shown in (self.braked, run):
            figure = draw_energy_flow(shown)
            axes = figure.axes[0]
            figure.draw_without_rendering()
            name, = [text for text in axes.texts if text.get_text().startswith('at the rail\n')]
            box = name.get_window_extent().transformed(axes.transData.inverted())
            corners = [(x, y) for x in np.linspace(box.x0, box.x1, 9) for y in np.linspace(box.y0, box.y1, 9)]
            for patch in axes.patches:
                outline = Path(patch.get_path().transformed(patch.get_patch_transform()).to_polygons()[0])
                self.assertFalse(outline.contains_points(corners).any(), patch)
            self.assertEqual((crossings(axes), overlaps(axes)), ([], []))
        self.assertNotIn('traction', name.get_text())  # there is none

    def test_spin_of_wheels_that_slow_down_goes_to_the_brakes_beside_the_rail(self):
        run = dataclasses.replace(self.braked, account={name: values.copy() for name, values in self.braked.account.items()},
                                  locos={name: values.copy() for name, values in self.braked.locos.items()})
        run.locos['recovered_rim'][-1] += 1e6
        run.account['recovered_rim'][-1] += 3e6
        sources, _, sinks, braked = flows_of(run)
        self.assertEqual(sources[-1][0], SPIN)
        self.assertAlmostEqual(sources[-1][2], 3.0, places=6)
        self.assertAlmostEqual(sum(flow[2] for flow in braked), sinks[-1][2], places=9)
        number = f'{run.account["brake_rail"][-1] / 1e6:.1f}'
        self.assertIn(f'at the rail\n{number} MJ', texts(draw_energy_flow(run)))

    def test_account_has_bars_and_rows_of_brakes_and_supply_only_where_there_are_some(self):
        def words(runs):
            return [cell.get_text().get_text() for cell in draw_energy_account(runs).axes[1].tables[0].get_celld().values()]
        shown = words([self.plain, self.braked])
        for row in ("air brake, wagons' shoes [MJ]", "locomotives' brakes, at the rail [MJ]", 'fuel burnt [l]'):
            self.assertIn(row, shown)
            self.assertNotIn(row, words([self.plain]))
        self.assertIn(f'{3e-6 * self.written["taken"][-1]:.3f}', shown)
        self.assertEqual(shown.count('-'), 8)  # the run without a supply

    def test_supply_closes_from_fuel_to_rim(self):
        supply = supply_MJ(self.braked)
        rim, recovered = 3e-6 * self.written['rim'][-1], 3e-6 * self.written['recovered'][-1]
        for name, value in (('energy_rim', rim), ('shaft', rim / 0.9 / 0.8), ('fuel', rim / 0.9 / 0.8 / 0.4), ('unserved', 0.0),
                            ('recovered_loss', 0.1 * recovered), ('storage_loss', 0.05 * 0.45 * recovered)):
            self.assertAlmostEqual(supply[name], value, delta=1e-9 * rim, msg=name)
        losses, sources, sinks = supply_flows(supply)
        self.assertEqual([flow[0] for flow in sources], ['fuel', 'recovered, at the rim'])
        self.assertAlmostEqual(sum(flow[2] for flow in sources), sum(flow[2] for flow in losses + sinks), delta=1e-9 * rim)
        words = texts(draw_energy_supply(self.braked))
        for part in ('fuel\n', 'shaft\n', 'link\n', 'motors, at the rim: ', 'resistors, at the link: ', ' l of fuel'):
            self.assertIn(part, words)
        self.assertIsNone(draw_energy_supply(self.plain))

    def test_no_ribbon_of_the_supply_passes_through_a_node(self):
        run = self.changed(self.braked)
        run.locos['storage_out'][-1] += 20e6  # beside the shaft
        for name in ('generator_loss', 'fuel'):  # over the link
            run.locos[name][-1] += 5e6
        for shown in (self.braked, run):
            axes = draw_energy_supply(shown).axes[0]
            self.assertEqual((crossings(axes), overlaps(axes)), ([], []))

    def test_sums_of_the_supply_are_those_of_the_bag(self):
        locos = {name: values.copy() for name, values in self.braked.locos.items()}
        for i, name in enumerate(('line_drawn', 'line_returned', 'line_loss', 'unserved', 'auxiliaries_unfed')):
            locos[name][-1] = 1e6 * (i + 1)
        got = supply_MJ(dataclasses.replace(self.braked, locos=locos))
        for name, value in (('line_drawn', 3.0), ('line_returned', 6.0), ('line_loss', 9.0), ('unserved', 12.0)):
            self.assertAlmostEqual(got[name], value, places=9, msg=name)

    def test_pressure_maps_show_the_whole_run_and_the_wave(self):
        self.assertAlmostEqual(first_application_s(self.braked), BRAKE_FROM_S + 0.04, delta=0.021)  # of 2.5 bar/s
        figure = draw_brake_pressures(self.braked)
        whole, wave = figure.axes[:2]
        self.assertEqual([axes.get_title() for axes in (whole, wave)], ['whole run', 'first application'])
        self.assertLess(wave.get_xlim()[1], BRAKE_FROM_S + 31.0)
        self.assertEqual(whole.get_ylim(), (8.5, 0.5))
        self.assertEqual(whole.get_yticks().tolist(), list(range(1, 9)))
        cylinders = figure.axes[2].collections[0].get_array().reshape(8, -1)
        self.assertTrue(np.ma.getmaskarray(cylinders)[:3].all())  # locomotives without shoes
        self.assertAlmostEqual(cylinders[7].max(), 3.8, places=9)
        self.assertIsNone(draw_brake_pressures(self.plain))

    def test_brake_energy_names_its_ends_and_the_stores_of_the_supply(self):
        brakes, stores = draw_brake_energy(self.braked).axes[:2]
        lines = {line.get_label(): line.get_ydata()[-1] for line in brakes.get_lines() + stores.get_lines()
                 if len(line.get_ydata())}
        stored = 3e-6 * 0.45 * 0.95 * self.written['recovered'][-1]
        self.assertIn(f'in the storage, change: {stored:.3g} MJ', lines)
        self.assertAlmostEqual(lines[f"wagons' shoes: {self.written['air'][-1] / 1e6:.3g} MJ"],
                               self.written['air'][-1] / 1e6, places=9)
        self.assertIsNone(draw_brake_energy(self.plain))

    def test_brake_energy_at_the_rail_is_the_sum_of_what_it_becomes(self):
        run = self.changed(self.braked)
        run.locos['shoes'][-1] += 2e6  # the wheels give more than they take at the rail: their spin
        axes = draw_brake_energy(run).axes[0]
        ends = {line.get_label().split(':')[0]: line.get_ydata()[-1] for line in axes.get_lines() if len(line.get_ydata())}
        parts = ('recovered by motors, at the rim', "locomotives' shoes, braking", 'slip loss, braking',
                 'wheel spin, braking (given back < 0)')
        self.assertAlmostEqual(ends["locomotives' brakes, at the rail"], sum(ends[part] for part in parts), places=9)
        self.assertLess(ends[parts[3]], -5.0)
        self.assertLess(axes.get_ylim()[0], ends[parts[3]])
        self.assertFalse(any(name.startswith('of it') for name in ends))

    def test_supply_without_brakes_has_no_panel_of_brakes_and_one_zero_for_both_scales(self):
        run = self.changed(self.braked)
        for name in ('brake_rail', 'air_brake', 'shoes'):
            run.account[name][:] = 0.0
        run.locos['stored'][100:] -= 3e8  # the storage gives: below zero
        stores, fuel = draw_brake_energy(run).axes
        self.assertIn('in the storage', stores.get_lines()[0].get_label())
        (low, high), (fuel_low, fuel_high) = stores.get_ylim(), fuel.get_ylim()
        self.assertLess(low, -100.0)
        self.assertAlmostEqual(fuel_low / fuel_high, low / high, places=9)
        self.assertGreaterEqual(min(fuel.get_yticks()), 0.0)
        self.assertEqual(draw_brake_energy(run)._suptitle.get_text().split(' over ')[0], 'Energy of supply')

    def test_page_tells_brakes_and_fuel_at_the_end(self):
        page = run_page([self.braked], {})
        for words in ('recovered, at the rim [MJ]', 'its fuel [l]', f'{self.braked.locos["litres"][-1, 0]:.2f}</td>',
                      f'{len(self.braked.time_s)} of {len(self.braked.time_s)}'):
            self.assertIn(words, page)
        self.assertIn('<td class="text">time [s]</td>', page)  # so many columns are rows instead
        plain = run_page([self.plain], {})
        self.assertNotIn('recovered', plain)
        self.assertIn('<th>time [s]</th>', plain)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_braking_figures', BrakingFiguresTest)
