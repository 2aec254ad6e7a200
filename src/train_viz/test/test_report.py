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
from train_viz.place_figures import draw_energy
from train_viz.run import ReportError

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
        for words in ('<li>adhesion_creep, adhesion_control, axle_loads of 1d: no wheels on the rail', '<li>brake_pressures of 2d: no air',
                      'guiding_forces, wheel_contacts of 2d: nothing of every wheel'):
            self.assertIn(words, page)
        for words in ('<li>energy:', '<li>friction_adhesion', 'axle_loads of 2d', 'coupler_forces of'):  # they are there
            self.assertNotIn(words, page)
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

    def test_title_of_couplers_takes_the_peaks_of_every_step_from_the_runs_folder(self):
        write_bag(self.bag, duration_s=60.0)
        run = read_bag(self.bag)
        path = os.path.join(os.path.dirname(self.bag), 'couplers.csv')

        def title(largest_draft_N, couplers=7):
            with open(path, 'w', encoding='utf-8') as file:
                file.write('coupler,largest_draft_N,draft_time_s,draft_location_km,largest_buff_N,buff_time_s,buff_location_km\n')
                file.writelines(f'{i},{largest_draft_N},1,3,{1.5e6 if i == 5 else 0.9e6},1,3\n' for i in range(1, couplers + 1))
            return draw_coupler_forces(run).axes[0].get_title()

        self.assertIn('largest of every step: draft 2000 kN (coupler 1), buff 1500 kN (coupler 5)', title(2e6))
        largest = f'largest of the recorded samples: draft {run.coupler_force_N.max() / 1e3:.0f} kN'
        self.assertIn(largest, title(0.9 * run.coupler_force_N.max()))  # of a run that stopped earlier
        self.assertIn(largest, title(2e6, couplers=8))                  # of another train
        with self.assertRaisesRegex(ReportError, 'couplers.csv, line 2'):
            title('x')
        os.remove(path)
        self.assertIn(largest, draw_coupler_forces(run).axes[0].get_title())

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
