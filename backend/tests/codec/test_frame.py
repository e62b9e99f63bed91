"""The decoder gives the same frames however the line cuts, breaks or pads them."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.encode import encode_command, encode_telemetry
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Damage, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import TO_PC_HEADER
from tests.codec.streams import mixed_frames
from tests.codec.vectors import decode, direction, dropped, failures, frames, good_frames, load

STREAMS = load("stream.jsonl")
TELEMETRY = load("telemetry.jsonl")
HEARTBEAT = good_frames()[0]
LONG_FALSE_HEADER = TO_PC_HEADER + (0x8000000B).to_bytes(4, "little")


@pytest.mark.parametrize("vector", STREAMS, ids=lambda vector: vector["case"])
@pytest.mark.parametrize("chunk", [1, 2, 3, 7, 16, 4096])
def test_streams_with_damage_give_the_frames_that_are_intact(vector: dict[str, Any], chunk: int) -> None:
    stream = bytes.fromhex("".join(part["hex"] for part in vector["parts"]))
    events = decode(stream, chunk, direction(vector["direction"]))
    assert frames(events) == [(frame["type"], frame["payload"]) for frame in vector["frames"]]
    assert failures(events) == vector["failed"]
    assert len(dropped(events)) == vector["dropped"]


@pytest.mark.parametrize("vector", TELEMETRY, ids=lambda vector: f"{vector['case']} {vector['sent']}")
def test_captured_frames_are_accepted_or_refused_for_the_right_reason(vector: dict[str, Any]) -> None:
    events = decode(bytes.fromhex(vector["hex"]) + HEARTBEAT * 2, 5)
    names = [event.message.name for event in events if isinstance(event, Frame)]
    if "refused" in vector:
        assert names == ["heartbeat", "heartbeat"]
        assert failures(events) == {vector["refused"]: 1}
    else:
        assert names == [vector["message"], "heartbeat", "heartbeat"]
        assert not dropped(events)


def test_cut_points_do_not_matter() -> None:
    for vector in STREAMS:
        stream = bytes.fromhex("".join(part["hex"] for part in vector["parts"]))
        way = direction(vector["direction"])
        whole = FrameDecoder(way).feed(stream)
        for cut in range(len(stream) + 1):
            decoder = FrameDecoder(way)
            assert decoder.feed(stream[:cut]) + decoder.feed(stream[cut:]) == whole, vector["case"]


@given(
    pieces=st.lists(st.one_of(st.sampled_from(good_frames()), st.binary(max_size=40)), max_size=12),
    chunk=st.integers(1, 50),
)
def test_noise_never_raises_and_never_hides_the_next_frame(pieces: list[bytes], chunk: int) -> None:
    stream = b"".join(pieces) + HEARTBEAT
    events = decode(stream, chunk)
    assert events == decode(stream, len(stream))
    accepted = [frame.hex() for frame in pieces if frame in set(good_frames())]
    found = [payload for _, payload in frames(events)]
    # Random bytes cannot make up a frame here, so what is found is what was put in.
    assert found == [frame[16:-16] for frame in [*accepted, HEARTBEAT.hex()]]


@given(st.lists(st.sampled_from([b"\rQT,", LONG_FALSE_HEADER, b"\r\n\r\n", b"\r", b"Q", HEARTBEAT]), max_size=20))
def test_every_byte_is_in_a_frame_or_reported_in_order(pieces: list[bytes]) -> None:
    stream = b"".join(pieces)
    rebuilt = b""
    for event in decode(stream, 3):
        if isinstance(event, Frame):
            rebuilt += HEARTBEAT
        else:
            rebuilt += event.data
    assert rebuilt == stream


def test_text_comes_out_at_each_line_end_without_waiting_for_a_frame() -> None:
    decoder = FrameDecoder()
    assert decoder.feed(b"\rk_elev 1.0\n\rk_air") == [Damage("noise", b"\rk_elev 1.0\n")]
    assert decoder.feed(b"ln 0.6\n") == [Damage("noise", b"\rk_airln 0.6\n")]


def test_a_prompt_without_line_end_comes_out_when_the_line_is_silent() -> None:
    decoder = FrameDecoder()
    assert decoder.feed(b"ready> ") == []
    assert decoder.flush() == [Damage("noise", b"ready> ")]
    assert decoder.flush() == []


def test_text_behind_a_damaged_frame_is_text_again() -> None:
    broken = bytearray(HEARTBEAT)
    broken[9] ^= 1
    events = FrameDecoder().feed(bytes(broken) + b"\rhello\n")
    assert [event.kind for event in events if isinstance(event, Damage)] == ["bad_checksum", "remains", "noise"]
    assert events[-1] == Damage("noise", b"\rhello\n")


def test_text_behind_a_damaged_frame_without_end_marker_is_text_again_behind_the_longest_frame() -> None:
    header = HEARTBEAT[:4] + b"\xff\xff\xff\xff"
    events = FrameDecoder().feed(header + b"x" * 252 + b"hello\n")
    assert [(event.kind, len(event.data)) for event in events if isinstance(event, Damage)] == [
        ("bad_type_bits", 4),
        ("remains", 256),
        ("noise", 6),
    ]


def test_text_behind_the_good_frame_that_follows_a_damaged_one_is_text() -> None:
    events = FrameDecoder().feed(HEARTBEAT[:9] + HEARTBEAT * 2 + b"hello\n")
    assert [getattr(event, "kind", "frame") for event in events] == ["bad_end", "remains", "frame", "frame", "noise"]


def test_noise_without_line_ends_is_handed_out_in_bounded_pieces() -> None:
    events = FrameDecoder().feed(b"\x55" * 1000)
    assert [len(event.data) for event in events if isinstance(event, Damage)] == [256, 256, 256]


def test_a_false_header_does_not_hold_back_a_frame_when_the_line_is_silent() -> None:
    decoder = FrameDecoder()
    assert decoder.feed(LONG_FALSE_HEADER + HEARTBEAT) == []
    events = decoder.flush()
    assert failures(events) == {"cut_short": 1}
    assert [event.message.name for event in events if isinstance(event, Frame)] == ["heartbeat"]


def test_silence_inside_a_good_frame_loses_nothing() -> None:
    for cut in range(1, len(HEARTBEAT)):
        decoder = FrameDecoder()
        assert decoder.feed(HEARTBEAT[:cut]) == []
        assert decoder.flush() == []
        assert len(frames(decoder.feed(HEARTBEAT[cut:]))) == 1


def test_the_end_of_the_line_reports_what_was_cut_short() -> None:
    decoder = FrameDecoder()
    decoder.feed(HEARTBEAT[:17])
    events = decoder.finish()
    assert failures(events) == {"cut_short": 1}
    assert dropped(events) == HEARTBEAT[:17]
    assert frames(decoder.feed(HEARTBEAT)) == [(0, HEARTBEAT[8:-8].hex())]


def test_the_weak_checksum_alone_does_not_decide() -> None:
    good = encode_telemetry("statistics", 40, 60)
    for bit in (28, 29, 30):
        flipped = bytearray(good)
        flipped[7] ^= 1 << (bit - 24)
        checksum = int.from_bytes(flipped[12:16], "little")
        flipped[12:16] = ((checksum - (1 << bit)) & 0xFFFFFFFF).to_bytes(4, "little")
        assert failures(decode(bytes(flipped), 99)) == {"bad_type_bits": 1}


def test_both_directions_have_their_own_frames() -> None:
    command = encode_command("set_fms_task_rate", 250)
    assert frames(decode(command, 4, TO_BOARD)) == [(47, "fa000000")]
    assert frames(decode(command, 4, FROM_BOARD)) == []


def test_values_are_those_of_the_wire_in_the_order_of_the_definition() -> None:
    (frame,) = FrameDecoder().feed(encode_telemetry("ahrs", 270.0, 2.5, -10.25))
    assert isinstance(frame, Frame)
    assert frame.values == (270.0, 2.5, -10.25)


def test_what_is_missing_is_exactly_what_makes_the_next_frame_whole() -> None:
    decoder = FrameDecoder()
    decoder.feed(HEARTBEAT)
    for frame in mixed_frames(100, seed=7):
        place = 0
        found: list[Frame | Damage] = []
        while not found:
            missing = decoder.missing_bytes
            assert 0 < missing <= len(frame) - place, "never more than the frame still takes"
            found = decoder.feed(frame[place : place + missing])
            place += missing
        assert place == len(frame)
        assert len(frames(found)) == 1


def test_with_the_next_bytes_in_hand_a_stream_is_cut_into_whole_frames() -> None:
    decoder = FrameDecoder()
    made = mixed_frames(100, seed=7)
    stream = b"".join(made)
    assert decoder.missing_with(stream[:7]) == 0, "seven bytes do not say what begins here"
    # The first piece ends within a frame: what the decoder holds and what comes next tell its length together.
    assert decoder.feed(stream[:5]) == []
    place, pieces = 5, [stream[:5]]
    while place < len(stream):
        missing = decoder.missing_with(stream[place : place + 8])
        pieces.append(stream[place : place + missing])
        assert len(frames(decoder.feed(pieces[-1]))) == 1
        place += missing
    assert pieces[0] + pieces[1] == made[0]
    assert pieces[2:] == made[1:]


def test_the_least_is_never_more_than_the_next_frame_takes() -> None:
    stream = b"noise\n" + HEARTBEAT[:9] + b"".join(mixed_frames(60, seed=8)) + b"text" + HEARTBEAT
    for step in (1, 5, 12, 40):
        decoder = FrameDecoder()
        promised = 0
        for place in range(0, len(stream), step):
            for byte in stream[place : place + step]:
                found = decoder.feed(bytes((byte,)))
                promised -= 1
                assert promised <= 0 or not frames(found), "a frame was whole before it was said to be possible"
            promised = decoder.missing_bytes


def test_among_text_and_noise_nobody_knows_what_is_missing() -> None:
    decoder = FrameDecoder()
    assert decoder.missing_bytes == 0
    decoder.feed(b"a text")
    assert decoder.missing_bytes == 0
    decoder.feed(HEARTBEAT)
    assert decoder.missing_bytes > 0
    decoder.feed(b"a text\n")
    assert decoder.missing_bytes == 0
    decoder.feed(HEARTBEAT[:10])
    assert decoder.missing_bytes == len(HEARTBEAT) - 10
    decoder.finish()
    assert decoder.missing_bytes == 0


def test_a_type_that_nobody_knows_is_told_as_soon_as_it_is_there() -> None:
    decoder = FrameDecoder()
    assert decoder.feed(TO_PC_HEADER + bytes(3)) == []
    assert failures(decoder.feed(bytes(1))) != {}


def test_a_silent_line_gives_a_frame_that_stands_behind_two_false_headers() -> None:
    false = max(mixed_frames(100, seed=7), key=len)[:8]
    decoder = FrameDecoder()
    assert decoder.feed(false + false + HEARTBEAT) == []
    assert len(frames(decoder.flush())) == 1
