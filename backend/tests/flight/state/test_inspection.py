"""What goes over the lines, as somebody who looks for a fault sees it."""

from __future__ import annotations

import socket
from collections.abc import AsyncIterator, Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import END, TELEMETRY, TELEMETRY_BY_NAME, TO_PC_HEADER
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import CHANNEL_BYTES_PER_S, SimulatorAddress
from epf_gcs.flight.state.inspection import build_inspector, take_snapshot
from epf_gcs.link.address import EMULATION, parse_address
from epf_gcs.vehicle.wanted import IntendedSettings
from epf_gcs.xplane.datagram import Record, build
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio

NO = -999.0
ROWS = dict.fromkeys((3, 4, 6, 8, 11, 16, 17, 18, 20, 25), (0.0, 0.0, 0.0, 0.0, NO, 100.0, NO, NO))


class Line:
    """A line that takes everything."""

    baud = 115200
    backlog = 0

    def write(self, data: bytes) -> bool:
        return bool(data)


class Simulator:
    """X-Plane's side; `port` is where the station listens."""

    def __init__(self, station: Flight) -> None:
        self.station = station
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]

    async def open(self, host: str = "127.0.0.1") -> None:
        await self.station.lines.open_simulator(SimulatorAddress(self.port, host, self.socket.getsockname()[1], "xp10"))

    def send(self, *rows: int) -> None:
        self.socket.sendto(build(Record(row, ROWS.get(row, (7.5,) * 8)) for row in rows), ("127.0.0.1", self.port))


@pytest.fixture
async def station(tmp_path: Path) -> AsyncIterator[Flight]:
    made = Flight(tmp_path / "data", record=False)
    async with made.running():
        yield made


@pytest.fixture
def simulator(station: Flight) -> Iterator[Simulator]:
    end = Simulator(station)
    yield end
    end.socket.close()


async def open_board(station: Flight, board: FakeBoard) -> None:
    await station.lines.open_board(parse_address(board.url))
    await eventually_async(lambda: station.supervisor.state == "open", "the board opens")


def inspect(station: Flight) -> dict[str, Any]:
    return asdict(build_inspector(take_snapshot(station.sources)))


def frames(station: Flight) -> dict[str, dict[str, Any]]:
    return {frame["name"]: frame for frame in inspect(station)["board"]}


def rows(station: Flight) -> dict[int, dict[str, Any]]:
    return {row["row"]: row for row in inspect(station)["rows"]}


def advised(station: Flight) -> dict[str, dict[str, Any]]:
    return {one["code"]: one["params"] for one in inspect(station)["advice"]}


async def test_every_frame_type_is_listed_before_it_is_heard(station: Flight) -> None:
    found = inspect(station)
    assert [(frame["id"], frame["name"]) for frame in found["board"]] == [
        (message.id, message.name) for message in TELEMETRY.values()
    ]
    assert {frame["count"] for frame in found["board"]} == {0}
    assert {frame["values"] for frame in found["board"]} == {None}
    assert {row["row"] for row in found["rows"] if row["expected"]} == {3, 4, 8, 16, 17, 18, 20, 25}
    assert found["link"]["capacity_bytes_per_s"] is None
    assert found["link"]["rx_percent"] is None
    assert found["advice"] == []


async def test_a_heard_frame_has_rate_jitter_age_and_values(station: Flight, board: FakeBoard) -> None:
    await open_board(station, board)
    await station.commands.run("ahrs_on")
    await eventually_async(lambda: frames(station)["ahrs"]["count"] > 20, "frames arrive")
    ahrs = frames(station)["ahrs"]
    assert ahrs["values"] == {"yaw_deg": 10.0, "pitch_deg": 5.0, "roll_deg": -3.0}
    assert 5 < ahrs["rate_hz"] < 60
    assert ahrs["jitter_ms"] >= 0
    assert 0 <= ahrs["age_s"] < 5
    assert ahrs["stale_after_s"] >= 0.2
    acknowledgement = frames(station)["acknowledgement"]
    assert acknowledgement["count"] >= 1, "what is no topic is counted too"
    assert acknowledgement["values"]["result"] == 0
    assert acknowledgement["stale_after_s"] is None


async def test_damaged_and_unknown_frames_are_counted_where_they_belong(station: Flight, board: FakeBoard) -> None:
    await open_board(station, board)
    good = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x38, 0x31, 0x41)
    body = (0x80000042).to_bytes(4, "little") + b"\1\0\0\0"
    board.send(good[:-9] + bytes([good[-9] ^ 1]) + good[-8:] + good)
    board.send(TO_PC_HEADER + body + checksum(body).to_bytes(4, "little") + END + good)
    await eventually_async(lambda: frames(station)["gps"]["count"] == 2, "the good ones arrive")
    assert frames(station)["gps"]["damaged"] == 1
    unknown = frames(station)["unknown_0x42"]
    assert (unknown["id"], unknown["count"], unknown["damaged"], unknown["values"]) == (0x42, 1, 0, None)


async def test_rows_are_counted_however_they_come(station: Flight, simulator: Simulator) -> None:
    await simulator.open()
    for _ in range(5):
        simulator.send(*ROWS)
    await eventually_async(lambda: rows(station)[20]["count"] == 5, "whole frames are counted")
    simulator.send(3, 4)
    simulator.send(99)
    await eventually_async(lambda: 99 in rows(station), "single rows are counted")
    assert (rows(station)[3]["count"], rows(station)[20]["count"]) == (6, 5)
    unknown = rows(station)[99]
    assert (unknown["name"], unknown["expected"], unknown["values"]) == ("row_99", False, [7.5] * 8)
    assert (rows(station)[20]["name"], rows(station)[20]["values"]) == ("position", list(ROWS[20]))


async def test_rows_that_no_simulator_has_do_not_fill_the_memory(station: Flight, simulator: Simulator) -> None:
    await simulator.open()

    def flood() -> bool:
        for row in range(1000, 2000, 20):
            simulator.send(*range(row, row + 20))
        return station.simulator.datagrams >= 50

    await eventually_async(flood, "the flood arrives")
    assert len([row for row in rows(station) if row >= 1000]) <= 256


async def test_a_value_that_is_no_number_is_none(station: Flight, simulator: Simulator) -> None:
    await simulator.open()
    values = (float("nan"), float("inf"), -float("inf"), 1.0, 2.0, 3.0, 4.0, 5.0)
    simulator.socket.sendto(build([Record(99, values)]), ("127.0.0.1", simulator.port))
    await eventually_async(lambda: 99 in rows(station), "it arrives")
    assert rows(station)[99]["values"] == [None, None, None, 1.0, 2.0, 3.0, 4.0, 5.0]


async def test_the_link_is_measured_against_its_baud_rate(station: Flight, board: FakeBoard) -> None:
    await station.lines.open_board(parse_address(f"{board.url}?baud=57600"))

    def measured() -> bool:
        link = inspect(station)["link"]
        share = 100 * link["rx_bytes_per_s"] / 5760
        return bool(link["rx_bytes_per_s"] > 0 and link["rx_percent"] == pytest.approx(share, abs=0.1))

    await eventually_async(measured, "it is measured")
    assert inspect(station)["link"]["capacity_bytes_per_s"] == 5760.0


async def test_each_way_of_the_lines_is_measured_and_of_the_simulators_it_is_the_share(tmp_path: Path) -> None:
    rates = (station := Flight(tmp_path, record=False)).rates
    for rate, total in ((rates.board_in, 2001), (rates.board_out, 501), (rates.simulator_in, 100_001)):
        rate.note(100.0, 0)
        rate.note(102.0, total)
    link = inspect(station)["link"]
    assert (link["rx_bytes_per_s"], link["tx_bytes_per_s"], link["simulator_bytes_per_s"]) == (1000.5, 250.5, 50000.5)
    assert link["simulator_percent"] == round(100 * 50000.5 / CHANNEL_BYTES_PER_S, 1)
    assert (link["rx_percent"], link["tx_percent"]) == (None, None)


async def test_of_a_full_line_the_servo_streams_have_the_share_that_came(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    now_s = station.clock.now_s()
    for name, period_s in (("servos_in", 0.02), ("fly_by_wire", 0.04)):
        for place in range(100):
            station.board.frame_statistics.heard[name].heard(now_s + place * period_s, None)
    station.memory.update(wanted=IntendedSettings().after("set_servos_task_rate", (40,)))
    snapshot = take_snapshot(station.sources)
    full = replace(
        snapshot,
        now_s=now_s + 1.98,
        link=replace(snapshot.link, capacity_bytes_per_s=20_000.0),
        observed=replace(snapshot.observed, rx_percent=95.0),
    )
    servo_bytes_per_s = 50 * (TELEMETRY_BY_NAME["servos_in"].size + 16) + 25 * (
        TELEMETRY_BY_NAME["fly_by_wire"].size + 16
    )
    found = {one.code: one.params for one in build_inspector(full).advice}
    assert found["servo_rate_high"] == {"ms": 40, "percent": round(servo_bytes_per_s / 200)}


async def test_a_slow_loop_is_advised_only_while_it_is_alive(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    station.hil.round_trip.asked(10.0)
    station.hil.round_trip.answered(10.2)
    assert advised(station) == {}
    station.hil.last_surfaces_s = station.clock.steady_s() - 0.5
    assert advised(station) == {"round_trip_long": {"ms": 200}}
    station.hil.last_surfaces_s = station.clock.steady_s() - 1.5
    assert advised(station) == {}


async def test_strangers_are_advised_for_ten_seconds(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    station.simulator.dropped["stranger"] = 3
    assert advised(station) == {}
    station.simulator.last_stranger_s = station.clock.steady_s() - 9.0
    assert advised(station) == {"foreign_datagrams": {"count": 3}}
    station.simulator.last_stranger_s = station.clock.steady_s() - 10.5
    assert advised(station) == {}


async def test_the_loop_is_measured(station: Flight, board: FakeBoard, simulator: Simulator) -> None:
    await open_board(station, board)
    await simulator.open()

    def fly() -> bool:
        simulator.send(*ROWS)
        return bool(inspect(station)["link"]["round_trips"] >= 10)

    await eventually_async(fly, "the loop is closed")
    round_trip_ms = inspect(station)["link"]["round_trip_ms"]
    assert 0 < round_trip_ms["p50"] <= round_trip_ms["p99"]


async def test_missing_rows_and_a_silent_simulator_are_advised(station: Flight, simulator: Simulator) -> None:
    await simulator.open()
    assert advised(station) == {"simulator_silent": {"port": simulator.port}}

    def all_but_one() -> bool:
        simulator.send(*(row for row in ROWS if row != 18))
        return advised(station) == {"row_missing": {"row": 18, "name": "alpha_beta_paths"}}

    await eventually_async(all_but_one, "the row is named")


async def test_a_stranger_is_advised(station: Flight, simulator: Simulator) -> None:
    await simulator.open("192.0.2.1")

    def intrude() -> bool:
        simulator.send(3)
        return "foreign_datagrams" in advised(station)

    await eventually_async(intrude, "it is told")


async def test_a_silent_board_is_advised(station: Flight, board: FakeBoard) -> None:
    board.silent = True
    await station.lines.open_board(parse_address(board.url))
    assert advised(station) == {"no_heartbeat": {"target": str(board.path)}}
    board.silent = False
    await eventually_async(lambda: station.supervisor.state == "open", "it speaks")
    await eventually_async(lambda: "no_heartbeat" not in advised(station), "that is over")
    await station.lines.close_board()
    assert advised(station) == {}


async def test_rubbish_on_a_serial_line_is_advised_as_a_wrong_baud_rate(station: Flight, board: FakeBoard) -> None:
    board.silent = True
    await station.lines.open_board(parse_address(f"serial://{board.path}?baud=9600"))

    def rubbish() -> bool:
        board.send(b"\x80\xf8\x07\n\xfe\x1f\n")
        return advised(station) == {"baud_wrong": {"baud": 9600}}

    await eventually_async(rubbish, "it is told")


async def test_a_stream_that_is_on_and_does_not_come_is_advised(station: Flight, board: FakeBoard) -> None:
    await open_board(station, board)
    await station.commands.run("gps_on")

    def told() -> bool:
        found = [one["params"] for one in inspect(station)["advice"] if one["code"] == "stream_slow"]
        return {"topic": "gps", "rate_hz": 0.0, "expected_hz": 10.0} in found

    await eventually_async(told, "it is told")
    await station.commands.run("gps_off")
    await eventually_async(lambda: not told(), "nobody wants it any more")


async def test_another_rate_counts_from_the_moment_it_was_commanded(station: Flight, board: FakeBoard) -> None:
    await open_board(station, board)
    await eventually_async(lambda: frames(station)["heartbeat"]["count"] > 20, "it lives")
    await station.commands.run("set_parameter_task_rate", (20,))
    rate_hz = station.board.frame_statistics.heard["heartbeat"].summary(station.clock.now_s()).rate_hz
    assert rate_hz == 0.0, "what was measured before says nothing"


async def test_examples_leave_no_trace_in_the_statistics_of_a_board(station: Flight, board: FakeBoard) -> None:
    await open_board(station, board)
    await eventually_async(lambda: frames(station)["heartbeat"]["count"] > 20, "a board speaks")
    await station.lines.open_board(EMULATION)
    assert frames(station)["heartbeat"]["count"] < 20
    await eventually_async(lambda: frames(station)["gps"]["count"] > 0, "examples are played")
    await eventually_async(lambda: rows(station)[20]["count"] > 0, "also of a simulator")
    await station.lines.close_board()
    await eventually_async(lambda: station.supervisor.state == "open", "the board is back")
    assert (frames(station)["gps"]["count"], frames(station)["gps"]["values"]) == (0, None)
    assert (rows(station)[20]["count"], rows(station)[20]["values"]) == (0, None)


async def test_what_was_copied_stays_as_it_was_while_more_comes(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    ahrs, row = encode_telemetry("ahrs", 10.0, 5.0, -3.0), build([Record(99, (7.5,) * 8)])
    station.board.on_bytes(ahrs)
    station.hil.on_datagram(row)
    await eventually_async(lambda: 99 in station.hil.arrivals, "the row came")
    snapshot = take_snapshot(station.sources)
    station.board.on_bytes(ahrs)
    station.hil.on_datagram(row)
    await eventually_async(lambda: station.hil.arrivals[99].count == 2, "the second row came")
    now, then = inspect(station), asdict(build_inspector(snapshot))
    for found, count in ((then, 1), (now, 2)):
        assert {frame["count"] for frame in found["board"] if frame["name"] == "ahrs"} == {count}
        assert {one["count"] for one in found["rows"] if one["row"] == 99} == {count}


async def test_damaged_frames_are_advised_beyond_the_limit_that_was_chosen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = Flight(tmp_path, record=False)
    monkeypatch.setattr(type(station.watch), "damaged_percent", property(lambda _: 2.0))
    assert advised(station) == {"frames_damaged": {"percent": 2.0}}
    station.alarms.choose({"frames_damaged_percent": 2.5})
    assert advised(station) == {}


@pytest.mark.parametrize(
    ("state", "found"),
    [("opening", ["simulator_silent"]), ("lost", ["simulator_silent"]), ("open", ["row_missing"] * 8), ("closed", [])],
)
async def test_a_simulator_is_silent_until_it_sends_and_only_then_are_rows_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, state: str, found: list[str]
) -> None:
    station = Flight(tmp_path, record=False)
    station.simulator.want(SimulatorAddress(49003, "127.0.0.1", 49000, "xp10"))
    monkeypatch.setattr(type(station.simulator), "state", property(lambda _: state))
    assert [one["code"] for one in inspect(station)["advice"]] == found


async def test_a_board_is_silent_after_three_seconds_or_three_of_its_own_slower_periods(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = Flight(tmp_path, record=False)
    station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    silent = {"no_heartbeat": {"target": f"{tmp_path}/board"}}
    assert advised(station) == silent
    ages_s: list[float | None] = []
    monkeypatch.setattr(type(station.board), "link", property(lambda _: Line()))
    monkeypatch.setattr(station.board, "heartbeat_age_s", lambda: ages_s[-1])
    stale_s: list[float | None] = [None]
    monkeypatch.setattr(station.telemetry, "stale_after_s", lambda _: stale_s[-1])
    for age_s, after_s, is_silent in (
        (None, None, True),
        (0.1, None, False),
        (2.9, 0.3, False),
        (3.1, 0.3, True),
        (5.9, 6.0, False),
        (6.1, 6.0, True),
    ):
        ages_s.append(age_s)
        stale_s.append(after_s)
        assert advised(station) == (silent if is_silent else {})
    ages_s.append(0.1)
    monkeypatch.setattr(type(station.board), "link", property(lambda _: None))
    assert advised(station) == silent, "what was heard over a line that is gone says nothing"


async def test_a_stream_is_expected_as_the_heartbeat_says_and_a_plan_as_it_was_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = Flight(tmp_path, record=False)
    assert take_snapshot(station.sources).expected_hz == {}, "no board is open"
    monkeypatch.setattr(type(station.board), "is_open", property(lambda _: True))
    assert take_snapshot(station.sources).expected_hz == {"heartbeat": 10.0}
    station.telemetry.take("heartbeat", 1.0, {"ahrs": True, "gps": False, "servos": True, "fly_by_wire": None})
    wanted = IntendedSettings().after("gps_on", ()).after("fms_plan_on", ()).after("set_servos_task_rate", (40,))
    station.memory.update(wanted=wanted)
    assert take_snapshot(station.sources).expected_hz == {
        "heartbeat": 10.0,
        "ahrs": 10.0,
        "servos_in": 25.0,
        "fms_plan": 10.0,
    }


async def test_rubbish_is_a_wrong_baud_rate_only_on_a_serial_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = Flight(tmp_path, record=False)
    station.board.baud = 57600
    monkeypatch.setattr(type(station.board), "hears_only_rubbish", property(lambda _: True))
    assert advised(station) == {}
    station.supervisor.want(parse_address("tcp://192.0.2.1:4000"), None)
    assert set(advised(station)) == {"no_heartbeat"}
    station.supervisor.want(parse_address("serial:///dev/ttyUSB0?baud=57600"), None)
    assert advised(station) == {"baud_wrong": {"baud": 57600}}


async def test_a_full_line_is_advised_by_its_direction(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    station.board.attach(Line())
    for rate, percent, direction in ((station.rates.board_in, 91, "rx"), (station.rates.board_out, 95, "tx")):
        rate.note(100.0, 0)
        rate.note(101.0, percent * 115.2)  # type: ignore[arg-type]
        assert advised(station) == {"line_full": {"percent": percent, "direction": direction}}
        rate.note(102.1, percent * 115.2)  # type: ignore[arg-type]
        rate.note(103.2, percent * 115.2)  # type: ignore[arg-type]
    assert inspect(station)["link"]["capacity_bytes_per_s"] == 11520.0
    station.board.detach()
    assert inspect(station)["link"]["capacity_bytes_per_s"] is None, "no line, no capacity"
