"""What a recording's notes say, also where a stranger wrote them."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any, get_args

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import PARAMETERS
from epf_gcs.codec.values import meaning
from epf_gcs.contract.answers import FlightIdentity, GainStateName
from epf_gcs.vehicle.noted import gains_of, identity_of

UNKNOWN = tuple(asdict(FlightIdentity()))


def test_a_stations_note_is_taken_as_it_is() -> None:
    note = {
        "station": "1.0",
        "firmware": "2.0",
        "aircraft": "Ave",
        "operator": "Ana",
        "board": "EPF",
        "emulated": True,
    }
    assert asdict(identity_of(note)) == note


def test_a_board_has_the_name_that_its_capabilities_say() -> None:
    name, version = b"EPF".ljust(16, b"\0"), b"2.0".ljust(16, b"\0")
    (frame,) = FrameDecoder().feed(encode_telemetry("capabilities", 1, 0, name, version, 9))
    assert isinstance(frame, Frame)
    assert identity_of({"board": meaning(frame).values}).board == "EPF"


@pytest.mark.parametrize("content", [None, [], "text", 1, {}])
def test_without_a_note_nothing_is_known(content: Any) -> None:
    assert identity_of(content) == FlightIdentity()


@pytest.mark.parametrize("wrong", [1, True, [], {"firmware_name": 2}, {}])
def test_what_is_no_text_is_not_known(wrong: Any) -> None:
    assert identity_of(dict.fromkeys((*UNKNOWN, "more"), wrong)) == FlightIdentity(emulated=wrong is True)


def test_gains_are_given_with_their_limits_and_what_is_no_number_is_not_known() -> None:
    first, second, third, *others = PARAMETERS
    found = gains_of(
        {
            first.name: {"value": 1.5, "state": "confirmed", "loaded": 2},
            second.name: {"value": True, "state": "flown", "loaded": "2"},
            third.name: "rubbish",
            "more": {"value": 1.0},
        }
    )
    known = [(one.name, one.value, one.loaded, one.state) for one in found]
    assert known == [
        (first.name, 1.5, 2, "confirmed"),
        *((one.name, None, None, "unknown") for one in (second, third, *others)),
    ]
    assert [(one.minimum, one.maximum, one.default, one.unit) for one in found] == [
        (one.minimum, one.maximum, one.default, "1") for one in PARAMETERS
    ]
    assert [(one.group, one.step, one.is_integer, one.doc) for one in found] == [
        (one.group, one.step, one.is_integer, one.doc) for one in PARAMETERS
    ]


@pytest.mark.parametrize("state", get_args(GainStateName))
def test_every_state_that_a_gain_of_a_station_can_have_is_known(state: str) -> None:
    (first, *_) = gains_of({PARAMETERS[0].name: {"value": 1.0, "state": state, "loaded": None}})
    assert first.state == state
