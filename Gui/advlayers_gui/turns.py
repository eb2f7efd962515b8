"""Work in steps, some in each turn of the event loop, so that the window stays alive."""
from __future__ import annotations

import time
from typing import Any, Callable, Generator, Optional

from PySide import QtCore

_TURN = 0.03  # [s] of work before the event loop has its turn


class Turns:
    """One piece of work at a time."""

    def __init__(self) -> None:
        self._steps: Optional[Generator[None, None, Any]] = None
        self._done: Optional[Callable[[Any], None]] = None
        self._timer = QtCore.QTimer()
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._go_on)

    @property
    def busy(self) -> bool:
        return self._steps is not None

    def start(self, steps: Generator[None, None, Any],
              done: Optional[Callable[[Any], None]] = None) -> None:
        """In place of what is under way; the first steps are made before it returns. `done` gets
        what the steps return in the end."""
        self._steps, self._done = steps, done
        self._timer.start()
        self._go_on()

    def stop(self) -> None:
        self._steps = None
        self._timer.stop()

    def _go_on(self) -> None:
        end = time.monotonic() + _TURN
        self._step()
        while self._steps is not None and time.monotonic() < end:
            self._step()

    def _step(self) -> None:
        try:
            next(self._steps)
        except StopIteration as end:
            self.stop()
            if self._done is not None:
                self._done(end.value)
        except BaseException:
            self.stop()
            raise
