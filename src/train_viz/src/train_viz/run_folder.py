"""A run's folder as LTD leaves it: bag, summary.csv, outcome.yaml; and its name beside other runs of the paper's case."""
import dataclasses
import glob
import os
from typing import Any, Dict, List

import yaml

from train_viz import paper_values as paper
from train_viz.bag_reader import read_bag, read_configuration
from train_viz.paper_case import differences
from train_viz.run import ReportError, Run, join_parts
from train_viz.summary import Summary, read_summary

MODELS = ('1d', '2d', '3d')


@dataclasses.dataclass(frozen=True)
class RunFolder:
    """One finished run of the paper's case."""
    path: str
    key: str                  # 1d, 2d, 3d, 3d_two_point: the scenario's name without paper_
    model: str                # of the leading locomotive
    run: Run                  # its label is the key as people write it: 1D, 3D two-point
    summary: Summary
    outcome: Dict[str, Any]   # outcome.yaml

    @property
    def label(self) -> str:
        return self.run.label


# What the comparison takes from summary.csv, at every place that the paper states anything for
COMPARED = (('traction_force', 'N'), ('time', 's'), ('speed', 'm/s'), ('energy_rail', 'J'), ('energy_slip', 'J'),
            ('energy_rim', 'J'))


@dataclasses.dataclass(frozen=True)
class _Found:
    """A run whose bags are not read yet: that takes a minute of a long one, all else a second."""
    path: str
    key: str
    bags: List[str]
    summary: Summary
    outcome: Dict[str, Any]


def read_run_folders(paths: List[str]) -> List[RunFolder]:
    """In the order 1D, 2D, 3D, others of 3D, whatever the order of the paths. Refuses what can be refused before it reads bags.

    @raise ReportError naming the file and what to do
    """
    found = sorted((_find(path) for path in paths), key=lambda run: (run.summary.model, len(run.key)))
    for first, second in zip(found, found[1:]):
        if first.key == second.key:
            raise ReportError(f'{first.path}, {second.path}: both are a run of {first.key}: give one')
    return [_read(run) for run in found]


def _find(path: str) -> _Found:
    if not os.path.isdir(path):
        raise ReportError(f'{path}: no such folder: give the folders of finished runs')
    outcome = _read_outcome(os.path.join(path, 'outcome.yaml'))
    bags = sorted(glob.glob(os.path.join(glob.escape(path), '*.bag')))
    if not bags:
        raise ReportError(f'{path}: no bag: run it with a bag (record:=true)')
    scenario = _check_bags(path, bags)
    summary = read_summary(os.path.join(path, 'summary.csv'))
    if summary.model not in MODELS:
        raise ReportError(f'{summary.path}: model "{summary.model}", known are {", ".join(MODELS)}')
    for place in paper.REPORT_PLACES_KM:
        for quantity, unit in COMPARED:
            summary.at(quantity, unit, place)
    return _Found(path, _key(scenario, summary.model), bags, summary, outcome)


def _check_bags(path: str, bags: List[str]) -> str:
    """@return the scenario's name"""
    configurations = [read_configuration(bag) for bag in bags]
    if len({c.run_id for c in configurations}) > 1:
        raise ReportError(f'{path}: bags of {len({c.run_id for c in configurations})} runs: leave those of one')
    other = differences(configurations[0].resolved)
    if other:
        raise ReportError(f"{bags[0]}: no run of the paper's case: {'; '.join(other)}: give runs of "
                          'config/scenarios/paper_1d.yaml and the like, and this one to `report`')
    return configurations[0].scenario


def _read(found: _Found) -> RunFolder:
    run, = join_parts([read_bag(bag) for bag in found.bags])
    label = ' '.join([found.key[:2].upper()] + [found.key[3:].replace('_', '-')] * (len(found.key) > 3))
    return RunFolder(found.path, found.key, found.summary.model, dataclasses.replace(run, label=label), found.summary,
                     found.outcome)


def _key(scenario: str, model: str) -> str:
    return scenario[len('paper_'):] if scenario.startswith(f'paper_{model}') else model


def _read_outcome(path: str) -> Dict[str, Any]:
    try:
        with open(path, encoding='utf-8') as file:
            outcome = yaml.safe_load(file)
    except (OSError, ValueError, yaml.YAMLError):
        raise ReportError(f'{path}: missing or not readable: give the folder of a run that finished') from None
    if not isinstance(outcome, dict) or outcome.get('outcome') != 'finished':
        words = outcome.get('outcome') if isinstance(outcome, dict) else 'nothing'
        raise ReportError(f'{path}: the run did not finish ({words}): its values cannot be compared')
    return outcome


def combined_summary(folders: List[RunFolder]) -> List[List[str]]:
    """Rows of all runs, as each wrote them; a second run of a model is told apart by its key in the column `model`."""
    return [[folder.key if folder.key != folder.model else row[0]] + row[1:] for folder in folders
            for row in folder.summary.rows]
