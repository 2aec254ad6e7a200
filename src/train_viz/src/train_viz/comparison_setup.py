"""What made the runs of the comparison: values identified, configuration, build, and the commands to do it again."""
from typing import Any, List

from train_viz import page
from train_viz.comparison import Comparison
from train_viz.resolved_scenario import read_value

VEHICLE = ('train', 'groups', 0, 'vehicle')
# Words, factor to their unit, path in the resolved scenario, models that use it
IDENTIFIED = (
    ('largest force F_max [kN]', 1e-3, VEHICLE + ('traction', 'largest_force_N'), ('1d', '2d', '3d')),
    ('power at the rail P [MW]', 1e-6, VEHICLE + ('traction', 'power_at_rail_W'), ('1d', '2d', '3d')),
    ('exponential friction decrease B [s/m]', 1.0, ('adhesion', 'friction', 'B_s_per_m'), ('2d', '3d')),
    ('2D patch: rail crown radius [m]', 1.0, VEHICLE + ('contact', 'rail_crown_radius_m'), ('2d',)),
    ('2D patch: transverse curvature of the wheel [1/m]', 1.0,
     VEHICLE + ('contact', 'wheel_transverse_curvature_1pm'), ('2d',)),
)


def identified_values(c: Comparison) -> str:
    rows = [[words] + [_text(read_value(folder.run.resolved, *path), factor) if folder.model in models else '-'
                       for folder in c.folders] for words, factor, path, models in IDENTIFIED]
    return page.table(['identified', *(folder.label for folder in c.folders)], rows)


def _text(value: Any, factor: float = 1.0) -> str:
    try:  # float(), as PyYAML takes 4.10e6 for a text
        return f'{factor * float(value):.6g}'
    except (TypeError, ValueError):
        return '-' if value is None else str(value)


def setup(c: Comparison) -> List[str]:
    def row(words, get):
        return [words] + [_text(get(folder)) for folder in c.folders]

    rows = [
        ['scenario'] + [folder.run.scenario for folder in c.folders],
        ['description'] + [str(read_value(folder.run.resolved, 'description') or '-') for folder in c.folders],
        ['build'] + [folder.run.build_id or '-' for folder in c.folders],
        ['run id'] + [str(folder.run.run_id) for folder in c.folders],
        row('macro step H [s]', lambda f: read_value(f.run.resolved, 'steps', 'macro_step_s')),
        row('micro step h [s]', lambda f: read_value(f.run.resolved, 'steps', 'micro_step_s') if f.model != '1d' else None),
        ['steps'] + [str(folder.outcome.get('step', '-')) for folder in c.folders],
        ['rotary inertia in the train'] + ['yes' if f.summary.of_run('rotary_inertia', '1') else 'no' for f in c.folders],
        ['digest of all exchanges'] + [str(folder.outcome.get('exchange_digest', '-')) for folder in c.folders],
        ['times real time'] + [f'{f.summary.of_run("real_time_factor", "1"):.1f}' for f in c.folders],
    ]
    count = len(c.folders) + 1
    pieces = [page.table(['', *(folder.label for folder in c.folders)], rows, range(count)),
              page.paragraph('Each run\'s scenario with all files that it names, as one text that runs again on its own:')]
    return pieces + [page.folded(f'{folder.label}: {folder.run.scenario}', folder.run.resolved) for folder in c.folders]


def reproduction(c: Comparison) -> List[str]:
    keys = [folder.key for folder in c.folders]
    runs = ' '.join(f'OUT/{key}' for key in keys)
    offline = [f'rosrun ltd_sim ltd_offline config/scenarios/{folder.run.scenario}.yaml --out OUT/{folder.key}'
               for folder in c.folders]
    return [page.paragraph('As a node graph, in the checkout of the build named above:'),
            page.code('./scripts/demo.sh --out OUT'),
            page.paragraph('Without a master, with the same bits (same digest of all exchanges):'),
            page.code('\n'.join(offline + [f'rosrun train_viz paper_comparison {runs} --out OUT'])),
            page.paragraph('Or from this page alone: save a text under "Configuration and build" as a file and give it to '
                           'ltd_offline.')]
