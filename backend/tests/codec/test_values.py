"""What a frame says: names, units, oddities, and "no data" for what is not plausible."""

from __future__ import annotations

import struct
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import TELEMETRY
from epf_gcs.codec.tables import Value
from epf_gcs.codec.values import Meaning, _step, meaning, shortest, single
from tests.codec.vectors import load

ACCEPTED = [vector for vector in load("telemetry.jsonl") if "message" in vector]


def _meaning(frame: bytes) -> Meaning:
    (event,) = FrameDecoder().feed(frame)
    assert isinstance(event, Frame)
    return meaning(event)


@pytest.mark.parametrize("vector", ACCEPTED, ids=lambda vector: f"{vector['case']} {vector['sent']}")
def test_captured_frames_have_the_values_that_were_put_in(vector: dict[str, Any]) -> None:
    values, implausible = _meaning(bytes.fromhex(vector["hex"]))
    expected = {
        name: single(value) if isinstance(values[name], float) else value for name, value in vector["values"].items()
    }
    assert values == expected
    assert list(implausible) == vector["implausible"]


def test_every_topic_of_the_deployed_board_is_in_the_captures() -> None:
    assert {vector["message"] for vector in ACCEPTED} >= {m.name for m in TELEMETRY.values() if not m.extension}


def test_what_a_board_says_it_does_not_know_is_no_data_and_no_fault() -> None:
    nan = float("nan")
    values, implausible = _meaning(encode_telemetry("analog", *[nan] * 10))
    assert set(values.values()) == {None}
    assert implausible == ()
    values, implausible = _meaning(encode_telemetry("fms_plan", nan, nan, nan, -1, -1))
    assert set(values.values()) == {None}
    assert implausible == ()


def test_not_a_number_is_a_fault_where_there_is_always_a_value() -> None:
    nan = float("nan")
    assert _meaning(encode_telemetry("ahrs", nan, 0.0, 0.0)).implausible == ("yaw_deg",)
    assert _meaning(encode_telemetry("fms_plan", nan, nan, nan, -2, 100)).implausible == ("distance_m", "waypoint")


@pytest.mark.parametrize(
    ("raw", "satellites"),
    [
        (0x38, 8),
        (0x3132, 12),
        (0x3939, 99),
        (0x3830, 80),
        (8, None),
        (0x313233, None),
        (0x41, None),
        (0, None),
        (-1, None),
    ],
)
def test_satellites_are_ascii_digits(raw: int, satellites: int | None) -> None:
    values, implausible = _meaning(encode_telemetry("gps", 0, 0, 0, 0, 0, raw, 0x30, 0x41))
    assert values["satellites"] == satellites
    assert implausible == (() if satellites is not None else ("satellites",))


def test_one_heartbeat_byte_holds_autopilot_and_source() -> None:
    for raw, autopilot, joystick in ((0, False, False), (1, True, False), (2, False, True), (3, True, True)):
        values, _ = _meaning(encode_telemetry("heartbeat", *[0] * 10, raw, 0))
        assert (values["autopilot_hil"], values["source_joystick"]) == (autopilot, joystick)
    values, implausible = _meaning(encode_telemetry("heartbeat", *[0] * 10, 4, 2))
    assert values["autopilot_hil"] is None
    assert implausible == ("autopilot_hil", "source_joystick", "autotrim_hil")


def test_text_ends_at_the_first_zero_and_unprintable_text_is_no_data() -> None:
    values, _ = _meaning(encode_telemetry("capabilities", 1, 0b1011, b"epf-board", b"1.2.0\0junk", 1234))
    assert values == {
        "protocol_version": 1,
        "has_acknowledgements": True,
        "has_store": True,
        "has_sources": False,
        "has_missions": True,
        "has_card_alarm": False,
        "has_hil_steps": False,
        "describes_itself": False,
        "firmware_name": "epf-board",
        "firmware_version": "1.2.0",
        "uptime_ms": 1234,
    }
    assert _meaning(encode_telemetry("capabilities", 1, 0, b"\xffbad", b"\x01", 0)).implausible == (
        "firmware_name",
        "firmware_version",
    )


def test_a_limit_that_single_precision_rounds_is_still_inside() -> None:
    # Rounded, 99.99 is smaller and 0.1 is greater: as a lowest and as a highest value they must still be reached.
    step = _step(Value("gain", "number", 0, "plain", "A gain.", minimum=99.99, maximum=200.1))
    assert step.minimum <= single(99.99) < 99.99
    step = _step(Value("gain", "number", 0, "plain", "A gain.", minimum=0.0, maximum=0.1))
    assert step.maximum >= single(0.1) > 0.1


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_the_shortest_decimal_is_the_same_number_on_the_wire(value: float) -> None:
    assert struct.pack("<f", shortest(value)) == struct.pack("<f", value)


def test_the_shortest_decimal_is_the_one_that_people_typed() -> None:
    assert [shortest(single(typed)) for typed in (0.6, 99.99, 0.06, 40.0, 27.9319)] == [0.6, 99.99, 0.06, 40.0, 27.9319]
