"""The two lines of a flight, opened and closed by the operator: the board's and the simulator's."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import structlog

from epf_gcs.errors import GatewayError
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.hil.emulation import PROFILE, EmulationLink
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.hil.simulator import Simulator, SimulatorAddress
from epf_gcs.flight.memory.memory import Memory
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.link.address import EMULATION, LinkAddress, parse_address
from epf_gcs.link.base import Link
from epf_gcs.link.open import open_link
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.wanted import IntendedSettings

log = structlog.get_logger("flight")


@dataclass(frozen=True, slots=True)
class LinkOpener:
    """Opens what an address names: a device, or the emulation with its example datagrams."""

    hil: Hil
    is_simulated: Callable[[], bool]

    async def __call__(self, address: LinkAddress) -> Link:
        """An open link. Raises LinkError."""
        if address != EMULATION:
            return await open_link(address)
        if not self.is_simulated():
            self.hil.begin(None, PROFILE)
        return EmulationLink(self._take_example)

    def _take_example(self, datagram: bytes) -> None:
        """Use an emulated datagram, but only while no simulator is connected."""
        if not self.is_simulated():
            self.hil.on_datagram(datagram)


@dataclass(frozen=True, slots=True)
class BothLines:
    """The board's line, the simulator's, and the loop between them."""

    board: Board
    supervisor: Supervisor
    simulator: Simulator
    hil: Hil


class Lines:
    """Remembers which lines were open, to reopen them at the next start; the emulation is not remembered."""

    def __init__(
        self,
        both: BothLines,
        *,
        parameters: Parameters,
        memory: Memory,
        recorder: Recorder | None,
        on_change: Callable[[], None],
    ) -> None:
        self._board = both.board
        self._supervisor = both.supervisor
        self._simulator = both.simulator
        self._hil = both.hil
        self._parameters = parameters
        self._memory = memory
        self._recorder = recorder
        self._on_change = on_change
        self.before_emulation: LinkAddress | None = None

    def reopen(self, board_url: str | None) -> None:
        """At the start: open the remembered lines, with `board_url` in place of the remembered board if given."""
        remembered = self._memory.now
        url = board_url or remembered.board_url
        if url is not None:
            identity = remembered.board_identity if url == remembered.board_url else None
            with _told_if_senseless():
                self._supervisor.want(parse_address(url), identity)
        if remembered.simulator is not None:
            with _told_if_senseless():
                self._simulator.want(SimulatorAddress(**remembered.simulator))

    async def open_board(self, address: LinkAddress) -> None:
        """Open a board's line in place of any other. Raises LinkError; then everything is as it was."""
        was_emulated, before = self._board.is_emulated, self._supervisor.address
        await self._supervisor.open(address)
        if address == EMULATION:
            self.before_emulation = self.before_emulation if was_emulated else before
            self._on_change()
            return
        if was_emulated:
            self._end_emulation()
        self._memory.update(board_url=address.url, board_identity=self._supervisor.identity)

    async def close_board(self) -> None:
        """End the session with this board and forget what was requested of it.

        Closing the emulation reopens the line that was open before it.
        """
        if self._board.is_emulated:
            before, identity = self.before_emulation, self._memory.now.board_identity
            await self._supervisor.close()
            self._end_emulation()
            if before is not None:
                self._supervisor.want(before, identity if before.url == self._memory.now.board_url else None)
            self._on_change()
            return
        await self._supervisor.close()
        self._parameters.forget()
        self._memory.update(board_url=None, board_identity=None, wanted=IntendedSettings())
        self._end_recording_if_idle()

    async def open_simulator(self, address: SimulatorAddress) -> None:
        """Listen to a simulator. Raises LinkError; then everything is as it was."""
        await self._simulator.open(address)
        self._memory.update(simulator=address.as_dict())

    async def close_simulator(self) -> None:
        """Hand the controls back to the simulator and forget its address."""
        await self._simulator.close()
        self._memory.update(simulator=None)
        self._end_recording_if_idle()

    def _end_emulation(self) -> None:
        self.before_emulation = None
        self._parameters.forget()
        if self._simulator.address is None:
            self._hil.begin(None, PROFILE)

    def _end_recording_if_idle(self) -> None:
        if self._recorder is not None and self._supervisor.address is None and self._simulator.address is None:
            self._recorder.end_session()


@contextmanager
def _told_if_senseless() -> Iterator[None]:
    """What is remembered in a form that makes no sense is logged, and costs nothing else."""
    try:
        yield
    except (GatewayError, TypeError) as error:
        log.error("a remembered link cannot be opened", reason=str(error))
