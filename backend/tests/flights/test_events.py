"""Events from notes and samples: what began and ended is one event."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from epf_gcs.errors import NotFoundError
from epf_gcs.flights import answers
from epf_gcs.flights.events import as_answer, find_events, read_events, write_events
from epf_gcs.flights.fields import FieldMeaning, fields_of
from epf_gcs.flights.flight_data import PeriodCache, Samples, TopicSpan
from epf_gcs.flights.summary import summarise
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Note
from epf_gcs.vehicle.parameters import GainRecord, gain_state

START_NS = 1_767_261_600_000_000_000


class MadeFlight:
    """A flight of these samples, {topic: (times in s, {field: values})}, and notes.

    All names are of the definition, as those of a real flight are.
    """

    def __init__(self, samples: dict[str, tuple[Any, dict[str, Any]]], noted: list[Note] | None = None) -> None:
        for topic, (_, fields) in samples.items():
            assert set(fields) <= set(fields_of(topic)), topic
        self._samples = samples
        self._notes = noted or []
        self.start_ns = START_NS
        self.end_ns = START_NS + round(max((float(t_s[-1]) for t_s, _ in samples.values()), default=60.0) * 1e9)

    def topics(self) -> list[TopicSpan]:
        return [
            TopicSpan(topic, len(t_s), START_NS + int(t_s[0] * 1e9), START_NS + int(t_s[-1] * 1e9))
            for topic, (t_s, _) in self._samples.items()
        ]

    def fields(self, topic: str) -> Mapping[str, FieldMeaning]:
        return fields_of(topic)

    def samples(self, topic: str, field: str) -> Samples:
        t_s, fields = self._samples.get(topic, ((), {}))
        if field not in fields:
            raise NotFoundError("signal_unknown", "no such field")
        return Samples(np.asarray(t_s, dtype=float), np.asarray(fields[field], dtype=float))

    def replace(self, topic: str, t_s: Any, fields: dict[str, Any]) -> None:
        self._samples[topic] = (t_s, fields)

    def notes(self) -> list[Note]:
        return self._notes


def noted(at_s: float, event: str, **data: Any) -> Note:
    return Note(START_NS + round(at_s * 1e9), notes.EVENT, {"event": event, "data": data})


def found(flight: MadeFlight) -> list[tuple[str, str, float, float | None]]:
    """Kind, name, begin and end of each event, in seconds since the start."""
    return [
        (
            event.kind,
            event.name,
            (event.t_ns - START_NS) * 1e-9,
            None if event.until_ns is None else (event.until_ns - START_NS) * 1e-9,
        )
        for event in find_events(flight, [], [])
    ]


def test_a_command_and_its_outcome_are_one_event() -> None:
    flight = MadeFlight(
        {},
        [
            noted(1, "command", id=7, name="ahrs_on", state="pending"),
            noted(2, "command", id=8, name="ahrs_off", state="pending"),
            noted(3, "command", id=7, name="ahrs_on", state="confirmed"),
        ],
    )
    assert found(flight) == [("command", "ahrs_on", 1.0, 3.0), ("command", "ahrs_off", 2.0, None)]
    assert [event.data["state"] for event in find_events(flight, [], [])] == ["confirmed", "pending"]


def test_an_alarm_lasts_from_its_coming_to_its_going_also_when_it_is_acknowledged() -> None:
    flight = MadeFlight(
        {},
        [
            noted(1, "alarm", id="battery_low", active=True, acknowledged=False),
            noted(2, "alarm", id="battery_low", active=True, acknowledged=True),
            noted(5, "alarm", id="battery_low", active=False, acknowledged=True),
            noted(6, "alarm", id="battery_low", active=False, acknowledged=True),
            noted(7, "alarm", id="battery_low", active=True, acknowledged=False),
        ],
    )
    assert found(flight) == [("alarm", "battery_low", 1.0, 5.0), ("alarm", "battery_low", 7.0, None)]


def test_brief_alarms_that_come_again_and_again_are_one_event() -> None:
    def sounded(name: str, *spans: tuple[float, float]) -> list[Note]:
        return [
            noted(at_s, "alarm", id=name, active=at_s == begin, acknowledged=False)
            for begin, end in spans
            for at_s in (begin, end)
        ]

    brief = sounded(
        "hil_lost", (1.0, 1.1), (4.0, 4.1), (9.0, 9.1), (40.0, 44.0), (46.0, 46.1), (90.0, 94.0), (96.0, 99.0)
    )
    flight = MadeFlight({}, sorted([*brief, *sounded("gps_lost", (5.0, 5.1))], key=lambda note: note.t_ns))
    assert found(flight) == [
        ("alarm", "hil_lost", 1.0, pytest.approx(9.1)),
        ("alarm", "gps_lost", 5.0, pytest.approx(5.1)),
        ("alarm", "hil_lost", 40.0, pytest.approx(46.1)),
        ("alarm", "hil_lost", 90.0, 94.0),
        ("alarm", "hil_lost", 96.0, 99.0),
    ]
    first = find_events(flight, [], [])[0]
    assert (first.data["times"], first.data["lasted_s"]) == (3, pytest.approx(0.3))


def test_stick_limits_and_who_moves_the_surfaces_are_events_where_they_change() -> None:
    flight = MadeFlight(
        {},
        [
            noted(0, "limits", battery_low_v=10.5, hil_lost_s=0.5),
            noted(0, "hil", path="manual", source="joystick"),
            noted(1, "stick", source="gamepad", state="live", reason="chosen", gamepad="Xbox"),
            noted(2, "hil", path="manual", source="radio"),
            noted(3, "hil", path="assisted", source="radio"),
            noted(4, "limits", battery_low_v=11.0, hil_lost_s=0.5),
            noted(5, "limits", battery_low_v=11.0, hil_lost_s=0.5),
        ],
    )
    assert found(flight) == [
        ("stick", "gamepad", 1.0, None),
        ("mode", "assisted", 3.0, None),
        ("limits", "battery_low_v", 4.0, None),
    ]
    told = find_events(flight, [], [])
    assert (told[1].data, told[2].data) == ({"on": True}, {"before": 10.5, "after": 11.0})


def test_advice_is_an_event_of_its_own_by_its_code() -> None:
    flight = MadeFlight({}, [noted(3, "advice", code="line_full", level="warning", text="full", params={})])
    assert found(flight) == [("advice", "line_full", 3.0, None)]


def test_modes_and_waypoints_are_found_in_the_samples() -> None:
    t_s = np.arange(5.0)
    flight = MadeFlight(
        {
            "heartbeat": (t_s, {"autopilot_hil": [0, np.nan, 1, 1, 0]}),
            "fms_hil_plan": (t_s, {"waypoint": [np.nan, 0, 0, 1, np.nan]}),
        }
    )
    assert found(flight) == [
        ("mode", "autopilot_hil", 2.0, None),
        ("waypoint", "hil", 3.0, None),
        ("mode", "autopilot_hil", 4.0, None),
    ]
    assert [event.data for event in find_events(flight, [], [])] == [
        {"on": True},
        {"from": 0, "to": 1},
        {"on": False},
    ]


def test_events_are_the_same_after_they_were_written(tmp_path: Path) -> None:
    mark = Note(START_NS + 10**9, notes.MARK, {"text": "¡aquí!", "by": "Ana", "id": "m1"})
    events = find_events(
        MadeFlight({}, [mark, noted(2, "console", direction="sent", text="ls")]),
        [(START_NS + 3 * 10**9, START_NS + 4 * 10**9)],
        [],
    )
    write_events(tmp_path / "events.parquet", events)
    assert read_events(tmp_path / "events.parquet") == events
    first, _, last = as_answer(events, START_NS).events
    assert (first.kind, first.id, first.data["text"], first.at_s) == ("mark", "m1", "¡aquí!", 1.0)
    assert last.until_s is not None
    assert (last.kind, last.at_s, last.until_s - last.t_s) == ("gap", 3.0, 1.0)


def circle(seconds: float = 600.0) -> MadeFlight:
    """A circle of 1000 m round 28 N 15 W at 50 m/s, climbing to 300 m; the receiver has no fix at first."""
    t_s = np.arange(0, seconds, 0.2)
    angle = t_s * 50.0 / 1000.0
    fix = np.where(t_s < 10.0, 0.0, 3.0)
    return MadeFlight(
        {
            "gps": (
                t_s,
                {
                    "latitude_deg": np.where(fix > 0, 28.0 + 1000.0 / 111_195.0 * np.sin(angle), 0.0),
                    "longitude_deg": np.where(
                        fix > 0, -15.0 + 1000.0 / 111_195.0 / np.cos(np.radians(28.0)) * np.cos(angle), 0.0
                    ),
                    "altitude_m": np.minimum(300.0, t_s),
                    "speed_kt": np.full(len(t_s), 97.2),
                    "fix": fix,
                    "valid": (fix > 0).astype(float),
                },
            )
        },
        [Note(START_NS, notes.IDENTITY, {"station": "1.0", "board": {"firmware_name": "EPF"}, "operator": 5})],
    )


def test_the_figures_of_the_row_are_those_of_the_flight() -> None:
    row = summarise(circle(), [])
    assert row.thumbnail is not None
    assert row.distance_nm is not None
    assert row.highest_ft == 984.3
    assert row.fastest_kt == 97.2
    assert abs(row.distance_nm - 590.0 * 50.0 / 1852.0) < 0.05
    assert (row.station, row.board, row.operator, row.emulated) == ("1.0", "EPF", None, False)
    track = np.array(row.thumbnail.track)
    assert track.min() >= 0.0
    assert track.max() <= 1.0
    assert np.ptp(track, axis=0).min() > 0.95, "a circle stays one"
    assert len(row.thumbnail.altitude) == 80
    nothing = summarise(MadeFlight({}), [])
    assert (nothing.highest_ft, nothing.thumbnail) == (None, None)


def test_the_track_holds_no_point_without_a_fix_and_every_other() -> None:
    body = answers.track(circle(), "flight", None)
    assert body[:4] == b"EPT1"
    points = np.frombuffer(body[32:], dtype=[("t_ms", "<u4"), ("lat", "<i4"), ("lon", "<i4"), ("alt", "<i4")])
    assert int.from_bytes(body[12:16], "little") == len(points) == 2950
    assert (points["t_ms"][0], points["t_ms"][-1]) == (10_000, 599_800)
    assert points["lat"].min() > 27.9e7
    assert points["alt"][-1] == 300_000
    assert len(answers.track(circle(), "hil", None)) == 32
    assert len(answers.track(circle(), "flight", 100)) <= 32 + 100 * 16


def test_the_overview_shows_altitude_and_silence() -> None:
    flight = circle()
    t_s, fields = flight._samples["gps"]
    keep = (t_s < 200.0) | (t_s > 300.0)
    flight._samples["gps"] = (t_s[keep], {name: values[keep] for name, values in fields.items()})
    seen = answers.overview(flight, PeriodCache(), 60)
    assert seen.signal == "gps.altitude_m"
    assert seen.altitude_ft[25] is None
    assert seen.altitude_ft[-1] == 984.3
    ((begin, end),) = seen.gaps
    assert (round(begin), round(end)) == (200, 300)


def test_what_was_known_is_the_newest_note_before_the_moment() -> None:
    def plan(at_s: float, which: str, waypoints: Any) -> Note:
        return Note(START_NS + round(at_s * 1e9), notes.PLAN, {"plan": which, "waypoints": waypoints})

    # As the recorder writes them; two of a stranger's file are of no shape.
    known = GainRecord(value=2.5, state="confirmed", loaded=1.0)
    gains = {"k_pitch": asdict(gain_state("k_pitch", known)), "k_roll": 3, "k_VVI": {"value": "x", "state": []}}
    flight = MadeFlight(
        {},
        [
            plan(1, "hil", None),
            plan(5, "hil", [{"latitude_deg": 28.0}]),
            Note(START_NS + 3 * 10**9, notes.PARAMETERS, gains),
            Note(START_NS + 4 * 10**9, notes.PARAMETERS, "of no shape that we write"),
        ],
    )
    assert answers.known(flight, 0.5)["missions"] == {"flight": None, "hil": None}
    assert answers.known(flight, 4.9)["missions"]["hil"] == {"plan": "hil", "waypoints": None}
    assert answers.known(flight, 5.0)["missions"]["hil"]["waypoints"] == [{"latitude_deg": 28.0}]
    assert answers.known(flight, 2.0)["parameters"] is None
    then = {one.name: one for one in answers.known(flight, 9.0)["parameters"]}
    assert [getattr(then["k_pitch"], key) for key in ("value", "state", "loaded", "group")] == [
        2.5,
        "confirmed",
        1.0,
        "altitude",
    ]
    assert {then[name].state for name in ("k_roll", "k_VVI", "k_elev")} == {"unknown"}
    assert then["k_VVI"].value is None


def test_a_line_that_is_opened_is_told_once_and_its_silence_beside_it() -> None:
    line = {"line": "board", "open": True, "url": "pty:///b"}
    closed = Note(START_NS, notes.LINE, {"line": "simulator", "open": False})
    told = [
        Note(START_NS + 10**9, notes.LINE, line),
        noted(1.1, "link", board="opening", simulator="closed"),
        noted(1.5, "link", board="open", simulator="closed"),
        noted(20, "link", board="lost", simulator="closed"),
        noted(21, "link", board="lost", simulator="closed"),
        noted(30, "link", board="open", simulator="closed"),
        Note(START_NS + 40 * 10**9, notes.LINE, {**line, "open": False}),
        noted(40.1, "link", board="closed", simulator="closed"),
    ]
    assert [(kind, name, round(at_s, 3)) for kind, name, at_s, _ in found(MadeFlight({}, told))] == [
        ("link", "board_opened", 1.0),
        ("link", "", 20.0),
        ("link", "", 30.0),
        ("link", "board_closed", 40.0),
    ]
    again = [closed, told[0], told[0], closed, *told[1:]]
    assert found(MadeFlight({}, again)) == found(MadeFlight({}, told)), "nor is one that was never open closed"
    assert len(found(MadeFlight({}, told[1:3]))) == 2, "an old recording has no notes of lines"


def clocks(*noted: dict[str, Any]) -> tuple[float, bool]:
    row = summarise(MadeFlight({}, [Note(START_NS, notes.CLOCK, one) for one in noted]), [])
    return row.clock_ahead_s, row.clock_unsure


def test_the_last_word_about_the_clock_holds_for_the_whole_flight() -> None:
    unset = {"ahead_s": 0.0, "synchronised": False}
    assert clocks() == (0.0, False)
    assert clocks(unset) == (0.0, True)
    assert clocks(unset, {"ahead_s": 8.4e8, "synchronised": True}) == (8.4e8, False)
    assert clocks({"ahead_s": 1.9, "synchronised": None}) == (0.0, False)
    assert clocks({"ahead_s": "much"}, {"ahead_s": None}) == (0.0, False)
