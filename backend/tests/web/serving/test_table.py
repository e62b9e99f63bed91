"""The table of access and the application agree, or the station does not start."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi import APIRouter, FastAPI
from fastapi.routing import iter_route_contexts

from epf_gcs.access.roles import OPEN, Role
from epf_gcs.web import app as app_module
from epf_gcs.web import docs
from epf_gcs.web.app import create_app
from epf_gcs.web.interface.deps import get_operator
from epf_gcs.web.serving.access_table import MESSAGES, ROUTES, AccessTableError, Entry, Gate
from epf_gcs.web.serving.settings import Settings


@pytest.fixture(scope="module")
def app() -> FastAPI:
    return create_app(Settings(data_dir=Path("unused")))


def test_a_route_without_an_entry_stops_the_start(monkeypatch: pytest.MonkeyPatch) -> None:
    async def planted() -> None:
        """Nobody said who may ask this."""

    together = APIRouter()
    together.include_router(docs.router)
    together.add_api_route("/api/v1/planted", planted, methods=["DELETE"])
    # A router of its own: the real one is shared by every application of this process.
    monkeypatch.setattr(app_module, "_INTERFACE", together)
    with pytest.raises(AccessTableError, match="DELETE /api/v1/planted"):
        create_app(Settings(data_dir=Path("unused")))


def test_an_entry_without_a_route_stops_it_too(app: FastAPI) -> None:
    with pytest.raises(AccessTableError, match="GET /api/v1/gone"):
        Gate(app, {**ROUTES, ("GET", "/api/v1/gone"): Entry(Role.viewer)})


def test_the_table_says_of_exactly_those_routes_that_they_need_control(app: FastAPI) -> None:
    needing = set()
    for context in iter_route_contexts(app.routes):
        route: Any = context
        dependant = getattr(route, "dependant", None)
        if dependant is not None and get_operator in _calls(dependant):
            needing |= {(method, route.path) for method in route.methods}
    assert needing
    assert needing == {key for key, entry in ROUTES.items() if entry.control}


def test_nothing_that_a_request_calls_leaves_the_event_loop_to_which_the_parts_belong(app: FastAPI) -> None:
    called = {
        call
        for context in iter_route_contexts(app.routes)
        if (dependant := getattr(context, "dependant", None)) is not None
        for call in _calls(dependant)
    }
    assert get_operator in called
    # Plain functions are called in threads by FastAPI.
    assert [call.__qualname__ for call in called if not inspect.iscoroutinefunction(call)] == []


def _calls(dependant: Any) -> Iterator[Any]:
    yield dependant.call
    for part in dependant.dependencies:
        yield from _calls(part)


FOR_ANYONE = {
    ("GET", "/{path:path}"),
    ("GET", "/health"),
    ("GET", "/api/v1/access/me"),
    ("GET", "/api/v1/access/authority"),
    ("POST", "/api/v1/access/enter"),
    ("POST", "/api/v1/access/ask"),
    ("POST", "/api/v1/access/leave"),
}
# An answer that is made for whoever asks, or is not wanted any more by who asked for it; and a note in the flight that
# is being recorded.
A_VIEWER_MAY_SEND = {
    ("DELETE", "/api/v1/jobs/{job_id}"),
    ("POST", "/api/v1/missions/export"),
    ("POST", "/api/v1/flights/{flight_id}/exports"),
    ("POST", "/api/v1/flights/{flight_id}/marks"),
}
FOR_OWNERS = {
    ("POST", "/api/v1/faults"),
    ("DELETE", "/api/v1/faults"),
    ("DELETE", "/api/v1/faults/{fault_id}"),
    ("PUT", "/api/v1/faults/wind"),
    ("POST", "/api/v1/backups"),
    ("PUT", "/api/v1/flights/policy"),
    ("DELETE", "/api/v1/flights/{flight_id}"),
    ("POST", "/api/v1/flights/{flight_id}/restore"),
    ("GET", "/api/v1/first-start"),
    ("DELETE", "/api/v1/first-start"),
    ("GET", "/api/v1/doctor"),
}


def test_the_table_says_what_it_was_decided_to_say() -> None:
    """Written down a second time: the other tests believe the table."""
    least = {key: entry.least for key, entry in ROUTES.items()}
    assert {key for key in least if least[key] == OPEN} == FOR_ANYONE
    changing = {key for key in least if key[0] not in ("GET", "HEAD")} - FOR_ANYONE
    assert {key for key in changing if least[key] == Role.viewer} == A_VIEWER_MAY_SEND
    administering = {key for key in least if "/access/" in key[1]} - FOR_ANYONE
    shown_to_all = {("GET", "/api/v1/access/addresses"), ("GET", "/api/v1/access/code")}
    assert administering > shown_to_all
    assert {key for key in least if least[key] == Role.owner} == FOR_OWNERS | administering - shown_to_all
    assert all(least[key] >= Role.operator for key, entry in ROUTES.items() if entry.control)


@pytest.mark.parametrize(
    ("method", "path", "least"),
    [
        ("GET", "/", OPEN),
        ("HEAD", "/", OPEN),
        ("GET", "/assets/index-1234.js", OPEN),
        ("GET", "/health", OPEN),
        ("GET", "/metrics", Role.viewer),
        ("GET", "/api/docs", Role.viewer),
        ("GET", "/api/docs/swagger-ui.css", Role.viewer),
        ("GET", "/api/v1/openapi.json", Role.viewer),
        ("HEAD", "/api/v1/status", Role.viewer),
        ("GET", "/api/v1/flights/bin", Role.viewer),
        ("DELETE", "/api/v1/flights/20260131T120000Z", Role.owner),
        ("GET", "/api/v1/map/layers/a/terrain/1/2/3.terrain", Role.viewer),
        ("POST", "/api/v1/access/enter", OPEN),
    ],
)
def test_a_request_finds_its_row(app: FastAPI, method: str, path: str, least: int) -> None:
    entry = Gate(app).entry(method, path)
    assert entry is not None
    assert entry.least == least


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("GET", "/api"),
        ("GET", "/api/v1/no-such"),
        ("GET", "/api/v1/status/"),
        ("GET", "/api/v1//status"),
        ("GET", "/api/v2/status"),
        ("POST", "/api/v1/status"),
        ("OPTIONS", "/api/v1/status"),
        ("TRACE", "/"),
        ("POST", "/"),
        ("PUT", "/index.html"),
        ("GET", "/api/v1/commands/start/more"),
    ],
)
def test_what_is_not_in_the_table_has_no_row(app: FastAPI, method: str, path: str) -> None:
    assert Gate(app).entry(method, path) is None


def test_every_message_of_a_stream_says_who_may_send_it() -> None:
    assert {name for name, entry in MESSAGES.items() if entry.least > Role.viewer} == {"stick"}
    assert MESSAGES["stick"].control


def test_the_document_of_the_interface_says_who_may(app: FastAPI) -> None:
    document = app.openapi()
    schemes = document["components"]["securitySchemes"]
    for (method, path), entry in ROUTES.items():
        operation = document["paths"].get(path, {}).get(method.lower())
        if operation is None:
            continue
        assert operation["x-needs-control"] is entry.control
        assert operation["x-least-role"] == ("anyone" if entry.least == OPEN else Role(entry.least).name)
        assert bool(operation["security"]) is (entry.least != OPEN)
        assert {name for one in operation["security"] for name in one} <= set(schemes)
    assert document["x-stream"]["messages"]["stick"] == {"x-least-role": "operator", "x-needs-control": True}
