"""Notes what is known of a flight whenever it changes: identity, gains, plans, both lines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass

from epf_gcs import __version__
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.events import ControlEvent, Event, OwnGainsEvent
from epf_gcs.flight.board.board_link import Supervisor
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.hil.simulator import Simulator
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.recording.flight_notes import FlightNotes
from epf_gcs.recordings.notes import EVENT, IDENTITY, LINE, PARAMETERS, PLAN
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.parameters import gain_state


@dataclass(frozen=True, slots=True)
class HolderNote(Event):
    """The page that has control, as a recording says it: less than viewers are told."""

    NAME = ControlEvent.NAME
    client: str | None = None
    name: str | None = None


class KnownNotes:
    """Each method is called when what it notes may have changed; what stayed the same is not noted again.

    `aircraft` is what a person calls the aircraft, for no line names it; empty for no name.
    """

    def __init__(
        self,
        notes: FlightNotes,
        board: Board,
        *,
        parameters: Parameters,
        stick: Stick,
        supervisor: Supervisor,
        simulator: Simulator,
        aircraft: str = "",
    ) -> None:
        self._notes = notes
        self._board = board
        self._parameters = parameters
        self._stick = stick
        self._supervisor = supervisor
        self._simulator = simulator
        self._aircraft = aircraft
        self._plans: set[str] = set()

    def identity(self) -> None:
        """Whose board and station it is, and who has control."""
        capabilities, holder = self._board.capabilities(), self._stick.holder
        firmware = f"{capabilities['firmware_name']} {capabilities['firmware_version']}" if capabilities else None
        identity = {
            "station": __version__,
            "board": capabilities,
            "firmware": firmware,
            "aircraft": self._aircraft or None,
            "operator": None if holder is None else holder.name,
            "emulated": self._board.is_emulated,
        }
        self._notes.know(IDENTITY, identity)

    def name_aircraft(self, name: str) -> None:
        """From now on the aircraft is called this; empty for no name."""
        self._aircraft = name
        self.identity()

    def parameters(self) -> None:
        """The gains, as a viewer is told them."""
        self._notes.know(
            PARAMETERS, {name: asdict(gain_state(name, one)) for name, one in self._parameters.held.items()}
        )
        own = self._parameters.own.known
        if own.table.state != "none":
            self._own_gains(OwnGainsEvent(own.table, {}), "own_gains.table")
            self._own_gains(OwnGainsEvent(None, own.values), "own_gains.values")

    def _own_gains(self, event: OwnGainsEvent, about: str) -> None:
        self._notes.know(EVENT, {"event": event.NAME, "data": event}, about)

    def limits(self, limits: Mapping[str, float]) -> None:
        """What alarms are judged by."""
        self._notes.know(EVENT, {"event": "limits", "data": dict(limits)}, "limits")

    def plan(self, plan: str, waypoints: list[Waypoint] | None) -> None:
        """A plan that was read from the board; None where it is not known any more."""
        found = None if waypoints is None else [asdict(waypoint) for waypoint in waypoints]
        if found is not None:
            self._plans.add(plan)
        self._notes.know(PLAN, {"plan": plan, "waypoints": found}, plan)

    def forget_plans(self) -> None:
        """The board closed, or began anew: nobody knows which plans it has."""
        for plan in sorted(self._plans):
            self.plan(plan, None)
        self._plans.clear()

    def holder(self) -> None:
        """Another browser, or none, has control."""
        holder = self._stick.holder
        self._notes.event(HolderNote() if holder is None else HolderNote(holder.id, holder.name))
        self.identity()

    def lines(self) -> None:
        """Which devices the bytes of both lines belong to."""
        board, simulator = self._supervisor.address, self._simulator.address
        link = self._board.link
        self._notes.know(
            LINE,
            {
                "line": "board",
                "open": link is not None,
                "url": None if board is None else board.url,
                "baud": None if link is None else link.baud,
                "profile": None,
                "emulated": self._board.is_emulated,
            },
            "board",
        )
        self._notes.know(
            LINE,
            {
                "line": "simulator",
                "open": self._simulator.is_listening,
                "url": None if simulator is None else f"udp://{simulator.send_host}:{simulator.send_port}",
                "baud": None,
                "profile": None if simulator is None else simulator.profile,
                "emulated": False,
            },
            "simulator",
        )
