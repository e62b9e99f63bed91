"""What to do, in words."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.vehicle.advice import AdviceFacts, MissingRow, Stream, advice

GOOD = AdviceFacts(
    rx_percent=82.0,
    tx_percent=33.0,
    servos_percent=42.0,
    streams=(Stream("ahrs", 9.9, 10.0), Stream("servos_in", 49.9, 50.0)),
    round_trip_p99_ms=12.0,
)


def test_where_all_is_well_nothing_is_said() -> None:
    assert advice(AdviceFacts()) == []
    assert advice(GOOD) == []


@pytest.mark.parametrize(
    ("observed", "code", "level", "params", "words"),
    [
        (
            replace(GOOD, missing_rows=(MissingRow(20, "position"),)),
            "row_missing",
            "warning",
            {"row": 20, "name": "position"},
            "Row 20 (position) is not being sent: tick it",
        ),
        (
            replace(GOOD, missing_rows=(MissingRow(18, "alpha_beta_paths"),)),
            "row_missing",
            "info",
            {"row": 18, "name": "alpha_beta_paths"},
            "Row 18",
        ),
        (
            replace(GOOD, rx_percent=96.4, servos_percent=10.0),
            "line_full",
            "warning",
            {"percent": 96, "direction": "rx"},
            "The line from the board is 96 % full",
        ),
        (
            replace(GOOD, tx_percent=90.0),
            "line_full",
            "warning",
            {"percent": 90, "direction": "tx"},
            "The line to the board is 90 % full",
        ),
        (
            replace(GOOD, silent_port=49003, missing_rows=(MissingRow(20, "position"),)),
            "simulator_silent",
            "warning",
            {"port": 49003},
            "UDP port 49003",
        ),
        (
            replace(GOOD, silent_target="/dev/ttyUSB0"),
            "no_heartbeat",
            "warning",
            {"target": "/dev/ttyUSB0"},
            "No heartbeat comes from /dev/ttyUSB0",
        ),
        (
            replace(GOOD, silent_target="/dev/ttyUSB0", rubbish_at_baud=9600),
            "baud_wrong",
            "warning",
            {"baud": 9600},
            "at 9600 baud",
        ),
        (
            replace(GOOD, damaged_percent=2.34),
            "frames_damaged",
            "warning",
            {"percent": 2.3},
            "2.3 % of the board's frames",
        ),
        (replace(GOOD, round_trip_p99_ms=130.4), "round_trip_long", "warning", {"ms": 130}, "takes 130 ms"),
        (replace(GOOD, strangers=3), "foreign_datagrams", "info", {"count": 3}, "3 datagrams"),
        (
            replace(GOOD, streams=(Stream("ahrs", 7.9, 10.0), Stream("gps", 8.0, 10.0))),
            "stream_slow",
            "info",
            {"topic": "ahrs", "rate_hz": 7.9, "expected_hz": 10.0},
            "ahrs comes 7.9 times a second and should come 10.0 times",
        ),
    ],
)
def test_each_thing_that_is_wrong_is_said_once_with_its_values(
    observed: AdviceFacts, code: str, level: str, params: dict[str, object], words: str
) -> None:
    (found,) = advice(observed)
    assert (found.code, found.level, found.params) == (code, level, params)
    assert words in found.text


def test_on_a_full_line_that_the_servos_fill_their_rate_is_named_too() -> None:
    codes = [(one.code, one.params) for one in advice(replace(GOOD, rx_percent=96.0, servos_ms=20))]
    assert codes == [
        ("line_full", {"percent": 96, "direction": "rx"}),
        ("servo_rate_high", {"ms": 20, "percent": 42}),
    ]


def test_rates_are_said_with_one_decimal() -> None:
    (found,) = advice(replace(GOOD, streams=(Stream("ahrs", 2.34, 16.67),)))
    assert found.params == {"topic": "ahrs", "rate_hz": 2.3, "expected_hz": 16.7}
    assert "2.3 times a second and should come 16.7 times" in found.text


def test_the_servo_rate_is_named_from_its_limit_on_and_with_whole_percents() -> None:
    (_, found) = advice(replace(GOOD, rx_percent=90.0, servos_percent=42.4, servos_ms=40))
    assert found.params == {"ms": 40, "percent": 42}
    assert "take 42 % of the line at 40 ms" in found.text
    assert len(advice(replace(GOOD, rx_percent=90.0, servos_percent=None))) == 1
    assert len(advice(replace(GOOD, rx_percent=90.0, servos_percent=19.9))) == 1
    assert len(advice(replace(GOOD, rx_percent=90.0, servos_percent=20.0))) == 2
    assert advice(replace(GOOD, rx_percent=None, servos_percent=80.0)) == []


def test_limits_are_limits() -> None:
    assert advice(replace(GOOD, rx_percent=89.9, damaged_percent=1.0, round_trip_p99_ms=100.0)) == []
    assert advice(replace(GOOD, damaged_percent=2.0, damaged_limit_percent=2.5)) == []


@given(
    st.builds(
        AdviceFacts,
        silent_target=st.none() | st.text(),
        rx_percent=st.none() | st.floats(0, 300),
        tx_percent=st.none() | st.floats(0, 300),
        servos_percent=st.none() | st.floats(0, 300),
        damaged_percent=st.floats(0, 100),
        streams=st.lists(st.builds(Stream, st.text(), st.floats(0, 100), st.floats(0.1, 100))),
        silent_port=st.none() | st.integers(1, 65535),
        missing_rows=st.lists(st.builds(MissingRow, st.integers(0, 200), st.text())),
        strangers=st.integers(0),
        round_trip_p99_ms=st.none() | st.floats(0, 1e4),
    )
)
def test_warnings_come_first(observed: AdviceFacts) -> None:
    levels = [one.level for one in advice(observed)]
    assert levels == sorted(levels, key=["warning", "info"].index)


def test_many_slow_streams_are_one_hint_for_they_have_one_cause() -> None:
    slow = tuple(Stream(topic, 3.46, 10.0) for topic in ("ahrs", "gps", "servos_in"))
    few = advice(replace(GOOD, streams=slow[:2]))
    assert [(one.code, one.params["topic"]) for one in few] == [("stream_slow", "ahrs"), ("stream_slow", "gps")]
    (many,) = advice(replace(GOOD, streams=(*slow, Stream("heartbeat", 1.0, 1.0))))
    assert (many.code, many.level) == ("streams_slow", "info")
    assert many.params == {"number": 3, "list": "ahrs 3.5/10.0 Hz, gps 3.5/10.0 Hz, servos_in 3.5/10.0 Hz"}
    assert many.text == f"3 streams come slower than asked for: {many.params['list']}."


def test_of_many_things_that_are_wrong_at_once_each_is_said_the_lines_first() -> None:
    found = advice(
        AdviceFacts(
            silent_target="/dev/ttyUSB0",
            rx_percent=95.6,
            tx_percent=96.7,
            servos_percent=42.6,
            damaged_percent=2.0,
            streams=(Stream("ahrs", 1.0, 10.0), Stream("gps", 10.0, 10.0)),
            silent_port=49003,
            strangers=3,
            round_trip_p99_ms=130.6,
        )
    )
    assert [(one.code, one.params) for one in found] == [
        ("no_heartbeat", {"target": "/dev/ttyUSB0"}),
        ("line_full", {"percent": 96, "direction": "rx"}),
        ("line_full", {"percent": 97, "direction": "tx"}),
        ("frames_damaged", {"percent": 2.0}),
        ("simulator_silent", {"port": 49003}),
        ("round_trip_long", {"ms": 131}),
        ("servo_rate_high", {"ms": 20, "percent": 43}),
        ("foreign_datagrams", {"count": 3}),
        ("stream_slow", {"topic": "ahrs", "rate_hz": 1.0, "expected_hz": 10.0}),
    ]


def test_every_missing_row_is_named_and_those_that_can_be_replaced_last() -> None:
    missing = (MissingRow(17, "attitude"), MissingRow(18, "alpha_beta_paths"), MissingRow(20, "position"))
    found = advice(replace(GOOD, missing_rows=missing))
    assert [(one.level, one.params["row"]) for one in found] == [("warning", 17), ("warning", 20), ("info", 18)]
