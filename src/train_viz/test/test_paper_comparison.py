#!/usr/bin/env python3
"""The paper's comparison: the numbers beside the paper's, the marks in the figures, the page."""
import html
import re
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt
from matplotlib.colors import to_rgb

from synthetic_run import RESIDUAL_RELATIVE, write_run_folder
from train_viz import comparison_figures as figures
from train_viz.comparison import FITTED, PREDICTED, Comparison
from train_viz.comparison_page import comparison_page
from train_viz.comparison_verdict import verdict
from train_viz.equal_speed_figure import draw_equal_speed
from train_viz.run_folder import read_run_folders

# Forces that the paper states or that give what it states, energies with its percentages against 3D.
PAPER_N = {'1d': {3.15: 460e3, 3.3: 450e3, 3.45: 460e3}, '2d': {3.15: 400e3, 3.4: 365.6e3, 3.45: 386e3},
           '3d': {3.15: 416e3, 3.3: 400e3, 3.4: 400e3, 3.45: 423e3}}
PAPER_J = {'1d': {3.6: 107.6e6, 4.5: 205e6}, '2d': {3.6: 95.1e6, 4.5: 196.6e6}, '3d': {3.6: 100e6, 4.5: 200e6}}


def as_in_the_paper(model):
    changed = {('traction_force', place): value for place, value in PAPER_N[model].items()}
    changed.update({('energy_rail', place): value for place, value in PAPER_J[model].items()})
    return changed


def legend_texts(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def marks(axes):
    """Points of the paper's diamonds by label."""
    return {line.get_label(): list(zip(line.get_xdata(), line.get_ydata())) for line in axes.get_lines()
            if line.get_marker() == 'D'}


def curves(axes):
    """Lines that hold a run's rows."""
    return [line for line in axes.get_lines() if len(line.get_xdata()) > 100]


def cells_of(page):
    """Rows of all tables of a page as lists of texts."""
    return [[html.unescape(re.sub('<[^>]*>', '', cell)) for cell in re.findall(r'<t[hd][^>]*>(.*?)</t[hd]>', row)]
            for row in re.findall('<tr>(.*?)</tr>', page)]


class PaperComparisonTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.folder = {key: write_run_folder(directory.name, key, as_in_the_paper(key)) for key in ('1d', '2d', '3d')}
        cls.folder['3d_two_point'] = write_run_folder(
            directory.name, '3d_two_point', {('traction_force', 3.15): 384e3, ('traction_force', 3.45): 380e3},
            limit_N=390e3)
        cls.folders = {folder.key: folder for folder in read_run_folders(list(cls.folder.values()))}
        cls.three = Comparison([cls.folders[key] for key in ('1d', '2d', '3d')])
        cls.four = Comparison(list(cls.folders.values()))
        cls.two = Comparison([cls.folders['1d'], cls.folders['2d']])

    def setUp(self):
        self.addCleanup(plt.close, 'all')

    def test_page_says_why_signs_differ_only_where_they_do(self):
        words = 'force falls into the curve, the paper&#x27;s rises'
        self.assertNotIn(words, comparison_page(self.three, {}))  # 416 to 423 kN
        page = comparison_page(self.four, {})
        self.assertIn(f'3D two-point: {words}', page)  # 384 to 380 kN
        self.assertEqual(page.count(words), 1)
        self.assertNotIn('more than one contact.', page)  # these bags tell of none

    # ---- numbers

    def test_runs_come_in_the_papers_order_with_names_of_their_own(self):
        self.assertEqual(list(self.folders), ['1d', '2d', '3d', '3d_two_point'])
        self.assertEqual([folder.label for folder in self.folders.values()], ['1D', '2D', '3D', '3D two-point'])
        self.assertIs(self.four.base, self.folders['3d'])

    def test_the_papers_own_values_deviate_by_nothing(self):
        rows = self.three.rows()
        self.assertEqual(len(rows), 6 + 3 + 6 + 2 + 4)
        for row in rows:
            # 0.1 points: the paper rounds +12.5 % and the like to a tenth; its ratios follow from its percentages
            self.assertAlmostEqual(row.deviation, 0.0, delta=0.1 if row.unit == '%' else 1e-9, msg=str(row))

    def test_deviation_is_ours_less_the_papers_in_its_unit(self):
        rows = [row for row in self.four.rows() if row.whose == '3D two-point' and row.quantity == 'traction']
        np.testing.assert_allclose([row.deviation for row in rows], (384.0 - 416.0, 380.0 - 423.0), rtol=1e-12)
        self.assertEqual({row.unit for row in rows}, {'kN'})
        row, = [row for row in self.four.rows() if row.whose == '2D against 3D two-point' and row.place.startswith('3.15')]
        self.assertAlmostEqual(row.ours, 100.0 * (400.0 / 384.0 - 1.0), places=9)
        self.assertAlmostEqual(row.paper, 100.0 * (400.0 / 416.0 - 1.0), places=9)

    def test_what_involves_3d_is_predicted_and_the_rest_fitted(self):
        for row in self.four.rows():
            self.assertEqual(row.kind, PREDICTED if '3D' in row.whose else FITTED, row)

    def test_without_3d_1d_is_compared_with_2d_and_nothing_with_3d(self):
        rows = self.two.rows()
        self.assertFalse([row for row in rows if '3D' in row.whose])
        against = {row.place: row.paper for row in rows if row.whose == '1D against 2D'}
        np.testing.assert_allclose(list(against.values()), (15.0, 100.0 * (460.0 / 386.0 - 1.0)), rtol=1e-12)
        np.testing.assert_allclose([row.paper for row in rows if row.whose == '1D / 2D'], (1.13144, 1.04273), atol=1e-5)

    def test_largest_difference_is_sought_at_the_papers_places(self):
        place, value = self.three.largest_difference(self.folders['2d'], self.folders['3d'])
        self.assertEqual(place, 3.4)
        self.assertAlmostEqual(value, -8.6, places=9)

    def test_equal_speed_is_the_slowest_ones_final_speed_where_each_first_reaches_it(self):
        slowest = self.folders['3d_two_point']
        self.assertEqual(self.four.equal_speed_mps, slowest.run.speed_mps[-1])
        for folder in self.four.folders:
            s = self.four.stages_at_equal_speed(folder)
            run = folder.run
            self.assertAlmostEqual(s.speed_mps, self.four.equal_speed_mps, places=12)
            self.assertAlmostEqual(np.interp(s.speed_mps, run.speed_mps, run.time_s), s.time_s, places=9)
            for got, values in ((s.rail_J, run.loco_energy_rail_J), (s.rim_J, run.loco_energy_rim_J),
                                (s.slip_J, run.loco_energy_slip_J)):
                np.testing.assert_allclose(got, np.interp(s.time_s, run.time_s, values[:, 0]), rtol=1e-9, atol=1e-3)
            self.assertAlmostEqual(s.stored_J, s.rim_J - s.rail_J - s.slip_J, places=3)
        self.assertEqual(self.four.stages_at_equal_speed(slowest).time_s, slowest.run.time_s[-1])
        self.assertLess(self.four.stages_at_equal_speed(self.folders['1d']).time_s, self.folders['1d'].run.time_s[-1])

    # ---- figures

    def test_fig6_marks_the_stated_forces_in_kN(self):
        for comparison in (self.two, self.four):
            figure = figures.draw_fig6(comparison)
            for axes in figure.axes:
                self.assertEqual(len(curves(axes)), len(comparison.runs))
                for line, run in zip(curves(axes), comparison.runs):
                    np.testing.assert_allclose(line.get_xdata(), run.location_m / 1e3, rtol=1e-12)
                    np.testing.assert_allclose(line.get_ydata(), run.traction_N[:, 0] / 1e3, rtol=1e-12)
                self.assertEqual(axes.get_ylabel(), 'traction at the rail [kN]')
                self.assertEqual(axes.get_xlabel(), 'place of the leading locomotive [km]')
                self.assertEqual(sorted(marks(axes).values()),
                                 [[(3.15, 400.0), (3.45, 386.0)], [(3.15, 416.0), (3.45, 423.0)],
                                  [(3.15, 460.0), (3.45, 460.0)]])
            self.assertIn('paper, 3D: 416 kN at 3.15 km, 423 kN at 3.45 km', legend_texts(figure))
            near = figure.axes[1]
            self.assertEqual({'460', '400', '416', '386', '423'} - {text.get_text() for text in near.texts}, set())
            first, last = near.get_ylim()
            self.assertTrue(first < 380.0 and last > 460.0)

    def test_fig7_marks_force_over_weight(self):
        axes = figures.draw_fig7(self.four).axes[0]
        np.testing.assert_allclose(sorted(marks(axes).values()), [[(3.15, 0.30428), (3.45, 0.29364)],
                                                                  [(3.15, 0.31646), (3.45, 0.32178)]], atol=1e-5)
        self.assertIn('[-]', axes.get_ylabel())

    def test_fig8_has_percentages_against_3d_and_speed_and_time_beside_energy(self):
        figure = figures.draw_fig8(self.three)
        energy, difference = figure.axes
        self.assertEqual(len(curves(energy)), 3)
        for line, run in zip(curves(energy), self.three.runs):
            np.testing.assert_allclose(line.get_ydata(), run.loco_energy_rail_J[:, 0] / 1e6, rtol=1e-12)
        self.assertIn('[MJ]', energy.get_ylabel())
        self.assertEqual(difference.get_ylabel(), 'difference against 3D [%]')
        got = marks(difference)
        np.testing.assert_allclose(got['paper, 1D against 3D: +7.6 % at 3.6 km, +2.5 % at 4.5 km'],
                                   [(3.6, 7.6), (4.5, 2.5)], rtol=1e-9)
        np.testing.assert_allclose(got['paper, 2D against 3D: -4.9 % at 3.6 km, -1.7 % at 4.5 km'],
                                   [(3.6, -4.9), (4.5, -1.7)], rtol=1e-9)
        for folder in self.three.folders:
            end = self.three.stages(folder, 4.5)
            words, = [text for text in legend_texts(figure) if text.startswith(f'{folder.label}: ')]
            self.assertIn(f'{end.rail_J / 1e6:.1f} MJ at 4.5 km ({end.time_s:.1f} s, {3.6 * end.speed_mps:.2f} km/h)', words)

    def test_fig8_curve_of_difference_is_that_of_the_bags(self):
        line, _ = curves(figures.draw_fig8(self.three).axes[1])
        run, base = self.folders['1d'].run, self.folders['3d'].run
        at = len(line.get_xdata()) // 2
        place = 1e3 * line.get_xdata()[at]
        expected = 100.0 * (np.interp(place, run.location_m, run.loco_energy_rail_J[:, 0]) /
                            np.interp(place, base.location_m, base.loco_energy_rail_J[:, 0]) - 1.0)
        self.assertAlmostEqual(line.get_ydata()[at], expected, places=9)

    def test_fig9_bars_are_differences_of_force_and_the_largest_are_marked(self):
        axes, = figures.draw_fig9(self.three).axes
        self.assertEqual([tick.get_text() for tick in axes.get_xticklabels()], ['3.2', '3.3', '3.4', '3.5', '3.6'])
        of_1d, of_2d = axes.containers
        self.assertAlmostEqual(of_1d[1].get_height(), 12.5, places=9)
        self.assertAlmostEqual(of_2d[2].get_height(), -8.6, places=9)
        self.assertEqual(axes.get_ylabel(), 'difference of traction against 3D [%]')
        (mark_1d,), (mark_2d,) = (marks(axes)[words] for words in ('paper, 1D against 3D: +12.5 % at 3.3 km',
                                                                  'paper, 2D against 3D: -8.6 % at 3.4 km'))
        diamonds = [line for line in axes.get_lines() if line.get_marker() == 'D']
        self.assertEqual([to_rgb(line.get_markerfacecolor()) for line in diamonds],
                         [bars[0].get_facecolor()[:3] for bars in (of_1d, of_2d)])
        np.testing.assert_allclose(mark_1d, (of_1d[1].get_x() + of_1d[1].get_width() / 2.0, 12.5), rtol=1e-9)
        np.testing.assert_allclose(mark_2d, (of_2d[2].get_x() + of_2d[2].get_width() / 2.0, -8.6), rtol=1e-9)

    def test_fig9_without_3d_is_against_2d_with_what_the_forces_give(self):
        axes, = figures.draw_fig9(self.two).axes
        self.assertEqual(axes.get_ylabel(), 'difference of traction against 2D [%]')
        points, = marks(axes).values()
        np.testing.assert_allclose([value for _, value in points], (15.0, 19.170984), rtol=1e-6)

    def test_fig3_has_a_panel_a_run_with_slip_limit_and_static_friction(self):
        figure = figures.draw_fig3(self.four)
        self.assertEqual([axes.get_title() for axes in figure.axes], ['2D', '3D', '3D two-point'])
        for axes, key in zip(figure.axes, ('2d', '3d', '3d_two_point')):
            wheels = self.folders[key].run.adhesion
            np.testing.assert_allclose(axes.collections[0].get_offsets(),
                                       np.column_stack([100.0 * wheels.creep.ravel(), wheels.adhesion.ravel()]), rtol=1e-9)
        self.assertIn('paper: slip limit 7 %', legend_texts(figure))
        self.assertIn('paper: static friction 0.35', legend_texts(figure))
        self.assertIn('[%]', figure._supxlabel.get_text())

    def test_equal_speed_figure_stacks_rail_slip_and_storage(self):
        figure = draw_equal_speed(self.three)
        lines, bars = figure.axes
        self.assertEqual(lines.get_lines()[0].get_xdata()[0], 3.6 * self.three.equal_speed_mps)
        of_1d, rail, rim, *_ = curves(lines)
        for line, folder, energy_J in ((of_1d, '1d', 'loco_energy_rail_J'), (rail, '2d', 'loco_energy_rail_J'),
                                       (rim, '2d', 'loco_energy_rim_J')):
            run = self.folders[folder].run
            np.testing.assert_allclose(line.get_xdata(), 3.6 * run.speed_mps, rtol=1e-12)
            np.testing.assert_allclose(line.get_ydata(), getattr(run, energy_J)[:, 0] / 1e6, rtol=1e-12)
        widths = [patch.get_width() for patch in bars.patches[:9]]
        expected = [value / 1e6 for folder in self.three.folders for s in [self.three.stages_at_equal_speed(folder)]
                    for value in (s.rail_J, s.slip_J, s.stored_J)]
        np.testing.assert_allclose(widths, expected, rtol=1e-9, atol=1e-9)
        self.assertTrue(all('[MJ]' in label for label in (lines.get_ylabel(), bars.get_xlabel())))

    # ---- page

    def test_page_says_first_what_is_as_in_the_paper_and_what_is_not(self):
        words = verdict(self.four)
        page = html.unescape(comparison_page(self.four, {}))
        self.assertLess(page.index(words[0]), page.index('<section'))
        for part in ('Fitted: forces of 1D and 2D and the ratio of their energies lie within 0.00 % of',
                     'As in the paper: 3D pulls 416.0 kN at 3.15 km, on straight track, the paper\'s 416 kN (+0.0 %); the '
                     'order is 2D below 3D below 1D.',
                     'As in the paper: into the curve the force of 3D rises by 1.7 %, the paper\'s rises by 1.7 %; 423.0 kN at '
                     '3.45 km against 423 kN (+0.0 %).',
                     'Not as in the paper: 3D two-point pulls 384.0 kN at 3.15 km, on straight track, the paper\'s 416 kN '
                     '(-7.7 %); the order is 3D below 2D below 1D, the paper\'s 2D below 3D below 1D.',
                     'Not as in the paper: into the curve the force of 3D two-point falls by 1.0 %, the paper\'s rises by 1.7 %',
                     'As in the paper in sign: 1D against 3D, traction +8.7 to +12.5 % (paper +8.7 to +12.5 %); energy '
                     '+2.5 to +7.6 % (paper +2.5 to +7.6 %).'):
            self.assertTrue(any(part in sentence for sentence in words), (part, words))
        self.assertEqual(len(words), 1 + 2 * 2 + 2)
        self.assertEqual(len(verdict(self.two)), 1)  # without 3D only what is fitted

    def test_opposite_signs_are_told_first_of_all(self):
        with tempfile.TemporaryDirectory() as directory:
            folder, = read_run_folders([write_run_folder(directory, '2d', {**as_in_the_paper('2d'),
                                                                                ('traction_force', 3.45): 424e3})])
            comparison = Comparison([folder, self.folders['3d']])
        self.assertIn('Not as in the paper: 2D against 3D', verdict(comparison)[-1])
        self.assertIn('opposite sign at 1 of 5 values', verdict(comparison)[-1])

    def test_badges_of_kinds_have_no_colour_of_praise(self):
        badge = re.search(r'\.badge\.outlined {([^}]*)}', comparison_page(self.four, {}))[1]
        for colour in re.findall('#([0-9a-f]+)', badge):
            self.assertEqual(len(set(colour)), 1, colour)  # grey

    def test_page_has_every_value_beside_the_papers_with_its_kind(self):
        rows = cells_of(comparison_page(self.four, {}))
        for expected in (['3.15 km', '1D', '460', '460.0', '+0.00 kN', '+0.00 %', 'fitted'],
                         ['3.15 km', '3D two-point', '416', '384.0', '-32.00 kN', '-7.69 %', 'predicted'],
                         ['3.15 to 3.45 km', '3D two-point', '+1.7', '-1.0', '-2.72 points', 'opposite sign', 'predicted'],
                         ['3.3 km', '1D against 3D', '+12.5', '+12.5', '+0.00 points', '', 'predicted'],
                         ['to 4.5 km', '2D against 3D', '-1.7', '-1.7', '+0.00 points', '', 'predicted'],
                         ['to 3.6 km', '1D / 2D', '1.131', '1.1314', '+0.0000', '+0.00 %', 'fitted']):
            self.assertIn(expected, [row[:7] for row in rows])
        headers = [row[0] for row in rows]
        for header in ('traction [kN]', 'difference of traction [%]', 'ratio of energy, Eq. (4) [-]',
                       'difference of energy, Eq. (4) [%]'):
            self.assertIn(header, headers)

    def test_page_names_every_stage_with_speed_and_time(self):
        page = comparison_page(self.three, {})
        rows = cells_of(page)
        header = next(row for row in rows if row[0] == 'from 3.0 km to')
        self.assertEqual(header[2:8], ['time [s]', 'speed [km/h]', 'at the rail, Eq. (4) [MJ]', 'slip loss [MJ]',
                                       'spin-up and other storage [MJ]', 'at the rim [MJ]'])
        s = self.three.stages(self.folders['2d'], 4.5)
        self.assertIn(['4.5 km', '2D', f'{s.time_s:.2f}', f'{3.6 * s.speed_mps:.2f}', '196.60', f'{s.slip_J / 1e6:.2f}',
                       f'{s.stored_J / 1e6:.2f}', f'{s.rim_J / 1e6:.2f}', '-1.7 %'], [row[:9] for row in rows])
        s = self.three.stages_at_equal_speed(self.folders['1d'])
        self.assertIn(['1D', f'{s.time_s:.2f}', f'{s.location_m / 1e3:.3f}', f'{s.rail_J / 1e6:.2f}'],
                      [row[:4] for row in rows])
        self.assertEqual(page.count('k0 = 0.075'), 2)  # beside both tables that show the slip loss
        self.assertIn('is not a saving', page)
        self.assertNotIn('k0', re.sub('<pre>.*?</pre>', '', comparison_page(Comparison([self.folders['1d']]), {}), flags=re.S))

    def test_page_tells_residual_configuration_build_and_how_to_reproduce(self):
        page = comparison_page(self.four, {})
        rows = cells_of(page)
        self.assertIn(['residual / traction or brakes, the larger'] + 4 * [f'{RESIDUAL_RELATIVE:+.1e}'], rows)
        self.assertIn(['residual [J]'] + 4 * ['+48.8'], rows)
        self.assertIn(['build'] + 4 * ['test'], rows)
        self.assertIn(['digest of all exchanges', 'cafe1d', 'cafe2d', 'cafe3d', 'cafe3d_two_point'], rows)
        self.assertIn(['exponential friction decrease B [s/m]', '-', '0.275', '0.275', '0.275'], rows)
        self.assertEqual(page.count('<details>'), 4)
        self.assertIn('description: synthetic 3d_two_point', page)
        self.assertIn('ltd_offline config/scenarios/paper_3d_two_point.yaml --out OUT/3d_two_point', page)

    def test_page_without_3d_says_so_and_goes_on(self):
        page = comparison_page(self.two, {})
        self.assertIn('There is no run of 3D here', page)
        self.assertIn('Instead 1D is compared with 2D', page)
        self.assertNotIn('against 3D</td>', page)
        self.assertNotIn('There is no run of', comparison_page(self.three, {}))
        self.assertIn('no run of 2D and 3D', comparison_page(Comparison([self.folders['1d']]), {}))


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_paper_comparison', PaperComparisonTest)
