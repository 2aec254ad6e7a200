#!/usr/bin/env python3
"""The figures of wheels on the rail show what the bag holds, with units, and say what they leave out."""
import dataclasses
import os
import tempfile
import unittest

import numpy as np
import rosunit
from matplotlib import pyplot as plt

from synthetic_bag import AXLES, write_bag
from train_viz import plot_style
from train_viz.adhesion import true_stretches
from train_viz.adhesion_figures import draw_adhesion_creep, draw_axle_loads, draw_friction_adhesion
from train_viz.bag_reader import read_bag
from train_viz.control_figure import draw_adhesion_control


def legend_texts(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def curves(axes):
    """Lines that hold data; the legend's keys hold none, and limits have two points."""
    return [line for line in axes.get_lines() if len(line.get_xdata()) > 2]


class AdhesionFiguresTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, 'run.bag')
            cls.written = write_bag(path, '2d', wagons=105, duration_s=60.0, with_wheels=(1,))  # heavy: slips
            cls.run_2d = read_bag(path)
            write_bag(path, 'behind', duration_s=60.0, with_wheels=(2,))
            cls.run_behind = read_bag(path)
            write_bag(path, '1d', duration_s=60.0)
            cls.run_1d = read_bag(path)

    def setUp(self):
        self.addCleanup(plt.close, 'all')
        self.axles = self.written['axles']
        self.place_km = self.written['location'] / 1e3

    def with_wheels(self, **changes):
        return dataclasses.replace(self.run_2d, adhesion=dataclasses.replace(self.run_2d.adhesion, **changes))

    def assert_axle_curves(self, axes, values, label):
        lines = [line for line in curves(axes) if line.get_linestyle() == '-']
        self.assertEqual(len(lines), AXLES)
        for axle, line in enumerate(lines):
            np.testing.assert_allclose(line.get_xdata(), self.place_km, rtol=1e-12)
            np.testing.assert_allclose(line.get_ydata(), values[:, axle], rtol=1e-12)
        self.assertEqual(len({line.get_color() for line in lines}), AXLES)
        self.assertEqual(axes.get_ylabel(), label)

    def test_every_axle_has_adhesion_and_friction_over_creep_coloured_by_speed(self):
        figure = draw_adhesion_creep(self.run_2d)
        panels = [axes for axes in figure.axes if axes.get_title().startswith('axle')]
        self.assertEqual([axes.get_title() for axes in panels], [f'axle {n}' for n in range(1, AXLES + 1)])
        for axle, axes in enumerate(panels):
            friction, adhesion = axes.collections
            for points, name in ((friction, 'friction'), (adhesion, 'adhesion')):
                np.testing.assert_allclose(points.get_offsets(), np.column_stack(
                    [100.0 * self.axles['creep'][:, axle], self.axles[name][:, axle]]), rtol=1e-12)
                np.testing.assert_allclose(points.get_array(), 3.6 * self.written['speed'], rtol=1e-12)
            self.assertEqual([line.get_xdata()[0] for line in axes.get_lines()], [100.0 * 0.07])
        self.assertEqual(figure.axes[-1].get_ylabel(), 'speed [km/h]')
        self.assertEqual(figure._supxlabel.get_text(), 'creep [%]')
        self.assertEqual(figure._supylabel.get_text(), 'coefficient of adhesion or friction [-]')
        self.assertEqual(len(legend_texts(figure)), 3)
        self.assertIn('slip limit 7 %', legend_texts(figure))

    def test_creep_of_racing_wheels_gets_a_logarithmic_axis_that_says_so(self):
        creep = self.run_2d.adhesion.creep.copy()
        creep[-1, 0] = 70.0
        run = self.with_wheels(creep=creep)
        over_creep, over_place = draw_adhesion_creep(run), draw_adhesion_control(run)
        self.assertEqual(over_creep.axes[0].get_xscale(), 'symlog')
        self.assertIn('logarithmic beyond 10 %', over_creep._supxlabel.get_text())
        self.assertEqual(over_place.axes[0].get_yscale(), 'symlog')
        self.assertIn('logarithmic beyond 10 %', over_place.axes[0].get_ylabel())

    def test_slip_limit_is_marked_on_the_side_that_comes_near_it(self):
        creep = self.run_2d.adhesion.creep
        both = np.where(np.arange(len(creep))[:, None] % 2, creep, -creep)
        for values, marks, sign in ((creep, (7.0,), ''), (-creep, (-7.0,), '-'), (both, (7.0, -7.0), '\u00b1')):
            figure = draw_adhesion_creep(self.with_wheels(creep=values))
            np.testing.assert_allclose([line.get_xdata()[0] for line in figure.axes[0].get_lines()], marks, rtol=1e-12)
            self.assertIn(f'slip limit {sign}7 %', legend_texts(figure))

    def test_slip_limit_that_no_wheel_comes_near_is_told_and_not_drawn(self):
        run = self.with_wheels(creep=0.1 * self.run_2d.adhesion.creep)
        creep = draw_adhesion_creep(run)
        self.assertEqual([len(line.get_xdata()) for line in creep.axes[0].get_lines()], [0])
        self.assertLess(creep.axes[0].get_xlim()[1], 1.0)
        control = draw_adhesion_control(run)
        self.assertLess(control.axes[0].get_ylim()[1], 1.0)
        for figure in (creep, control):
            self.assertIn('slip limit 7 %, beyond the axis', legend_texts(figure))

    def test_slip_limit_that_a_wheel_comes_near_is_on_the_axis(self):
        creep = self.run_2d.adhesion.creep
        for factor, side in ((0.6, 1), (-0.6, 0)):
            limits = draw_adhesion_creep(self.with_wheels(creep=factor * creep)).axes[0].get_xlim()
            self.assertGreater(abs(limits[side]), 7.0)

    def test_braking_wheels_lie_below_zero_with_the_friction_that_they_may_use(self):
        adhesion, friction = self.run_2d.adhesion.adhesion, self.run_2d.adhesion.friction
        run = self.with_wheels(creep=-self.run_2d.adhesion.creep, adhesion=-adhesion,
                               shoe_torque_N_m=np.full_like(adhesion, -3e3))
        offered = draw_adhesion_creep(run).axes[0].collections[0].get_offsets()
        slips = run.adhesion.creep[:, 0] < 0.0
        np.testing.assert_allclose(offered[slips, 1], -friction[slips, 0], rtol=1e-12)
        mirrored = [line for line in curves(draw_friction_adhesion([run]).axes[0]) if np.nanmax(line.get_ydata()) < 0.0]
        self.assertEqual(len(mirrored), 2)  # static friction, friction at the slip
        torque = draw_adhesion_control(run).axes[1]
        shoes, = [line for line in curves(torque) if line.get_label() == 'torque of shoes']
        np.testing.assert_allclose(shoes.get_ydata(), -3.0, rtol=1e-12)

    def test_control_shows_creep_torque_and_where_it_acts(self):
        figure = draw_adhesion_control(self.run_2d)
        creep, torque, active = figure.axes
        self.assert_axle_curves(creep, 100.0 * self.axles['creep'], 'creep [%]')
        self.assert_axle_curves(torque, self.axles['torque_applied'] / 1e3, 'torque on the wheelset [kN m]')
        demanded = [line for line in curves(torque) if line.get_linestyle() == ':']
        self.assertEqual(len(demanded), AXLES)  # of each axle another torque
        for axle, line in enumerate(demanded):
            np.testing.assert_allclose(line.get_ydata(), self.axles['torque_demanded'][:, axle] / 1e3, rtol=1e-12)
        for axle, bars in enumerate(active.collections[-AXLES:]):
            (path,) = bars.get_paths()
            acts = self.place_km[self.axles['controller_active'][:, axle]]
            extents = path.get_extents()
            np.testing.assert_allclose((extents.x0, extents.x1), (acts[0], acts[-1]), rtol=1e-9)
            np.testing.assert_allclose((extents.y0, extents.y1), (axle + 0.65, axle + 1.35), rtol=1e-9)
        self.assertEqual(active.get_xlabel(), 'place of the leading locomotive [km]')

    def test_equal_demands_are_one_line_and_no_controller_no_panel(self):
        applied = self.run_2d.adhesion.torque_applied_N_m
        run = self.with_wheels(torque_demanded_N_m=applied, controller_active=np.zeros_like(applied))
        creep, torque = draw_adhesion_control(run).axes
        self.assertEqual(len([line for line in curves(torque) if line.get_linestyle() == ':']), 1)
        self.assertIn('no controller', torque.get_title())

    def test_axle_loads_and_slip_losses_have_a_line_an_axle_in_kN_and_kW(self):
        figure = draw_axle_loads(self.run_2d)
        for axes, name, label in zip(figure.axes, ('normal_force', 'frictional_power', 't_gamma'),
                                     ('axle load [kN]', 'frictional power [kW]', 'T-gamma [kN = kJ/m]')):
            self.assert_axle_curves(axes, self.axles[name] / 1e3, label)
        self.assertEqual(legend_texts(figure), [f'axle {n}' for n in range(1, AXLES + 1)])

    def test_friction_over_place_is_three_means_and_the_range_of_adhesion(self):
        axes, = draw_friction_adhesion([self.run_2d]).axes
        lines = curves(axes)
        self.assertEqual(len(lines), 3)
        for line, name in zip(lines, ('static_friction', 'friction', 'adhesion')):
            np.testing.assert_allclose(line.get_xdata(), self.place_km, rtol=1e-12)
            np.testing.assert_allclose(line.get_ydata(), self.axles[name].mean(axis=1), rtol=1e-12)
        self.assertEqual(len({line.get_linestyle() for line in lines}), 3)
        corners = axes.collections[0].get_paths()[0].vertices
        for i in (1000, 2000):
            here = corners[np.isclose(corners[:, 0], self.place_km[i], rtol=0.0, atol=1e-9), 1]
            np.testing.assert_allclose((here.min(), here.max()),
                                       (self.axles['adhesion'][i].min(), self.axles['adhesion'][i].max()), rtol=1e-9)
        self.assertEqual(axes.get_ylabel(), 'coefficient of friction or adhesion [-]')
        self.assertEqual(axes.get_xlabel(), 'place of the leading locomotive [km]')

    def test_run_without_wheels_is_named_and_colours_stay_those_of_the_other_figures(self):
        figure = draw_friction_adhesion([self.run_1d, self.run_2d])
        self.assertIn('1d', figure.legends[0].get_title().get_text())
        self.assertEqual({line.get_color() for line in curves(figure.axes[0])}, {plot_style.line_style(1)['color']})

    def test_two_runs_with_wheels_are_told_apart(self):
        figure = draw_friction_adhesion([self.run_2d, dataclasses.replace(self.run_2d, label='other')])
        self.assertEqual(len(curves(figure.axes[0])), 6)
        for label in ('2d', 'other', 'static friction', 'friction offered at the slip', 'adhesion used, mean of the axles'):
            self.assertIn(label, legend_texts(figure))

    def test_runs_without_wheels_give_no_figure(self):
        self.assertIsNone(draw_friction_adhesion([self.run_1d]))

    def test_locomotive_behind_is_named_and_its_own_places_are_on_the_axis(self):
        figure = draw_axle_loads(self.run_behind)
        axes = figure.axes[-1]
        self.assertEqual(axes.get_xlabel(), 'place of locomotive 2 [km]')
        places = self.run_behind.adhesion.location_km
        np.testing.assert_allclose(axes.get_xlim(), (2.978, places[-1]), rtol=1e-9)
        self.assertIn('locomotive 2', figure._suptitle.get_text())

    def test_stretches_end_at_the_row_after_their_last(self):
        place = np.array([0.0, 1.0, 3.0, 6.0, 10.0])
        self.assertEqual(true_stretches(place, np.array([0, 1, 1, 0, 1])), [(1.0, 5.0), (10.0, 0.0)])
        self.assertEqual(true_stretches(place, np.zeros(5)), [])
        self.assertEqual(true_stretches(place, np.ones(5)), [(0.0, 10.0)])


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_adhesion_figures', AdhesionFiguresTest)
