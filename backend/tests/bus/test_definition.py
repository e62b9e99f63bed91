"""Records are the same whatever pieces they come in, and what is no record is refused."""

from __future__ import annotations

import orjson
import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.bus.definition import (
    MAX_BODY_BYTES,
    BusError,
    Decoder,
    Kind,
    pack,
    pack_event,
    pack_numbered,
    pack_sample,
    unpack_named,
    unpack_numbered,
    unpack_object,
)
from epf_gcs.contract.events import FlightProcessEvent

STREAM = b"".join(
    [
        pack(Kind.HELLO, b"{}"),
        pack_sample("ahrs", 1.5, {"roll_deg": -3.25, "pitch_deg": None}),
        pack_event(FlightProcessEvent("lost"), 2.5),
        pack_numbered(Kind.ANSWER, 7, {"result": [1, 2]}),
        pack(Kind.BYE, b""),
    ]
)


def test_cut_points_do_not_matter() -> None:
    whole = Decoder().feed(STREAM)
    assert [record.kind for record in whole] == [Kind.HELLO, Kind.SAMPLE, Kind.EVENT, Kind.ANSWER, Kind.BYE]
    for cut in range(len(STREAM) + 1):
        decoder = Decoder()
        assert decoder.feed(STREAM[:cut]) + decoder.feed(STREAM[cut:]) == whole
    decoder = Decoder()
    assert [record for byte in STREAM for record in decoder.feed(bytes([byte]))] == whole


def test_a_sample_is_text_that_a_viewer_gets_as_it_is() -> None:
    sample = unpack_named(Decoder().feed(STREAM)[1].body)
    assert (sample.name, sample.t_s) == ("ahrs", 1.5)
    assert orjson.loads(sample.text) == {
        "topic": "ahrs",
        "t_s": 1.5,
        "values": {"roll_deg": -3.25, "pitch_deg": None},
    }


def test_an_answer_keeps_its_number() -> None:
    assert unpack_numbered(Decoder().feed(STREAM)[3].body) == (7, {"result": [1, 2]})


@given(st.binary(max_size=200))
def test_noise_is_refused_or_waited_for_and_never_raises_anything_else(noise: bytes) -> None:
    try:
        for record in Decoder().feed(noise):
            unpack_named(record.body)
            unpack_numbered(record.body)
    except BusError:
        pass


@pytest.mark.parametrize("body", [b"", b"\x00" * 8, b"\x00" * 8 + b"\x09abc", b"\x00" * 8 + b"\x02\xff\xfe"])
def test_a_named_record_that_is_cut_is_refused(body: bytes) -> None:
    with pytest.raises(BusError):
        unpack_named(body)


@pytest.mark.parametrize("body", [b"", b"[1]", b"{", b"null"])
def test_what_is_no_object_is_refused(body: bytes) -> None:
    with pytest.raises(BusError):
        unpack_object(body)


def test_a_record_longer_than_any_is_refused_before_it_is_waited_for() -> None:
    with pytest.raises(BusError):
        Decoder().feed((MAX_BODY_BYTES + 1).to_bytes(4, "little") + b"\x02")


def test_the_time_of_a_sample_is_told_to_the_microsecond() -> None:
    (record,) = Decoder().feed(pack_sample("ahrs", 1.7e9 + 0.123456, {}))
    sample = unpack_named(record.body)
    assert sample.t_s == 1.7e9 + 0.123456
    assert orjson.loads(sample.text)["t_s"] == pytest.approx(1.7e9 + 0.123456, abs=1e-6)
