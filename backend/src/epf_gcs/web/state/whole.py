"""The whole status: the flight process's, plus version, control and viewers."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from dataclasses import replace

import orjson

from epf_gcs import __version__
from epf_gcs.access.control import Control
from epf_gcs.contract.status import Status
from epf_gcs.contract.surroundings import SurroundingsState
from epf_gcs.error_log import ErrorLog
from epf_gcs.repeating import Repeating
from epf_gcs.shares.table import STATUS_PER_S
from epf_gcs.web.stream.hub import Hub


class WholeStatus:
    """`flight` returns the part that the flight process sent last, `around` what was seen of ground and fence."""

    def __init__(
        self,
        flight: Callable[[], Status],
        control: Control,
        errors: ErrorLog,
        hub: Hub,
        around: Callable[[], SurroundingsState],
        *,
        loop: asyncio.AbstractEventLoop,
    ) -> None:
        self._flight = flight
        self._control = control
        self._errors = errors
        self._hub = hub
        self._around = around
        self._loop = loop
        self._sending = Repeating(loop, "the status", self._send)
        self._next_s = 0.0
        # Samples of the stick that did not count: their page has no control.
        self.strange_samples = 0

    def build(self) -> Status:
        """The flight process's part and the web process's own."""
        known = self._flight()
        stick = known.hil.stick
        if self.strange_samples:
            stick = replace(stick, samples=dict(Counter(stick.samples) + Counter(not_operator=self.strange_samples)))
        return replace(
            known,
            hil=replace(known.hil, stick=stick),
            version=__version__,
            control=self._control.state(),
            surroundings=self._around(),
            errors=dict(Counter(known.errors) + self._errors.counts),
            viewers=len(self._hub.viewers),
        )

    def text(self) -> bytes:
        """The status as JSON."""
        return orjson.dumps(self.build())

    def changed(self) -> None:
        """Send the status to the viewers in the next turn of the loop, or as soon as it may be sent again, once for all
        changes until then."""
        self._sending.arm(max(0.0, self._next_s - self._loop.time()))

    def _send(self) -> None:
        self._next_s = self._loop.time() + 1.0 / STATUS_PER_S
        if self._hub.viewers:
            self._hub.status(b'{"type":"status","data":%b}' % self.text())
