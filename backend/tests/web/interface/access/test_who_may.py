"""The whole table of access tried on a running station: every route and stream, by everybody who could ask."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Iterator

import httpx
import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from epf_gcs.access.keys import new_cookie, new_program_key
from epf_gcs.access.roles import OPEN, Role
from epf_gcs.web.serving.access_table import ROUTES, Entry
from tests.support.callers import person, program, stranger, strict_gateway
from tests.support.gateway import Gateway
from tests.support.quick_doctor import QuickDoctor
from tests.support.waiting import DEADLINE_S

REFUSED = {"not_admitted", "role_too_low", "access_too_many_tries"}
# What the parts of a path could be; a wrong value is answered with 404 or 422 only after the caller was let in.
PARTS = {
    "flight_id": "20260131T120000Z",
    "recording_id": "20260131T120000Z",
    "plan": "flight",
    "name": "start",
    "zoom": "1",
    "column": "1",
    "row": "1",
}
Client = httpx.Client


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    with strict_gateway(tmp_path_factory.mktemp("who") / "data") as gateway:
        gateway.web.doctor = QuickDoctor()
        yield gateway


@pytest.fixture(scope="module")
def owner(station: Gateway) -> Iterator[Client]:
    with person(station, Role.owner, "Owner") as client:
        yield client


def ended_cookie(station: Gateway, owner: Client) -> Client:
    client = person(station, Role.owner, "Ended")
    people = owner.get("/access/people").json()["people"]
    ended = next(one["id"] for one in people if one["name"] == "Ended" and one["state"] == "in")
    owner.patch(f"/access/people/{ended}", json={"state": "ended"}).raise_for_status()
    return client


def ended_key(station: Gateway, owner: Client) -> Client:
    client, _, program_id = program(station, Role.owner, owner)
    assert client.get("/status").status_code == 200
    owner.delete(f"/access/programs/{program_id}").raise_for_status()
    return client


def waiting(station: Gateway, _: Client) -> Client:
    client = stranger(station)
    assert client.post("/access/ask", json={"name": "Waiting"}).json()["state"] == "waiting"
    return client


STRANGERS: dict[str, Callable[[Gateway, Client], Client]] = {
    "no key": lambda station, _: stranger(station),
    "a wrong key": lambda station, _: stranger(station, Authorization=f"Bearer {new_program_key()[0]}"),
    "a wrong password": lambda station, _: stranger(
        station, Authorization="Basic " + base64.b64encode(b"owner:owner").decode()
    ),
    "a wrong cookie": lambda station, _: stranger(station, Cookie=f"epf_{station.server.port}={new_cookie()}"),
    "an ended cookie": ended_cookie,
    "an ended key": ended_key,
    "still waiting": waiting,
}
ADMITTED: dict[str, tuple[Role, Callable[[Gateway, Client], Client]]] = {
    "viewer": (Role.viewer, lambda station, _: person(station, Role.viewer)),
    "operator": (Role.operator, lambda station, _: person(station, Role.operator)),
    "owner": (Role.owner, lambda station, _: person(station, Role.owner)),
    "viewing program": (Role.viewer, lambda station, owner: program(station, Role.viewer, owner)[0]),
    "operating program": (Role.operator, lambda station, owner: program(station, Role.operator, owner)[0]),
}


def ask(client: Client, station: Gateway, method: str, path: str) -> tuple[int, str]:
    """Status and code of the answer to a harmless request of this route."""
    filled = re.sub(r"\{(\w+)(?::path)?\}", lambda part: PARTS.get(part[1], "0123456789abcdef"), path)
    body = None if method in ("GET", "DELETE") else b"{"  # nothing is done: it cannot be read
    answer = client.request(method, station.base + filled, content=body, headers={"Content-Type": "application/json"})
    is_problem = answer.headers.get("content-type") == "application/problem+json"
    return answer.status_code, answer.json()["code"] if is_problem else ""


def rows() -> list[tuple[str, str, Entry]]:
    # Leaving would end the caller in the middle.
    return [(method, path, entry) for (method, path), entry in ROUTES.items() if not path.endswith("/leave")]


@pytest.mark.parametrize("kind", STRANGERS)
def test_a_stranger_gets_nothing_but_what_is_open(station: Gateway, owner: Client, kind: str) -> None:
    wrong = []
    with STRANGERS[kind](station, owner) as client:
        for method, path, entry in rows():
            status, code = ask(client, station, method, path)
            is_refused = (status, code) in ((401, "not_admitted"), (429, "access_too_many_tries"))
            if is_refused != (entry.least != OPEN) and code != "access_too_many_tries":
                wrong.append((method, path, status, code))
    assert wrong == []


@pytest.mark.parametrize("kind", ADMITTED)
def test_each_role_may_what_the_table_says_and_nothing_else(station: Gateway, owner: Client, kind: str) -> None:
    role, make = ADMITTED[kind]
    wrong = []
    with make(station, owner) as client:
        for method, path, entry in rows():
            status, code = ask(client, station, method, path)
            expected = (403, "role_too_low") if role < entry.least else None
            if (expected is None and code in REFUSED) or (expected is not None and (status, code) != expected):
                wrong.append((method, path, status, code))
    assert wrong == []


@pytest.mark.parametrize("kind", STRANGERS)
@pytest.mark.parametrize("query", ["", "?flight=current", "?flight=20260131T120000Z"])
def test_no_stream_opens_for_a_stranger(station: Gateway, owner: Client, kind: str, query: str) -> None:
    with STRANGERS[kind](station, owner) as client, pytest.raises(InvalidStatus) as refused:
        open_stream(station, client, query)
    assert refused.value.response.status_code in (401, 429)
    assert b"urn:epf-gcs:problem:" in refused.value.response.body


@pytest.mark.parametrize("kind", ADMITTED)
def test_the_stream_opens_for_each_role(station: Gateway, owner: Client, kind: str) -> None:
    with ADMITTED[kind][1](station, owner) as client:
        assert '"hello"' in open_stream(station, client, "")


def open_stream(station: Gateway, client: Client, query: str) -> str:
    """The first message of the stream."""
    headers = {name: client.headers[name] for name in ("Authorization", "Cookie") if name in client.headers}
    if client.cookies:
        headers["Cookie"] = "; ".join(f"{name}={value}" for name, value in client.cookies.items())
    address = f"ws://127.0.0.1:{station.server.port}/api/v1/stream{query}"
    with connect(address, additional_headers=headers) as connection:
        return str(connection.recv(timeout=DEADLINE_S))


def test_a_stranger_hears_of_the_health_only_whether_the_processes_answer(station: Gateway, owner: Client) -> None:
    with stranger(station) as client:
        assert set(client.get(f"{station.base}/health").json()) == {"status", "processes"}
    assert "parts" in owner.get(f"{station.base}/health").json()


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("/api/v1/no-such", 401),
        ("/api/", 401),
        ("/api/v1/status/", 401),
        ("/api/v1//status", 401),
        ("/api/v1/STATUS", 401),
        ("/api/v1/%73tatus", 401),
        ("//api/v1/status", 404),
    ],
)
def test_an_address_that_is_none_is_refused_or_says_nothing(station: Gateway, path: str, status: int) -> None:
    with stranger(station) as client:
        answer = client.get(station.base + path)
    assert answer.status_code == status
    assert b"heartbeat" not in answer.content
