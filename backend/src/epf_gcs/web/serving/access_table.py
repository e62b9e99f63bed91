"""The table of access: the least role that each route and each message of a stream needs.

Code, OpenAPI document, guide and tests are made from it. What is not in it is refused, and a route without an entry, or
an entry without a route, keeps the station from starting.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, Final, NamedTuple

from fastapi import FastAPI
from fastapi.routing import iter_route_contexts

from epf_gcs.access.roles import OPEN, Least, Role

API: Final = "/api/v1"
_READING_METHOD: Final = "GET"
_PAGE: Final = "/{path:path}"
_INTERFACE: Final = "/api"
_viewer, _operator, _owner = Role.viewer, Role.operator, Role.owner


class Entry(NamedTuple):
    """`least`: the least role. `control`: the caller must also have control, or nobody has it. `deed`: what the log of
    people's deeds calls it; None: not logged. `secret`: what the request says is not written there."""

    least: Least
    control: bool = False
    deed: str | None = None
    secret: bool = False


def _command(deed: str) -> Entry:
    return Entry(_operator, control=True, deed=deed)


_SEES: Final = Entry(_viewer)
_ANYONE: Final = Entry(OPEN)
# What these do stands in the log with names; their bodies hold keys.
_OWNS: Final = Entry(_owner)

_V1: Final[Mapping[tuple[str, str], Entry]] = {
    ("GET", "/about"): _SEES,
    ("GET", "/status"): _SEES,
    ("GET", "/telemetry"): _SEES,
    ("GET", "/control"): _SEES,
    ("POST", "/control"): Entry(_operator, deed="control"),
    ("GET", "/ports"): _SEES,
    ("GET", "/simulators"): _SEES,
    ("PUT", "/links/board"): _command("link"),
    ("DELETE", "/links/board"): _command("link"),
    ("PUT", "/links/simulator"): _command("link"),
    ("DELETE", "/links/simulator"): _command("link"),
    ("GET", "/commands"): _SEES,
    ("POST", "/commands/{name}"): _command("command"),
    ("GET", "/hil"): _SEES,
    ("PUT", "/hil"): _command("hil"),
    ("GET", "/faults"): _SEES,
    # An instructor's, who need not have control: a pupil flies.
    ("POST", "/faults"): Entry(_owner, deed="faults"),
    ("DELETE", "/faults"): Entry(_owner, deed="faults"),
    ("DELETE", "/faults/{fault_id}"): Entry(_owner, deed="faults"),
    ("PUT", "/faults/wind"): Entry(_owner, deed="faults"),
    ("POST", "/console"): _command("console"),
    ("POST", "/ahrs-test"): _command("ahrs_test"),
    ("DELETE", "/ahrs-test"): _command("ahrs_test"),
    ("GET", "/parameters"): _SEES,
    ("GET", "/parameters/journal"): _SEES,
    ("PATCH", "/parameters"): _command("gains"),
    ("POST", "/parameters/load"): _command("gains"),
    ("POST", "/parameters/store"): _command("gains"),
    ("POST", "/parameters/undo"): _command("gains"),
    ("POST", "/parameters/redo"): _command("gains"),
    ("GET", "/missions/{plan}"): _SEES,
    ("PUT", "/missions/{plan}"): _command("plan"),
    ("POST", "/missions/export"): _SEES,
    ("POST", "/missions/import"): Entry(_operator),
    ("POST", "/missions/rehearsal"): Entry(_operator),
    ("GET", "/alarms"): _SEES,
    ("GET", "/checklist"): _SEES,
    ("PUT", "/checklist"): Entry(_operator, deed="checklist"),
    ("DELETE", "/checklist"): Entry(_operator, deed="checklist"),
    ("GET", "/surroundings"): _SEES,
    ("PUT", "/surroundings"): Entry(_operator, deed="surroundings"),
    ("GET", "/surroundings/fence"): _SEES,
    ("POST", "/surroundings/fence/import"): Entry(_operator),
    ("GET", "/alarms/thresholds"): _SEES,
    ("PUT", "/alarms/thresholds"): _command("alarms"),
    ("POST", "/alarms/{alarm_id}/acknowledge"): _command("alarms"),
    ("GET", "/inspector"): _SEES,
    ("GET", "/earth.kml"): _SEES,
    ("GET", "/earth/live.kml"): _SEES,
    ("GET", "/earth/aircraft.dae"): _SEES,
    ("GET", "/plan.kml"): _SEES,
    ("GET", "/plan.kmz"): _SEES,
    ("GET", "/track"): _SEES,
    ("GET", "/track/points"): _SEES,
    ("GET", "/track.czml"): _SEES,
    ("GET", "/track.gpx"): _SEES,
    ("GET", "/track.kml"): _SEES,
    ("GET", "/track.kmz"): _SEES,
    ("POST", "/track/reset"): _command("track"),
    ("POST", "/track/restore"): _command("track"),
    ("GET", "/map/layers"): _SEES,
    ("GET", "/map/layers/{layer_id}/terrain/layer.json"): _SEES,
    ("GET", "/map/layers/{layer_id}/terrain/{zoom}/{column}/{row}.terrain"): _SEES,
    ("GET", "/map/layers/{layer_id}/tiles/{zoom}/{column}/{row}"): _SEES,
    ("DELETE", "/map/layers/{layer_id}"): _command("map"),
    ("POST", "/map/layers/{layer_id}/restore"): _command("map"),
    ("PUT", "/map/layers/{layer_id}/datum"): _command("map"),
    ("POST", "/map/imports"): _command("upload"),
    ("GET", "/map/imports/{import_id}"): _SEES,
    ("DELETE", "/map/imports/{import_id}"): _command("map"),
    ("GET", "/map/online"): _SEES,
    ("PUT", "/map/online"): _command("map"),
    ("DELETE", "/map/online/cache"): _command("map"),
    ("GET", "/map/layers/{layer_id}/file"): _SEES,
    ("POST", "/map/layers/{layer_id}/proof"): Entry(_operator),
    ("GET", "/map/fields"): _SEES,
    ("POST", "/map/fields"): _command("map"),
    ("POST", "/map/fields/estimate"): Entry(_operator),
    ("POST", "/map/fields/{field_id}/pause"): _command("map"),
    ("POST", "/map/fields/{field_id}/resume"): _command("map"),
    ("DELETE", "/map/fields/{field_id}"): _command("map"),
    ("GET", "/recordings"): _SEES,
    ("GET", "/recordings/{recording_id}"): _SEES,
    ("GET", "/recordings/{recording_id}/export"): _SEES,
    ("GET", "/flights"): _SEES,
    ("POST", "/flights"): _command("upload"),
    ("GET", "/flights/bin"): _SEES,
    ("PUT", "/flights/aircraft"): _command("flights"),
    ("PUT", "/flights/policy"): Entry(_owner, control=True, deed="flights"),
    ("GET", "/flights/{flight_id}"): _SEES,
    ("PATCH", "/flights/{flight_id}"): Entry(_operator, deed="flights"),
    ("DELETE", "/flights/{flight_id}"): Entry(_owner, control=True, deed="flight_deleted"),
    ("POST", "/flights/{flight_id}/restore"): Entry(_owner, control=True, deed="flights"),
    ("POST", "/flights/{flight_id}/index"): Entry(_operator),
    ("GET", "/flights/{flight_id}/events"): _SEES,
    ("GET", "/flights/{flight_id}/export"): _SEES,
    ("POST", "/flights/{flight_id}/exports"): _SEES,
    ("GET", "/flights/{flight_id}/known"): _SEES,
    ("POST", "/flights/{flight_id}/marks"): Entry(_viewer, deed="mark"),
    ("PATCH", "/flights/{flight_id}/marks/{mark_id}"): Entry(_operator, deed="mark"),
    ("DELETE", "/flights/{flight_id}/marks/{mark_id}"): Entry(_operator, deed="mark"),
    ("GET", "/flights/{flight_id}/overview"): _SEES,
    ("GET", "/flights/{flight_id}/plan"): _SEES,
    ("GET", "/flights/{flight_id}/report"): _SEES,
    ("GET", "/flights/{flight_id}/signals"): _SEES,
    ("GET", "/flights/{flight_id}/topics"): _SEES,
    ("GET", "/flights/{flight_id}/track"): _SEES,
    ("POST", "/backups"): Entry(_owner, deed="backup", secret=True),
    ("GET", "/jobs"): _SEES,
    ("GET", "/jobs/{job_id}"): _SEES,
    # A backup's is an owner's (`job_routes`).
    ("GET", "/jobs/{job_id}/result"): _SEES,
    # Its own; another's is an operator's (`job_routes`).
    ("DELETE", "/jobs/{job_id}"): _SEES,
    ("GET", "/access/me"): _ANYONE,
    ("POST", "/access/enter"): _ANYONE,
    ("POST", "/access/ask"): _ANYONE,
    ("POST", "/access/leave"): _ANYONE,
    ("GET", "/access/people"): _OWNS,
    ("PATCH", "/access/people/{person_id}"): _OWNS,
    ("DELETE", "/access/people/{person_id}"): _OWNS,
    ("GET", "/access/sessions"): _OWNS,
    ("DELETE", "/access/sessions/{session_id}"): _OWNS,
    ("GET", "/access/programs"): _OWNS,
    ("POST", "/access/programs"): _OWNS,
    ("DELETE", "/access/programs/{program_id}"): _OWNS,
    ("GET", "/access/invitations"): _OWNS,
    ("POST", "/access/invitations"): _OWNS,
    ("DELETE", "/access/invitations/{invitation_id}"): _OWNS,
    ("GET", "/access/addresses"): _SEES,
    ("GET", "/access/code"): _SEES,
    ("GET", "/access/log"): _OWNS,
    ("GET", "/access/certificates"): _OWNS,
    # What a phone needs before it can come in; it is shown in each handshake anyway.
    ("GET", "/access/authority"): _ANYONE,
    ("GET", "/first-start"): Entry(_owner),
    ("DELETE", "/first-start"): Entry(_owner),
    # It tells of this computer: folders, programs and ports.
    ("GET", "/doctor"): Entry(_owner),
    ("GET", "/openapi.json"): _SEES,
}

ROUTES: Final[Mapping[tuple[str, str], Entry]] = {
    **{(method, API + path): entry for (method, path), entry in _V1.items()},
    ("GET", "/api/docs"): _SEES,
    ("GET", "/api/docs/start.js"): _SEES,
    ("GET", "/api/docs/{name}"): _SEES,
    ("GET", "/metrics"): _SEES,
    # To a stranger it says nothing of the vehicle.
    ("GET", "/health"): _ANYONE,
    # The page's own files: what everybody can read in its sources.
    ("GET", _PAGE): _ANYONE,
}
"""By method and path template, as the application has them."""

STREAMS: Final[Mapping[str, Entry]] = {"/stream": _SEES, "/stream?flight": _SEES}
"""Opening a stream, live or of a flight of the past."""

MESSAGES: Final[Mapping[str, Entry]] = {
    "ack": _SEES,
    "rate": _SEES,
    "stick": Entry(_operator, control=True),
    "play": _SEES,
    "pause": _SEES,
    "seek": _SEES,
    "step": _SEES,
    "loop": _SEES,
    "ask": _SEES,
}
"""By type of a message that a browser sends on its stream. Playing a flight moves only the sender's own replay."""


class AccessTableError(Exception):
    """Application and table do not agree: routes without an entry, or entries without a route."""


class Gate:
    """Finds the entry of a request, with the application's own patterns in the application's order."""

    def __init__(self, app: FastAPI, table: Mapping[tuple[str, str], Entry] = ROUTES) -> None:
        """Raises AccessTableError if a route has no entry, or an entry no route."""
        self._exact: dict[tuple[str, str], Entry] = {}
        self._patterns: dict[str, list[tuple[str, re.Pattern[str], Entry]]] = {}
        seen = set()
        missing = []
        for method, path, pattern in _routes(app):
            entry = table.get((method, path))
            seen.add((method, path))
            if entry is None:
                missing.append(f"{method} {path}")
            elif "{" not in path:
                # A pattern before it would take the request.
                self._exact.setdefault((method, path), self._match(method, path) or entry)
            elif path != _PAGE:
                self._patterns.setdefault(_room(path), []).append((method, pattern, entry))
        unused = [f"{method} {path}" for method, path in table if (method, path) not in seen]
        if missing or unused:
            raise AccessTableError(
                f"The table of access (access_table.py) lacks {missing or 'nothing'} and has {unused or 'nothing'} "
                "too much: every route needs its least role."
            )
        self._page = table.get((_READING_METHOD, _PAGE))

    def entry(self, method: str, path: str) -> Entry | None:
        """The entry of the route that will take this request; None if none will."""
        if method == "HEAD":
            method = _READING_METHOD
        exact = self._exact.get((method, path))
        if exact is not None:
            return exact
        entry = self._match(method, path)
        if entry is not None:
            return entry
        is_interface = path == _INTERFACE or path.startswith(_INTERFACE + "/")
        return None if is_interface or method != _READING_METHOD else self._page

    def _match(self, method: str, path: str) -> Entry | None:
        for taken, pattern, entry in self._patterns.get(_room(path), ()):
            if taken == method and pattern.match(path):
                return entry
        return None


def _routes(app: FastAPI) -> Iterator[tuple[str, str, re.Pattern[str]]]:
    """Method, template and pattern of each route, in the order in which they are tried."""
    for context in iter_route_contexts(app.routes):
        route: Any = context
        for method in sorted(route.methods or ()):
            if method != "HEAD":
                yield method, str(route.path), route.path_regex


def _room(path: str) -> str:
    """The literal part of a path below the interface's version: paths of other rooms need no comparing."""
    parts = path.split("/", 4)
    return "/".join(parts[:4]) if path.startswith(API) else "/".join(parts[:3])
