"""Advice in flight is an event like others: told once, and kept in the recording."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import pytest

from epf_gcs.contract.inspector import AdviceCode, AdviceState
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.state import advised, inspection
from epf_gcs.flight.state.advised import AdviceWatch
from epf_gcs.flight.state.sources import StateSources
from epf_gcs.link.address import parse_address
from epf_gcs.recordings.notes import EVENT
from epf_gcs.recordings.reading import notes_of
from epf_gcs.vehicle.outside import Outlet
from tests.support.fake_board import FakeBoard
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async


def watch() -> AdviceWatch:
    """One of which only the choice of what is new is asked."""
    return AdviceWatch(cast("StateSources", None), cast("Outlet", None))


def piece(code: AdviceCode, **params: Any) -> AdviceState:
    return AdviceState(code, "info", code, params)


def codes(found: list[AdviceState]) -> list[str]:
    return [one.code for one in found]


def test_advice_is_told_when_it_begins_and_not_while_it_lasts() -> None:
    looks = watch()
    assert codes(looks.new_of([piece("line_full", direction="rx")])) == ["line_full"]
    assert looks.new_of([piece("line_full", direction="rx")]) == []
    assert codes(looks.new_of([piece("line_full", direction="rx"), piece("line_full", direction="tx")])) == [
        "line_full"
    ]


@pytest.mark.parametrize(
    ("code", "about", "first", "second"),
    [
        ("row_missing", "row", 3, 17),
        ("line_full", "direction", "rx", "tx"),
        ("stream_slow", "topic", "ahrs", "gps"),
    ],
)
def test_advice_about_something_else_is_told_beside_what_lasts(
    code: AdviceCode, about: str, first: object, second: object
) -> None:
    looks = watch()
    one, other = piece(code, **{about: first}), piece(code, **{about: second})
    assert looks.new_of([one]) == [one]
    assert looks.new_of([one, other]) == [other]
    assert looks.new_of([other, one]) == []


def test_advice_whose_numbers_change_is_no_news_and_other_advice_is() -> None:
    looks = watch()
    looks.new_of([piece("frames_damaged", percent=2.0)])
    assert looks.new_of([piece("frames_damaged", percent=3.0)]) == []
    assert codes(looks.new_of([piece("round_trip_long", ms=130)])) == ["round_trip_long"]


def test_advice_that_comes_and_goes_is_told_again_after_a_minute_without_it() -> None:
    looks = watch()
    row = piece("row_missing", row=3)
    assert looks.new_of([row]) == [row]
    for _ in range(4):
        assert looks.new_of([]) == []
    assert looks.new_of([row]) == []
    for _ in range(5):
        assert looks.new_of([]) == []
    assert looks.new_of([row]) == [row]


@pytest.mark.anyio
async def test_what_was_advised_is_in_the_recording(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(advised, "_EVERY_S", 0.05)
    monkeypatch.setattr(inspection, "_SILENT_S", 0.1)
    flight = Flight(tmp_path)
    async with flight.running():
        await flight.lines.open_board(parse_address(board.url))
        await eventually_async(lambda: flight.recorder is not None and flight.recorder.file is not None, "it records")
        port = free_udp_port()
        await flight.lines.open_simulator(SimulatorAddress(port, "127.0.0.1", free_udp_port(), "xp10"))
        # On a busy computer something else may be advised first.
        await eventually_async(
            lambda: any(code == "simulator_silent" for code, _ in flight._advised._seen), "it is advised"
        )
    (file,) = (tmp_path / "recordings").glob("*.mcap")
    noted = [note.content for note in notes_of(file) if note.name == EVENT]
    (silent,) = [one["data"] for one in noted if one["event"] == "advice" and one["data"]["code"] == "simulator_silent"]
    assert silent["params"] == {"port": port}
    assert str(port) in silent["text"]
