"""One station, as a program sees and commands it."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import asynccontextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Generic, Literal, Self
from urllib.parse import urlencode

import msgspec
import orjson
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

from epf_gcs.client.errors import StationError, StationLostError
from epf_gcs.client.rest import Rest
from epf_gcs.client.stream import EventT, Sample, Stream, TopicT
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import AlarmBook, CommandOutcome, LinkResult, ParameterJournal, ParameterState
from epf_gcs.contract.base import ControlSource, PlanName, RoleName, SimulatorProfile, SurfacePath
from epf_gcs.contract.flights import Flight, Job
from epf_gcs.contract.own_gains import OwnGains
from epf_gcs.contract.simulator_faults import FaultKind, FaultPlace, FaultState, SimulatedFaults, TurbulenceName
from epf_gcs.contract.status import HilState, Status

_OPENING_S: Final = 20.0
_JOB_LOOK_S: Final = 0.2
EXPORTS = Literal["mcap", "mcap-decoded", "csv", "parquet", "kml", "kmz", "gpx", "czml"]


@dataclass(frozen=True, slots=True)
class Newest(Generic[TopicT]):
    """The newest sample of a topic: when it was heard (Unix seconds), how old it is, and whether that is too old."""

    t_s: float
    age_s: float
    stale: bool
    values: TopicT


class Station:
    """A context: inside it the stream is open. Whoever commands takes control first: `async with station.control():`.

    `url` as in a browser, such as http://127.0.0.1:8080; `key`: of a program, as the station's owner made it (the own
    computer needs none); `name`: what people on the station read; `rate_hz`: batches a second at most, 0 for every
    sample; `asks_for_control`: a command that is refused because another has control asks that one for it.
    """

    def __init__(
        self, url: str, key: str | None = None, *, name: str = "", rate_hz: int = 0, asks_for_control: bool = False
    ) -> None:
        self._url = url.rstrip("/")
        self._key = key
        self._query = urlencode({"rate": rate_hz, "name": name})
        self._rest = Rest(self._url, key, asks_for_control=asks_for_control)
        self._opened: Stream | None = None

    async def __aenter__(self) -> Self:
        headers = {} if self._key is None else {"Authorization": f"Bearer {self._key}"}
        address = f"ws{self._url.removeprefix('http')}/api/v1/stream?{self._query}"
        try:
            connection = await connect(
                address, additional_headers=headers, max_size=None, open_timeout=_OPENING_S, proxy=None
            )
            hello = orjson.loads(await connection.recv())
        except InvalidStatus as error:
            await self._rest.close()
            reason = error.response.body.decode(errors="replace") if error.response.body else str(error)
            raise StationError("not_admitted", reason, {}) from error
        except OSError as error:
            await self._rest.close()
            raise StationLostError(f"No station answers at {self._url}: {error}.") from error
        self._opened = Stream(connection, hello)
        self._rest.act_as(self._opened.client)
        if hello["has_control"]:
            # Who comes first has control without asking; a program has it while it says so.
            await self._release()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self._stream.close()
        await self._rest.close()

    # ---- what is -------------------------------------------------------------------------------------

    @property
    def status(self) -> Status:
        """The station's state as it told last. Raises StationLostError when nothing is told any more."""
        return self._stream.status

    @property
    def role(self) -> RoleName:
        """What this program may do."""
        return self._stream.role

    @property
    def version(self) -> str:
        """The station's."""
        return self._stream.version

    def samples(self, topic: type[TopicT]) -> AsyncIterator[Sample[TopicT]]:
        """Every sample of a topic from now on. Raises StationLostError when the stream ends."""
        return self._stream.samples(topic)

    def events(self, *kinds: type[EventT]) -> AsyncIterator[EventT]:
        """What happens from now on, of these kinds of `epf_gcs.contract.events`."""
        return self._stream.events(*kinds)

    async def until(self, holds: Callable[[Status], bool], within_s: float | None = None) -> Status:
        """The first status of which this holds, the present one included. Raises TimeoutError after `within_s`."""
        async with asyncio.timeout(within_s):
            async for status in self._stream.statuses():
                if holds(status):
                    return status
        raise AssertionError("the statuses have no end but an exception")

    async def newest(self, topic: type[TopicT]) -> Newest[TopicT] | None:
        """The newest sample of a topic, with its age; None if none came yet."""
        one = (await self._rest.json("GET", "/telemetry")).get(topic.NAME)
        if one is None:
            return None
        return Newest(one["t_s"], one["age_s"], one["stale"], msgspec.convert(one["values"], topic))

    async def alarms(self) -> AlarmBook:
        """What is wrong now and what was."""
        return await self._rest.ask("GET", "/alarms", AlarmBook)

    # ---- commands, each with its proof ---------------------------------------------------------------

    @asynccontextmanager
    async def control(self) -> AsyncIterator[None]:
        """Have control inside, and give it back. Raises ControlError if another has it: nothing is taken by force."""
        client = self._stream.client
        await self._rest.json("POST", "/control", {"client": client, "action": "take"})
        try:
            yield
        finally:
            if self._stream.is_open:
                await self._release()

    async def command(self, name: str, value: float | Sequence[float] | None = None) -> CommandOutcome:
        """Send a command by its name of the wire's reference, and wait for its proof or for what became of it."""
        body = None if value is None else {"value": value}
        return await self._rest.ask("POST", f"/commands/{name}", CommandOutcome, body)

    async def set_hil(self, source: ControlSource | None = None, path: SurfacePath | None = None) -> HilState:
        """Who holds the stick, and who moves the simulator's surfaces; None stays as it is."""
        asked = {"source": source, "path": path}
        return await self._rest.ask("PUT", "/hil", HilState, {name: word for name, word in asked.items() if word})

    async def begin_fault(
        self,
        place: FaultPlace,
        kind: FaultKind,
        *,
        start_s: float = 0.0,
        length_s: float | None = None,
        strength: float | None = None,
    ) -> FaultState:
        """Let something go wrong in the embedded simulator, `start_s` from now; None: as usual for it. For owners."""
        asked = {"place": place, "kind": kind, "start_s": start_s, "length_s": length_s, "strength": strength}
        return await self._rest.ask("POST", "/faults", FaultState, asked)

    async def end_faults(self, fault_id: str | None = None) -> SimulatedFaults:
        """End a fault of the embedded simulator, or all."""
        path = "/faults" if fault_id is None else f"/faults/{fault_id}"
        return await self._rest.ask("DELETE", path, SimulatedFaults)

    async def set_wind(self, from_deg: float, speed_kt: float, turbulence: TurbulenceName = "none") -> SimulatedFaults:
        """Steady wind and turbulence of the embedded simulator from now on."""
        asked = {"from_deg": from_deg, "speed_kt": speed_kt, "turbulence": turbulence}
        return await self._rest.ask("PUT", "/faults/wind", SimulatedFaults, asked)

    async def open_board(self, url: str) -> LinkResult:
        """Open the board's line, such as serial:///dev/ttyUSB0 or tcp://10.0.0.2:7000."""
        return await self._rest.ask("PUT", "/links/board", LinkResult, {"url": url})

    async def close_board(self) -> None:
        """Close the board's line."""
        await self._rest.json("DELETE", "/links/board")

    async def open_simulator(
        self, receive_port: int, send_host: str, send_port: int, profile: SimulatorProfile
    ) -> LinkResult:
        """Listen for the simulator, and send it the surfaces."""
        asked = {"receive_port": receive_port, "send_host": send_host, "send_port": send_port, "profile": profile}
        return await self._rest.ask("PUT", "/links/simulator", LinkResult, asked)

    # ---- gains and plans -----------------------------------------------------------------------------

    async def gains(self) -> Mapping[str, ParameterState]:
        """The 17 gains by name; `value` is the board's, None until it was read."""
        return _by_name(await self._rest.json("GET", "/parameters"))

    async def own_gains(self) -> OwnGains:
        """Those that the board describes itself, as far as they are known; `set_gains` writes them too."""
        return msgspec.convert((await self._rest.json("GET", "/parameters"))["own"], OwnGains)

    async def load_gains(self) -> Mapping[str, ParameterState]:
        """The same, read from the board now."""
        return _by_name(await self._rest.json("POST", "/parameters/load"))

    async def set_gains(self, changes: Mapping[str, float]) -> Mapping[str, ParameterState]:
        """Write gains in one step that can be undone; answers after they were read back."""
        return _by_name(await self._rest.json("PATCH", "/parameters", changes))

    async def undo_gains(self) -> Mapping[str, ParameterState]:
        """Take the last step back."""
        return _by_name(await self._rest.json("POST", "/parameters/undo"))

    async def store_gains(self) -> CommandOutcome:
        """Have the board keep them on its card."""
        return await self._rest.ask("POST", "/parameters/store", CommandOutcome)

    async def journal(self) -> ParameterJournal:
        """Who wrote which gain when."""
        return await self._rest.ask("GET", "/parameters/journal", ParameterJournal)

    async def plan(self, name: PlanName) -> list[Waypoint]:
        """The plan that the board has."""
        return msgspec.convert((await self._rest.json("GET", f"/missions/{name}"))["waypoints"], list[Waypoint])

    async def send_plan(self, name: PlanName, waypoints: Sequence[Waypoint]) -> list[Waypoint]:
        """Send a plan; answers with what was read back from the board."""
        body = {"waypoints": [asdict(waypoint) for waypoint in waypoints]}
        return msgspec.convert((await self._rest.json("PUT", f"/missions/{name}", body))["waypoints"], list[Waypoint])

    # ---- flights -------------------------------------------------------------------------------------

    async def flights(self) -> list[Flight]:
        """The newest flights of the library, the last first."""
        return msgspec.convert((await self._rest.json("GET", "/flights"))["flights"], list[Flight])

    async def export(self, flight_id: str, kind: EXPORTS, file: Path) -> Path:
        """Make a file of a flight and save it here."""
        job_id = (await self._rest.json("POST", f"/flights/{flight_id}/exports", {"format": kind}))["job"]
        job = await self._rest.ask("GET", f"/jobs/{job_id}", Job)
        while job.state in ("waiting", "running"):
            await asyncio.sleep(_JOB_LOOK_S)
            job = await self._rest.ask("GET", f"/jobs/{job_id}", Job)
        if job.state != "done":
            fault = job.fault
            raise StationError(fault.code, fault.detail, fault.params) if fault else StationError(job.state, "", {})
        made = await self._rest.fetch("GET", f"/jobs/{job_id}/result")
        await asyncio.to_thread(file.write_bytes, made.content)
        return file

    async def _release(self) -> None:
        await self._rest.json("POST", "/control", {"client": self._stream.client, "action": "release"})

    @property
    def _stream(self) -> Stream:
        if self._opened is None:
            raise StationLostError("The station is not open: use it inside 'async with Station(...)'.")
        return self._opened


def _by_name(answer: Any) -> Mapping[str, ParameterState]:
    """The gains of an answer."""
    return {one.name: one for one in msgspec.convert(answer["parameters"], list[ParameterState])}
