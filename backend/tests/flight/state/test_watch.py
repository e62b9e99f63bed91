"""What the operator must see at once, found on a real line."""

from __future__ import annotations

import math
import socket
from pathlib import Path

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.contract.base import Values
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.state.lines import BothLines
from epf_gcs.flight.state.watch import Watch
from epf_gcs.link.address import parse_address
from epf_gcs.link.failures import lost_error
from epf_gcs.vehicle.judges import Finding
from epf_gcs.vehicle.surroundings import ToldSurroundings
from epf_gcs.xplane.datagram import Record, build
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def ids(station: Flight) -> set[str]:
    """What is wrong now; what recovered is listed beside it until it is acknowledged."""
    return {alarm.finding.id for alarm in station.alarms.active if alarm.until_s is None}


def analog(battery_v: float) -> bytes:
    nan = math.nan
    return encode_telemetry("analog", 1013.0, 10.0, nan, nan, nan, nan, nan, 20.0, battery_v, nan)


def gps(fix: str, status: str) -> bytes:
    return encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, ord("8"), ord(fix), ord(status))


async def open_board(station: Flight, board: FakeBoard) -> None:
    await station.lines.open_board(parse_address(board.url))
    await eventually_async(lambda: station.supervisor.state == "open", "the board opens")


async def test_a_pulled_cable_is_an_alarm_until_it_is_back(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        assert ids(station) == set()
        board.unplug()
        await eventually_async(lambda: ids(station) == {"heartbeat_lost"}, "the alarm comes")
        (alarm,) = station.alarms.active
        assert alarm.finding.level == "critical"
        assert abs(alarm.since_s - station.clock.now_s()) < 20
        board.plug_in()
        await eventually_async(lambda: ids(station) == set(), "the alarm goes")


async def test_a_silent_board_is_an_alarm_although_the_line_is_there(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        board.silent = True
        await eventually_async(lambda: ids(station) == {"heartbeat_lost"}, "the alarm comes")
        board.silent = False
        await eventually_async(lambda: ids(station) == set(), "the alarm goes")


async def test_a_port_where_no_board_speaks_is_a_warning(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    board.silent = True
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: ids(station) == {"no_heartbeat"}, "the warning comes")
        assert station.alarms.active[0].finding.level == "warning"


async def test_a_board_that_was_closed_is_no_alarm(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        board.unplug()
        await eventually_async(lambda: ids(station) == {"heartbeat_lost"}, "the alarm comes")
        await station.lines.close_board()
        await eventually_async(lambda: ids(station) == set(), "the alarm goes")


async def test_a_line_with_more_than_one_bad_frame_in_a_hundred_is_a_warning(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        bad = bytearray(encode_telemetry("ahrs", 1.0, 2.0, 3.0))
        bad[-5] ^= 0x40
        for _ in range(20):
            board.send(bytes(bad))
        await eventually_async(lambda: ids(station) == {"frames_damaged"}, "the warning comes")


async def test_an_open_loop_is_an_alarm(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    whole = build(Record(row, (0.0,) * 8) for row in (3, 4, 8, 16, 17, 20, 25))
    async with station.running():
        await open_board(station, board)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as simulator:
            simulator.bind(("127.0.0.1", 0))
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
                probe.bind(("127.0.0.1", 0))
                port = probe.getsockname()[1]
            await station.lines.open_simulator(SimulatorAddress(port, "127.0.0.1", simulator.getsockname()[1], "xp10"))
            assert ids(station) == set(), "a loop that never was closed is not lost"

            def fly() -> bool:
                simulator.sendto(whole, ("127.0.0.1", port))
                return station.hil.last_surfaces_s is not None

            await eventually_async(fly, "the loop is closed")
            await eventually_async(lambda: ids(station) == {"hil_lost"}, "the simulator's silence is an alarm")
            assert "the simulator sends nothing" in station.alarms.active[0].finding.text
            board.ignore["xplane_info"] = 10_000

            def fly_unanswered() -> bool:
                simulator.sendto(whole, ("127.0.0.1", port))
                return any("does not answer" in alarm.finding.text for alarm in station.alarms.active)

            await eventually_async(fly_unanswered, "the board's silence is an alarm")


async def test_a_recorder_that_failed_is_an_alarm_and_the_flight_goes_on(tmp_path: Path, board: FakeBoard) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "recordings").write_text("a file where the folder should be")
    station = Flight(tmp_path / "data", record=True)
    async with station.running():
        await open_board(station, board)
        await eventually_async(lambda: ids(station) == {"recorder_failed"}, "the alarm comes")
        assert (await station.commands.run("ahrs_on")).state == "confirmed"
        await eventually_async(lambda: station.telemetry.newest("ahrs") is not None, "telemetry goes on")


async def test_a_low_battery_is_critical_while_it_is_measured(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)

        def drain() -> bool:
            board.send(analog(9.9))
            return ids(station) == {"battery_low"}

        await eventually_async(drain, "the alarm comes")
        assert station.alarms.active[0].finding.level == "critical"
        assert station.alarms.active[0].finding.params == {"battery_v": 9.9, "limit_v": 10.5, "cells": 3}
        await eventually_async(lambda: ids(station) == set(), "a battery that is not measured any more is no alarm")

        def lower_limit() -> bool:
            board.send(analog(9.9))
            return ids(station) == {"battery_low"}

        await eventually_async(lower_limit, "it comes again")
        station.alarms.choose({"battery_low_v": 9.5})

        def keep_measuring() -> bool:
            board.send(analog(9.9))
            return ids(station) == set()

        await eventually_async(keep_measuring, "under the lower limit it is no alarm")


async def test_a_busy_processor_is_a_warning(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)

        def work() -> bool:
            board.send(encode_telemetry("statistics", 12, 97))
            return ids(station) == {"cpu_high"}

        await eventually_async(work, "the warning comes")
        assert station.alarms.active[0].finding.params == {"percent": 97}


async def test_a_gps_that_loses_its_position_is_an_alarm_until_it_is_back(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)

        def says(fix: str, status: str, found: set[str]) -> bool:
            board.send(gps(fix, status))
            return station.telemetry.is_live("gps") and ids(station) == found

        await eventually_async(lambda: says("3", "A", set()), "it has a position")
        await eventually_async(lambda: says("0", "V", {"gps_lost"}), "the position is lost")
        assert station.alarms.active[0].finding.params == {"reason": "no_fix"}
        await eventually_async(lambda: says("3", "A", set()), "it is back")


async def gets_a_position(station: Flight, board: FakeBoard) -> None:
    """The receiver has a fix, and the station has heard of it."""

    def live() -> bool:
        board.send(gps("3", "A"))
        return station.telemetry.is_live("gps")

    await eventually_async(live, "it has a position")


async def test_a_gps_stream_that_dies_is_an_alarm_only_where_it_is_wanted(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        await station.commands.run("gps_on")
        await gets_a_position(station, board)
        await eventually_async(lambda: ids(station) == {"gps_lost"}, "the stream died")
        assert station.alarms.active[0].finding.params == {"reason": "silent"}
        await station.commands.run("gps_off")
        await eventually_async(lambda: ids(station) == set(), "nobody wants it any more")


async def test_with_the_board_gone_the_gps_is_not_an_alarm_of_its_own(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        await station.commands.run("gps_on")
        await gets_a_position(station, board)
        board.silent = True
        await eventually_async(lambda: (station.telemetry.age_s("heartbeat") or 0) > 3, "the board is silent")
        assert ids(station) == {"heartbeat_lost"}
        board.silent = False

        def alive() -> bool:
            board.send(gps("3", "A"))
            return ids(station) == set()

        await eventually_async(alive, "it is back")
        assert {alarm.finding.id for alarm in station.alarms.past} == {"heartbeat_lost"}


async def test_a_board_whose_card_failed_is_an_alarm_until_it_says_otherwise(tmp_path: Path, board: FakeBoard) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        assert ids(station) == set()
        # By itself, as when a plan cannot be stored.
        board.send(encode_telemetry("capabilities", 1, 0x1F, b"fake", b"1.0", 5))
        await eventually_async(lambda: ids(station) == {"card_failed"}, "the alarm comes")
        assert station.supervisor.state == "open"
        board.send(encode_telemetry("capabilities", 1, 0x0F, b"fake", b"1.0", 5))
        await eventually_async(lambda: ids(station) == set(), "the alarm goes")


async def test_a_gain_that_was_not_confirmed_is_an_alarm_until_it_is_or_somebody_knows(
    tmp_path: Path, board: FakeBoard
) -> None:
    station = Flight(tmp_path / "data", record=False)
    async with station.running():
        await open_board(station, board)
        board.refuse["set_k_pitch"] = 1
        await station.parameters.set({"k_pitch": 2.5}, None)
        await eventually_async(lambda: ids(station) == {"parameter_not_confirmed"}, "the warning comes")
        assert station.alarms.active[0].finding.params == {"names": "k_pitch"}
        board.refuse["set_k_pitch"] = 0
        await station.parameters.set({"k_pitch": 2.5}, None)
        await eventually_async(lambda: ids(station) == set(), "a later write settles it")
        board.refuse["set_k_roll"] = 1
        await station.parameters.set({"k_roll": 2.5}, None)
        await eventually_async(lambda: ids(station) == {"parameter_not_confirmed"}, "it comes again")
        assert not station.alarms.active[0].acknowledged
        assert station.alarms.acknowledge("parameter_not_confirmed").acknowledged
        await eventually_async(lambda: ids(station) == set(), "whoever acknowledged it knows")
        assert [alarm.acknowledged for alarm in station.alarms.past] == [True, False]


class At:
    """A watch over a station whose lines are not run, at a time that the test says."""

    def __init__(self, folder: Path) -> None:
        self.now_s = 1000.0
        self.station = station = Flight(folder / "data", record=False)
        self.watch = Watch(
            BothLines(station.board, station.supervisor, station.simulator, station.hil),
            telemetry=station.telemetry,
            parameters=station.parameters,
            recorder=None,
            steady_s=lambda: self.now_s,
            wants=lambda _: False,
            surroundings=ToldSurroundings(),
        )

    def findings(self, now_s: float) -> list[Finding]:
        self.now_s = now_s
        return self.watch(self.station.alarms.thresholds)

    def found(self, now_s: float) -> dict[str, str]:
        return {finding.id: finding.text for finding in self.findings(now_s)}


async def test_a_board_has_five_seconds_to_speak_from_when_it_was_wanted_or_the_line_was_free_again(
    tmp_path: Path,
) -> None:
    at = At(tmp_path)
    assert at.found(1000.0) == {}
    at.station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    assert at.found(1002.0) == {}
    assert at.found(1006.9) == {}
    assert set(at.found(1007.1)) == {"no_heartbeat"}
    at.station.board.exclusive_user = at.station.ahrs_test
    assert at.found(1008.0) == {}
    at.station.board.exclusive_user = None
    assert at.found(1009.0) == {}
    assert at.found(1013.9) == {}
    assert set(at.found(1014.1)) == {"no_heartbeat"}


async def test_a_board_whose_line_is_opened_again_is_silent_only_when_it_has_not_spoken_for_a_second(
    tmp_path: Path,
) -> None:
    at = At(tmp_path)
    session = at.station.board.session
    at.station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    assert at.found(1000.0) == {}
    session.heartbeat_s = 1010.0
    assert at.found(1010.0) == {}
    session.heartbeat_s = None
    assert at.found(1010.9) == {}
    assert set(at.found(1011.1)) == {"heartbeat_lost"}
    at.station.supervisor.want(parse_address(f"pty://{tmp_path}/other"), None)
    assert at.found(1012.0) == {}, "another board has five seconds of its own"
    assert set(at.found(1017.1)) == {"no_heartbeat"}


async def test_the_loop_is_open_half_a_second_after_what_went_or_came_last(tmp_path: Path) -> None:
    at = At(tmp_path)
    hil, station = at.station.hil, at.station
    station.simulator.want(SimulatorAddress(1, "127.0.0.1", 2, "xp10"))
    station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    assert at.found(1000.0) == {}
    hil.last_to_board_s = hil.last_surfaces_s = 1001.0
    assert at.found(1001.49) == {}
    assert "gets no simulator data" in at.found(1001.51)["hil_lost"]
    hil.last_to_board_s = 1001.2
    assert "does not answer" in at.found(1001.51)["hil_lost"]
    hil.last_surfaces_s = 1001.2
    assert at.found(1001.51) == {}


async def test_a_board_that_has_not_answered_yet_has_as_long_for_it_as_any_other(tmp_path: Path) -> None:
    at = At(tmp_path)
    hil, station = at.station.hil, at.station
    station.simulator.want(SimulatorAddress(1, "127.0.0.1", 2, "xp10"))
    station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    hil.first_to_board_s = hil.last_to_board_s = 1001.0
    assert at.found(1001.01) == {}
    hil.last_to_board_s = 1001.5
    assert at.found(1001.49) == {}
    assert "does not answer" in at.found(1001.51)["hil_lost"]


async def test_a_line_that_failed_before_a_board_was_heard_is_an_alarm_only_if_it_was_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    at = At(tmp_path)
    supervisor = at.station.supervisor
    supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    monkeypatch.setattr(type(supervisor), "failure", property(lambda _: lost_error("board", "unplugged")))
    states: list[str] = []
    monkeypatch.setattr(type(supervisor), "state", property(lambda _: states[-1]))
    for state, found in (("opening", set()), ("lost", {"heartbeat_lost"}), ("open", set()), ("closed", set())):
        states.append(state)
        assert set(at.found(1001.0)) == found


async def test_a_board_flies_when_it_says_so_or_moves_the_surfaces_and_not_when_it_says_nothing(tmp_path: Path) -> None:
    station = Flight(tmp_path / "data", record=False)
    assert not station.flies()
    silent: Values = {"autopilot": None}
    off: Values = {"autopilot": False, "autopilot_hil": False}
    for values in (silent, off):
        station.telemetry.take("heartbeat", 1.0, values)
        assert not station.flies()
    station.telemetry.take("heartbeat", 1.0, {"autopilot": False, "autopilot_hil": True})
    assert station.flies()


def saying(value: object) -> property:
    return property(lambda _: value)


async def test_a_loop_whose_board_or_simulator_was_closed_is_not_lost(tmp_path: Path) -> None:
    at = At(tmp_path)
    station = at.station
    station.hil.last_to_board_s = station.hil.last_surfaces_s = 1000.0
    assert at.found(1001.0) == {}, "neither is wanted"
    station.simulator.want(SimulatorAddress(1, "127.0.0.1", 2, "xp10"))
    assert at.found(1001.0) == {}, "a simulator alone is no loop"
    station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    assert set(at.found(1001.0)) == {"hil_lost"}
    await station.simulator.close()
    assert at.found(1001.0) == {}, "a board alone is no loop"


async def test_an_open_loop_is_blamed_on_the_part_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    at = At(tmp_path)
    station = at.station
    station.simulator.want(SimulatorAddress(1, "127.0.0.1", 2, "xp10"))
    station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    station.hil.last_to_board_s = station.hil.last_surfaces_s = 1000.0
    monkeypatch.setattr(type(station.hil), "missing_rows", saying([17, 20]))
    assert "Check the board's link" in at.found(1001.0)["hil_lost"]
    monkeypatch.setattr(type(station.board), "is_open", saying(value=True))
    assert "the simulator sends nothing" in at.found(1001.0)["hil_lost"]
    monkeypatch.setattr(type(station.simulator), "state", saying("open"))
    assert "rows [17, 20] are missing" in at.found(1001.0)["hil_lost"]


async def test_strangers_at_the_simulators_port_are_a_warning_that_names_the_last_of_them(tmp_path: Path) -> None:
    at = At(tmp_path)
    at.station.simulator.dropped["malformed"] = 100
    assert at.found(1001.0) == {}
    at.station.simulator.dropped["stranger"] = 30
    at.station.simulator.last_stranger = "192.0.2.7:5000"
    (found,) = at.findings(1002.0)
    assert (found.id, found.params) == ("foreign_datagrams", {"per_s": 3, "host": "192.0.2.7:5000"})


@pytest.mark.parametrize(("source_joystick", "level"), [(None, "critical"), (True, "critical"), (False, "warning")])
async def test_a_silent_gamepad_is_critical_unless_the_rc_is_known_to_fly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, source_joystick: object, level: str
) -> None:
    at = At(tmp_path)
    stick = at.station.stick
    at.station.telemetry.take("heartbeat", 1.0, {"source_joystick": source_joystick})
    monkeypatch.setattr(type(stick), "state", saying("lost"))
    assert at.found(1001.0) == {}
    stick.gamepad = "Pad"
    (found,) = at.findings(1001.0)
    assert (found.id, found.level, found.params) == ("stick_lost", level, {"gamepad": "Pad"})


async def test_ground_and_fence_come_before_everything_else_that_is_wrong(tmp_path: Path) -> None:
    at = At(tmp_path)
    at.station.supervisor.want(parse_address(f"pty://{tmp_path}/board"), None)
    at.found(1000.0)
    at.watch.surroundings.take(
        [{"id": "terrain_ahead", "aircraft": "flight", "what": "terrain", "in_s": 20.0}], at.now_s + 10.0
    )
    assert [found.id for found in at.findings(1010.0)] == ["terrain_ahead", "no_heartbeat"]
    assert [found.id for found in at.findings(1013.0)] == ["no_heartbeat"], "whoever said it has gone"


async def test_a_position_is_not_missed_any_more_once_no_board_is_wanted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    at = At(tmp_path)
    station = at.station
    monkeypatch.setattr(station.telemetry, "is_live", lambda _: True)
    address = parse_address(f"pty://{tmp_path}/board")

    def looks(*frames: bytes) -> set[str]:
        station.board.on_bytes(encode_telemetry("heartbeat", *([1] * 12)) + b"".join(frames))
        return set(at.found(at.now_s + 2.0)) & {"gps_lost"}

    station.supervisor.want(address, None)
    looks(gps("3", "A"))
    looks(gps("3", "V"))
    assert looks(gps("3", "V")) == {"gps_lost"}
    assert {one.level for one in at.findings(at.now_s) if one.id == "gps_lost"} == {"critical"}
    await station.supervisor.close()
    assert looks(gps("3", "V")) == set()
    station.supervisor.want(address, None)
    looks(gps("3", "V"))
    assert {one.level for one in at.findings(at.now_s + 2.0) if one.id == "gps_lost"} == {"warning"}
