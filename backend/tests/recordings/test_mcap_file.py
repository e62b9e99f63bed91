"""Files that mcap's own readers read."""

from __future__ import annotations

from io import BytesIO

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import make_reader
from mcap.records import Channel, Header, Message, Metadata, Statistics
from mcap.stream_reader import StreamReader

from epf_gcs.recordings.mcap_file import Contents, Tally, closing, data_end, message_record, metadata_record, opening

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


def test_a_message_has_one_time_and_its_number_begins_anew_after_the_last_that_fits() -> None:
    data = opening("test 1.0", TOPICS) + message_record(1, 2**32 + 5, 77, b"a") + data_end()
    (message,) = [
        r for r in StreamReader(BytesIO(data + closing(TOPICS, Tally(), len(data)))).records if isinstance(r, Message)
    ]
    assert (message.sequence, message.log_time, message.publish_time, message.data) == (5, 77, 77, b"a")


def test_a_summary_has_the_times_and_counts_of_all_chunks_in_whatever_order_they_are_counted() -> None:
    tally = Tally()
    for channel, times in ((1, [30, 20]), (2, [40, 25]), (1, [10, 15]), (2, [35])):
        tally.add_all(channel, np.array(times, np.int64))
    assert (tally.counts, tally.first_ns, tally.last_ns) == ({1: 4, 2: 3}, 10, 40)
    tally.metadata_count = 5
    data = opening("test 1.0", TOPICS) + data_end()
    summary = make_reader(BytesIO(data + closing(TOPICS, tally, len(data), chunk_count=4))).get_summary()
    assert summary is not None
    statistics = summary.statistics
    assert statistics is not None
    assert (statistics.chunk_count, statistics.message_count, statistics.channel_count) == (4, 7, 2)
    assert (statistics.message_start_time, statistics.message_end_time) == (10, 40)
    assert (statistics.schema_count, statistics.attachment_count, statistics.metadata_count) == (0, 0, 5)
    encodings = {channel.topic: (channel.message_encoding, channel.schema_id) for channel in summary.channels.values()}
    assert encodings == dict.fromkeys(TOPICS.values(), ("application/octet-stream", 0))
    told = make_reader(BytesIO(data + closing(Contents(b"", 2, 3), tally, len(data)))).get_summary()
    assert told is not None
    assert told.statistics is not None
    assert (told.statistics.channel_count, told.statistics.schema_count, told.statistics.chunk_count) == (2, 3, 0)
