"""Tables of wheel_rail_contact: contact patches and cross-sections."""
import csv
from typing import Dict, List, NamedTuple, Tuple

import numpy as np

from train_viz.run import ReportError


class Contact(NamedTuple):
    """One patch; lengths in mm, y_rail to the field side, z down, displacement to the right."""
    side: str
    y_mm: float
    y_rail_mm: float
    z_rail_mm: float
    angle_rad: float
    rolling_radius_mm: float
    normal_force_N: float  # noqa: N815  (the unit)


def read_rows(path: str, columns: Tuple[str, ...]) -> List[Dict[str, str]]:
    try:
        with open(path, encoding='utf-8', newline='') as file:
            reader = csv.DictReader(file)
            missing = [column for column in columns if column not in (reader.fieldnames or [])]
            if missing:
                raise ReportError(f'{path}: line 1: no column {", ".join(missing)}: is this from wheel_rail_contact?')
            rows = list(reader)
    except (OSError, UnicodeDecodeError) as error:
        raise ReportError(f'{path}: cannot be read ({error})') from None
    if not rows:
        raise ReportError(f'{path}: no rows')
    return rows


def number(path: str, line: int, row: Dict[str, str], column: str) -> float:
    try:
        return float(row[column])
    except (TypeError, ValueError):
        raise ReportError(f'{path}: line {line}: {column} = {row[column]}: must be a number') from None


def read_contacts(path: str) -> List[Contact]:
    rows = read_rows(path, ('side',) + Contact._fields[1:])
    return [Contact(row['side'], *(number(path, i + 2, row, column) for column in Contact._fields[1:]))
            for i, row in enumerate(rows)]


def read_sections(path: str) -> Dict[str, np.ndarray]:
    """Points (y, z) of wheel and rail in mm, in the rail's frame."""
    rows = read_rows(path, ('body', 'y_mm', 'z_mm'))
    sections = {}
    for body in ('wheel', 'rail'):
        points = [(number(path, i + 2, row, 'y_mm'), number(path, i + 2, row, 'z_mm'))
                  for i, row in enumerate(rows) if row['body'] == body]
        if not points:
            raise ReportError(f'{path}: no points of the {body}')
        sections[body] = np.array(points)
    return sections
