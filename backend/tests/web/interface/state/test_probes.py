"""Health of each part, and the figures as Prometheus reads them."""

from __future__ import annotations

import copy
import re
from pathlib import Path
from typing import Any

import httpx
import pytest
from fastapi import FastAPI

from epf_gcs.access.caller import LOCAL
from epf_gcs.contract.status import Status
from epf_gcs.web.interface.state.probes import disk_of, probe_router
from epf_gcs.web.state.figures import Disk, WebFigures
from epf_gcs.web.state.health import LEAST_FREE_BYTES, health
from epf_gcs.web.state.metrics import MEDIA_TYPE, metrics
from tests.support.contract import read_as
from tests.support.fake_board import FakeBoard
from tests.support.gateway import FlightThread, Gateway
from tests.support.waiting import DEADLINE_S, eventually

ROOM = Disk(free_bytes=50_000_000_000, total_bytes=100_000_000_000)
NAME = r"[a-zA-Z_:][a-zA-Z0-9_:]*"
SAMPLE = re.compile(rf'({NAME})(?:\{{({NAME})="((?:[^"\\\n]|\\["\\n])*)"\}})? (-?[0-9.e+-]+|NaN|[+-]Inf)')
FAILURE = {"code": "link_lost", "detail": "It is gone.", "params": {}}


@pytest.fixture
def status(gateway: Gateway, board: FakeBoard) -> dict[str, Any]:
    """Of a flight that goes well."""
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["active"], "it is recorded")
    found = gateway.status()
    read_as(Status, found)
    return found


def read(text: str) -> dict[tuple[str, str], float]:
    """A strict reader of the format: each family has HELP and TYPE before its samples, and comes once."""
    found: dict[tuple[str, str], float] = {}
    families: dict[str, str] = {}
    lines = text.split("\n")
    assert lines.pop() == "", "the last line ends"
    current = ""
    for line in lines:
        if line.startswith("# HELP "):
            current = line.split(" ")[2]
            assert current not in families
            families[current] = ""
        elif line.startswith("# TYPE "):
            _, _, name, kind = line.split(" ")
            assert name == current
            families[name] = kind
        else:
            match = SAMPLE.fullmatch(line)
            assert match is not None, line
            assert match[1] == current
            assert families[current] in ("counter", "gauge")
            assert (families[current] == "counter") == current.endswith("_total")
            key = (match[1], match[3] or "")
            assert key not in found
            found[key] = float(match[4])
    return found


def test_all_is_well(status: dict[str, Any]) -> None:
    code, body = health(read_as(Status, status), ROOM)
    assert (code, body.status, body.failed) == (200, "ok", [])
    states = {name: part.state for name, part in body.parts.items()}
    assert states == {
        "web": "ok",
        "flight": "ok",
        "board": "ok",
        "simulator": "off",
        "recording": "ok",
        "disk": "ok",
    }


def test_each_part_that_failed_is_named(status: dict[str, Any]) -> None:
    def after(**changes: Any) -> tuple[int, list[str]]:
        changed = copy.deepcopy(status)
        for part, values in changes.items():
            changed[part] |= values
        code, body = health(read_as(Status, changed), ROOM)
        return code, body.failed

    assert after(board={"state": "lost"}) == (503, ["board"])
    assert after(board={"state": "opening", "failure": FAILURE}) == (503, ["board"])
    assert after(board={"heartbeat_age_s": 9.0}) == (503, ["board"])
    assert after(board={"heartbeat_age_s": 9.0, "emulated": True}) == (200, [])
    assert after(board={"state": "closed"}, recording={"active": False}) == (200, [])
    assert after(simulator={"state": "opening"}) == (200, [])
    assert after(simulator={"state": "lost"}, recording={"failure": "The disk is full."}) == (
        503,
        ["recording", "simulator"],
    )


def test_without_the_flight_process_or_a_disk_it_is_not_well(status: dict[str, Any], tmp_path: Path) -> None:
    code, body = health(None, ROOM)
    assert (code, body.failed) == (503, ["flight"])
    assert health(read_as(Status, status), Disk(LEAST_FREE_BYTES - 1, ROOM.total_bytes))[1].failed == ["disk"]
    assert disk_of(tmp_path / "gone") is None
    assert health(read_as(Status, status), disk_of(tmp_path / "gone"))[1].failed == ["disk"]
    assert disk_of(tmp_path) is not None


def test_the_figures_are_those_of_the_status(status: dict[str, Any]) -> None:
    status["simulator"]["hil_round_trip_ms"] = {"newest": 9.0, "p50": 9.5, "p99": 12.0}
    status["errors"] = {"internal": 2, 'odd"\\\n': 1}
    status["recording"]["hours_left"] = 41.5
    web = WebFigures(answers={200: 7, 404: 1}, connections=3, sockets=2, refused={"socket": 4})
    found = read(metrics(read_as(Status, status), ROOM, web))
    assert found["epf_flight_up", ""] == 1
    assert found["epf_board_frames_total", ""] == status["board"]["frames_received"] > 0
    assert found["epf_board_link", "open"] == 1
    assert found["epf_board_link", "lost"] == 0
    assert found["epf_board_frames_damaged_total", ""] == 0
    assert found["epf_topic_age_seconds", "heartbeat"] == status["topics"]["heartbeat"]["age_s"]
    assert found["epf_hil_round_trip_seconds", "0.99"] == pytest.approx(0.012)
    assert found["epf_viewers", ""] == 0
    assert found["epf_errors_total", "internal"] == 2
    assert found["epf_errors_total", 'odd\\"\\\\\\n'] == 1
    assert found["epf_http_requests_total", "404"] == 1
    assert found["epf_http_refused_total", "socket"] == 4
    assert found["epf_disk_free_bytes", ""] == ROOM.free_bytes
    assert found["epf_recording_active", ""] == 1
    assert found["epf_recording_hours_left", ""] == 41.5


def test_what_is_not_known_is_left_out(gateway: Gateway) -> None:
    found = read(metrics(read_as(Status, gateway.status()), None, WebFigures()))
    assert not [key for key in found if key[0] in ("epf_board_heartbeat_age_seconds", "epf_hil_round_trip_seconds")]
    alone = read(metrics(None, ROOM, WebFigures()))
    assert alone["epf_flight_up", ""] == 0
    assert not [key for key in alone if key[0].startswith("epf_board")]


@pytest.mark.anyio
async def test_both_are_at_their_addresses() -> None:
    app = FastAPI()
    app.include_router(probe_router(lambda: None, WebFigures, lambda: ROOM, lambda _: LOCAL))
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://station") as client:
        answer = await client.get("/health")
        assert (answer.status_code, answer.json()["parts"]["flight"]["state"]) == (503, "failed")
        answer = await client.get("/metrics")
        assert answer.headers["content-type"] == MEDIA_TYPE
        assert read(answer.text)["epf_flight_up", ""] == 0


def test_the_gateway_answers_at_both_places(gateway: Gateway) -> None:
    health = httpx.get(f"{gateway.base}/health", timeout=DEADLINE_S)
    assert health.status_code == 200
    assert health.json()["status"] == "ok"
    text = httpx.get(f"{gateway.base}/metrics", timeout=DEADLINE_S).text
    assert read(text)["epf_http_connections", ""] >= 1, "the one that asks"
    gateway.flight_thread.stop()
    eventually(
        lambda: httpx.get(f"{gateway.base}/health", timeout=DEADLINE_S).status_code == 503,
        "the flight process is missed",
    )
    gateway.flight_thread = FlightThread(gateway.flight_thread.data_dir)
    gateway.flight_thread.start()
    eventually(lambda: httpx.get(f"{gateway.base}/health", timeout=DEADLINE_S).status_code == 200, "it is back")
