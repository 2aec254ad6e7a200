"""Figures over the place of the leading locomotive: traction force, energy, speed and notch."""
from typing import Any, Dict, List, Optional

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.energy_stages import LEAST_J, rim_words
from train_viz.resolved_scenario import read_adhesion_limit
from train_viz.run import Run

KWH_PER_MJ = 1.0 / 3.6
MARKED_CURVES = 2  # chosen: more marks make the legend unreadable
SAME_PLACE_M = 1.0  # chosen: the end of a run this near to a mark needs no other


def draw_traction_force(runs: List[Run]) -> Figure:
    """Traction at the rail of the leading locomotive; as Fig. 6."""
    figure, axes = plt.subplots(figsize=(9.0, 5.6))
    names_pt = plot_style.shade_curves(axes, runs)
    for i, run in enumerate(runs):
        axes.plot(run.location_km, run.shown_traction_N / 1e3, label=run.label, **plot_style.line_style(i))
    _mark_adhesion_limits(axes, runs)
    plot_style.start_at_zero(axes)
    brakes = min(run.shown_traction_N.min() for run in runs) < -1e3  # chosen: less is a rolling locomotive's own resistance
    axes.set_title(f'Traction {"and braking " * brakes}force of {runs[0].whose}', pad=plot_style.title_pad(names_pt))
    axes.set_ylabel('force at the rail [kN]; braking < 0' if brakes else 'traction at the rail [kN]')
    plot_style.set_place_axis(axes, runs)
    plot_style.legend_below(figure, axes)
    return figure


def _mark_adhesion_limits(axes: Axes, runs: List[Run]) -> None:
    """Of every locomotive shown, on the sides of zero where a force comes near it."""
    forces = [run.shown_traction_N for run in runs]
    limits = {read_adhesion_limit(run.resolved, run.locomotive) for run in runs} - {None}
    for coefficient, limit_N in sorted(limits):
        sides = plot_style.sides_near(limit_N, min(map(np.min, forces)), max(map(np.max, forces)))
        plot_style.mark_limit(axes, axes.axhline, limit_N / 1e3, sides, 'adhesion limit {sign}'
                              f'{coefficient:g} m g = {{sign}}{limit_N / 1e3:.1f} kN')


def draw_energy(runs: List[Run]) -> Optional[Figure]:
    """Energy of the leading locomotive, Eq. (4) at the rail and what the rim pays; as Fig. 8, and over speed.

    At one place the slower train's lesser energy is not a saving but kinetic energy that it lacks; hence the comparison
    at equal speed, where the runs allow it. None if no motor gives any.
    """
    if max(np.abs([run.rail_J, run.rim_J]).max() for run in runs) < LEAST_J:
        return None
    over_speed = all(run.speed_rises() for run in runs)
    figure, panels = plt.subplots(1, 2 if over_speed else 1, figsize=(12.5 if over_speed else 9.0, 6.4),
                                  squeeze=False, sharey=True)
    place, last = panels[0, 0], panels[0, -1]
    pad = plot_style.title_pad(plot_style.shade_curves(place, runs))
    for i, run in enumerate(runs):
        _draw_energy_of(run, panels[0], plot_style.line_style(i), plot_style.curve_ends_m(runs)[:MARKED_CURVES])
    place.set_ylabel('energy [MJ]')
    place.set_title('over place', pad=pad)
    plot_style.set_place_axis(place, runs)
    if over_speed:
        last.set_title('over speed', pad=pad)
        last.set_xlabel('speed [km/h]')
    plot_style.start_at_zero(place)
    kwh = last.secondary_yaxis('right', functions=(lambda mj: mj * KWH_PER_MJ, lambda kwh: kwh / KWH_PER_MJ))
    kwh.set_ylabel('energy [kWh]')
    figure.suptitle(f'Energy of {runs[0].whose}')
    notes = _clip_racing(place, runs)
    if len(runs) > 1:
        notes.append('Less energy at equal place is no saving where the train is slower: compare at equal speed, too.')
    if any(run.rim_differs() for run in runs):
        notes.append('The rim also pays ' + rim_words(runs) + '.')
    plot_style.legend_below(figure, place, '\n'.join(plot_style.wrapped(note, 100) for note in notes))
    return figure


def _clip_racing(axes: Axes, runs: List[Run]) -> List[str]:
    """Work of racing wheels leaves the frame, lest it flatten the other lines; a note for each such run."""
    racing = [run for run in runs if run.races()]
    if not racing:
        return []
    axes.set_ylim(top=1.25e-6 * max(np.max(run.rail_J if run.races() else run.rim_J) for run in runs))
    return [f'{run.label}: the wheels race, work at the rim goes on to {run.rim_J[-1] / 1e6:.0f} MJ beyond the frame.'
            for run in racing]


def _draw_energy_of(run: Run, panels: np.ndarray, style: Dict[str, Any], marks_m: List[float]) -> None:
    lines = [('at the rail', run.rail_J, '-')]
    if run.rim_differs():
        lines.append(('at the rim', run.rim_J, '--'))
    for where, energy_J, dashes in lines:
        energy_MJ = energy_J / 1e6
        marks = [(place, run.at_location(energy_MJ, place)) for place in marks_m
                 if abs(place - run.location_m[-1]) > SAME_PLACE_M]
        marks.append((run.location_m[-1], energy_MJ[-1]))
        values = ', '.join(f'{energy:.1f} MJ at {place / 1e3:.3f} km' for place, energy in marks)
        label = f'{run.label} {where}: {values} ({run.time_s[-1]:.1f} s, {run.end_kmph:.2f} km/h)'
        panels[0].plot(run.location_km, energy_MJ, dashes, label=label, **style)
        panels[0].plot([place / 1e3 for place, _ in marks], [energy for _, energy in marks], 'o',
                       color=style['color'], markersize=4.5, clip_on=run.races())
        if len(panels) > 1:
            panels[1].plot(run.speed_kmph, energy_MJ, dashes, **style)


def draw_speed_notch(runs: List[Run]) -> Figure:
    """Speed and notch of the leading locomotive; without a notch in any run speed alone."""
    notches = np.concatenate([shown_notch(run) for run in runs])
    both = bool(notches.any())
    figure, panels = plt.subplots(1 + both, 1, figsize=(9.0, 7.0 if both else 4.8), sharex=True, squeeze=False,
                                  gridspec_kw={'height_ratios': (3, 2)[:1 + both]})
    speed = panels[0, 0]
    pad = plot_style.title_pad(plot_style.shade_curves(speed, runs))
    if both:
        plot_style.shade_curves(panels[1, 0], runs, labels=False)
    for i, run in enumerate(runs):
        speed.plot(run.location_km, run.speed_kmph, label=run.label, **plot_style.line_style(i))
    plot_style.start_at_zero(speed)
    speed.set_ylabel('speed [km/h]')
    if both:
        _draw_notches(panels[1, 0], runs, notches)
        speed.set_title('Speed and notch of the leading locomotive' if runs[0].locomotive == 1 else
                        f'Speed of the train and notch of {runs[0].whose}', pad=pad)
    else:
        speed.set_title('Speed of the leading locomotive; its notch is 0 all the time', pad=pad)
    plot_style.set_place_axis(panels[-1, 0], runs)
    plot_style.legend_below(figure, speed)
    return figure


def _draw_notches(axes: Axes, runs: List[Run], notches: np.ndarray) -> None:
    for i, run in enumerate(runs):
        axes.step(run.location_km, shown_notch(run), where='post', **plot_style.line_style(i))
    axes.set_ylabel('notch' if notches.min() >= 0.0 else 'notch; dynamic brake < 0')
    axes.set_ylim(min(notches.min(), 0.0) - 0.3, (max(notches.max(), 8.0) if notches.max() > 0.0 else 0.0) + 0.4)
    axes.yaxis.set_major_locator(plt.MaxNLocator(integer=True))


def shown_notch(run: Run) -> np.ndarray:
    """Of the locomotive shown: traction above zero, the dynamic brake below."""
    return (run.notch - run.brake_notch)[:, run.locomotive - 1]
