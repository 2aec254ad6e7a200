"""How far a long read is: one line on a terminal that is written over, elsewhere a line now and then."""
import sys
import time
from typing import Callable, Optional, TextIO

SILENT_S = 2.0        # of wall time, chosen: short reads stay silent
TERMINAL_S = 0.2      # chosen: smooth to look at
ELSEWHERE_S = 10.0    # chosen: a log stays short
BAR_CELLS = 24


class Progress:
    """Told how many of `total` are done, as often as anybody likes."""

    def __init__(self, words: str, total: int, stream: Optional[TextIO] = None,
                 clock: Callable[[], float] = time.monotonic):
        self._words, self._total, self._clock = words, max(total, 1), clock
        self._stream = sys.stderr if stream is None else stream
        self._terminal = self._stream.isatty()
        self._start = clock()
        self._due = self._start + (SILENT_S if self._terminal else ELSEWHERE_S)
        self._shown = 0  # letters of the line on the terminal

    def tell(self, done: int) -> None:
        now = self._clock()
        if now < self._due or done <= 0:
            return
        self._due = now + (TERMINAL_S if self._terminal else ELSEWHERE_S)
        self._write(self._line(done, (now - self._start) * (self._total - done) / done))

    def close(self) -> None:
        """Wipes the terminal's line, so that what follows starts on a clean one."""
        if self._shown:
            self._stream.write('\r' + ' ' * self._shown + '\r')
            self._stream.flush()
            self._shown = 0

    def _line(self, done: int, left_s: float) -> str:
        left = f'{left_s:.0f} s' if left_s < 90.0 else f'{left_s / 60.0:.0f} min'
        percent = f'{100 * done // self._total:3d} %, {left} left'
        if not self._terminal:
            return f'{self._words}: {percent.strip()}'
        full = BAR_CELLS * done // self._total
        return f'{self._words}: [{"#" * full}{"." * (BAR_CELLS - full)}] {percent}'

    def _write(self, line: str) -> None:
        if self._terminal:
            self._stream.write('\r' + line.ljust(self._shown))
            self._shown = len(line)
        else:
            self._stream.write(line + '\n')
        self._stream.flush()
