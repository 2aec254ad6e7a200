#!/usr/bin/env python3
"""The program `report` from the outside: files, exit codes, messages; and what its figures show."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np
import rosunit

from synthetic_bag import write_bag
from train_viz.account_figure import draw_energy_account
from train_viz.bag_reader import read_bag
from train_viz.coupler_figure import COLUMNS, bin_extremes, draw_coupler_forces
from train_viz.flow_figure import draw_energy_flow, flows_of
from train_viz.place_figures import draw_energy, draw_speed_notch, draw_traction_force

REPORT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'scripts', 'report')
COMPARISONS = ('traction_force', 'energy', 'speed_notch', 'energy_account')


def own_lines(result):
    """What the program says on stderr, without matplotlib's remarks on its caches on a fresh machine."""
    return [line for line in result.stderr.splitlines() if line.startswith('report:')]


class ReportTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.bag = os.path.join(directory.name, 'run.bag')
        self.out = os.path.join(directory.name, 'deep', 'figures')

    def report(self, *arguments):
        return subprocess.run([sys.executable, REPORT, *arguments], capture_output=True, text=True, check=False)

    def assert_figures(self, *names):
        self.assertEqual(sorted(os.listdir(self.out)),
                         sorted([f'{n}.{s}' for n in names for s in ('png', 'svg')] + ['report.html']))
        for name in names:
            with open(os.path.join(self.out, f'{name}.png'), 'rb') as file:
                self.assertEqual(file.read(8), b'\x89PNG\r\n\x1a\n')
            root = xml.etree.ElementTree.parse(os.path.join(self.out, f'{name}.svg')).getroot()
            self.assertTrue(root.tag.endswith('svg'))

    def assert_refused(self, result, *words):
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(len(own_lines(result)), 1, result.stderr)
        self.assertNotIn('Traceback', result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)

    def test_missing_bag_is_one_line_and_exit_code_2(self):
        self.assert_refused(self.report(self.bag, '--out', self.out), self.bag, 'no such file')

    def test_out_that_is_a_file_is_one_line_and_exit_code_2(self):
        write_bag(self.bag, duration_s=1.0)
        self.assert_refused(self.report(self.bag, '--out', self.bag), self.bag, '--out')

    def test_missing_out_is_refused(self):
        self.assertEqual(self.report(self.bag).returncode, 2)

    def test_one_run_gives_seven_figures(self):
        write_bag(self.bag, 'paper 1d/x', duration_s=60.0)
        result = self.report(self.bag, '--out', self.out)
        self.assertEqual((result.returncode, own_lines(result)), (0, []), result.stderr)
        self.assert_figures(*COMPARISONS, 'energy_flow_paper_1d_x', 'trip_paper_1d_x', 'coupler_forces_paper_1d_x')

    def test_two_runs_share_figures_but_for_flows_and_couplers(self):
        other = self.bag.replace('run.bag', 'other.bag')
        write_bag(self.bag, 'left', run_id=1, duration_s=60.0)
        write_bag(other, 'right', run_id=2, wagons=9, duration_s=50.0, resolved='')
        result = self.report(self.bag, other, '--out', self.out)
        self.assertEqual((result.returncode, own_lines(result)), (0, []), result.stderr)
        self.assert_figures(*COMPARISONS, 'coupler_forces_left', 'coupler_forces_right', 'energy_flow_left',
                            'energy_flow_right', 'trip_left', 'trip_right')

    def test_runs_with_wheels_beside_one_without_get_their_figures(self):
        other = self.bag.replace('run.bag', 'other.bag')
        write_bag(self.bag, '1d', run_id=1, duration_s=60.0)
        write_bag(other, '2d', run_id=2, duration_s=60.0, with_wheels=(1, 2))
        result = self.report(self.bag, other, '--out', self.out)
        self.assertEqual((result.returncode, own_lines(result)), (0, []), result.stderr)
        self.assert_figures(*COMPARISONS, 'coupler_forces_1d', 'coupler_forces_2d', 'energy_flow_1d', 'energy_flow_2d',
                            'trip_1d', 'trip_2d', 'friction_adhesion',
                            'adhesion_creep_2d', 'adhesion_control_2d', 'axle_loads_2d')

    def test_vehicle_alone_gives_no_coupler_figure_and_says_so(self):
        write_bag(self.bag, locos=1, wagons=0, duration_s=10.0)
        result = self.report(self.bag, '--out', self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn('no couplers', result.stderr)
        self.assert_figures(*COMPARISONS, 'energy_flow_synthetic', 'trip_synthetic')

    def test_3d_locomotive_gives_its_wheels_figures_under_the_label_given(self):
        write_bag(self.bag, '3d', duration_s=60.0, with_wheels=(1, 2), contacts=True)
        result = self.report(os.path.dirname(self.bag), '--out', self.out, '--label', 'mine', '--loco', '2')  # its folder
        self.assertEqual((result.returncode, own_lines(result)), (0, []), result.stderr)
        self.assert_figures(*COMPARISONS, 'coupler_forces_mine', 'energy_flow_mine', 'trip_mine', 'friction_adhesion', *(
            f'{name}_mine' for name in ('adhesion_creep', 'adhesion_control', 'axle_loads', 'guiding_forces',
                                        'wheel_contacts')))

    def test_folder_without_bag_and_locomotive_that_is_not_there_are_refused(self):
        self.assert_refused(self.report(os.path.dirname(self.bag), '--out', self.out), 'is a folder without a .bag')
        write_bag(self.bag, duration_s=1.0)
        self.assert_refused(self.report(self.bag, '--out', self.out, '--loco', '4'), 'no locomotive 4', self.bag)
        self.assert_refused(self.report(self.bag, '--out', self.out, '--label', 'a', '--label', 'b'), '--label')

    def test_reader_that_goes_away_is_no_error(self):
        write_bag(self.bag, duration_s=1.0)
        read, write = os.pipe()
        os.close(read)
        result = subprocess.run([sys.executable, REPORT, self.bag, '--out', self.out], stdout=write, stderr=subprocess.PIPE,
                                text=True, check=False)
        os.close(write)
        self.assertEqual((result.returncode, 'Error' in result.stderr), (0, False), result.stderr)

    def test_locomotive_asked_for_is_drawn_and_named(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag, 2)
        run.traction_N[:, 1] = 7e3
        run.loco_energy_rail_J[:, 1] = 5e6
        traction, energy = draw_traction_force([run]).axes[0], draw_energy([run])
        self.assertEqual(set(traction.get_lines()[0].get_ydata()), {7.0})
        self.assertEqual(traction.get_title(), 'Traction force of locomotive 2')
        self.assertEqual(set(energy.axes[0].get_lines()[0].get_ydata()), {5.0})
        self.assertEqual(energy._suptitle.get_text(), 'Energy of locomotive 2')

    def test_rail_sections_are_shaded_and_named(self):
        write_bag(self.bag, duration_s=60.0, resolved='rail_sections: [{from_km: 3.02, to_km: 3.05, adhesion: {name: wet}}]')
        axes = draw_traction_force([read_bag(self.bag)]).axes[0]
        self.assertEqual([text.get_text() for text in axes.texts], ['wet'])
        spans = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
        for span in spans:
            np.testing.assert_allclose((span.x0, span.x1), (3.02, 3.05), rtol=1e-9)
        self.assertEqual(len(spans), 2)

    def test_energy_has_one_mark_where_a_run_ends_at_the_end_of_a_curve(self):
        for beyond_m, marks in ((0.2, 1), (40.0, 2)):
            write_bag(self.bag, duration_s=1.0)
            run = read_bag(self.bag)
            run.location_m[:] = np.linspace(3000.0, 3600.0 + beyond_m, len(run.location_m))
            line, points = draw_energy([run]).axes[0].get_lines()
            self.assertEqual((len(points.get_xdata()), line.get_label().count(' MJ at ')), (marks, marks))

    def test_racing_wheels_leave_the_frame_with_a_note(self):
        write_bag(self.bag, 'calm', run_id=1, duration_s=60.0)
        calm = read_bag(self.bag)
        write_bag(self.bag, 'racing', run_id=2, wagons=105, duration_s=60.0, limit_N=300e3, slip=20.0)
        racing = read_bag(self.bag)
        energy, account = draw_energy([calm, racing]), draw_energy_account([calm, racing])
        top = 1.25e-6 * max(calm.rim_J.max(), racing.rail_J.max())
        self.assertAlmostEqual(energy.axes[0].get_ylim()[1], top, places=9)
        self.assertIn(f'racing: the wheels race, work at the rim goes on to {racing.rim_J[-1] / 1e6:.0f} MJ',
                      energy.legends[0].get_title().get_text())
        self.assertAlmostEqual(account.axes[0].get_xlim()[1], 3.0 * top, places=6)  # three locomotives
        self.assertIn(f'on to {3e-6 * racing.rim_J[-1]:.0f} MJ', account.axes[0].texts[0].get_text())
        self.assertNotIn('race', draw_energy([calm]).legends[0].get_title().get_text())

    def test_traction_is_in_kN_over_km_with_the_limit(self):
        written = write_bag(self.bag, duration_s=60.0)
        axes = draw_traction_force([read_bag(self.bag)]).axes[0]
        traction, limit = axes.get_lines()
        np.testing.assert_allclose(traction.get_xdata(), written['location'] / 1e3, rtol=1e-12)
        np.testing.assert_allclose(traction.get_ydata(), written['traction'] / 1e3, rtol=1e-12)
        np.testing.assert_allclose(limit.get_ydata(), 460.089, rtol=1e-12)

    def test_adhesion_limit_is_marked_on_the_sides_that_come_near_it(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag)
        for low, high, marks, words in ((0.0, 460e3, [460.089], 'adhesion limit 0.35 m g = 460.1 kN'),
                                        (-300e3, 460e3, [460.089, -460.089], 'adhesion limit \u00b10.35 m g = \u00b1460.1 kN'),
                                        (-300e3, 0.0, [-460.089], 'adhesion limit -0.35 m g = -460.1 kN'),
                                        (-100e3, 0.0, [], 'adhesion limit 0.35 m g = 460.1 kN, beyond the axis')):
            run.traction_N[:, 0] = np.linspace(low, high, len(run.time_s))
            figure = draw_traction_force([run])
            axes = figure.axes[0]
            drawn = [line for line in axes.get_lines() if line.get_linestyle() == '--']
            np.testing.assert_allclose([line.get_ydata()[0] for line in drawn], marks, rtol=1e-12)
            self.assertIn(words, [text.get_text() for text in figure.legends[0].get_texts()])
            self.assertEqual('braking < 0' in axes.get_ylabel(), low < 0.0)
            for mark in marks:
                self.assertTrue(axes.get_ylim()[0] <= mark <= axes.get_ylim()[1])
            self.assertEqual(axes.get_ylim()[1] < 460.0, 460.089 not in marks)

    def test_run_without_traction_has_no_energy_picture_and_speed_alone(self):
        write_bag(self.bag, duration_s=10.0)
        run = read_bag(self.bag)
        self.assertEqual(len(draw_speed_notch([run]).axes), 2)
        for values in (run.loco_energy_rail_J, run.loco_energy_rim_J, run.notch):
            values[:] = 0.0
        self.assertIsNone(draw_energy([run]))
        speed, = draw_speed_notch([run]).axes
        self.assertIn('notch is 0', speed.get_title())

    def test_energy_is_in_MJ_and_kWh(self):
        written = write_bag(self.bag, duration_s=60.0)
        figure = draw_energy([read_bag(self.bag)])
        figure.canvas.draw()
        place, speed = figure.axes[:2]
        for axes, x in ((place, written['location'] / 1e3), (speed, written['speed'] * 3.6)):
            np.testing.assert_allclose(axes.get_lines()[0].get_xdata(), x, rtol=1e-12)
            np.testing.assert_allclose(axes.get_lines()[0].get_ydata(), written['work'] / 1e6, rtol=1e-12)
        kwh, = speed.child_axes
        np.testing.assert_allclose(kwh.get_ylim(), np.array(speed.get_ylim()) * 1e6 / 3.6e6, rtol=1e-12)

    def test_energy_shows_the_rim_only_where_it_differs(self):
        for slip, lines in ((0.0, ['-']), (0.1, ['-', '--'])):
            write_bag(self.bag, slip=slip, limit_N=50e3, duration_s=60.0)
            drawn = draw_energy([read_bag(self.bag)]).axes[0].get_lines()
            self.assertEqual([line.get_linestyle() for line in drawn if line.get_linestyle() != 'None'], lines)

    def test_account_names_the_residual_and_the_end(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag)
        run.account['residual'][-1] = -12.3e3
        cells = [cell.get_text().get_text() for cell in draw_energy_account([run]).axes[1].tables[0].get_celld().values()]
        for text in ('residual [J]', '-12300', '60.00', f'{run.speed_mps[-1] * 3.6:.3f}'):
            self.assertIn(text, cells)

    def test_page_opens_offline_with_every_figure_numbers_and_configuration(self):
        other = self.bag.replace('run.bag', 'other.bag')
        write_bag(self.bag, '1d', run_id=1, duration_s=60.0)
        write_bag(other, '2d', run_id=2, duration_s=60.0, slip=0.1, limit_N=50e3, with_wheels=(1,))
        self.assertEqual(self.report(self.bag, other, '--out', self.out).returncode, 0)
        with open(os.path.join(self.out, 'report.html'), encoding='utf-8') as file:
            page = file.read()
        pictures = [name for name in os.listdir(self.out) if name.endswith('.png')]
        self.assertEqual(page.count('src="data:image/png;base64,iVBORw0KGgo'), len(pictures))
        for name in pictures:
            self.assertEqual(page.count(f'<figcaption>{name[:-4]}: '), 1, name)
        self.assertEqual(re.findall(r'src="(?!data:)|href="(?!#)|https?:|@import|url\(', page), [])
        run = read_bag(other)
        for text in (f'{run.time_s[-1]:.2f}', f'{run.speed_kmph[-1]:.2f}', f'{run.loco_energy_rail_J[-1, 0] / 1e6:.2f}',
                     f'{run.loco_energy_rim_J[-1, 0] / 1e6:.2f}', 'test', other):
            self.assertIn(f'>{text}</td>', page)
        self.assertIn('control: {law: pi, slip_limit: 0.07}', page)
        self.assertIn('is not a saving', page)

    def test_flow_picture_balances_and_names_every_stage_in_MJ(self):
        write_bag(self.bag, slip=0.1, limit_N=50e3, duration_s=60.0)
        run = read_bag(self.bag)
        run.account['potential'][-1] = -30e6
        run.account['kinetic'][-1] += 30e6
        sources, losses, sinks, braked = flows_of(run)
        self.assertEqual(braked, [])
        self.assertEqual([flow[0] for flow in sources], ['motors, at the rim', 'given back: potential, change'])
        self.assertEqual([flow[0] for flow in losses], ['slip loss', 'wheel spin-up and other storage'])
        self.assertAlmostEqual(sources[1][2], 30.0, places=9)
        total = [sum(flow[2] for flow in flows) for flows in (sources, losses, sinks)]
        self.assertAlmostEqual(total[0], total[1] + total[2], delta=1e-6 * total[0])  # the residual is 1e-9 of it
        texts = ' '.join(text.get_text() for text in draw_energy_flow(run).axes[0].texts)
        for words in ('at the rail\n', 'of it traction\n', 'kinetic, change: ', 'slip loss: ', 'residual', f'{run.speed_kmph[-1]:.2f} km/h'):
            self.assertIn(words, texts)
        self.assertEqual(texts.count(' MJ'), len(sources) + len(losses) + len(sinks) + 2)

    def test_coupler_map_is_symmetric_and_keeps_peaks(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag)
        run.coupler_force_N[1234, 3] = -5e6
        mesh = draw_coupler_forces(run).axes[0].collections[0]
        self.assertEqual(mesh.get_clim(), (-5000.0, 5000.0))
        self.assertEqual(mesh.get_array().min(), -5000.0)

    def test_bins_hold_the_value_farthest_from_zero(self):
        values = np.zeros((10 * COLUMNS, 2))
        values[25], values[29] = (3.0, -4.0), (-2.0, 4.5)
        edges, extremes = bin_extremes(np.arange(10.0 * COLUMNS), values)
        self.assertEqual((len(edges), extremes.shape), (COLUMNS + 1, (COLUMNS, 2)))
        self.assertEqual(edges[2], 20.0)
        np.testing.assert_array_equal(extremes[2], (3.0, 4.5))
        self.assertEqual(np.count_nonzero(extremes), 2)


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_report', ReportTest)
