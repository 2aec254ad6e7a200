"""Figs. 3, 6, 7, 8 and 9 of the paper from our runs, with the values that it states marked."""
from typing import Dict, List, Optional, Tuple

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import paper_values as paper
from train_viz import plot_style
from train_viz.adhesion_figures import draw_creep_curves, draw_friction_adhesion
from train_viz.comparison import Comparison
from train_viz.creep_curve import creep_curves, speeds_of
from train_viz.resolved_scenario import GRAVITY_MPS2
from train_viz.run_folder import RunFolder

PAPER_STYLE = {'marker': 'D', 'markersize': 7.5, 'markerfacecolor': 'white', 'markeredgewidth': 1.8, 'linestyle': 'none',
               'zorder': 6}
ABSENT_COLOUR = '0.45'  # of a model that the paper states a value for and that was not run


def colour_of(c: Comparison, folder: RunFolder) -> str:
    return plot_style.line_style(c.folders.index(folder))['color']


def colour_of_model(c: Comparison, model: str) -> str:
    found = c.of_model(model)
    return colour_of(c, found[0]) if found else ABSENT_COLOUR


def draw_fig3(c: Comparison) -> Optional[Figure]:
    """Adhesion used over creep, all axles, with adhesion control; None if no run has wheels on the rail."""
    shown = [folder for folder in c.folders if folder.run.adhesion is not None]
    if not shown:
        return None
    figure, panels = plt.subplots(1, len(shown), figsize=(3.0 + 3.6 * len(shown), 5.4), sharex=True, sharey=True,
                                  squeeze=False)
    for folder, axes in zip(shown, panels[0]):
        wheels = folder.run.adhesion
        colour = colour_of(c, folder)
        draw_creep_curves(axes, creep_curves(folder.run, speeds_of(folder.run), 1.08 * max(wheels.creep.max(), 1e-3)))
        axes.scatter(100.0 * wheels.creep, wheels.adhesion, s=2.0, color=colour, linewidths=0.0, rasterized=True)
        axes.axvline(100.0 * paper.SLIP_LIMIT, color='black', linestyle='--', linewidth=1.2)
        axes.axhline(paper.STATIC_FRICTION, color='black', linestyle=':', linewidth=1.5)
        axes.set_title(folder.label)
    plot_style.start_at_zero(panels[0, 0])
    panels[0, 0].set_xlim(left=0.0)
    last = panels[0, -1]
    last.plot([], [], '.', color='0.3', markersize=6.0, label='adhesion used, every axle of the leading locomotive')
    last.plot([], [], color='black', linestyle='--', linewidth=1.2,
              label=f'paper: slip limit {100.0 * paper.SLIP_LIMIT:g} %')
    last.plot([], [], color='black', linestyle=':', linewidth=1.5, label=f'paper: static friction {paper.STATIC_FRICTION}')
    figure.supxlabel('creep [%]', fontsize=12)
    figure.supylabel('coefficient of adhesion [-]', fontsize=12)
    figure.suptitle('Fig. 3: adhesion characteristics')
    plot_style.legend_below(figure, panels[0])
    return figure


def draw_fig6(c: Comparison) -> Figure:
    """Traction force over place, all of it and enlarged where the paper states values."""
    figure, (whole, near) = plt.subplots(2, 1, figsize=(9.0, 9.6))
    for axes in (whole, near):
        plot_style.shade_curves(axes, c.runs)
        for i, folder in enumerate(c.folders):
            axes.plot(folder.run.location_km, folder.run.traction_N[:, 0] / 1e3, label=folder.label,
                      **plot_style.line_style(i))
        axes.set_ylabel('traction at the rail [kN]')
    plot_style.start_at_zero(whole)
    plot_style.set_place_axis(whole, c.runs)
    for model in ('1d', '2d', '3d'):
        points = [(place, values[model]) for place, values in sorted(paper.FORCE_KN.items())]
        words = ', '.join(f'{value:.0f} kN at {place:g} km' for place, value in points)
        for axes in (whole, near):
            axes.plot(*zip(*points), color=colour_of_model(c, model), label=f'paper, {model.upper()}: {words}',
                      **PAPER_STYLE)
        for place, value in points:
            near.annotate(f'{value:.0f}', (place, value), xytext=(9, 0), textcoords='offset points', va='center',
                          fontsize=11, color=colour_of_model(c, model), zorder=7,
                          bbox={'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.8, 'pad': 0.8})
    near.set_xlabel('place of the leading locomotive [km]')
    near.set_xlim(3.1, 3.65)
    near.set_ylim(*_range_near(c))
    whole.set_title('Fig. 6: traction force of the leading locomotive', pad=22)
    near.set_title('enlarged: where the paper states values', fontsize=12, pad=22)
    plot_style.legend_below(figure, whole)
    return figure


def _range_near(c: Comparison) -> Tuple[float, float]:
    values = [value for at_place in paper.FORCE_KN.values() for value in at_place.values()]
    values += [c.force_kN(folder, place) for folder in c.folders for place in paper.REPORT_PLACES_KM if 3.1 <= place <= 3.6]
    return min(values) - 15.0, max(values) + 15.0


def draw_fig7(c: Comparison) -> Optional[Figure]:
    """Friction and adhesion over place; the paper's forces over the locomotive's weight as marks."""
    figure = draw_friction_adhesion(c.runs)
    if figure is None:
        return None
    axes = figure.axes[0]
    axes.set_title('Fig. 7: ' + axes.get_title()[0].lower() + axes.get_title()[1:], pad=22)
    for model in ('2d', '3d'):
        points = [(place, 1e3 * values[model] / (paper.LEADING_MASS_KG * GRAVITY_MPS2))
                  for place, values in sorted(paper.FORCE_KN.items())]
        words = ', '.join(f'{value:.3f} at {place:g} km' for place, value in points)
        axes.plot(*zip(*points), color=colour_of_model(c, model), label=f'paper, {model.upper()}, force / weight: {words}',
                  **PAPER_STYLE)
    figure.legends[0].remove()
    absent = [folder.label for folder in c.folders if folder.run.adhesion is None]
    plot_style.legend_below(figure, axes, f'No wheels on the rail, so not shown: {", ".join(absent)}' if absent else '')
    return figure


def draw_fig8(c: Comparison) -> Figure:
    """Energy by Eq. (4) over place; below, the difference against 3D with the paper's percentages."""
    base = c.base
    figure, panels = plt.subplots(2 if base else 1, 1, figsize=(9.0, 9.6 if base else 5.6), squeeze=False, sharex=True)
    energy = panels[0, 0]
    for axes in panels[:, 0]:
        plot_style.shade_curves(axes, c.runs, labels=axes is energy)
    for i, folder in enumerate(c.folders):
        stages = [c.stages(folder, place) for place in sorted(paper.ENERGY_AGAINST_3D)]
        words = ', '.join(f'{s.rail_J / 1e6:.1f} MJ at {s.location_m / 1e3:g} km ({s.time_s:.1f} s, '
                          f'{3.6 * s.speed_mps:.2f} km/h)' for s in stages)
        energy.plot(folder.run.location_km, folder.run.loco_energy_rail_J[:, 0] / 1e6, label=f'{folder.label}: {words}',
                    **plot_style.line_style(i))
        energy.plot([s.location_m / 1e3 for s in stages], [s.rail_J / 1e6 for s in stages], 'o', markersize=5.0,
                    color=colour_of(c, folder), clip_on=False)
    plot_style.start_at_zero(energy)
    energy.set_ylabel('energy at the rail, Eq. (4) [MJ]')
    energy.set_title('Fig. 8: energy of the leading locomotive', pad=22)
    if base:
        _draw_energy_difference(panels[1, 0], c, base)
    plot_style.set_place_axis(panels[-1, 0], c.runs)
    plot_style.legend_below(figure, panels[:, 0], 'Less energy at one place is no saving where the train is slower.')
    return figure


def _draw_energy_difference(axes: Axes, c: Comparison, base: RunFolder) -> None:
    """Runs against the base over the places that both passed, from 50 m on: energy is then large enough to divide by."""
    axes.axhline(0.0, color='0.3', linewidth=1.0)
    base_km, base_J = base.run.location_km, base.run.loco_energy_rail_J[:, 0]
    for i, folder in enumerate(c.folders):
        if folder is base:
            continue
        shown = (base_km >= base_km[0] + 0.05) & (base_km <= folder.run.location_km.max())
        other_J = [folder.run.at_location(folder.run.loco_energy_rail_J[:, 0], 1e3 * place) for place in base_km[shown]]
        axes.plot(base_km[shown], 100.0 * (other_J / base_J[shown] - 1.0), **plot_style.line_style(i))
        points = _paper_energy(folder.model, base.model)
        if points:
            words = ', '.join(f'{value:+.1f} % at {place:g} km' for place, value in points)
            axes.plot(*zip(*points), color=colour_of(c, folder), clip_on=False,
                      label=f'paper, {folder.label} against {base.label}: {words}', **PAPER_STYLE)
    axes.set_ylabel(f'difference against {base.label} [%]')


def _paper_energy(model: str, base: str) -> List[Tuple[float, float]]:
    """What the paper states, or what its statements give, for a pair of models."""
    if model == base:
        return []
    return [(place, 100.0 * (paper.energy_ratio(model, base, place) - 1.0)) for place in sorted(paper.ENERGY_AGAINST_3D)]


def draw_fig9(c: Comparison) -> Optional[Figure]:
    """Difference of traction force against 3D at the paper's places; None without a run to compare with."""
    base = c.base
    if base is None:
        return None
    places = list(paper.FIG9_PLACES_KM) if c.has_3d else sorted({*paper.FIG9_PLACES_KM, *paper.FORCE_KN})
    others = [folder for folder in c.folders if folder is not base]
    width = 0.8 / len(others)
    marks = {}
    figure, axes = plt.subplots(figsize=(9.5, 5.8))
    axes.axhline(0.0, color='0.3', linewidth=1.0)
    for n, folder in enumerate(others):
        at = [i + (n - (len(others) - 1) / 2.0) * width for i in range(len(places))]
        values = [c.force_against(folder, base, place) for place in places]
        bars = axes.bar(at, values, 0.92 * width, color=colour_of(c, folder), label=f'{folder.label} against {base.label}')
        axes.bar_label(bars, [f'{value:+.1f}' for value in values], padding=8, fontsize=10, zorder=7,
                       bbox={'facecolor': 'white', 'edgecolor': 'none', 'alpha': 0.75, 'pad': 0.5})
        marks[folder.label] = colour_of(c, folder), [(at[places.index(place)], place, value) for place, value in
                                                     _paper_forces(folder.model, base.model) if place in places]
    _mark_differences(axes, base, marks)
    axes.set_xticks(range(len(places)), [f'{place:g}' for place in places])
    axes.grid(axis='x', visible=False)
    axes.margins(y=0.12)
    axes.set_xlabel('place of the leading locomotive [km]')
    axes.set_ylabel(f'difference of traction against {base.label} [%]')
    axes.set_title('Fig. 9: differences of energy consumption rate, that is of traction force')
    plot_style.legend_below(figure, axes)
    return figure


def _mark_differences(axes: Axes, base: RunFolder, marks: Dict[str, Tuple[str, List[Tuple[float, float, float]]]]) -> None:
    """Of each run its colour and (position on the axis, place, value). They stand on its bars: filled as these, edged black."""
    for label, (colour, points) in marks.items():
        if points:
            words = ', '.join(f'{value:+.1f} % at {place:g} km' for _, place, value in points)
            axes.plot([x for x, _, _ in points], [value for _, _, value in points], label=f'paper, {label} against '
                      f'{base.label}: {words}', **dict(PAPER_STYLE, color='black', markerfacecolor=colour, markersize=9.5))


def _paper_forces(model: str, base: str) -> List[Tuple[float, float]]:
    if base == '3d':
        return [paper.LARGEST_AGAINST_3D[model]] if model in paper.LARGEST_AGAINST_3D else []
    return [(place, paper.force_against(model, base, place)) for place in sorted(paper.FORCE_KN)] if model != base else []
