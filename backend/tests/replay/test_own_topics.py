"""Topics that a board described itself, in a replay: shown as they were, however the moment was reached."""

from __future__ import annotations

import json
from pathlib import Path

from epf_gcs.recordings import notes
from epf_gcs.recordings.topics import BOARD_RECEIVED
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.timeline import Timeline
from epf_gcs.vehicle.own_topics import usable_topics
from tests.replay.recordings import SECOND_NS, STARTS_NS, Made, flight, write
from tests.support.own_rows import filter_rows, own_frame, table_note

TOPICS, _ = usable_topics(filter_rows())


def described(tmp_path: Path) -> Path:
    """A flight of 24 s whose board's table is known from 5 s to 18 s; its topic comes each half second all along."""
    items: Made = flight(24.0)
    items += [
        (STARTS_NS + 5 * SECOND_NS, notes.EVENT, table_note(TOPICS)),
        (STARTS_NS + 18 * SECOND_NS, notes.EVENT, table_note(TOPICS, is_known=False)),
    ]
    # Between the pieces of the flight's own frames, which lie in the first 4 ms of each twentieth of a second.
    items += [
        (STARTS_NS + step * SECOND_NS // 2 + 20_000_000, BOARD_RECEIVED, own_frame(TOPICS, 0.02 * step, 0, 1, 2))
        for step in range(46)
    ]
    return write(tmp_path / "a.mcap", sorted(items, key=lambda item: item[0]))


def at(timeline: Timeline, seconds: float) -> Playhead:
    head = Playhead(timeline, Silence())
    assert head.advance(STARTS_NS + round(seconds * SECOND_NS))
    return head


def test_an_own_topic_is_there_while_its_table_was_known_and_its_frames_are_of_an_unknown_type_else(
    tmp_path: Path,
) -> None:
    timeline = Timeline(described(tmp_path))
    assert at(timeline, 4.9).vehicle.telemetry.newest("filter") is None
    assert at(timeline, 4.9).vehicle.board.damage["unknown_type"] == 10
    known = at(timeline, 17.9).vehicle
    newest = known.telemetry.newest("filter")
    assert newest is not None
    assert round(newest["bias_x_rad_s"], 6) == 0.7
    assert newest["mode"] == 2
    assert known.board.damage["unknown_type"] == 10
    later = at(timeline, 23.0).vehicle
    assert later.telemetry.newest("filter") == newest
    assert later.board.damage["unknown_type"] == 10 + 10


def test_from_a_key_frame_it_is_the_same_as_from_the_start(tmp_path: Path) -> None:
    timeline = Timeline(described(tmp_path))
    keys = Keys(None, "a", timeline.starts_ns or 0)
    scout = Scout(timeline, keys)
    while scout.has_work:
        scout.work()
    for seconds in (9.3, 17.2, 21.6):
        to_ns = STARTS_NS + round(seconds * SECOND_NS)
        key = keys.before(to_ns)
        assert key is not None
        from_key = Playhead(timeline, Silence(), *key)
        assert from_key.advance(to_ns)
        assert json.loads(from_key.kept()) == json.loads(at(timeline, seconds).kept())
