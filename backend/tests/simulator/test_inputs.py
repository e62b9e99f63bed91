"""Commands from the station: which axis moves, which is given back, what is ignored."""

import math
import struct
from dataclasses import astuple

import pytest

from epf_gcs.simulator.inputs import Inputs
from epf_gcs.simulator.state import Controls

TRIM = Controls(-0.16, 0.03, 0.0, 0.71)
GIVE_BACK = -999.0


def datagram(*rows: tuple[int, list[float]], tag: int = 0) -> bytes:
    body = b"".join(struct.pack("<i8f", row, *values, *[GIVE_BACK] * (8 - len(values))) for row, values in rows)
    return b"DATA" + bytes([tag]) + body


def commanded(*datagrams: bytes) -> Inputs:
    inputs = Inputs(TRIM)
    for one in datagrams:
        command = inputs.parse(one)
        if command is not None:
            inputs.apply(command)
    return inputs


def test_with_no_command_the_pilot_has_the_controls_trimmed() -> None:
    inputs = commanded()
    assert inputs.controls() == TRIM
    assert inputs.stick() == Controls(0.0, 0.0, 0.0, 0.71)


def test_row_11_moves_the_surfaces_and_row_25_the_throttle() -> None:
    inputs = commanded(datagram((11, [0.25, -0.5, 0.125]), (25, [0.5] * 8)))
    assert inputs.controls() == Controls(0.25, -0.5, 0.125, 0.5)
    # The pilot's own stick has not moved: what rows 8 and 25 report is still the pilot's.
    assert inputs.stick() == Controls(0.0, 0.0, 0.0, 0.71)


def test_row_8_moves_the_stick_which_moves_the_surfaces_about_the_trim() -> None:
    inputs = commanded(datagram((8, [0.5, 0.25, -0.25])))
    assert inputs.stick() == Controls(0.5, 0.25, -0.25, 0.71)
    assert astuple(inputs.controls()) == pytest.approx((0.34, 0.28, -0.25, 0.71))


def test_minus_999_gives_one_axis_back_and_leaves_the_others() -> None:
    inputs = commanded(datagram((11, [0.25, 0.5, 0.75])), datagram((11, [GIVE_BACK, 0.125, GIVE_BACK])))
    assert inputs.controls() == Controls(TRIM.elevator, 0.125, TRIM.rudder, TRIM.throttle)


def test_the_release_datagram_gives_everything_back() -> None:
    release = datagram((11, [GIVE_BACK] * 8), (25, [GIVE_BACK] * 8))
    assert commanded(datagram((11, [1.0, 1.0, 1.0]), (25, [1.0] * 8)), release).controls() == TRIM


def test_values_beyond_their_ends_are_clamped() -> None:
    inputs = commanded(datagram((11, [7.0, -7.0, 1.5]), (25, [-0.5])))
    assert inputs.controls() == Controls(1.0, -1.0, 1.0, 0.0)


def test_a_value_that_is_not_finite_is_counted_and_its_axis_stays() -> None:
    inputs = commanded(datagram((11, [0.25, 0.25, 0.25])), datagram((11, [math.nan, math.inf, 0.5])))
    assert inputs.controls() == Controls(0.25, 0.25, 0.5, TRIM.throttle)
    assert inputs.counts.bad_values == 2


def test_unknown_rows_are_counted_and_the_known_ones_beside_them_work() -> None:
    inputs = commanded(datagram((77, [1.0]), (11, [0.5, 0.5, 0.5]), (-1, [1.0])))
    assert inputs.controls().elevator == 0.5
    assert inputs.counts.unknown_rows == 2


@pytest.mark.parametrize(
    "bad", [b"", b"X", b"DATA", b"DATA\0", b"DATA\0" + bytes(35), b"DREF\0" + bytes(36), b"A" * 41]
)
def test_a_bad_datagram_is_counted_and_changes_nothing(bad: bytes) -> None:
    inputs = commanded(bad)
    assert inputs.controls() == TRIM
    assert (inputs.counts.datagrams, inputs.counts.bad_datagrams) == (1, 1)


def test_any_tag_byte_is_taken() -> None:
    assert commanded(datagram((25, [0.25]), tag=0x3C)).controls().throttle == 0.25
