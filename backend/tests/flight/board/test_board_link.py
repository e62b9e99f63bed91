"""The board's link through everything that happens to a cable."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.errors import LinkError
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.link.descriptor import DescriptorLink
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

pytestmark = pytest.mark.anyio


def a_station(folder: Path) -> Flight:
    return Flight(folder / "data", record=False)


def state(station: Flight) -> str:
    return station.supervisor.state


def reason(station: Flight) -> str:
    return "" if station.supervisor.failure is None else station.supervisor.failure.detail


async def test_a_line_that_is_pulled_and_plugged_in_is_opened_again(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        board.unplug()
        await eventually_async(lambda: station.supervisor.state == "lost", "the loss is noticed")
        assert str(board.path) in reason(station)
        board.plug_in()
        await eventually_async(lambda: station.supervisor.state == "open", "it opens again")
        assert reason(station) == ""
        assert station.supervisor.reopened == 1
        assert board.in_binary_mode


async def test_the_streams_come_back_with_the_board(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        for command, arguments in (("ahrs_on", ()), ("control_source", (1,)), ("autopilot_on", ())):
            assert (await station.commands.run(command, arguments)).state == "confirmed"
        board.unplug()
        board.plug_in()
        await eventually_async(lambda: board.flags["ahrs"] == 1, "the stream is on again")
        await eventually_async(lambda: board.flags["autopilot_hil"] & 2 == 2, "the source is the joystick again")
        assert board.flags["autopilot_hil"] & 1 == 0, "nobody but the operator switches an autopilot on"


async def test_only_the_period_of_the_heartbeats_own_task_says_when_it_is_missed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    station = a_station(tmp_path)
    expected_s: list[float] = []
    monkeypatch.setattr(station.board.session, "expect_heartbeat_every", expected_s.append)
    async with station.running():
        for command in ("set_servos_task_rate", "set_fms_task_rate", "ahrs_on"):
            station.rearming.command_done(command, () if command == "ahrs_on" else (3000,))
        assert expected_s == []
        station.rearming.command_done("set_parameter_task_rate", (2500,))
        assert expected_s == [2.5]
        assert station.memory.now.wanted.periods_ms == {
            "set_servos_task_rate": 3000,
            "set_fms_task_rate": 3000,
            "set_parameter_task_rate": 2500,
        }


async def test_a_board_that_restarts_while_the_cable_stays_is_armed_again(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await station.commands.run("ahrs_on")
        board.restart()
        # The silence between is too short to be sure of seeing it; the restarted board has every stream off.
        await eventually_async(lambda: board.flags["ahrs"] == 1, "the stream is on again")
        assert station.supervisor.reopened == 0


async def test_a_device_that_came_back_under_another_name_is_found(tmp_path: Path) -> None:
    places = {"usb-1": str(tmp_path / "ttyUSB0")}
    station = a_station(tmp_path)
    station.supervisor.find_devices_by(lambda _: "usb-1", places.get)
    first = FakeBoard(tmp_path / "ttyUSB0")
    async with station.running():
        with first:
            await station.lines.open_board(parse_address(f"serial://{first.path}"))
            await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await eventually_async(lambda: station.supervisor.state == "lost", "it is gone")
        places["usb-1"] = str(tmp_path / "ttyUSB7")
        with FakeBoard(tmp_path / "ttyUSB7"):
            await eventually_async(lambda: station.supervisor.state == "open", "it opens under the new name")
            assert station.supervisor.address == parse_address(f"serial://{tmp_path}/ttyUSB7")


async def test_closing_leaves_the_board_quiet_and_forgets_the_streams(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await station.commands.run("ahrs_on")
        await station.lines.close_board()
        await eventually_async(lambda: board.received[-2:] == ["stop", "exit_binary_mode"], "the farewell arrives")
        assert station.supervisor.state == "closed"
        assert station.memory.now.wanted.streams == set()
        assert station.memory.now.board_url is None


async def test_a_link_that_cannot_be_opened_changes_nothing(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        with pytest.raises(LinkError):
            await station.lines.open_board(parse_address(f"pty://{tmp_path}/nothing"))
        assert station.supervisor.address == parse_address(board.url)
        assert station.supervisor.state == "open"
        assert (await station.commands.run("ahrs_on")).state == "confirmed"


async def test_the_same_device_can_be_opened_again(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens again")
        assert board.count("exit_binary_mode") == 1


async def test_another_board_takes_the_place_of_the_first(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        with FakeBoard(tmp_path / "other") as other:
            await station.lines.open_board(parse_address(board.url))
            await eventually_async(lambda: station.supervisor.state == "open", "it opens")
            await station.lines.open_board(parse_address(other.url))
            await eventually_async(lambda: station.supervisor.state == "open", "the other opens")
            assert (await station.commands.run("ahrs_on")).state == "confirmed"
            assert other.flags["ahrs"] == 1
            assert board.count("exit_binary_mode") == 1
            assert board.flags["ahrs"] == 0


async def test_the_end_of_the_gateway_leaves_the_board_quiet_and_remembers_it(tmp_path: Path, board: FakeBoard) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await station.commands.run("ahrs_on")
    await eventually_async(lambda: board.received[-2:] == ["stop", "exit_binary_mode"], "the farewell arrives")
    again = a_station(tmp_path)
    async with again.running():
        await eventually_async(lambda: board.flags["ahrs"] == 1, "the next gateway carries on")


@pytest.mark.parametrize(
    ("asked", "url", "identity"),
    [
        (None, "serial:///dev/ttyUSB0", "usb-1"),
        ("serial:///dev/ttyUSB0", "serial:///dev/ttyUSB0", "usb-1"),
        ("serial:///dev/ttyUSB1", "serial:///dev/ttyUSB1", None),
        ("serial:///dev/a", "serial:///dev/a", None),
    ],
)
async def test_the_remembered_device_is_looked_for_only_where_its_own_board_is_wanted(
    tmp_path: Path, asked: str | None, url: str, identity: str | None
) -> None:
    station = a_station(tmp_path)
    station.memory.update(board_url="serial:///dev/ttyUSB0", board_identity="usb-1")
    station.lines.reopen(asked and "".join(asked))
    assert station.supervisor.address == parse_address(url)
    assert station.supervisor.identity == identity


async def test_a_remembered_board_that_is_not_there_yet_is_waited_for(tmp_path: Path) -> None:
    station = Flight(tmp_path / "data", record=False, board_url=f"pty://{tmp_path}/board")
    async with station.running():
        await eventually_async(lambda: station.supervisor.state == "lost", "it is missed")
        assert station.errors.counts["link_no_device"] == 1
        with FakeBoard(tmp_path / "board"):
            await eventually_async(lambda: station.supervisor.state == "open", "it opens when it comes")


async def test_a_board_at_a_name_that_no_network_can_have_is_told_and_another_can_be_opened(
    tmp_path: Path, board: FakeBoard
) -> None:
    station = Flight(tmp_path / "data", record=False, board_url="tcp://a..b:5")
    async with station.running():
        await eventually_async(lambda: station.supervisor.state == "lost", "the failure is told")
        assert station.errors.counts == {"link_unknown_host": 1}
        await station.supervisor.close()
        station.supervisor.want(parse_address(board.url), None)
        await eventually_async(lambda: station.supervisor.state == "open", "the board opens")


async def test_a_line_is_opening_until_its_board_is_heard_and_lost_when_it_falls_silent(
    tmp_path: Path, board: FakeBoard
) -> None:
    station = a_station(tmp_path)
    async with station.running():
        board.silent = True
        await station.lines.open_board(parse_address(board.url))
        assert state(station) == "opening"
        board.silent = False
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        board.silent = True
        later_s = (station.board.session.deadline_s or 0.0) + 1.0
        station.board.session.tick(later_s)
        assert state(station) == "lost"


async def test_a_device_without_an_identity_is_looked_for_under_its_name_only(tmp_path: Path) -> None:
    looked: list[str] = []

    def nobody(path: str) -> None:
        looked.append(path)

    station = a_station(tmp_path)
    station.supervisor.find_devices_by(nobody, lambda identity: looked.append(f"identity {identity}"))
    first = FakeBoard(tmp_path / "ttyUSB0")
    async with station.running():
        with first:
            await station.lines.open_board(parse_address(f"serial://{first.path}"))
            await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await eventually_async(lambda: station.supervisor.state == "lost", "it is gone")
        with FakeBoard(tmp_path / "ttyUSB0"):
            await eventually_async(lambda: station.supervisor.state == "open", "it opens again")
    assert looked
    assert set(looked) == {str(first.path)}


async def test_what_is_no_port_of_this_machine_is_not_looked_for_among_its_devices(tmp_path: Path) -> None:
    looked: list[str] = []
    station = a_station(tmp_path)
    station.supervisor.find_devices_by(looked.append, lambda _: None)
    for url in ("pty:///x", "serial:///dev/ttyUSB0", "tcp://h:1"):
        await station.supervisor._learn_identity(parse_address(url))
    assert looked == ["/dev/ttyUSB0"]


@pytest.mark.parametrize(("board_may", "others_may"), [(True, True), (True, False), (False, True), (False, False)])
async def test_bytes_wait_only_while_neither_the_board_nor_another_part_needs_them_at_once(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch, *, board_may: bool, others_may: bool
) -> None:
    station = a_station(tmp_path)
    async with station.running():
        monkeypatch.setattr(type(station.board), "may_wait", lambda _: board_may)
        monkeypatch.setattr(station.supervisor, "_others_may_wait", lambda: others_may)
        asked: list[bool] = []
        start = DescriptorLink.start

        def note(self: DescriptorLink, callbacks: LinkCallbacks) -> None:
            asked.append(callbacks.may_wait())
            start(self, callbacks)

        monkeypatch.setattr(DescriptorLink, "start", note)
        await station.lines.open_board(parse_address(board.url))
    assert asked == [board_may and others_may]


async def test_a_board_that_is_told_a_slow_heartbeat_is_waited_for_three_of_them(
    tmp_path: Path, board: FakeBoard
) -> None:
    station = a_station(tmp_path)
    async with station.running():
        await station.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: station.supervisor.state == "open", "it opens")
        await station.commands.run("set_parameter_task_rate", (2000,))

        def patience_s() -> float:
            session = station.board.session
            return (session.deadline_s or 0.0) - (session.heartbeat_s or 0.0)

        await eventually_async(lambda: abs(patience_s() - 6.0) < 1e-6, "6 s")
