"""Files that mcap's own readers read."""

from __future__ import annotations

from io import BytesIO

from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import make_reader
from mcap.records import Channel, Header, Message, Metadata, Statistics
from mcap.stream_reader import StreamReader

from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, metadata_record, opening

TOPICS = {1: "board/received", 2: "board/sent"}


def a_file(messages: list[tuple[int, int, bytes]]) -> bytes:
    tally = Tally()
    data = opening("test 1.0", TOPICS) + metadata_record("board_link", {"url": "tcp://h:1"})
    tally.metadata_count += 1
    for channel, time_ns, payload in messages:
        data += message_record(channel, tally.add(channel, time_ns), time_ns, payload)
    end = data_end()
    return data + end + closing(TOPICS, tally, len(data) + len(end))


@given(st.lists(st.tuples(st.sampled_from([1, 2]), st.integers(0, 2**62), st.binary(max_size=300)), max_size=20))
def test_what_is_written_is_what_the_library_reads(messages: list[tuple[int, int, bytes]]) -> None:
    records = list(StreamReader(BytesIO(a_file(messages))).records)
    read = [(r.channel_id, r.log_time, r.data) for r in records if isinstance(r, Message)]
    assert read == messages
    assert [r.library for r in records if isinstance(r, Header)] == ["test 1.0"]
    assert {r.topic for r in records if isinstance(r, Channel)} == set(TOPICS.values())


def test_the_summary_is_read_without_the_messages() -> None:
    data = a_file([(1, 1_000, b"a"), (2, 2_000, b"b"), (1, 3_000, b"c")])
    summary = make_reader(BytesIO(data)).get_summary()
    assert summary is not None
    assert isinstance(summary.statistics, Statistics)
    assert summary.statistics.message_count == 3
    assert summary.statistics.channel_message_counts == {1: 2, 2: 1}
    assert (summary.statistics.message_start_time, summary.statistics.message_end_time) == (1_000, 3_000)


def test_the_messages_of_a_channel_are_numbered() -> None:
    records = StreamReader(BytesIO(a_file([(1, 1, b"a"), (2, 2, b"b"), (1, 3, b"c")]))).records
    assert [(r.channel_id, r.sequence) for r in records if isinstance(r, Message)] == [(1, 0), (2, 0), (1, 1)]


def test_a_note_stands_where_it_was_made() -> None:
    (note,) = [r for r in StreamReader(BytesIO(a_file([]))).records if isinstance(r, Metadata)]
    assert (note.name, note.metadata) == ("board_link", {"url": "tcp://h:1"})
