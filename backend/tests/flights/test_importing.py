"""A stranger's file is read as far as it is a flight, or refused with a sentence; nothing of it stays behind."""

from __future__ import annotations

import os
import time
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from mcap.writer import Writer

from epf_gcs.errors import GatewayError
from epf_gcs.flights.importing import run
from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, opening
from epf_gcs.recordings.reading import read_file
from epf_gcs.recordings.topics import BOARD_RECEIVED, TOPICS
from tests.flights.flown_flights import quiet, recording
from tests.recordings.files import START_NS, mark, messages, packed, plain

DAY_NS = 86_400 * 10**9


def imported(tmp_path: Path, content: bytes) -> tuple[dict[str, Any], Path]:
    """What importing says, and the file that it wrote."""
    source, target = tmp_path / "came.mcap", tmp_path / "checked" / "checked.mcap"
    source.write_bytes(content)
    target.parent.mkdir(exist_ok=True)
    return run([str(source), str(target)], quiet), target


def at_times(*times_ns: int, count: int | None = None) -> bytes:
    """A whole recording with a message at each of these times; `count` is how many it claims to have."""
    tally, body = Tally(), opening("test", TOPICS)
    for t_ns in times_ns:
        body += message_record(BOARD_RECEIVED, tally.add(BOARD_RECEIVED, t_ns), t_ns, b"\rQT,")
    body += data_end()
    if count is not None:
        tally.counts = {BOARD_RECEIVED: count}
    return body + closing(TOPICS, tally, len(body))


def of_another_program(topic: str = "/imu", times: int = 1) -> bytes:
    """An MCAP file as the library writes it, with this topic as many times."""
    output = BytesIO()
    writer = Writer(output)
    writer.start("ros2", "a recorder")
    for number in range(times):
        channel = writer.register_channel(topic=topic, message_encoding="cdr", schema_id=0)
        for index in range(10):
            writer.add_message(channel, START_NS + index * 10**6 + number, b"stranger", START_NS)
    writer.finish()  # type: ignore[no-untyped-call]
    return output.getvalue()


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "recording_empty"),
        (os.urandom(100_000), "recording_foreign"),
        (b"PK\x03\x04" + bytes(5000), "recording_foreign"),
        (of_another_program(), "recording_foreign"),
        (of_another_program("board/received", 2), "recording_two_boards"),
        (at_times(), "recording_empty"),
        (at_times(count=10**9), "recording_empty"),
        (at_times(0), "recording_clock_wrong"),
        (at_times(START_NS, time.time_ns() + 2 * DAY_NS), "recording_clock_wrong"),
        (at_times(START_NS, START_NS + 8 * DAY_NS), "recording_clock_wrong"),
    ],
    ids=[
        "empty",
        "random bytes",
        "an archive",
        "another program's",
        "two boards in one",
        "no message",
        "10^9 messages claimed and none there",
        "a clock of 1970",
        "a clock of the future",
        "longer than a week",
    ],
)
def test_what_is_no_flight_is_refused_with_a_sentence(tmp_path: Path, content: bytes, code: str) -> None:
    with pytest.raises(GatewayError) as fault:
        imported(tmp_path, content)
    assert fault.value.code == code
    assert fault.value.detail.endswith(".")
    assert list((tmp_path / "checked").iterdir()) == []


def test_a_folder_or_a_missing_file_is_refused(tmp_path: Path) -> None:
    for source in (tmp_path, tmp_path / "nothing"):
        with pytest.raises((GatewayError, OSError)):
            run([str(source), str(tmp_path / "out.mcap")], quiet)
    assert list(tmp_path.iterdir()) == []


def test_what_a_file_claims_is_not_believed(tmp_path: Path) -> None:
    answer, target = imported(tmp_path, at_times(START_NS, START_NS + 1, count=10**9))
    assert (answer["started_ns"], answer["damage"]) == (START_NS, None)
    assert len(read_file(target).messages.t_ns) == 2


def test_a_truncated_file_is_read_as_far_as_it_is_whole(tmp_path: Path) -> None:
    content = recording(2)
    whole = len(read_file_of(tmp_path, content).messages.t_ns)
    for cut in (len(content) // 3, len(content) - 5):
        _, target = imported(tmp_path, content[:cut])
        found = read_file(target)
        assert found.is_whole, "what is in the library is whole"
        assert 0 < len(found.messages.t_ns) <= whole


def read_file_of(tmp_path: Path, content: bytes) -> Any:
    path = tmp_path / "whole.mcap"
    path.write_bytes(content)
    return read_file(path)


def test_a_damaged_chunk_is_told_and_left_behind(tmp_path: Path) -> None:
    content = bytearray(packed(messages(2000), chunk_size=8192))
    middle = len(content) // 2
    content[middle : middle + 20] = os.urandom(20)
    answer, target = imported(tmp_path, bytes(content))
    assert answer["damage"]
    found = read_file(target)
    assert found.damage is None
    assert 0 < len(found.messages.t_ns) < 2000


def test_a_message_that_claims_more_than_memory_is_refused_or_left(tmp_path: Path) -> None:
    body = opening("test", TOPICS) + message_record(BOARD_RECEIVED, 0, START_NS, b"good")
    body += b"\x05" + (1 << 60).to_bytes(8, "little") + bytes(100)
    answer, target = imported(tmp_path, body)
    assert answer["damage"]
    assert len(read_file(target).messages.t_ns) == 1


@pytest.mark.uncounted
def test_a_small_file_cut_at_any_byte_is_taken_as_far_as_it_is_whole_or_refused(tmp_path: Path) -> None:
    said = messages(6)
    body, end = plain(said, mark_every=3)
    whole = body + end
    for size in range(len(whole) + 1):
        if not holds_a_message(size, body):
            with pytest.raises(GatewayError) as fault:
                imported(tmp_path, whole[:size])
            assert fault.value.code == "recording_empty", size
            continue
        answer, target = imported(tmp_path, whole[:size])
        found = read_file(target)
        assert (found.is_whole, found.damage) == (True, None), size
        count = len(found.messages.t_ns)
        assert [int(t_ns) for t_ns in found.messages.t_ns] == [t_ns for _, t_ns, _ in said[:count]], size
        assert answer["started_ns"] == said[0][1]


def holds_a_message(size: int, body: bytes) -> bool:
    """Whether the first message of a file is whole when it is cut to this size."""
    channel, t_ns, payload = messages(6)[0]
    first = message_record(channel, 0, t_ns, payload)
    return size >= body.index(first) + len(first)


def test_two_boards_recorded_one_behind_the_other_are_told(tmp_path: Path) -> None:
    one = recording(1)
    answer, target = imported(tmp_path, one + one)
    assert answer["damage"] == "The file goes on after its end, what follows was not read."
    assert read_file(target).damage is None


def test_where_a_clock_was_set_back_in_flight_time_goes_on_and_it_is_told(tmp_path: Path) -> None:
    hour_ns, step_ns = 3600 * 10**9, 10**8
    times = [START_NS + number * step_ns for number in range(50)]
    # Half an hour in all, and a hundredth of a second, which is how records of two lines interleave.
    jumped = times[:20] + [t_ns - hour_ns for t_ns in times[20:40]] + [t_ns - 2 * hour_ns for t_ns in times[40:]]
    jumped[5] += 2 * step_ns
    content = at_times(*jumped)
    end = content.index(data_end())
    # A mark by the clock as it was last.
    content = content[:end] + mark(jumped[-1], "late") + content[end:]
    answer, target = imported(tmp_path, content)
    assert answer["damage"] == "The clock was set back 2 times in flight; here time goes on."
    recording_read = read_file(target)
    found = recording_read.messages.t_ns
    assert [note.t_ns for note in recording_read.notes] == [int(found[-1])], "notes go with the messages"
    assert int(found[0]) == answer["started_ns"] == START_NS
    # The step itself is lost: what was read after it counts as read at once.
    assert int(found[-1]) == times[-1] - 2 * step_ns
    assert [int(t_ns) for t_ns in found[:20]] == jumped[:20]
    again, _ = imported(tmp_path, target.read_bytes())
    assert (again["fingerprint"], again["damage"]) == (answer["fingerprint"], None), "it is known the next time"
