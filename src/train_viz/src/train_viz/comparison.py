"""The paper's comparison as numbers: ours beside the paper's, energies by stage, and at equal speed.

Values at places are those that the runs wrote into summary.csv; only what no run can know alone, the place where all trains
have the same speed, is read off the bags.
"""
import dataclasses
from typing import Iterator, List, Optional

import numpy as np

from train_viz import paper_values as paper
from train_viz.run import Run
from train_viz.run_folder import RunFolder

FITTED, PREDICTED = 'fitted', 'predicted'


@dataclasses.dataclass(frozen=True)
class Row:
    """One value beside the paper's."""
    quantity: str
    unit: str      # kN, % or 1
    place: str
    whose: str
    paper: float
    ours: float
    kind: str      # FITTED or PREDICTED
    why: str

    @property
    def deviation(self) -> float:
        """Ours less the paper's, in the unit (percentage points for %)."""
        return self.ours - self.paper


@dataclasses.dataclass(frozen=True)
class Stages:
    """Energy of the leading locomotive since the start by stage, with what belongs beside it."""
    location_m: float
    time_s: float
    speed_mps: float
    rail_J: float  # Eq. (4)
    slip_J: float  # lost between rim and rail
    rim_J: float   # what the motors pay

    @property
    def stored_J(self) -> float:
        """Wheel spin-up and other storage between rim and rail."""
        return self.rim_J - self.rail_J - self.slip_J


class Comparison:
    """Finished runs of the paper's case, in the order 1D, 2D, 3D."""

    def __init__(self, folders: List[RunFolder]):
        self.folders = folders

    @property
    def runs(self) -> List[Run]:
        return [folder.run for folder in self.folders]

    def of_model(self, model: str) -> List[RunFolder]:
        return [folder for folder in self.folders if folder.model == model]

    @property
    def has_3d(self) -> bool:
        return bool(self.of_model('3d'))

    @property
    def base(self) -> Optional[RunFolder]:
        """That differences are taken against: 3D as in the paper; without it 2D, if there is another run beside it."""
        others = self.of_model('3d') or self.of_model('2d')
        return others[0] if others and len(self.folders) > 1 else None

    def force_kN(self, folder: RunFolder, place_km: float) -> float:
        return folder.summary.at('traction_force', 'N', place_km) / 1e3

    def force_against(self, folder: RunFolder, base: RunFolder, place_km: float) -> float:
        """[%]"""
        return 100.0 * (self.force_kN(folder, place_km) / self.force_kN(base, place_km) - 1.0)

    def energy_ratio(self, folder: RunFolder, base: RunFolder, place_km: float) -> float:
        """By Eq. (4), at the rail."""
        return self.stages(folder, place_km).rail_J / self.stages(base, place_km).rail_J

    def stages(self, folder: RunFolder, place_km: float) -> Stages:
        at = folder.summary.at
        return Stages(1e3 * place_km, at('time', 's', place_km), at('speed', 'm/s', place_km),
                      at('energy_rail', 'J', place_km), at('energy_slip', 'J', place_km), at('energy_rim', 'J', place_km))

    @property
    def equal_speed_mps(self) -> float:
        """The final speed of the run that ends slowest: every run reaches it."""
        return min(float(run.speed_mps[-1]) for run in self.runs)

    def stages_at_equal_speed(self, folder: RunFolder) -> Stages:
        """Where the leading locomotive first reaches `equal_speed_mps`, linear between the rows of the bag."""
        run, speed = folder.run, self.equal_speed_mps
        last = int(np.argmax(run.speed_mps >= speed))
        first = max(last - 1, 0)
        rise = run.speed_mps[last] - run.speed_mps[first]
        share = (speed - run.speed_mps[first]) / rise if rise > 0.0 else 1.0
        there = [float(values[first] + share * (values[last] - values[first])) for values in (
            run.location_m, run.time_s, run.speed_mps, run.loco_energy_rail_J[:, 0], run.loco_energy_slip_J[:, 0],
            run.loco_energy_rim_J[:, 0])]
        return Stages(*there)

    def rows(self) -> List[Row]:
        """Every number that the paper states and these runs have."""
        return [*self._forces(), *self._changes(), *self._force_differences(), *self._energy_ratio(),
                *self._energy_differences()]

    def _forces(self) -> Iterator[Row]:
        why = {'1d': 'published limit 0.35 m g; F_max and P identified so that it is reached',
               '2d': 'B and contact patch identified', '3d': 'patches from the profiles, P and B as in 2D'}
        for place, values in paper.FORCE_KN.items():
            for folder in self.folders:
                yield Row('traction', 'kN', _at(place), folder.label, values[folder.model], self.force_kN(folder, place),
                          PREDICTED if folder.model == '3d' else FITTED, why[folder.model])

    def _changes(self) -> Iterator[Row]:
        """Whether traction rises or falls from straight track into the curve."""
        outside, inside = sorted(paper.FORCE_KN)
        for folder in self.folders:
            yield Row('change of traction into the curve', '%', f'{outside:g} to {inside:g} km', folder.label,
                      100.0 * (paper.FORCE_KN[inside][folder.model] / paper.FORCE_KN[outside][folder.model] - 1.0),
                      100.0 * (self.force_kN(folder, inside) / self.force_kN(folder, outside) - 1.0),
                      PREDICTED if folder.model == '3d' else FITTED, 'from the two forces above')

    def _force_differences(self) -> Iterator[Row]:
        """Fig. 9; without 3D only what the stated forces give for 1D against 2D."""
        for base in self.of_model('3d'):
            stated = [(place, model, paper.force_against(model, '3d', place)) for place in paper.FORCE_KN
                      for model in ('1d', '2d')]
            stated += [(place, model, value) for model, (place, value) in paper.LARGEST_AGAINST_3D.items()]
            for place, model, value in sorted(stated):
                for folder in self.of_model(model):
                    yield self._difference(folder, base, place, value)
        if not self.has_3d:
            for folder in self.of_model('1d'):
                for base in self.of_model('2d'):
                    for place in sorted(paper.FORCE_KN):
                        yield self._difference(folder, base, place, paper.force_against('1d', '2d', place))

    def _difference(self, folder: RunFolder, base: RunFolder, place: float, value: float) -> Row:
        return Row('difference of traction', '%', _at(place), f'{folder.label} against {base.label}', value,
                   self.force_against(folder, base, place), *_kind_against(base))

    def _energy_ratio(self) -> Iterator[Row]:
        for folder in self.of_model('1d'):
            for base in self.of_model('2d'):
                for place in sorted(paper.ENERGY_AGAINST_3D):
                    yield Row('ratio of energy, Eq. (4)', '1', f'to {place:g} km', f'{folder.label} / {base.label}',
                              paper.energy_ratio('1d', '2d', place), self.energy_ratio(folder, base, place),
                              FITTED, 'P, B and patch identified with this ratio')

    def _energy_differences(self) -> Iterator[Row]:
        for base in self.of_model('3d'):
            for place, values in paper.ENERGY_AGAINST_3D.items():
                for folder in self.of_model('1d') + self.of_model('2d'):
                    yield Row('difference of energy, Eq. (4)', '%', f'to {place:g} km',
                              f'{folder.label} against {base.label}', values[folder.model],
                              100.0 * (self.energy_ratio(folder, base, place) - 1.0),
                              *_kind_against(base))

    def wheels_with_more_contacts(self, folder: RunFolder, place_km: float) -> Optional[int]:
        """How many wheels of the locomotive have more than one contact at a place; None of models without contacts."""
        wheels = folder.run.adhesion
        if wheels is None or wheels.wheels is None:
            return None
        row = min(int(np.searchsorted(wheels.location_km, place_km)), len(wheels.location_m) - 1)
        return int((wheels.wheels.contacts[row] > 1).sum())

    def largest_difference(self, folder: RunFolder, base: RunFolder) -> tuple:
        """Place [km] and value [%] of the largest difference of force at the paper's places of Fig. 9."""
        found = [(place, self.force_against(folder, base, place)) for place in paper.FIG9_PLACES_KM]
        return max(found, key=lambda pair: abs(pair[1]))


def _at(place_km: float) -> str:
    return f'{place_km:g} km' + (', in the curve' if 3.3 < place_km < 3.6 else '')


def _kind_against(base: RunFolder) -> tuple:
    if base.model == '3d':
        return PREDICTED, 'follows from the 3D run'
    return FITTED, 'both forces identified'
