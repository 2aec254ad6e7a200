"""A run's folder as LTD leaves it: bag, summary.csv, outcome.yaml; and its name beside other runs of the paper's case."""
import dataclasses
import glob
import os
from typing import Any, Dict, List

import yaml

from train_viz.bag_reader import read_bag
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


def read_run_folders(paths: List[str]) -> List[RunFolder]:
    """In the order 1D, 2D, 3D, others of 3D, whatever the order of the paths.

    @raise ReportError naming the file and what to do
    """
    folders = sorted((_read(path) for path in paths), key=lambda folder: (folder.model, len(folder.key)))
    for first, second in zip(folders, folders[1:]):
        if first.key == second.key:
            raise ReportError(f'{first.path}, {second.path}: both are a run of {first.key}: give one')
    return folders


def _read(path: str) -> RunFolder:
    if not os.path.isdir(path):
        raise ReportError(f'{path}: no such folder: give the folders of finished runs')
    outcome = _read_outcome(os.path.join(path, 'outcome.yaml'))
    summary = read_summary(os.path.join(path, 'summary.csv'))
    if summary.model not in MODELS:
        raise ReportError(f'{summary.path}: model "{summary.model}", known are {", ".join(MODELS)}')
    bags = sorted(glob.glob(os.path.join(path, '*.bag')))
    if not bags:
        raise ReportError(f'{path}: no bag: run it with a bag (record:=true)')
    runs = join_parts([read_bag(bag) for bag in bags])
    if len(runs) > 1:
        raise ReportError(f'{path}: bags of {len(runs)} runs: leave those of one')
    key = _key(runs[0].scenario, summary.model)
    label = ' '.join([key[:2].upper()] + [key[3:].replace('_', '-')] * (len(key) > 3))
    return RunFolder(path, key, summary.model, dataclasses.replace(runs[0], label=label), summary, outcome)


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
