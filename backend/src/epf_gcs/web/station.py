"""The running parts of the web process, put together once.

vehicle (stream of the flight process) -> mirror -> hub -> viewers
routes and viewers -> control -> requests to the vehicle
"""

from __future__ import annotations

import asyncio
import contextlib
import gc
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any, Final

from epf_gcs.access.admission import Admission
from epf_gcs.access.caller import Caller
from epf_gcs.access.changes import HolderChange
from epf_gcs.access.control import Control
from epf_gcs.beacons.listener import BeaconListener
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.clock import Clock
from epf_gcs.contract.events import ErrorEvent, Event
from epf_gcs.contract.hello import ControlHolder
from epf_gcs.contract.notices import Notice, Pace
from epf_gcs.contract.requests import ReadInspector
from epf_gcs.error_log import ErrorLog
from epf_gcs.fields.fields import Fields
from epf_gcs.library.aircraft import AircraftNameChoice
from epf_gcs.library.flights import Flights, FlightsInUse
from epf_gcs.library.imports import FlightImports
from epf_gcs.library.jobs import Jobs
from epf_gcs.library.mark_shares import MarkShares
from epf_gcs.library.policy import PolicyChoice
from epf_gcs.library.queries import Queries
from epf_gcs.maps.maps import Maps
from epf_gcs.recordings.places import Places
from epf_gcs.rehearsal.rehearsals import Rehearsals
from epf_gcs.repeating import keep_alive, log_and_count_failures, repeat
from epf_gcs.shares.table import SHARES, Shares
from epf_gcs.surroundings.kept import KeptSurroundings
from epf_gcs.surroundings.watch import Surroundings
from epf_gcs.track.tracks import Tracks
from epf_gcs.web.checklist.checklist_store import KeptChecklist
from epf_gcs.web.endpoint import StreamParts
from epf_gcs.web.replays.replays import Replays
from epf_gcs.web.setup.doctor import Doctor
from epf_gcs.web.setup.first_start import FirstStart
from epf_gcs.web.state.whole import WholeStatus
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.open_streams import OpenStreams
from epf_gcs.web.vehicle.mirror import VehicleMirror
from epf_gcs.web.vehicle.shared_inspector import SharedInspector

# How long the server's start waits for the flight process, which is started at the same time.
_FIRST_WAIT_S: Final = 5.0
_STATUS_S: Final = 0.5
# The flight process says its status twice a second, at a high priority, also on a busy machine.
_SILENT_S: Final = 0.9


class Station:
    """Constructed on the running loop. `parts` are what routes get by name (`deps.py`). Implements `control.Told`."""

    def __init__(
        self,
        data_dir: Path,
        errors: ErrorLog,
        clock: Clock,
        *,
        shares: Shares = SHARES,
        control_by_silence: bool = False,
    ) -> None:
        loop = asyncio.get_running_loop()
        self._errors = errors
        log_and_count_failures(loop, "web", lambda: errors.count("internal"))
        self._here = asyncio.Event()
        self.clock = clock
        self.hub = Hub(loop, self.clock.now_s, on_rate=self._rate_changed)
        errors.tell_viewers(self.clock.steady_s, lambda *told: self.hub.event(ErrorEvent.of(*told)))
        self.mirror = VehicleMirror(self.hub, self.clock, on_change=self._status_changed, on_here=self._vehicle_here)
        self.vehicle = StationEnd(data_dir, self.mirror, silent_after_s=_SILENT_S)
        self.control = Control(loop, self.clock, self, by_silence=control_by_silence)
        self.streams = OpenStreams(self.control)
        self.tracks = Tracks(self.mirror, self.hub.say, self.clock, data_dir / "track", errors.report)
        self.maps = Maps(data_dir, self.hub.say, self.clock, errors.report)
        self.surroundings = Surroundings(
            self.mirror, self.maps, KeptSurroundings(data_dir), self.clock.now_s, self.vehicle.notice
        )
        self.status = WholeStatus(
            lambda: self.mirror.status, self.control, errors, self.hub, self.surroundings.state, loop=loop
        )
        self.beacons = BeaconListener(self.clock.steady_s)
        self.fields = Fields(self.maps, self.hub.say, errors.report)
        self.flights = Flights(
            Places(data_dir),
            Jobs(self.hub.say, shares=shares),
            self.clock,
            FlightsInUse(self._growing, lambda: self.mirror.is_here, lambda: self.replays.flights),
            policy=PolicyChoice(self.vehicle.ask),
            aircraft=AircraftNameChoice(self.vehicle.ask),
            report=errors.report,
        )
        self.queries = Queries(data_dir)
        self.replays = Replays(data_dir, errors, self._growing, shares)
        self.stream_parts = StreamParts(
            self.hub, self.control, self.vehicle, self.status, errors, self.clock, self.replays, self.streams
        )
        self.parts: dict[str, Any] = {
            "vehicle": self.vehicle,
            "mirror": self.mirror,
            "status": self.status,
            "control": self.control,
            "streams": self.streams,
            "tracks": self.tracks,
            "maps": self.maps,
            "fields": self.fields,
            "beacons": self.beacons,
            "inspector": SharedInspector(lambda: self.vehicle.ask(ReadInspector()), self.clock.steady_s),
            "recordings_dir": data_dir / "recordings",
            "flights": self.flights,
            "flight_queries": self.queries,
            "flight_imports": FlightImports(self.flights),
            "mark_shares": MarkShares(shares.marks),
            "checklist": KeptChecklist(data_dir),
            "rehearsals": Rehearsals(self.maps),
            "surroundings": self.surroundings,
            "first_start": FirstStart(data_dir),
            "doctor": Doctor(data_dir),
            "hub": self.hub,
            "clock": self.clock,
        }

    def follow(self, admission: Admission) -> None:
        """Sessions and keys that end or change do so for their open streams, and the log hears who has control."""

        def changed(sessions: frozenset[str]) -> None:
            for caller in filter(None, map(admission.current, sessions)):
                self.control.change_session(caller)

        def noted(change: HolderChange) -> None:
            page = change.page or change.before
            if page is not None:
                caller = Caller(page.kind, page.client, page.name, page.role, page.session)
                what = f"{change.before.name if change.before else '-'} > {change.page.name if change.page else '-'}"
                admission.log.note(caller, "", "holder", what, change.reason)

        admission.on_ended = self.streams.close_sessions
        admission.on_changed = changed
        self.control.on_holder = noted

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        """Run all parts inside."""
        try:
            async with asyncio.TaskGroup() as tasks:
                running = [
                    tasks.create_task(keep_alive("web", name, job, lambda: self._errors.count("internal")), name=name)
                    for name, job in (
                        ("vehicle", self.vehicle.run),
                        ("maps", self.maps.run),
                        ("fields", self.fields.run),
                        ("beacons", self.beacons.run),
                        ("track", self.tracks.run),
                        ("surroundings", self.surroundings.run),
                        ("flights", self.flights.run),
                        ("flight queries", self.queries.run),
                        ("status", self._repeat),
                    )
                ]
                with contextlib.suppress(TimeoutError):
                    async with asyncio.timeout(_FIRST_WAIT_S):
                        await self._here.wait()
                # All objects made so far live as long as the process: frozen, they are not scanned again.
                gc.collect()
                gc.freeze()
                try:
                    yield
                finally:
                    for task in running:
                        task.cancel()
        finally:
            await self.replays.close()
            await self.queries.close()
            await self.flights.close()
            await self.fields.close()
            await self.maps.close()
            await self.tracks.close()

    async def _repeat(self) -> None:
        """Without the flight process send the status ourselves, so that viewers see the ages grow."""
        await repeat(_STATUS_S, "the status without a flight process", self._tell_alone)

    def _tell_alone(self) -> None:
        if not self.mirror.is_here:
            self.status.changed()

    def _growing(self) -> str | None:
        """The id of the flight that is being recorded."""
        recording = self.mirror.status.recording
        return str(recording.file).removesuffix(".mcap") if recording.active else None

    def _rate_changed(self, rate_hz: int) -> None:
        self.vehicle.notice(Pace(rate_hz))

    def _status_changed(self) -> None:
        self.tracks.status_changed()
        self.flights.status_changed()
        self.status.changed()

    def _vehicle_here(self, holder: ControlHolder | None) -> None:
        """Agree on who has control: the process that was restarted learns it from the other one."""
        if holder is not None:
            self.control.restore(holder)
        self.control.tell_flight()
        self.vehicle.notice(Pace(self.hub.rate_hz))
        self._here.set()

    def event(self, event: Event) -> None:
        """For `Control`: tell all viewers."""
        self.hub.event(event)

    def notice(self, notice: Notice) -> None:
        """For `Control`: tell the flight process."""
        self.vehicle.notice(notice)

    def changed(self) -> None:
        """For `Control`: the status is another one."""
        self.status.changed()
