"""Reading goes on behind damage: at the next whole record, with what is left out counted."""

from __future__ import annotations

import io
import random
import re
import struct
from dataclasses import replace
from pathlib import Path

import pytest

from epf_gcs.recordings.limits import LIMITS
from epf_gcs.recordings.mcap_file import message_record, opening
from epf_gcs.recordings.reading import Reader, read_file, walk
from epf_gcs.recordings.scan import PAYLOAD_AT
from epf_gcs.recordings.topics import TOPICS
from tests.recordings.files import EVERY_NS, START_NS, Said, heard, mark, messages, plain, said_by
from tests.recordings.test_reading import RUBBISH

FLIPS = 200


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "20260131T120000Z.mcap"


def lines(count: int) -> list[Said]:
    """Messages as long as those of a flight."""
    rng = random.Random(3)
    return [(rng.choice(list(TOPICS)), START_NS + index * EVERY_NS, rng.randbytes(200)) for index in range(count)]


def left_out(damage: str | None) -> int:
    """How many bytes are no records."""
    found = re.search(r"(\d+) bytes are no records and were left out", damage or "")
    return int(found[1]) if found else 0


@pytest.mark.parametrize("byte", range(8))
def test_a_wrong_length_costs_its_own_message_and_no_other(
    path: Path, byte: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("epf_gcs.recordings.parts._BLOCK_BYTES", 60_000)
    said = lines(4000)
    whole = b"".join(plain(said, mark_every=500))
    damaged = 1700
    length_at = whole.index(said[damaged][2]) - PAYLOAD_AT + 1 + byte
    for flip in (0x01, 0x80):
        path.write_bytes(whole[:length_at] + bytes([whole[length_at] ^ flip]) + whole[length_at + 1 :])
        recording = read_file(path)
        read = said_by(recording)
        # A length that is too short leaves the message's first bytes.
        assert [one for one in read if one in said] == said[:damaged] + said[damaged + 1 :]
        assert all(one[2] == said[damaged][2][: len(one[2])] for one in read if one not in said)
        assert 0 < left_out(recording.damage) <= PAYLOAD_AT + len(said[damaged][2])
        assert (recording.is_whole, len(recording.notes)) == (True, 8)
        assert heard(walk(path)) == read


def test_of_a_file_with_200_changed_bytes_all_but_the_changed_messages_are_read(path: Path) -> None:
    said = lines(3500)
    body, end = plain(said, mark_every=100)
    whole = body + end
    begin = len(opening("test 1.0", TOPICS))
    for seed in range(20):
        rng, damaged = random.Random(seed), bytearray(whole)
        for at in rng.sample(range(begin, len(body)), FLIPS):
            damaged[at] ^= rng.randrange(1, 256)
        path.write_bytes(damaged)
        recording = read_file(path)
        same = set(said_by(recording)) & set(said)
        print(f"{len(same)} of {len(said)} messages as written, {left_out(recording.damage)} of {len(whole)} bytes out")
        # Beside each changed message its successor may be lost: a whole one has to follow what is taken.
        assert len(same) >= len(said) - FLIPS - 20
        assert recording.messages.t_ns.max() <= said[-1][1], "no changed time makes the flight longer"
        assert left_out(recording.damage) < 0.01 * len(whole)
        assert recording.is_whole


def test_damage_all_over_a_file_costs_no_more_memory_than_the_file(path: Path) -> None:
    said = lines(3000)
    body, end = plain(said)
    damaged = bytearray(body + end)
    for one in said[100::10]:
        damaged[body.index(one[2]) - PAYLOAD_AT + 2] ^= 0x01
    path.write_bytes(damaged)
    recording = read_file(path, limits=replace(LIMITS, whole_bytes=len(damaged)))
    assert said_by(recording) == said[:100] + [one for place, one in enumerate(said[100:]) if place % 10]


@pytest.mark.parametrize("rubbish", [*RUBBISH, bytes(5000), b"\x05" * 3000])
def test_what_is_no_record_is_left_out_and_counted(path: Path, rubbish: bytes) -> None:
    said = messages(50)
    first, (rest, end) = plain(said[:20])[0], plain(said)
    note = mark(START_NS, "behind it")
    path.write_bytes(first + rubbish + note + rest[len(first) :] + end)
    recording = read_file(path)
    assert said_by(recording) == said
    assert [note.content["text"] for note in recording.notes] == ["behind it"]
    assert recording.damage == (
        f"{len(rubbish)} bytes are no records and were left out, the first at byte {len(first)}."
    )
    assert recording.is_whole


def test_a_message_in_the_payload_of_another_is_no_place_to_go_on(path: Path) -> None:
    inside = message_record(1, 7, START_NS, b"inside")
    said = [(1, START_NS + index * EVERY_NS, inside) for index in range(20)]
    whole = b"".join(plain(said))
    at = whole.index(message_record(1, 8, said[8][1], inside))
    path.write_bytes(whole[:at] + b"\x77" + whole[at + 1 :])
    # What is in the damaged message itself cannot be told from a message.
    assert [one for one in said_by(read_file(path)) if one[2] != b"inside"] == said[:8] + said[9:]


def test_a_file_that_grows_behind_damage_is_read_on(path: Path) -> None:
    said = lines(40)
    body = plain(said)[0]
    half = len(plain(said[:20])[0])
    path.write_bytes(body[:half] + b"\x77" * 30)
    reader = Reader(path)
    read = heard(reader.items())
    assert read == said[:20]
    with path.open("ab") as file:
        file.write(body[half:])
    assert read + heard(reader.items()) == said


class Growing(io.FileIO):
    """A file of a flight in the air: the rest of it is written right after it was first read to its end."""

    def __init__(self, path: Path, rest: bytes) -> None:
        super().__init__(path)
        self._path, self._rest = path, rest

    def read(self, size: int | None = -1, /) -> bytes:
        data = super().read(size) or b""
        if self._rest and self.tell() == self._path.stat().st_size:
            with self._path.open("ab") as file:
                file.write(self._rest)
            self._rest = b""
        return data


@pytest.mark.parametrize("cut", [1, 8, 30, 200])
def test_a_record_that_becomes_whole_while_it_is_read_is_not_passed_over(path: Path, cut: int) -> None:
    said = lines(40)
    body = plain(said)[0]
    half = len(plain(said[:20])[0]) + cut
    path.write_bytes(body[:half])
    reader = Reader(path)
    with Growing(path, body[half:]) as file:
        reader.file = file
        assert heard(reader.items()) + heard(reader.items()) == said
    assert reader.damage is None


def test_a_damaged_time_is_taken_from_the_other_one(path: Path) -> None:
    said = lines(100)
    whole = b"".join(plain(said))
    for damaged in (0, 50):
        at = whole.index(struct.pack("<QQ", said[damaged][1], said[damaged][1]))
        for place in (at + 5, at + 13):
            path.write_bytes(whole[:place] + bytes([whole[place] ^ 0x10]) + whole[place + 1 :])
            recording = read_file(path)
            assert said_by(recording) == said
            assert recording.damage == "A message has two times, the likelier one was taken."


def test_another_program_may_give_each_message_two_times(path: Path) -> None:
    record = struct.Struct("<BQHIQQ")
    times = [(9_000_000 + index, 8_000_000) for index in range(50)]
    path.write_bytes(opening("x", TOPICS) + b"".join(record.pack(5, 22, 1, 0, *both) for both in times))
    recording = read_file(path)
    assert (recording.messages.t_ns.tolist(), recording.damage) == ([log for log, _ in times], None)
