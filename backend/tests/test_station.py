"""The gateway with the firmware itself on the other end of the line."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.messages_gen import ROUTES
from tests.support.gateway import Gateway
from tests.support.programs import board_process
from tests.support.waiting import eventually


@pytest.fixture(params=["extended", "legacy"])
def connected(gateway: Gateway, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Gateway]:
    """A gateway with the real firmware, as it is and as a deployed board."""
    options = ["--legacy"] if request.param == "legacy" else ["--card", str(tmp_path / "card")]
    with board_process(tmp_path / "board", *options):
        gateway.open_board(f"pty://{tmp_path}/board")
        # A board that answers late on a busy machine is a deployed one until it has answered.
        eventually(lambda: bool(gateway.status()["board"]["mode"] == request.param), "what it can do is known")
        yield gateway


def outcome(gateway: Gateway, name: str, value: Any = None) -> tuple[str, str]:
    answer = gateway.http.post(f"/commands/{name}", json={"value": value}).raise_for_status().json()
    return answer["state"], answer["by"]


def is_legacy(gateway: Gateway) -> bool:
    return bool(gateway.status()["board"]["mode"] == "legacy")


def test_every_stream_is_switched_on_and_seen(connected: Gateway) -> None:
    plans = ("fms_plan", "fms_hil_plan")
    streams = ("ahrs", "inertial", "analog", "statistics", "gps", "servos_in", "fly_by_wire", *plans)
    for stream in streams:
        state, by = outcome(connected, f"{stream}_on")
        expected = "read_back" if stream in plans else "heartbeat"
        assert (state, by) == ("confirmed", expected if is_legacy(connected) else "acknowledgement")
    eventually(lambda: set(streams) <= set(connected.http.get("/telemetry").json()), "all are heard")
    status = connected.status()
    assert status["board"]["frames_damaged"] == 0
    assert status["errors"] == {}


def test_a_route_is_loaded_and_stepped_through(connected: Gateway) -> None:
    outcome(connected, "fms_hil_plan_on")

    def waypoint() -> int | None:
        sample = connected.http.get("/telemetry").json().get("fms_hil_plan")
        return None if sample is None else sample["values"]["waypoint"]

    assert outcome(connected, "hil_load_gando")[0] == "confirmed"
    eventually(lambda: waypoint() == 0, "the first waypoint")
    assert outcome(connected, "hil_fms_next_waypoint")[0] == "confirmed"
    eventually(lambda: waypoint() == 1, "the next waypoint")


def test_a_gain_is_set_and_read_back(connected: Gateway) -> None:
    answer = connected.http.patch("/parameters", json={"k_pitch": 2.5, "k_div_velocidad": 710}).raise_for_status()
    states = {one["name"]: (one["value"], one["state"]) for one in answer.json()["parameters"]}
    assert states["k_pitch"] == (2.5, "confirmed")
    assert states["k_div_velocidad"] == (710, "confirmed")
    assert states["k_int_pitch"] == (0.6, "loaded")


def test_the_source_is_switched_and_the_autopilot_follows_it(connected: Gateway) -> None:
    connected.http.put("/hil", json={"source": "joystick"}).raise_for_status()
    assert outcome(connected, "autopilot_on")[0] == "confirmed"
    eventually(
        lambda: connected.http.get("/telemetry").json()["heartbeat"]["values"]["autopilot_hil"] is True, "it is on"
    )
    assert outcome(connected, "autopilot_off")[0] == "confirmed"


def test_a_slower_task_is_believed(connected: Gateway) -> None:
    assert outcome(connected, "set_parameter_task_rate", 500)[0] in ("confirmed", "sent")
    eventually(lambda: connected.status()["topics"]["heartbeat"]["stale_after_s"] > 1.0, "it is expected more rarely")
    assert outcome(connected, "ahrs_on")[0] == "confirmed"


def test_a_plan_goes_to_the_board_and_comes_back(connected: Gateway) -> None:
    waypoints = [
        {
            "latitude_deg": one.latitude_deg,
            "longitude_deg": one.longitude_deg,
            "altitude_ft": one.altitude_ft,
            "speed_kt": one.speed_kt,
        }
        for one in ROUTES["vuelo"].waypoints
    ]
    answer = connected.http.put("/missions/flight", json={"waypoints": waypoints})
    if is_legacy(connected):
        assert answer.json()["code"] == "not_supported"
        return
    assert answer.raise_for_status().json()["waypoints"] == waypoints
    assert connected.http.get("/missions/flight").json()["waypoints"] == waypoints


def test_gains_are_stored_where_there_is_a_card(connected: Gateway) -> None:
    answer = connected.http.post("/parameters/store")
    if is_legacy(connected):
        assert answer.json()["code"] == "not_supported"
    else:
        assert answer.json()["state"] == "confirmed"


def test_the_firmware_that_starts_anew_is_armed_again(gateway: Gateway, tmp_path: Path) -> None:
    path = tmp_path / "board"
    with board_process(path):
        gateway.open_board(f"pty://{path}")
        outcome(gateway, "ahrs_on")
    eventually(lambda: gateway.status()["board"]["state"] == "lost", "it is gone")
    with board_process(path):
        eventually(lambda: gateway.status()["board"]["state"] == "open", "it is back")
        eventually(
            lambda: gateway.status()["topics"].get("ahrs", {"rate_hz": 0})["rate_hz"] > 5, "its stream is on again"
        )
        assert gateway.status()["board"]["reopened"] == 1


def test_the_ahrs_test_shows_what_the_stream_showed_and_gives_it_back(connected: Gateway) -> None:
    outcome(connected, "ahrs_on")
    eventually(lambda: "ahrs" in connected.http.get("/telemetry").json(), "the attitude is heard")
    before = connected.http.get("/telemetry").json()["ahrs"]["values"]
    assert connected.http.post("/ahrs-test").raise_for_status().json()["state"] == "confirmed"
    during = connected.http.get("/telemetry").json()["ahrs_test"]["values"]
    assert during.keys() == before.keys()
    assert all(abs(during[angle] - before[angle]) < 5 for angle in before)
    count = connected.status()["topics"]["ahrs"]["count"]
    assert connected.http.delete("/ahrs-test").raise_for_status().json()["state"] == "confirmed"
    eventually(lambda: connected.status()["topics"]["ahrs"]["count"] > count, "the stream is back")
    assert connected.status()["board"]["frames_damaged"] == 0
