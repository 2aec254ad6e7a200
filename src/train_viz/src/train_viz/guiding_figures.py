"""Wheel by wheel over place, of the model 3d: guiding force, Y/Q; slip loss and number of contacts. A column a bogie."""
from typing import List, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.adhesion import Adhesion, true_stretches
from train_viz.adhesion_figures import place_range_km, set_place_axis, whose
from train_viz.run import Run

SIDES = (('left', '-', 1.0), ('right', '--', 0.75))  # in the order of the arrays: words, line, opacity
CONTACTS = ((0, 'no contact', plot_style.VERMILION), (2, 'two contacts', plot_style.SKY),
            (3, 'three contacts', plot_style.PURPLE))  # one contact stays white
SHORTEST_M = 0.5  # chosen, a pixel or so: shorter stretches are widened to it, so that no lifted wheel goes unseen


def bogies(wheels: Adhesion) -> List[range]:
    """Axles of each bogie, from 0: two bogies, or all axles together where they do not part evenly."""
    if wheels.axles < 4 or wheels.axles % 2:
        return [range(wheels.axles)]
    return [range(wheels.axles // 2), range(wheels.axles // 2, wheels.axles)]


def draw_guiding_forces(run: Run) -> Figure:
    """Lateral force of each wheel on its rail, and that over its vertical force (Y/Q, L/V)."""
    wheels = run.adhesion
    figure, panels = _panels(wheels, (3.0, 3.0))
    for (row, words), values in zip(((0, 'guiding force Y [kN]'), (1, 'Y/Q, L/V [-]')),
                                    (wheels.wheels.guiding_force_N / 1e3, wheels.wheels.lateral_over_vertical)):
        _draw_wheels(panels[row], wheels, values)
        panels[row, 0].set_ylabel(words)
    _finish(figure, panels, run, 'Guiding forces', 'Force of the wheel on its rail: outward > 0, as a flange presses; inward '
            '< 0.')
    return figure


def draw_wheel_contacts(run: Run) -> Figure:
    """T-gamma of each wheel, all its contacts together, and where it has another number of contacts than one."""
    wheels = run.adhesion
    always_one = bool((wheels.wheels.contacts == 1).all())
    figure, panels = _panels(wheels, (3.4, 2.4)[:1 if always_one else 2])
    _draw_wheels(panels[0], wheels, wheels.wheels.t_gamma_N / 1e3)
    plot_style.start_at_zero(panels[0, 0])
    panels[0, 0].set_ylabel('T-gamma [kN = kJ/m]')
    if not always_one:
        for axes, axles in zip(panels[1], bogies(wheels)):
            _draw_counts(axes, wheels, axles)
        panels[1, 0].set_ylabel('wheelset')
    _finish(figure, panels, run, 'Slip losses and contacts', 'Every wheel has one contact all the time.' if always_one else
            'T-gamma is the sum over a wheel\'s contacts; where nothing is drawn below, a wheel has one.')
    return figure


def _panels(wheels: Adhesion, heights: Tuple[float, ...]) -> Tuple[Figure, np.ndarray]:
    columns = len(bogies(wheels))
    return plt.subplots(len(heights), columns, figsize=(1.6 + 4.8 * columns, 1.4 + 1.25 * sum(heights)), sharex=True,
                        squeeze=False, gridspec_kw={'height_ratios': heights})


def _draw_wheels(panels: np.ndarray, wheels: Adhesion, values: np.ndarray) -> None:
    """One scale for all bogies. Colour: the wheelset within its bogie; line: the side."""
    for axes, axles in zip(panels, bogies(wheels)):
        if axes is not panels[0]:
            axes.sharey(panels[0])
            axes.tick_params(axis='y', labelleft=False)
        for axle in axles:
            for side, (_, dashes, opacity) in enumerate(SIDES):
                axes.plot(wheels.location_km, values[:, axle, side], dashes, color=_colour(axle - axles[0]), alpha=opacity,
                          linewidth=1.4)
        axes.axhline(0.0, color='0.3', linewidth=0.8)


def _colour(place_in_bogie: int) -> str:
    return plot_style.LINE_COLOURS[place_in_bogie % len(plot_style.LINE_COLOURS)]


def _draw_counts(axes: Axes, wheels: Adhesion, axles: range) -> None:
    rows = [(axle, side) for axle in axles for side in range(2)]
    for y, (axle, side) in enumerate(rows):
        for count, _, colour in CONTACTS:
            stretches = true_stretches(wheels.location_km, wheels.wheels.contacts[:, axle, side] == count)
            axes.broken_barh([(start, max(length, SHORTEST_M / 1e3)) for start, length in stretches], (y - 0.38, 0.76),
                             facecolors=colour, linewidth=0)
    axes.set_yticks(range(len(rows)), [f'{axle + 1} {SIDES[side][0]}' for axle, side in rows])
    axes.tick_params(axis='y', labelsize=10)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.grid(axis='y', visible=False)


def _finish(figure: Figure, panels: np.ndarray, run: Run, title: str, note: str) -> None:
    for axes in panels.flat:
        plot_style.shade_curves(axes, [run], axes in panels[0], place_range_km([run]))
    for axes, axles in zip(panels[0], bogies(run.adhesion)):
        axes.set_title(f'wheelsets {axles[0] + 1} to {axles[-1] + 1}', pad=20, fontsize=12)
    for axes in panels[-1]:
        set_place_axis(axes, [run])
    figure.suptitle(f'{title}, {whose(run)}')
    figure.align_ylabels(panels[:, 0])
    key = panels[0, 0]
    names = ('first', 'second', 'third') if len(bogies(run.adhesion)) == 2 else [f'{i + 1}.' for i in range(run.adhesion.axles)]
    for i in range(len(bogies(run.adhesion)[0])):
        name = names[i] if i < len(names) else f'{i + 1}.'
        key.plot([], [], color=_colour(i), linewidth=2.0, label=f'{name} wheelset of the bogie')
    for words, dashes, _ in SIDES:
        key.plot([], [], dashes, color='0.3', label=f'{words} wheel')
    if 'contacts' in title:
        found = run.adhesion.wheels.contacts
        for count, words, colour in CONTACTS:
            if (found == count).any():
                key.fill_between([], [], [], color=colour, linewidth=0, label=words)
    plot_style.legend_below(figure, key, note)
