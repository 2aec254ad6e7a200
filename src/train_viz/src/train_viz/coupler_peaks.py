"""Reads couplers.csv, which a run leaves beside its bag: the largest draft and buff of every coupler, of every step."""
import csv
import dataclasses
import os
from typing import Optional

import numpy as np

from train_viz.run import ReportError, Run

NAME = 'couplers.csv'
ROUNDING = 1e-9  # chosen: more than the digits of the file leave out, of a force


@dataclasses.dataclass(frozen=True)
class CouplerPeaks:
    """Of each coupler from the head, >= 0."""
    draft_N: np.ndarray
    buff_N: np.ndarray


def read_coupler_peaks(run: Run) -> Optional[CouplerPeaks]:
    """Of a run, from the folder of its last bag; None if there is no such file, or if it is not this run's: of another number
    of couplers, or smaller than what the bag holds (of a run that stopped, or that went on from another folder).

    @raise ReportError naming file and line
    """
    path = os.path.join(os.path.dirname(os.path.abspath(run.files[-1])), NAME)
    if not os.path.isfile(path) or os.path.getsize(path) == 0:  # written at a run's end
        return None
    peaks = _read(path)
    forces = run.coupler_force_N
    if len(peaks.draft_N) != forces.shape[1]:
        return None
    spare = 1.0 + ROUNDING
    covered = (forces.max(axis=0) <= peaks.draft_N * spare) & (-forces.min(axis=0) <= peaks.buff_N * spare)
    return peaks if covered.all() else None


def _read(path: str) -> CouplerPeaks:
    draft, buff = [], []
    try:
        with open(path, encoding='utf-8', newline='') as file:
            for number, row in enumerate(csv.DictReader(file), start=2):
                try:
                    draft.append(float(row['largest_draft_N']))
                    buff.append(float(row['largest_buff_N']))
                except (KeyError, TypeError, ValueError):
                    raise ReportError(f'{path}, line {number}: not a row of {NAME}: simulate again, or move it away') from None
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise ReportError(f'{path}: not readable ({error}): simulate again, or move it away') from None
    return CouplerPeaks(np.array(draft), np.array(buff))
