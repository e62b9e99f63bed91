"""The status that every page shows: each number in its own place, and what is not known is not made up."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Client
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.contract.status import RecordingState
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S, SimulatorAddress
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.link.address import parse_address
from epf_gcs.link.failures import lost_error
from epf_gcs.xplane.stick import FIELDS
from tests.support.outlet import KeptOutlet

pytestmark = pytest.mark.anyio

ADDRESS = SimulatorAddress(49003, "192.0.2.5", 49000, "xp12")
HEARTBEAT = encode_telemetry("heartbeat", *([1] * 10), 0, 0)


class Standing:
    """A clock that stands."""

    def now_s(self) -> float:
        return 1000.0

    def steady_s(self) -> float:
        return 1000.0


class Sink:
    """A line that takes everything."""

    backlog = 0

    def __init__(self, baud: int) -> None:
        self.baud = baud

    def write(self, data: bytes) -> bool:
        return bool(data)


def board(flight: Flight) -> dict[str, Any]:
    shown: dict[str, Any] = asdict(flight.status().board)
    return shown


def simulator(flight: Flight) -> dict[str, Any]:
    shown: dict[str, Any] = asdict(flight.status().simulator)
    return shown


def saying(value: object) -> property:
    return property(lambda _: value)


def put(monkeypatch: pytest.MonkeyPatch, part: object, **values: object) -> None:
    """What a part says of itself."""
    for name, value in values.items():
        monkeypatch.setattr(type(part), name, saying(value))


async def test_each_way_of_the_boards_line_has_its_share_of_the_baud_rate(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    rates = flight.rates
    for rate, total in ((rates.board_in, 1152), (rates.board_out, 580)):
        rate.note(100.0, 0)
        rate.note(101.0, total)
    assert (board(flight)["rx_percent"], board(flight)["tx_percent"]) == (0.0, 0.0), "no line, no share"
    flight.board.attach(Sink(57600))
    assert (board(flight)["rx_percent"], board(flight)["tx_percent"]) == (20.0, 10.1)


async def test_bytes_and_frames_of_the_boards_line_are_told_apart(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.board.attach(Sink(57600))
    damaged = bytearray(HEARTBEAT)
    damaged[-5] ^= 0x40
    flight.board.on_bytes(HEARTBEAT + HEARTBEAT + bytes(damaged) + HEARTBEAT)
    shown = board(flight)
    assert (shown["frames_received"], shown["frames_damaged"]) == (3, 1)
    assert shown["damage"] == flight.board.damage
    assert shown["bytes_in"] == 4 * len(HEARTBEAT)
    assert shown["bytes_out"] == flight.board.bytes_out != shown["bytes_in"]
    assert 0 <= shown["heartbeat_age_s"] < 60


async def test_what_a_board_can_do_is_known_once_it_has_said_so(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    assert (board(flight)["mode"], board(flight)["firmware"]) == (None, None)
    flight.board.attach(Sink(57600))
    flight.board.on_bytes(HEARTBEAT)
    assert board(flight)["mode"] is None, "it was asked and may answer yet"
    for place, feature in enumerate(("acknowledgements", "store", "sources", "missions")):
        flight.board.on_bytes(encode_telemetry("capabilities", 1, 1 << place, b"epf", b"2.1", 5))
        assert [name for name, has in board(flight)["features"].items() if has] == [feature]
    assert board(flight)["mode"] == "extended"
    assert board(flight)["firmware"] == {"name": "epf", "version": "2.1"}


async def test_a_board_that_did_not_answer_is_a_legacy_one_without_features(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.board.attach(Sink(57600))
    flight.board.on_bytes(HEARTBEAT)
    flight.board.session.tick(flight.clock.steady_s() + 1.0)
    shown = board(flight)
    assert (shown["mode"], shown["firmware"]) == ("legacy", None)
    assert set(shown["features"].values()) == {False}


async def test_why_a_line_is_not_open_is_said_of_that_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    flight = Flight(tmp_path, record=False)
    assert (board(flight)["failure"], simulator(flight)["failure"]) == (None, None)
    failure = lost_error("/dev/ttyUSB0", "unplugged")
    told = {"code": failure.code, "detail": failure.detail, "params": failure.params}
    put(monkeypatch, flight.supervisor, failure=failure)
    assert (board(flight)["failure"], simulator(flight)["failure"]) == (told, None)
    put(monkeypatch, flight.supervisor, failure=None)
    put(monkeypatch, flight.simulator, failure=failure)
    assert (board(flight)["failure"], simulator(flight)["failure"]) == (None, told)


async def test_the_line_of_the_simulator_is_shown_with_its_counts_and_its_share(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.simulator.want(ADDRESS)
    flight.simulator.datagrams, flight.simulator.bytes_in = 7, 700
    flight.simulator.dropped.update({"stranger": 3, "malformed": 2})
    flight.hil.frames_to_board, flight.hil.frames_to_simulator = 11, 12
    flight.hil.skipped["line_busy"] = 4
    flight.hil.round_trip.asked(1.0)
    flight.hil.round_trip.answered(1.02)
    flight.rates.simulator_in.note(100.0, 0)
    flight.rates.simulator_in.note(102.0, CHANNEL_BYTES_PER_S)
    shown = simulator(flight)
    assert {name: shown[name] for name in ADDRESS.as_dict()} == ADDRESS.as_dict()
    assert (shown["datagrams_received"], shown["bytes_in"], shown["percent"]) == (7, 700, 50.0)
    assert (shown["datagrams_dropped"], shown["drop_reasons"]) == (5, {"stranger": 3, "malformed": 2})
    assert (shown["frames_to_board"], shown["frames_to_simulator"]) == (11, 12)
    assert shown["frames_skipped"] == {"line_busy": 4}
    assert shown["hil_round_trip_ms"]["newest"] == pytest.approx(20.0)


async def test_without_a_simulator_there_is_neither_an_address_nor_advice(tmp_path: Path) -> None:
    shown = simulator(Flight(tmp_path, record=False))
    assert shown["state"] == "closed"
    assert {shown[name] for name in ("receive_port", "send_host", "send_port", "profile", "advice")} == {None}
    assert (shown["missing_rows"], shown["percent"]) == ([], 0.0)


@pytest.mark.parametrize(
    ("state", "has_failed", "missing", "words"),
    [
        ("opening", False, [3, 4], "UDP port 49003"),
        ("lost", False, [], "UDP port 49003"),
        ("opening", True, [3, 4], None),
        ("lost", True, [3, 4], None),
        ("closed", False, [3, 4], None),
        ("open", False, [], None),
        ("open", False, [3, 4], "Rows 3, 4 are missing"),
    ],
)
async def test_the_advice_for_a_simulator_is_what_the_operator_can_do_about_it(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    state: str,
    has_failed: bool,
    missing: list[int],
    words: str | None,
) -> None:
    flight = Flight(tmp_path, record=False)
    flight.simulator.want(ADDRESS)
    failure = lost_error("UDP port 49003", "taken") if has_failed else None
    put(monkeypatch, flight.simulator, state=state, failure=failure)
    put(monkeypatch, flight.hil, missing_rows=missing)
    shown = simulator(flight)
    assert (shown["advice"] is None) == (words is None)
    assert words is None or words in shown["advice"]
    assert shown["missing_rows"] == (missing if state == "open" else [])


async def test_the_recording_is_shown_as_it_is_and_without_a_recorder_as_none(tmp_path: Path) -> None:
    assert Flight(tmp_path / "without", record=False).status().recording == RecordingState()
    flight = Flight(tmp_path / "with")
    recorder = flight.recorder
    assert recorder is not None
    assert flight.status().recording == RecordingState()
    recorder.file = tmp_path / "flight.mcap"
    recorder.bytes_written, recorder.board_tap.lost, recorder.free_bytes = 1000, 20, 3000
    recorder.failure = "no space"
    assert asdict(flight.status().recording) == {
        "active": True,
        "file": "flight.mcap",
        "bytes": 1000,
        "bytes_lost": 20,
        "failure": "no space",
        "free_bytes": 3000,
        "hours_left": None,
    }


async def test_the_address_of_a_board_that_is_wanted_is_shown_before_it_is_there(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    assert (board(flight)["state"], board(flight)["url"]) == ("closed", None)
    flight.supervisor.want(parse_address("tcp://192.0.2.1:4000"), None)
    assert (board(flight)["state"], board(flight)["url"]) == ("opening", "tcp://192.0.2.1:4000")


async def test_errors_and_topics_are_counted_in_the_status(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    flight.errors.count("link_busy")
    flight.telemetry.take("ahrs", flight.clock.now_s(), {"roll_deg": 1.0}, ["roll_deg"])
    status = flight.status()
    assert status.errors == {"link_busy": 1}
    assert status.topics["ahrs"].count == 1
    assert status.topics["ahrs"].implausible == {"roll_deg": 1}
    assert abs(status.server_time_s - flight.clock.now_s()) < 60


async def test_the_stick_is_shown_with_whose_gamepad_it_is_and_what_came_of_it(tmp_path: Path) -> None:
    flight = Flight(tmp_path, record=False)
    nobody: dict[str, Any] = {
        "source": "simulator",
        "state": None,
        "client": None,
        "name": None,
        "gamepad": None,
        "samples": {},
    }
    assert asdict(flight.status().hil) == {"source": None, "path": "manual", "stick": nobody}
    flight.hil.stick = stick = Stick(KeptOutlet(), Standing(), lambda: None)
    ana = Client("c1", "Ana")
    stick.control_changed(ana)
    stick.take("c1", dict.fromkeys(FIELDS, 0.0))
    stick.take("c2", dict.fromkeys(FIELDS, 0.0))
    await stick.choose_gamepad("c1", "Pad")
    # Her page was lost, and gets the controls back on return.
    stick.control_changed(None, ana)
    flight.hil.path = "assisted"
    flight.telemetry.take("heartbeat", 1.0, {"source_joystick": True})
    assert asdict(flight.status().hil) == {
        "source": "joystick",
        "path": "assisted",
        "stick": {
            "source": "gamepad",
            "state": "lost",
            "client": "c1",
            "name": "Ana",
            "gamepad": "Pad",
            "samples": {"taken": 1, "not_operator": 1},
        },
    }
