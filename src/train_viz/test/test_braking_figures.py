#!/usr/bin/env python3
"""Braking and supplies: the terms that a bag has are parted, drawn and closed; runs without them have no such figures."""
import dataclasses

import numpy as np
import rosunit

from braked_runs import BRAKE_FROM_S, BrakedRunsTest
from train_viz.account_figure import draw_energy_account
from train_viz.brake_figures import draw_brake_energy, draw_brake_pressures, first_application_s
from train_viz.energy_stages import between_rim_and_rail, supply_MJ
from train_viz.flow_figure import flows_of
from train_viz.run_page import run_page


class BrakingFiguresTest(BrakedRunsTest):
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
        self.assertEqual([text.get_text() for text in draw_energy_account([run]).axes[0].texts], [' nothing'])  # no brake took any
        self.assertIn('own shoes while it pulls against them', run_page([run], {}))
        self.assertGreater(run.rim_J[-1], 2.0 * run.rail_J[-1] + 1e6)
        self.assertFalse(run.races())

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

    def test_account_has_bars_and_rows_of_brakes_and_supply_only_where_there_are_some(self):
        def words(runs):
            return [cell.get_text().get_text() for cell in draw_energy_account(runs).axes[1].tables[0].get_celld().values()]
        shown = words([self.plain, self.braked])
        for row in ("air brake, wagons' shoes [MJ]", "locomotives' brakes, at the rail [MJ]", 'fuel burnt [l]'):
            self.assertIn(row, shown)
            self.assertNotIn(row, words([self.plain]))
        self.assertIn(f'{3e-6 * self.written["taken"][-1]:.3f}', shown)
        self.assertEqual(shown.count('-'), 8)  # the run without a supply

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
