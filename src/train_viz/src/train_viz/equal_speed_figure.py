"""The comparison at equal speed: energy of the leading locomotive over speed, and by stage where all trains are as fast."""
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from train_viz import plot_style
from train_viz.comparison import Comparison


def draw_equal_speed(c: Comparison) -> Figure:
    """Energy at rail and rim over speed, and by stage where all trains have the slowest one's final speed."""
    height = 1.4 + 0.5 * len(c.folders)
    figure, (lines, bars) = plt.subplots(2, 1, figsize=(9.0, 5.4 + height), gridspec_kw={'height_ratios': (5.4, height)})
    speed_kmph = 3.6 * c.equal_speed_mps
    lines.axvline(speed_kmph, color='black', linestyle=':', linewidth=1.5, label=f'equal speed: {speed_kmph:.2f} km/h')
    for i, folder in enumerate(c.folders):
        run, style = folder.run, plot_style.line_style(i)
        lines.plot(run.speed_kmph, run.loco_energy_rail_J[:, 0] / 1e6, label=f'{folder.label} at the rail, Eq. (4)', **style)
        if run.rim_differs():
            lines.plot(run.speed_kmph, run.loco_energy_rim_J[:, 0] / 1e6, '--', label=f'{folder.label} at the rim', **style)
    plot_style.start_at_zero(lines)
    lines.set_xlabel('speed of the leading locomotive [km/h]')
    lines.set_ylabel('energy [MJ]')
    lines.set_title('Energy of the leading locomotive over speed')
    lines.legend(loc='upper left')
    _draw_stages(bars, c)
    bars.set_title(f'where each train first reaches {speed_kmph:.2f} km/h', fontsize=12)
    plot_style.legend_below(figure, bars)
    return figure


STAGES = (('rail_J', 'at the rail, Eq. (4)', 1.0), ('slip_J', 'slip loss', 0.55),
          ('stored_J', 'wheel spin-up and other storage', 0.25))


def _draw_stages(axes: Axes, c: Comparison) -> None:
    """A bar a run, rail to rim; paler from stage to stage."""
    for i, folder in enumerate(c.folders):
        s, left = c.stages_at_equal_speed(folder), 0.0
        for name, _, alpha in STAGES:
            value = getattr(s, name) / 1e6
            axes.barh(i, value, height=0.62, left=left, color=plot_style.line_style(i)['color'], alpha=alpha)
            left += value
        axes.text(left, i, f'  {s.rail_J / 1e6:.1f} + {s.slip_J / 1e6:.1f} + {s.stored_J / 1e6:.1f} MJ', va='center',
                  fontsize=11)
    for _, words, alpha in STAGES:
        axes.barh(0, 0.0, color='0.2', alpha=alpha, label=words)
    axes.set_yticks(range(len(c.folders)), [f'{folder.label}, {c.stages_at_equal_speed(folder).time_s:.1f} s'
                                            for folder in c.folders])
    axes.invert_yaxis()
    axes.set_xlim(0.0, 1.32 * axes.get_xlim()[1])  # room for the numbers
    axes.grid(axis='y', visible=False)
    axes.set_xlabel('energy of the leading locomotive [MJ]')
