"""The recording of a lab flight, in the format of the station: its library, report and replay open it.

The simulator's side holds the truth: where the aircraft was in each frame, before any delay or loss. The board's side
holds what the board was told, and what it made of that.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final, cast

import numpy as np

from epf_gcs import __version__
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE
from epf_gcs.data_folder.whereabouts import of_running
from epf_gcs.flight.recording.recording_file import RecordingFile
from epf_gcs.lab.aircraft_loop import AircraftLoop
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faulty import FaultyLockStep
from epf_gcs.lab.flight import Flight, Moment, fly_in
from epf_gcs.lab.laws import Laws
from epf_gcs.lab.lock_step import LockStep
from epf_gcs.library.about import About, write_about
from epf_gcs.recordings import notes
from epf_gcs.recordings.mcap_file import message_record, metadata_record
from epf_gcs.recordings.places import Places
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED, TOPICS
from epf_gcs.simulator.rows import RowWriter
from epf_gcs.simulator.simulation import SimulationOptions
from epf_gcs.simulator.state import Controls
from epf_gcs.xplane.datagram import build

TAG: Final = "lab"
"""Every flight of the lab has it in the library."""

_BY: Final = "epf-lab"
_USUAL_ADDRESS: Final = "http://127.0.0.1:8000"
_HEARTBEAT_TASK: Final = 0
_HEARTBEAT_PERIOD_S: Final = 0.2
# What a station asks first of a board: who it is, its gains, and the times of its steps.
_FIRST_QUESTIONS: Final = ("capabilities", "load_autopilot_parameters", "hil_steps_on")


@dataclass(frozen=True, slots=True)
class Recorded:
    """A recording in a data folder, by its id, and the moment of it to look at first."""

    data_dir: Path
    id: str
    moment: Moment

    @property
    def link(self) -> str:
        """Opens the station at that moment."""
        running = of_running(self.data_dir)
        address = _USUAL_ADDRESS
        if running is not None:
            address = f"http{'s' if running.tls else ''}://127.0.0.1:{running.port}"
        return f"{address}/?flight={self.id}&at={self.moment.at_s:.2f}"

    @property
    def command(self) -> str | None:
        """What starts the station that has it; None while that one runs."""
        return None if of_running(self.data_dir) else f"epf-gcs --data-dir {self.data_dir}"

    def __str__(self) -> str:
        start = "" if self.command is None else f", once this runs: {self.command}"
        return f"{self.moment.at_s:.1f} s, {self.moment.why}: {self.link}{start}"


def record(flight: Flight, data_dir: Path, title: str = "") -> Recorded:
    """Fly it again, and keep every byte of it in a station's data folder. Raises LabError if the disk does not take it,
    or if it is another flight now, as with laws that were built anew."""
    with _recorded(flight) as loop:
        loop.greet()
        again = fly_in(loop, flight.route, flight.conditions, flight.gains, flight.longest_s)
        if not all(map(np.array_equal, again.columns(), flight.truth.columns())):
            raise LabError(f"{flight} is another flight when it is flown again: were the laws built anew?")
        try:
            return loop.write(flight, data_dir, title or flight.route.name)
        except OSError as error:
            raise LabError(f"{data_dir} takes no recording: {error.strerror or error}") from error


class _Tap:
    """A board of which every byte is kept, each way; all else is the board's."""

    def __init__(self, laws: Laws, keep: Callable[[int, bytes], None]) -> None:
        self._laws = laws
        self._keep = keep

    def __getattr__(self, name: str) -> Any:
        return getattr(self._laws, name)

    def feed(self, data: bytes) -> bytes:
        self._keep(BOARD_SENT, data)
        answer = self._laws.feed(data)
        self._keep(BOARD_RECEIVED, answer)
        return answer

    def send_streams(self, task: int) -> bytes:
        sent = self._laws.send_streams(task)
        self._keep(BOARD_RECEIVED, sent)
        return sent


class _RecordedLoop(LockStep):
    """A loop of which every byte is kept, with its time in the simulation."""

    def __init__(self, options: SimulationOptions, *arguments: Any) -> None:
        self._said: list[tuple[float, int, bytes]] = []
        self._writer = RowWriter(options.profile)
        self._profile = options.profile
        self._heartbeat_every = round(_HEARTBEAT_PERIOD_S * options.rate_hz)
        self._frames = 0
        super().__init__(options, *arguments)

    def greet(self) -> None:
        """Ask the board what a station asks first."""
        self._tell(OPEN_BINARY_MODE)
        for name in _FIRST_QUESTIONS:
            self.command(name)

    def write(self, flight: Flight, data_dir: Path, title: str) -> Recorded:
        """Put it into a data folder, ending now. Raises OSError."""
        places, moment = Places(data_dir), flight.moment
        places.recordings.mkdir(parents=True, exist_ok=True)
        start_ns = time.time_ns() - round(self.time_s * 1e9)
        file = RecordingFile(places.recordings, start_ns, f"{_BY} {__version__}", TOPICS)
        try:
            pieces = [metadata_record(name, notes.written(start_ns, said)) for name, said in self._known(flight)]
            # What came from the simulator is what the station then told the board.
            for time_s, channel, data in sorted(self._said, key=lambda one: (one[0], one[1] != SIMULATOR_RECEIVED)):
                t_ns = start_ns + round(time_s * 1e9)
                pieces.append(message_record(channel, file.tally.add(channel, t_ns), t_ns, data))
            mark = {"text": moment.why, "by": _BY, "id": "lab"}
            pieces.append(metadata_record(notes.MARK, notes.written(start_ns + round(moment.at_s * 1e9), mark)))
            file.tally.metadata_count = len(pieces) - len(self._said)
            file.put(b"".join(pieces))
            file.finish()
        except OSError:
            file.give_up()
            file.path.unlink(missing_ok=True)
            raise
        write_about(places.about(file.path.stem), About(title=title, tags=[TAG], notes=str(flight)))
        return Recorded(data_dir, file.path.stem, moment)

    def _known(self, flight: Flight) -> list[tuple[str, Any]]:
        """What the bytes do not say."""
        line = {"open": True, "baud": None, "url": None}
        return [
            (
                notes.IDENTITY,
                {"station": __version__, "aircraft": flight.conditions.aircraft, "operator": _BY, "emulated": True},
            ),
            (notes.PLAN, {"plan": "hil", "waypoints": [asdict(one) for one in flight.route.waypoints]}),
            (notes.LINE, {**line, "line": "board", "profile": None, "emulated": True}),
            (notes.LINE, {**line, "line": "simulator", "profile": self._profile, "emulated": False}),
        ]

    def _frame(self) -> tuple[float, float]:
        place = super()._frame()
        if self.upset is None:
            stick = Controls(0.0, 0.0, 0.0, self._lever)
            self._keep(SIMULATOR_RECEIVED, build(self._writer.rows(self._craft.state(), stick)))
        if self._frames % self._heartbeat_every == 0:
            self._take(self._laws.send_streams(_HEARTBEAT_TASK))
        return place

    def _new_board(self) -> Laws:
        return cast("Laws", _Tap(super()._new_board(), self._keep))

    def _keep(self, channel: int, data: bytes) -> None:
        if data:
            self._said.append((self.time_s, channel, data))


class _RecordedFaultyLoop(_RecordedLoop, FaultyLockStep):
    """The same with faults."""


class _RecordedAircraftLoop(_RecordedLoop, AircraftLoop):
    """The same of the real aircraft's loop."""


def _recorded(flight: Flight) -> _RecordedLoop:
    options = flight.conditions.options()
    if flight.conditions.loop == "aircraft":
        return _RecordedAircraftLoop(options, flight.faults, flight.library)
    if flight.faults:
        return _RecordedFaultyLoop(options, flight.faults, flight.library)
    return _RecordedLoop(options, flight.library)
