"""The paper's comparison in a few sentences: what is as in the paper and what is not, by directions and signs."""
from typing import Iterator, List

from train_viz import paper_values as paper
from train_viz.comparison import FITTED, Comparison, Row
from train_viz.run_folder import RunFolder

AS_PAPER, NOT_AS_PAPER = 'As in the paper', 'Not as in the paper'


def verdict(c: Comparison) -> List[str]:
    """A sentence for each statement of the paper that these runs can be held against; sizes stand beside, unjudged."""
    sentences = [*_fitted(c.rows())]
    for folder in c.of_model('3d'):
        sentences += [_straight(c, folder), _into_the_curve(c, folder)]
    if c.has_3d:
        sentences += [_against(c, folder) for folder in c.folders if folder.model != '3d']
    return sentences


def _fitted(rows: List[Row]) -> Iterator[str]:
    off = [abs(row.deviation / row.paper) for row in rows if row.kind == FITTED and row.unit != '%']
    if off:
        yield (f'Fitted: forces of 1D and 2D and the ratio of their energies lie within {100.0 * max(off):.2f} % of the '
               'paper\'s. They were used to identify parameters, so this is no evidence.')


def _straight(c: Comparison, folder: RunFolder) -> str:
    """The order of the models on straight track, where all are there."""
    place = min(paper.FORCE_KN)
    stated, ours = paper.FORCE_KN[place]['3d'], c.force_kN(folder, place)
    words = f'{folder.label} pulls {ours:.1f} kN at {place:g} km, on straight track, the paper\'s {stated:.0f} kN ' \
            f'({_percent(ours, stated)})'
    others = {model: c.of_model(model) for model in ('1d', '2d')}
    if not all(others.values()):
        return f'Straight track: {words}.'
    forces = {'3d': ours, **{model: c.force_kN(those[0], place) for model, those in others.items()}}
    order, papers = (' below '.join(model.upper() for model in sorted(values, key=values.get))
                     for values in (forces, paper.FORCE_KN[place]))
    if order == papers:
        return f'{AS_PAPER}: {words}; the order is {order}.'
    return f'{NOT_AS_PAPER}: {words}; the order is {order}, the paper\'s {papers}.'


def _into_the_curve(c: Comparison, folder: RunFolder) -> str:
    outside, inside = sorted(paper.FORCE_KN)
    stated, ours = paper.FORCE_KN[inside]['3d'], c.force_kN(folder, inside)
    before = paper.FORCE_KN[outside]['3d'], c.force_kN(folder, outside)
    same = (stated - before[0]) * (ours - before[1]) > 0.0
    return (f'{AS_PAPER if same else NOT_AS_PAPER}: into the curve the force of {folder.label} '
            f'{_turn(ours, before[1])}, the paper\'s {_turn(stated, before[0])}; '
            f'{ours:.1f} kN at {inside:g} km against {stated:.0f} kN ({_percent(ours, stated)}).')


def _turn(value: float, before: float) -> str:
    change = 100.0 * (value / before - 1.0)
    return f'{"rises" if change > 0.0 else "falls"} by {abs(change):.1f} %'


def _percent(value: float, base: float) -> str:
    return f'{round(100.0 * (value / base - 1.0), 1) + 0.0:+.1f} %'  # + 0.0: no minus before a zero


def _against(c: Comparison, folder: RunFolder) -> str:
    """Signs of the differences against the first run of 3D, of traction and of energy."""
    whose = f'{folder.label} against {c.base.label}'
    rows = [row for row in c.rows() if row.whose == whose]
    other = [row.place for row in rows if row.paper * row.ours < 0.0]
    ranges = '; '.join(f'{quantity.split(" of ")[1].split(",")[0]} {_range([row.ours for row in those])} '
                       f'(paper {_range([row.paper for row in those])})'
                       for quantity in sorted({row.quantity for row in rows}, reverse=True)
                       for those in [[row for row in rows if row.quantity == quantity]])
    if not other:
        return f'{AS_PAPER} in sign: {whose}, {ranges}.'
    return f'{NOT_AS_PAPER}: {whose}, {ranges}; opposite sign at {len(other)} of {len(rows)} values.'


def _range(values: List[float]) -> str:
    return f'{min(values):+.1f} to {max(values):+.1f} %'
