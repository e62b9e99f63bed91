"""A board that opens again within one link: the same as before, or started anew."""

from __future__ import annotations

import pytest

from epf_gcs.codec.session import SessionState
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from epf_gcs.vehicle.restart import BoardRestart, Restart
from tests.support.fake_board import FakeBoard
from tests.support.waiting import eventually_async

QUIET = {"ahrs": False, "gps": False}
STREAMING = {"ahrs": True, "gps": False}


def test_an_uptime_below_what_it_must_be_is_a_restart() -> None:
    restart = BoardRestart()
    restart.link_opened("")
    assert restart.opened(100.0, 1e9, 50_000, QUIET) is None, "the first time nothing is known"
    restart.fell_silent(STREAMING)
    assert restart.opened(160.0, 2e9, 4_000, QUIET) == Restart(2e9, 4_000)
    assert restart.opened(170.0, 3e9, 14_000, QUIET) is None, "it is told once"


def test_a_board_that_was_up_longer_after_its_restart_than_before_is_found_all_the_same() -> None:
    restart = BoardRestart()
    restart.opened(100.0, 1e9, 2_000, QUIET)
    restart.fell_silent(QUIET)
    assert restart.opened(110.0, 2e9, 5_000, QUIET) == Restart(2e9, 5_000), "12 s would be the same board"


@pytest.mark.parametrize("uptime_ms", [59_700, 60_000, 60_020])
def test_a_line_that_failed_for_a_while_is_no_restart(uptime_ms: int) -> None:
    restart = BoardRestart()
    restart.opened(100.0, 1e9, 50_000, STREAMING)
    restart.fell_silent(STREAMING)
    assert restart.opened(110.0, 2e9, uptime_ms, STREAMING) is None


@pytest.mark.parametrize(("late_s", "is_restart"), [(8.0, False), (12.0, True)])
def test_after_hours_the_board_s_slower_quartz_is_no_restart(late_s: float, is_restart: bool) -> None:
    restart = BoardRestart()
    restart.opened(500.0, 1e9, 500_000, QUIET)
    restart.fell_silent(QUIET)
    uptime_ms = round((10_000.0 - late_s) * 1000.0)
    assert restart.opened(10_000.0, 2e9, uptime_ms, QUIET) == (Restart(2e9, uptime_ms) if is_restart else None)


def test_a_count_that_begins_again_after_25_days_is_no_restart() -> None:
    restart = BoardRestart()
    restart.opened(0.0, 1e9, 0, QUIET)
    restart.fell_silent(QUIET)
    assert restart.opened(2**31 / 1000.0 + 5.0, 2e9, 5_000, QUIET) is None


def test_another_link_is_perhaps_another_board() -> None:
    restart = BoardRestart()
    restart.link_opened("serial:/dev/ttyUSB0")
    restart.opened(100.0, 1e9, 50_000, QUIET)
    for target in ("serial:/dev/ttyUSB1", "", ""):
        restart.fell_silent(QUIET)
        restart.link_opened(target)
        assert restart.opened(110.0, 2e9, 1_000, QUIET) is None
    restart.fell_silent(QUIET)
    restart.link_opened("")
    assert restart.opened(110.0, 2e9, None, QUIET) is None


def test_a_board_that_was_switched_off_and_on_has_restarted_also_if_the_line_was_lost() -> None:
    restart = BoardRestart()
    for steady_s, uptime_ms, found in (
        (100.0, 50_000, None),
        (110.0, 60_000, None),
        (120.0, 4_000, Restart(1e9, 4_000)),
        (130.0, 14_000, None),
    ):
        restart.link_opened("serial:/dev/ttyUSB0")
        assert restart.opened(steady_s, 1e9, uptime_ms, QUIET) == found


def test_a_deployed_board_on_a_line_that_was_opened_again_may_be_the_same() -> None:
    restart = BoardRestart()
    restart.link_opened("serial:/dev/ttyUSB0")
    restart.opened(1.0, 1e9, None, STREAMING)
    restart.link_opened("serial:/dev/ttyUSB0")
    assert restart.opened(5.0, 2e9, None, QUIET) is None


@pytest.mark.parametrize(
    ("before", "after", "text", "is_restart"),
    [
        (STREAMING, QUIET, False, True),
        (STREAMING, STREAMING, False, False),
        (STREAMING, STREAMING, True, True),
        (QUIET, QUIET, False, True),
        (STREAMING, {"ahrs": True, "gps": True}, False, False),
        ({"ahrs": True, "gps": True}, STREAMING, False, True),
        (STREAMING, {"ahrs": None, "gps": None}, False, True),
    ],
)
def test_a_deployed_board_is_known_by_what_it_forgot(
    before: dict[str, bool], after: dict[str, bool], text: bool, is_restart: bool
) -> None:
    restart = BoardRestart()
    restart.link_opened("")
    assert restart.opened(1.0, 1e9, None, before) is None
    restart.fell_silent(before)
    if text:
        restart.heard_text()
    assert restart.opened(5.0, 2e9, None, after) == (Restart(2e9, None) if is_restart else None)


def test_what_a_deployed_board_said_before_it_was_first_open_is_no_restart() -> None:
    restart = BoardRestart()
    restart.link_opened("")
    restart.heard_text()
    assert restart.opened(1.0, 1e9, None, STREAMING) is None
    restart.fell_silent(STREAMING)
    assert restart.opened(5.0, 2e9, None, STREAMING) is None


def test_half_a_second_is_forgiven_and_no_more() -> None:
    for late_ms, is_restart in ((490, False), (600, True)):
        restart = BoardRestart()
        restart.opened(100.0, 1e9, 50_000, QUIET)
        assert (restart.opened(110.0, 2e9, 60_000 - late_ms, QUIET) is not None) == is_restart


@pytest.mark.uncounted
@pytest.mark.anyio
@pytest.mark.parametrize("kind", ["board", "legacy_board"])
async def test_a_real_dialogue_with_a_board_that_starts_anew_shows_it(
    tmp_path: object, request: pytest.FixtureRequest, kind: str
) -> None:
    board: FakeBoard = request.getfixturevalue(kind)
    station = Flight(tmp_path / "data", record=False)  # type: ignore[operator]
    await station.supervisor.open(parse_address(board.url))
    restart = BoardRestart()
    restart.link_opened("")
    seen: list[Restart | None] = []
    was_open = False

    def look() -> bool:
        nonlocal was_open
        station.board.tick()
        heartbeat = station.telemetry.newest("heartbeat") or {}
        if station.board.is_open and not was_open:
            was_open = True
            uptime = station.board.capabilities().get("uptime_ms")
            known = None if uptime is None else int(float(uptime))
            seen.append(restart.opened(station.clock.steady_s(), 1.0, known, heartbeat))
        elif was_open and station.board.session.state is SessionState.OPENING:
            was_open = False
            restart.fell_silent(heartbeat)
        return was_open

    await eventually_async(look, "the board opens")
    if kind == "legacy_board":
        board.restart()
    else:
        # This board always says that it has been up for 5 ms.
        restart.opened(station.clock.steady_s(), 0.0, 5_000_000, {})
        board.restart()
    await eventually_async(lambda: not look(), "the silence is noticed")
    await eventually_async(look, "it opens again")
    assert seen[0] is None
    assert seen[-1] == Restart(1.0, None if kind == "legacy_board" else 5)
    station.supervisor.shut_down()
