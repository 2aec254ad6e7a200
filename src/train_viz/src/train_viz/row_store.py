"""Rows of a bag by time, thinned where a picture cannot show more. Nothing here knows ROS."""
from typing import Any, Dict, List, Optional, Tuple

MOST_ROWS = 20000  # chosen: a dozen for each pixel of the widest figure, and some 20 MB for a number of each of 108 vehicles


def slot_width(count: int, span_ns: int) -> int:
    """Width of a slot of time for `count` rows over `span_ns`: 1 ns keeps every row."""
    if count <= MOST_ROWS:
        return 1
    every = -(-count // MOST_ROWS)
    return max(round(every * span_ns / (count - 1)), 1)


class RowStore:
    """One row a slot of time; slots end at whole multiples of their width, so the first row of a run has its own."""

    def __init__(self, first_ns: int, width_ns: int):
        self._first_ns, self._width_ns = first_ns, width_ns
        self._rows: Dict[int, Tuple[int, float, Any]] = {}
        self.added = 0

    def add(self, stamp_ns: int, row: Any, weight: Optional[float] = None) -> Optional[Any]:
        """Keeps the slot's last row, or with weights the one that weighs most.

        @return the row that this one took the place of
        """
        self.added += 1
        slot = -((self._first_ns - stamp_ns) // self._width_ns)  # rounded up
        old = self._rows.get(slot)
        if old is not None and weight is not None and weight <= old[1]:
            return None
        self._rows[slot] = (stamp_ns, weight or 0.0, row)
        return None if old is None else old[2]

    def rows(self) -> Dict[int, Any]:
        """By their stamps [ns]."""
        return {stamp: row for stamp, _, row in self._rows.values()}

    def stamps(self) -> List[int]:
        return sorted(self.rows())
