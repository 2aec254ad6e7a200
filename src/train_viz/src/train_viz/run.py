"""One simulated run as plain arrays, and what is asked of it. Nothing here knows ROS or matplotlib."""
import dataclasses
import os
from typing import Dict, List, Optional, Tuple

import numpy as np

from train_viz.adhesion import Adhesion, join_adhesion
from train_viz.run_labels import labels_of


# residual_relative of the account (docs/files.md), in tables
RESIDUAL_WORDS = 'residual / traction or brakes, the larger'


class ReportError(Exception):
    """Something the user can mend: says which file and what to do."""


def make_directory(path: str) -> None:
    """For a program's --out.

    @raise ReportError if it cannot be made or written
    """
    try:
        os.makedirs(path, exist_ok=True)
    except OSError as error:
        raise ReportError(f'{path}: cannot be made ({error.strerror}): give another --out') from None
    if not os.access(path, os.W_OK):
        raise ReportError(f'{path}: not writable: give another --out')


@dataclasses.dataclass(frozen=True)
class Run:
    """A run in rows of equal simulation time; all arrays have the same number of rows. SI units.

    Signs as in the messages: traction + forward, coupler + draft, dissipation >= 0.
    """
    label: str                        # in legends and file names; unique within one report
    files: Tuple[str, ...]            # bags that it was read from
    run_id: int
    build_id: str
    scenario: str
    resolved: str                     # the resolved scenario, YAML text
    time_s: np.ndarray                # since the start of the run
    location_m: np.ndarray            # chainage of the leading locomotive
    speed_mps: np.ndarray             # of the leading locomotive
    speed_limit_mps: np.ndarray       # lowest under the train
    notch: np.ndarray                 # [row, locomotive]
    brake_notch: np.ndarray           # [row, locomotive], of the dynamic brake
    traction_N: np.ndarray            # [row, locomotive], at the rail, < 0 braking
    coupler_force_N: np.ndarray       # [row, coupler]
    pipe_pressure_Pa: np.ndarray      # [row, vehicle], over the atmosphere; no vehicles in a train without an air brake
    cylinder_pressure_Pa: np.ndarray  # likewise
    locos: Dict[str, np.ndarray]      # TrainEnergy's lists by field name without loco_, [row, locomotive]
    account: Dict[str, np.ndarray]    # whole train: TrainEnergy's numbers by field name, [row]
    adhesion: Optional[Adhesion] = None  # of the first locomotive that has wheels on the rail; no locomotive of model 1d has
    recorded: int = 0                 # instants in the bag; of a long run the rows are fewer
    locomotive: int = 1               # that the figures show, from 1 at the head; place and speed are the leading one's

    @property
    def loco_energy_rail_J(self) -> np.ndarray:
        """[row, locomotive], Eq. (4), as the next two."""
        return self.locos['energy_rail']

    @property
    def loco_energy_rim_J(self) -> np.ndarray:
        return self.locos['energy_rim']

    @property
    def loco_energy_slip_J(self) -> np.ndarray:
        """Lost to slip between rim and rail."""
        return self.locos['energy_slip']

    @property
    def rail_J(self) -> np.ndarray:
        """Of the locomotive shown, as the next three."""
        return self.loco_energy_rail_J[:, self.locomotive - 1]

    @property
    def slip_J(self) -> np.ndarray:
        return self.loco_energy_slip_J[:, self.locomotive - 1]

    @property
    def rim_J(self) -> np.ndarray:
        return self.loco_energy_rim_J[:, self.locomotive - 1]

    @property
    def shown_traction_N(self) -> np.ndarray:
        return self.traction_N[:, self.locomotive - 1]

    @property
    def whose(self) -> str:
        return 'the leading locomotive' if self.locomotive == 1 else f'locomotive {self.locomotive}'

    @property
    def location_km(self) -> np.ndarray:
        return self.location_m / 1000.0

    @property
    def speed_kmph(self) -> np.ndarray:
        return self.speed_mps * 3.6

    @property
    def end_kmph(self) -> float:
        """Speed at the end to 0.001 km/h, so that a train at rest has 0, not -0."""
        return round(float(self.speed_kmph[-1]), 3) + 0.0

    def at_location(self, values: np.ndarray, location_m: float) -> float:
        """`values` where the leading locomotive first passes a place, linear between the rows around it."""
        return float(np.interp(location_m, np.maximum.accumulate(self.location_m), values))

    def brakes(self) -> bool:
        """Whether any brake took energy: more than 1e-6 (chosen) of what went through the rail."""
        taken = sum(self.account[name][-1] for name in ('brake_rail', 'air_brake', 'shoes'))
        return bool(taken > 1e-6 * max(abs(self.account['traction_rail'][-1]), 1.0))

    def has_air_brake(self) -> bool:
        return self.pipe_pressure_Pa.shape[1] > 0

    def has_supply(self) -> bool:
        """Whether any locomotive books what feeds its motors."""
        return bool(any(np.any(self.locos[name]) for name in ('fuel', 'line_drawn', 'auxiliaries', 'stored')))

    def rim_differs(self) -> bool:
        """Whether the rim pays visibly more than the rail gets (in 1D both are the same)."""
        scale = np.max(np.abs(self.loco_energy_rail_J))
        # 1e-4, chosen: a tenth of the width of a line in the figures.
        return bool(np.max(np.abs(self.loco_energy_rim_J - self.loco_energy_rail_J)) > max(1e-4 * scale, 1.0))

    def races(self) -> bool:
        """Whether wheels spin so much that the motors' work dwarfs what arrives: more than twice (chosen) the work at the rail.

        And most of it is slip: a locomotive that hardly gets away from its own shoes does not race.
        """
        over_J = self.rim_J[-1] - max(self.rail_J[-1], 0.0)
        return bool(self.rim_J[-1] > 2.0 * max(self.rail_J[-1], 0.0) + 1e6 and self.slip_J[-1] > 0.5 * over_J)

    def speed_rises(self) -> bool:
        """Whether energy over speed is one readable line: the speed never drops by more than 2 % (chosen) of its maximum."""
        drop = np.max(np.maximum.accumulate(self.speed_mps) - self.speed_mps)
        return bool(drop <= 0.02 * np.max(np.abs(self.speed_mps)))


def join_parts(parts: List[Run], names: Optional[List[str]] = None) -> List[Run]:
    """Joins bags of one run (LTD may close a bag and go on in the next) and gives every run a label of its own.

    @param names labels of the runs, in their order; none: the scenarios' names, and what tells equal ones apart
    """
    groups: Dict[Tuple[int, str, str], List[Run]] = {}
    for part in parts:
        groups.setdefault((part.run_id, part.build_id, part.resolved), []).append(part)
    runs = [_join(group) for group in groups.values()]
    if not names:
        names = labels_of([(run.scenario, run.resolved, run.files[0]) for run in runs])
    elif len(names) != len(runs) or len(set(names)) != len(names) or not all(names):
        raise ReportError(f'{len(names)} --label for {len(runs)} run(s): give each run one, no two the same')
    return [dataclasses.replace(run, label=name) for run, name in zip(runs, names)]


def _join(parts: List[Run]) -> Run:
    if len(parts) == 1:
        return parts[0]
    widths = {(p.traction_N.shape[1], p.coupler_force_N.shape[1], p.pipe_pressure_Pa.shape[1]) for p in parts}
    if len(widths) > 1:
        raise ReportError(f'{", ".join(p.files[0] for p in parts)}: parts of one run with trains of different length: '
                          'give each its own report')
    # A resumed run repeats the rows after its checkpoint, bit for bit: any one of the same time will do.
    _, rows = np.unique(np.concatenate([p.time_s for p in parts]), return_index=True)

    def merged(get):
        return np.concatenate([get(p) for p in parts])[rows]

    arrays = {f.name: merged(lambda p, name=f.name: getattr(p, name))
              for f in dataclasses.fields(Run) if f.type is np.ndarray}
    tables = {table: {name: merged(lambda p, table=table, name=name: getattr(p, table)[name])
                      for name in getattr(parts[0], table)} for table in ('account', 'locos')}
    wheels = [p.adhesion for p in parts if p.adhesion is not None]
    return dataclasses.replace(parts[0], files=sum((p.files for p in parts), ()), recorded=sum(p.recorded for p in parts),
                               adhesion=join_adhesion(wheels) if wheels else None, **arrays, **tables)
