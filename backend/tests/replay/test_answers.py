"""What was known and measured at the moment that a replay shows."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import KnownMission
from epf_gcs.contract.status import RoundTripMs
from epf_gcs.flights.answers import known
from epf_gcs.flights.growing import GrowingFlight
from epf_gcs.recordings import notes
from epf_gcs.replay.answers import build_inspector, build_known
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.timeline import Timeline
from epf_gcs.vehicle.own_gains import usable_rows
from tests.replay.recordings import SECOND_NS, STARTS_NS, flight, write
from tests.support.fake_board import own_row

GAIN = PARAMETERS[0].name
WAYPOINT = {"latitude_deg": 27.9, "longitude_deg": -15.4, "altitude_ft": 900.0, "speed_kt": 60.0}


def head_at(path: Path, at_s: float, *more: tuple[float, str, Any]) -> Playhead:
    made = flight(10.0) + [(STARTS_NS + round(then_s * SECOND_NS), name, content) for then_s, name, content in more]
    write(path / "20260101T120000Z.mcap", sorted(made, key=lambda one: one[0]))
    head = Playhead(Timeline(path / "20260101T120000Z.mcap"), Silence())
    head.advance(STARTS_NS + round(at_s * SECOND_NS))
    return head


def test_a_plan_and_gains_are_known_from_their_note_to_the_one_that_takes_them_away(tmp_path: Path) -> None:
    told = [
        (2.0, notes.PLAN, {"plan": "hil", "waypoints": [WAYPOINT]}),
        (2.0, notes.PARAMETERS, {GAIN: {"value": 0.5, "state": "loaded", "loaded": 0.5}}),
        (6.0, notes.PLAN, {"plan": "hil", "waypoints": None}),
    ]
    plans = [build_known(head_at(tmp_path, at_s, *told), at_s).missions for at_s in (1.0, 4.0, 8.0)]
    assert [plan.hil for plan in plans] == [
        None,
        KnownMission("hil", [Waypoint(**WAYPOINT)]),
        KnownMission("hil", None),
    ]
    assert plans[1].flight is None
    gains = build_known(head_at(tmp_path, 4.0, *told), 4.0).parameters
    assert {gain.name: gain.value for gain in gains or ()}[GAIN] == 0.5
    assert build_known(head_at(tmp_path, 1.0, *told), 1.0).parameters is None


def test_frames_and_rows_are_counted_up_to_the_moment_with_rate_jitter_and_last_values(tmp_path: Path) -> None:
    found = build_inspector(head_at(tmp_path, 5.0))
    ahrs = next(frame for frame in found.board if frame.name == "ahrs")
    assert 90 <= ahrs.count <= 101
    assert ahrs.jitter_ms is not None
    assert ahrs.values is not None
    assert 19.0 < ahrs.rate_hz < 21.0
    assert ahrs.jitter_ms > 0.0
    assert set(ahrs.values) == {"yaw_deg", "pitch_deg", "roll_deg"}
    assert sum(frame.damaged for frame in found.board) == 1, "the one that was spoiled before 5 s"
    row = next(row for row in found.rows if row.row == 17)
    assert row.count >= 90
    assert row.name != "row_17"
    assert found.link.rx_bytes_per_s > 0.0


def test_what_no_recording_tells_is_null_and_nothing_is_advised(tmp_path: Path) -> None:
    found = build_inspector(head_at(tmp_path, 5.0))
    assert found.advice == []
    assert found.link.round_trips is None
    assert found.link.round_trip_ms == RoundTripMs()


def test_the_boards_own_gains_are_known_as_they_were_then_and_the_finished_flight_says_the_same(tmp_path: Path) -> None:
    gain = asdict(usable_rows([own_row(0)])[0][0])
    held = {"value": 3.0, "state": "loaded", "loaded": 3.0, "heard_s": 1.0}
    table = {"state": "known", "gains": [gain]}

    def own(table: Any, **values: Any) -> dict[str, Any]:
        return {"event": "own_gains", "data": {"table": table, "values": values}}

    told = [
        (2.0, notes.EVENT, own(table, line_k_bank=held)),
        (5.0, notes.EVENT, own(None, line_k_bank={**held, "value": 4.0})),
        (8.0, notes.EVENT, own({**table, "state": "unknown"}, line_k_bank={**held, "value": None, "state": "unknown"})),
    ]
    values = []
    for at_s in (1.0, 4.0, 7.0, 9.0):
        then = build_known(head_at(tmp_path, at_s, *told), at_s).own
        assert then is None or [one.name for one in then.table.gains] == ["line_k_bank"]
        values.append(None if then is None else (then.table.state, then.values["line_k_bank"].value))
        growing = GrowingFlight(tmp_path / "20260101T120000Z.mcap")
        growing.advance()
        assert known(growing, at_s)["own"] == then
    assert values == [None, ("known", 3.0), ("known", 4.0), ("unknown", None)]
