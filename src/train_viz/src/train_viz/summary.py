"""Reads summary.csv, the long table that every run writes: one quantity, unit, place and value a row."""
import csv
import dataclasses
from typing import Dict, List, Optional, Tuple

from train_viz.run import ReportError

COLUMNS = ('model', 'vehicle', 'quantity', 'unit', 'location_km', 'value')
Key = Tuple[Optional[int], str, Optional[float]]  # vehicle from 1 or None for the run, quantity, place [km] or None


@dataclasses.dataclass(frozen=True)
class Summary:
    """What one summary.csv holds."""
    path: str
    rows: List[List[str]]                     # as in the file, without the header
    values: Dict[Key, Tuple[str, float]]      # unit, value

    @property
    def lead(self) -> int:
        """Number of the leading locomotive among the vehicles."""
        return min(vehicle for vehicle, _, _ in self.values if vehicle is not None)

    @property
    def model(self) -> str:
        """Of the leading locomotive."""
        return next(row[0] for row in self.rows if row[1] == str(self.lead))

    def at(self, quantity: str, unit: str, location_km: float) -> float:
        """Of the leading locomotive at a report location."""
        return self._value((self.lead, quantity, location_km), unit)

    def of_run(self, quantity: str, unit: str) -> float:
        return self._value((None, quantity, None), unit)

    def _value(self, key: Key, unit: str) -> float:
        if key not in self.values:
            _, quantity, place = key
            raise ReportError(f'{self.path}: no {quantity}' + (
                '' if place is None else f' at {place:g} km: add it to output.report_locations_km and run as far as there'))
        found, value = self.values[key]
        if found != unit:
            raise ReportError(f'{self.path}: {key[1]} is in {found}, {unit} is expected: use the train_viz of the '
                              'build that wrote it')
        return value


def read_summary(path: str) -> Summary:
    """@raise ReportError naming file and line"""
    try:
        with open(path, encoding='utf-8', newline='') as file:
            header, *rows = list(csv.reader(file)) or [[]]
    except OSError as error:
        raise ReportError(f'{path}: cannot be read ({error.strerror}): give the folder of a run that finished') from None
    except (ValueError, csv.Error) as error:
        raise ReportError(f'{path}: no CSV ({error}): simulate again') from None
    if tuple(header) != COLUMNS:
        raise ReportError(f'{path}: columns {",".join(header)}, expected {",".join(COLUMNS)}: use the train_viz of the '
                          'build that wrote it')
    values: Dict[Key, Tuple[str, float]] = {}
    for number, row in enumerate(rows, start=2):
        try:
            _, vehicle, quantity, unit, place, value = row
            values[(int(vehicle) if vehicle else None, quantity, float(place) if place else None)] = (unit, float(value))
        except ValueError:
            raise ReportError(f'{path}, line {number}: not a row of a summary: simulate again') from None
    if not any(vehicle is not None for vehicle, _, _ in values):
        raise ReportError(f'{path}: no locomotive reported: the run ended before its first report location')
    return Summary(path, rows, values)
