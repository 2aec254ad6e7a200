"""The air brake over vehicle and time, and where the brakes' energy goes over place."""
from typing import Optional, Tuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style, sankey
from train_viz.coupler_figure import COLUMNS
from train_viz.energy_stages import between_rim_and_rail, supplied
from train_viz.run import Run

PASCALS_PER_BAR = 1e5
WINDOW_S = (-2.0, 30.0)   # around the first fall of the pipe, chosen: a wave takes 8 s through 1.6 km, a cylinder 5 to 30 s
FALL_Pa = 0.1e5           # chosen: less is no application
SHOWN_MJ = 1e-3           # chosen: less is round-off of a brake that is not applied


def draw_brake_pressures(run: Run) -> Optional[Figure]:
    """Pipe and cylinders, over the whole run and around the first application, where the wave is seen; None without an air
    brake."""
    if not run.has_air_brake():
        return None
    windows = [(run.time_s[0], run.time_s[-1], 'whole run')]
    begin = first_application_s(run)
    if begin is not None:
        window = (max(begin + WINDOW_S[0], run.time_s[0]), min(begin + WINDOW_S[1], run.time_s[-1]))
        if window[1] - window[0] < 0.6 * (run.time_s[-1] - run.time_s[0]):
            windows.append((*window, 'first application'))
    figure, panels = plt.subplots(2, len(windows), figsize=(3.4 + 4.3 * len(windows), 7.6), squeeze=False, sharex='col',
                                  sharey=True)
    filled = run.cylinder_pressure_Pa.any(axis=0)
    cylinders_Pa = np.where(filled, run.cylinder_pressure_Pa, np.nan) if filled.any() else run.cylinder_pressure_Pa
    for row, (pressure, words, colours) in enumerate(((run.pipe_pressure_Pa, 'brake pipe', 'viridis'),
                                                      (cylinders_Pa, 'brake cylinders', 'inferno'))):
        for column, window in enumerate(windows):
            image = _draw_map(panels[row, column], run.time_s, pressure / PASCALS_PER_BAR, window[:2], colours)
        figure.colorbar(image, ax=list(panels[row]), pad=0.02).set_label(f'{words} [bar]')
        panels[row, 0].set_ylabel('vehicle, counted from the head')
    for column, window in enumerate(windows):
        panels[0, column].set_title(window[2])
        panels[1, column].set_xlabel('time since the start of the run [s]')
    note = '\ngrey: vehicles whose cylinders are never filled' if filled.any() and not filled.all() else ''
    figure.suptitle(f'Air brake: pressures over the atmosphere, {run.label}{note}')
    return figure


def first_application_s(run: Run) -> Optional[float]:
    """When the pipe at the first vehicle begins to fall the first time."""
    pressure = run.pipe_pressure_Pa[:, 0]
    fallen = np.flatnonzero(np.maximum.accumulate(pressure) - pressure > FALL_Pa)
    return float(run.time_s[fallen[0]]) if len(fallen) else None


def _draw_map(axes: Axes, time_s: np.ndarray, values: np.ndarray, window_s: Tuple[float, float], colours: str):
    rows = np.flatnonzero((time_s >= window_s[0]) & (time_s <= window_s[1]))
    rows = rows[::max(len(rows) // COLUMNS, 1)]
    vehicles = values.shape[1]
    edges = np.append(time_s[rows], max(window_s[1], time_s[rows[-1]] + 1e-3))
    image = axes.pcolormesh(edges, np.arange(vehicles + 1) + 0.5, values[rows].T, cmap=colours, vmin=0.0,
                            vmax=max(np.nanmax(values), 0.1), rasterized=True)
    axes.set_facecolor('0.85')
    axes.grid(False)
    axes.set_ylim(vehicles + 0.5, 0.5)  # the head of the train on top
    axes.set_yticks(plot_style.whole_ticks(vehicles))
    axes.set_xlim(*window_s)
    return image


def draw_brake_energy(run: Run) -> Optional[Figure]:
    """What the brakes take and what becomes of it, over place; below, of locomotives with a supply, its stores. None for a run
    that neither brakes nor has a supply."""
    with_supply = bool(supplied(run)) and run.has_supply()
    if not run.brakes() and not with_supply:
        return None
    parts = [('brakes', _draw_brakes)] * run.brakes() + [('supply', _draw_stores)] * with_supply
    figure, panels = plt.subplots(len(parts), 1, figsize=(9.5, 1.6 + 4.4 * len(parts)), sharex=True, squeeze=False)
    for i, (axes, (_, draw)) in enumerate(zip(panels[:, 0], parts)):
        names_pt = plot_style.shade_curves(axes, [run], labels=i == 0)
        axes.set_ylabel('energy since the start [MJ]')
        draw(axes, run)
        plot_style.legend_above(axes, 2, names_pt)
    plot_style.set_place_axis(panels[-1, 0], [run])
    figure.suptitle(f'Energy of {" and ".join(words for words, _ in parts)} over place, whole train, {run.label}')
    return figure


# Field of the account or of `between_rim_and_rail`, words, colour. The first is the sum of the four that follow.
BRAKE_LINES = (
    ('brake_rail', "locomotives' brakes, at the rail", '0.6', '-'),
    ('recovered_rim', 'recovered by motors, at the rim', '#1B7837', '-'),
    ('shoes_braking', "locomotives' shoes, braking", plot_style.ORANGE, '--'),
    ('slip_braking', 'slip loss, braking', plot_style.SKY, '--'),
    ('rest_braking', 'wheel spin, braking (given back < 0)', plot_style.PURPLE, '--'),
    ('shoes_driving', "locomotives' shoes, pulled against", plot_style.ORANGE, ':'),
    ('air_brake', "wagons' shoes", '#7F3B08', '-'),
)
SUPPLY_LINES = (  # of TrainEnergy's lists, less their start
    ('stored', 'in the storage, change', plot_style.BLUE, '-'),
    ('storage_in', 'into the storage, at the link', plot_style.SKY, '--'),
    ('storage_out', 'out of the storage, at the link', plot_style.PURPLE, '--'),
    ('line_drawn', 'drawn from the line', plot_style.PURPLE, '-'),
    ('line_returned', 'returned to the line', plot_style.GREEN, '-'),
    ('to_resistors', 'into resistors, at the link', plot_style.VERMILION, '-'),
    ('auxiliaries', 'auxiliaries, at the link', plot_style.ORANGE, '-'),
)


def _draw_brakes(axes: Axes, run: Run) -> None:
    parted, lowest = {name: values.sum(axis=1) for name, values in between_rim_and_rail(run).items()}, 0.0
    for name, words, colour, dashes in BRAKE_LINES:
        values = (parted[name] if name in parted else run.account[name]) / 1e6
        if np.abs(values).max() > SHOWN_MJ:
            axes.plot(run.location_km, values, dashes, color=colour, linewidth=3.2 if name == 'brake_rail' else 1.8,
                      label=f'{words}: {sankey.number(values[-1])} MJ')
            lowest = min(lowest, values.min())
    if lowest > -SHOWN_MJ:
        plot_style.start_at_zero(axes)


def _draw_stores(axes: Axes, run: Run) -> None:
    for name, words, colour, dashes in SUPPLY_LINES:
        values = (run.locos[name] - run.locos[name][0]).sum(axis=1) / 1e6
        if values.any():
            axes.plot(run.location_km, values, dashes, color=colour, linewidth=1.8, label=f'{words}: {sankey.number(values[-1])} MJ')
    plot_style.start_at_zero(axes)
    litres = run.locos['litres'].sum(axis=1)
    if litres.any():
        right = axes.twinx()
        right.plot(run.location_km, litres, color='0.4', linestyle=':', linewidth=1.8)
        axes.plot([], [], color='0.4', linestyle=':', linewidth=1.8, label=f'fuel burnt (right): {litres[-1]:.1f} l')
        right.set_ylabel('fuel [l]')
        right.grid(False)
        right.spines['right'].set_visible(True)
        plot_style.align_zeros(axes, right)
