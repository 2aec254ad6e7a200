#!/usr/bin/env python3
"""Flow pictures of runs with brakes and supplies: they close, and ribbons, nodes and names keep out of each other's way."""
import dataclasses

import numpy as np
import rosunit
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path

from braked_runs import BrakedRunsTest
from train_viz.energy_stages import supply_MJ
from train_viz.flow_figure import SPIN, draw_energy_flow, flows_of
from train_viz.supply_figure import draw_energy_supply, supply_flows


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


class FlowFiguresTest(BrakedRunsTest):
    @staticmethod
    def changed(run):
        """A copy whose books may be written."""
        return dataclasses.replace(run, account={name: values.copy() for name, values in run.account.items()},
                                   locos={name: values.copy() for name, values in run.locos.items()})

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

    def test_narrow_band_of_the_brakes_has_its_words_below_it(self):
        run = self.changed(self.braked)
        for books in (run.locos, run.account):
            for name in ('brake_rail', 'recovered_rim'):
                books[name] *= 0.1
        run.locos['energy_slip'] *= 0.1
        run.account['residual'][:] = 0.0
        words = texts(draw_energy_flow(run))
        self.assertIn("locomotives'\nbrakes, at the\nrail", words)
        self.assertNotIn("brakes,\nat the rail", words)

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


if __name__ == '__main__':
    rosunit.unitrun('train_viz', 'test_flow_figures', FlowFiguresTest)
