"""Status, telemetry and control over REST."""

from __future__ import annotations

from epf_gcs.contract.answers import Sample
from epf_gcs.contract.status import Status
from tests.support.contract import read_as
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually


def test_the_status_has_the_documented_shape_with_and_without_a_board(gateway: Gateway, board: FakeBoard) -> None:
    read_as(Status, gateway.status())
    gateway.open_board(board.url)
    gateway.http.put("/links/simulator", json={"receive_port": 1, "send_host": "127.0.0.1"})
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    eventually(lambda: "ahrs" in gateway.status()["topics"], "telemetry arrives")
    eventually(lambda: gateway.status()["recording"]["active"], "it records")
    status = read_as(Status, gateway.status())
    assert status.board.mode == "extended"
    assert status.board.firmware is not None
    assert status.board.firmware.name == "fake"
    assert status.board.frames_received > 0
    assert status.recording.bytes > 0


def test_the_newest_value_of_every_topic_has_its_age(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    eventually(lambda: "ahrs" in gateway.http.get("/telemetry").json(), "telemetry arrives")
    ahrs = read_as(Sample, gateway.http.get("/telemetry").json()["ahrs"])
    assert ahrs.values == {"yaw_deg": 10.0, "pitch_deg": 5.0, "roll_deg": -3.0}
    assert ahrs.age_s < 20


def test_what_is_not_sent_any_more_is_stale_and_comes_alive_again(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()

    def stale() -> bool:
        return bool(gateway.http.get("/telemetry").json().get("ahrs", {}).get("stale", True))

    eventually(lambda: not stale(), "it is live")
    gateway.http.post("/commands/ahrs_off").raise_for_status()
    eventually(stale, "it is stale")
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    eventually(lambda: not stale(), "it is live again")


def test_the_use_of_the_line_is_a_share_of_its_baud_rate(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["board"]["rx_percent"] > 5, "the line is used")
    assert gateway.status()["board"]["rx_percent"] < 100


def test_control_is_given_back_and_taken(gateway: Gateway) -> None:
    with gateway.stream() as first, gateway.stream() as second:
        assert (first.hello["has_control"], second.hello["has_control"]) == (True, False)
        holder = gateway.http.get("/control").json()
        assert holder["client"] == first.hello["client"]
        taken = gateway.http.post("/control", json={"client": second.hello["client"], "action": "take"})
        assert (taken.status_code, taken.json()["code"]) == (409, "control_unconfirmed")
        assert taken.json()["params"]["name"] == holder["name"]
        gateway.http.post("/control", json={"client": first.hello["client"], "action": "release"}).raise_for_status()
        assert gateway.http.get("/control").json()["client"] is None
        gateway.http.post("/control", json={"client": second.hello["client"], "action": "take"}).raise_for_status()
        assert second.event("control")["client"] is None
        assert second.event("control")["client"] == second.hello["client"]
    unknown = gateway.http.post("/control", json={"client": "nobody", "action": "take"})
    assert (unknown.status_code, unknown.json()["code"]) == (403, "client_not_yours")


def test_only_the_operator_commands(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as first, gateway.stream() as second:
        for path in ("/commands/start", "/parameters/load"):
            for headers in ({}, {"X-Client": second.hello["client"]}):
                answer = gateway.http.post(path, headers=headers)
                assert (answer.status_code, answer.json()["code"]) == (409, "control_held")
        assert board.count("start") == 0
        operator = {"X-Client": first.hello["client"]}
        assert gateway.http.post("/commands/start", headers=operator).json()["state"] == "confirmed"
        for path in ("/status", "/telemetry", "/parameters", "/commands", "/recordings", "/hil", "/ports"):
            assert gateway.http.get(path).status_code == 200


def test_the_periods_of_the_tasks_are_the_boards_own_until_one_is_chosen(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    assert gateway.status()["board"]["periods_ms"] == {
        "parameters": {"ms": 100, "chosen": False},
        "fms": {"ms": 100, "chosen": False},
        "servos": {"ms": 20, "chosen": False},
    }
    gateway.http.post("/commands/set_servos_task_rate", json={"value": 40}).raise_for_status()
    assert gateway.status()["board"]["periods_ms"]["servos"] == {"ms": 40, "chosen": True}
    assert gateway.status()["board"]["periods_ms"]["fms"]["chosen"] is False
