"""The simulator's datagrams, byte for byte as the deployed station took and sent them."""

from __future__ import annotations

import math
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.xplane.datagram import Record, Surfaces, build, parse, release_datagram, surfaces_datagram
from epf_gcs.xplane.mapping import surfaces_from_servos_in
from tests.codec.vectors import load

VECTORS = load("simulator.jsonl")


def _values(hexadecimal: str) -> tuple[float, ...]:
    (frame,) = FrameDecoder().feed(bytes.fromhex(hexadecimal))
    assert isinstance(frame, Frame)
    return frame.values


def test_captured_datagrams_are_rows_and_others_are_not() -> None:
    taken = [vector for vector in VECTORS if "datagram_in_hex" in vector]
    for vector in taken:
        records = parse(bytes.fromhex(vector["datagram_in_hex"]))
        assert (records is None) == vector.get("dropped", False), vector["case"]
    assert sum(vector.get("dropped", False) for vector in taken) == 2


def test_rows_have_their_number_and_eight_values() -> None:
    records = parse(bytes.fromhex(VECTORS[0]["datagram_in_hex"]))
    assert records is not None
    assert [record.row for record in records] == [3, 4, 6, 8, 11, 16, 17, 18, 20, 25]
    assert records[3].values == (0.25, -0.5, 0.125, -999.0, -999.0, -999.0, -999.0, -999.0)


def test_a_datagram_made_again_is_the_captured_one() -> None:
    for vector in VECTORS:
        if "datagram_in_hex" in vector and "NaN" not in vector["case"] and not vector.get("dropped"):
            data = bytes.fromhex(vector["datagram_in_hex"])
            assert build(parse(data) or ()) == data


def test_servos_in_goes_to_the_simulator_as_captured() -> None:
    vector = next(vector for vector in VECTORS if vector["case"] == "servos_in moves the simulator")
    made = surfaces_datagram(surfaces_from_servos_in(_values(vector["board_in_hex"])))
    assert made is not None
    assert [made.hex()] == vector["datagrams_out_hex"]


def test_hil_surfaces_go_to_the_simulator_as_captured() -> None:
    vector = next(vector for vector in VECTORS if vector["case"] == "hil_surfaces moves it")
    made = surfaces_datagram(Surfaces(*_values(vector["board_in_hex"])))
    assert made is not None
    assert [made.hex()] == vector["datagrams_out_hex"]


def test_the_release_is_no_value_in_all_sixteen_as_captured() -> None:
    vector = VECTORS[-1]
    assert vector["event"] == "close"
    assert [release_datagram().hex()] == vector["datagrams_out_hex"]


@pytest.mark.parametrize("size", [0, 4, 5, 40, 42, 76, 78])
def test_anything_but_whole_records_is_refused(size: int) -> None:
    assert parse((b"DATA@" + bytes(100))[:size]) is None


def test_any_tag_byte_is_accepted() -> None:
    for tag in (0x00, 0x30, 0x40, 0xFF):
        assert parse(b"DATA" + bytes((tag,)) + struct.pack("<i8f", 3, *[1.0] * 8)) == [Record(3, (1.0,) * 8)]


@given(st.binary(max_size=200))
def test_no_datagram_makes_the_parser_raise(data: bytes) -> None:
    records = parse(data)
    assert records is None or len(records) * 36 + 5 == len(data)


@given(st.tuples(*[st.floats(width=32)] * 4))
def test_whatever_is_sent_is_finite_and_inside_the_limits(values: tuple[float, float, float, float]) -> None:
    made = surfaces_datagram(Surfaces(*values))
    if not all(math.isfinite(value) for value in values):
        assert made is None
        return
    assert made is not None
    records = parse(made)
    assert records is not None
    surfaces, throttle = records
    assert all(-1.0 <= value <= 1.0 for value in surfaces.values[:3])
    assert surfaces.values[3:] == (-999.0,) * 5
    assert len(set(throttle.values)) == 1
    assert 0.0 <= throttle.values[0] <= 1.0
