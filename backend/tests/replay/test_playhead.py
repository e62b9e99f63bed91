"""A moment of a recording is the same however it was reached: played to, sought, from a key frame, in one go."""

from __future__ import annotations

import json
import math
import random
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.codec.encode import encode_command
from epf_gcs.contract.status import TaskPeriod
from epf_gcs.recordings import notes
from epf_gcs.recordings.packing import pack
from epf_gcs.recordings.topics import BOARD_SENT, SIMULATOR_RECEIVED
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.status import build_status
from epf_gcs.replay.timeline import Timeline
from epf_gcs.xplane.datagram import Record, build
from tests.replay.recordings import SECOND_NS, STARTS_NS, Made, flight, write
from tests.support.outlet import KeptOutlet
from tests.support.simulator import NO, ROWS, WHOLE


def state_of(head: Playhead) -> Any:
    """All that a viewer can see, and all that what follows depends on."""
    return {"status": build_status(head, "a.mcap", 0), "kept": json.loads(head.kept())}


def keyed(timeline: Timeline, file: Path | None = None) -> Keys:
    """All key frames of a recording."""
    keys = Keys(file, "a", timeline.starts_ns or 0)
    scout = Scout(timeline, keys)
    while scout.has_work:
        scout.work()
    return keys


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("flight") / "a.mcap", flight(24.0, gap=(10.0, 14.5)))


def test_a_moment_played_to_in_pieces_is_the_moment_sought(recording: Path) -> None:
    timeline = Timeline(recording)
    rng = random.Random(5)
    pieces = Playhead(timeline, Silence())
    for at_ns in sorted(STARTS_NS + rng.randrange(26 * SECOND_NS) for _ in range(5)):
        while not pieces.advance(at_ns, 7):
            pass
        at_once = Playhead(timeline, Silence())
        assert at_once.advance(at_ns)
        assert state_of(pieces) == state_of(at_once)


def test_a_moment_from_a_key_frame_is_the_moment_played_to(recording: Path, tmp_path: Path) -> None:
    timeline = Timeline(recording)
    keys = keyed(timeline, tmp_path / "a.keys")
    assert keys.latest_ns is not None
    assert keys.latest_ns > STARTS_NS + 20 * SECOND_NS
    rng = random.Random(6)
    for at_ns in (STARTS_NS + rng.randrange(3 * SECOND_NS, 26 * SECOND_NS) for _ in range(12)):
        key = keys.before(at_ns)
        assert key is not None
        sought = Playhead(timeline, Silence(), *key)
        sought.advance(at_ns)
        played = Playhead(timeline, Silence())
        played.advance(at_ns)
        assert state_of(sought) == state_of(played)


def test_after_a_key_frame_the_same_samples_and_events_follow(recording: Path) -> None:
    timeline = Timeline(recording)
    key = keyed(timeline).before(STARTS_NS + 10 * SECOND_NS)
    assert key is not None
    whole, rest = KeptOutlet(), KeptOutlet()
    Playhead(timeline, whole).advance(STARTS_NS + 24 * SECOND_NS)
    Playhead(timeline, rest, *key).advance(STARTS_NS + 24 * SECOND_NS)
    assert len(rest.samples) > 400
    assert whole.samples[-len(rest.samples) :] == rest.samples
    assert whole.samples[-len(rest.samples) - 1][1] < key[0] * 1e-9
    alarms = [event for event in rest.events if event[0] == "alarm"]
    assert alarms
    assert [event for event in whole.events if event[0] == "alarm"][-len(alarms) :] == alarms


def test_a_gap_is_a_gap_ages_grow_and_values_go_stale(recording: Path) -> None:
    head = Playhead(Timeline(recording), Silence())
    head.advance(STARTS_NS + 14 * SECOND_NS)
    status = build_status(head, "a.mcap", 0)
    assert status.topics["ahrs"].age_s == pytest.approx(4.0, abs=0.1)
    assert status.topics["ahrs"].rate_hz == 0.0
    assert not head.vehicle.telemetry.is_live("ahrs")
    assert status.simulator.rows == []


def test_the_status_says_what_the_recording_knows(recording: Path) -> None:
    head = Playhead(Timeline(recording), Silence())
    head.advance(STARTS_NS + 17 * SECOND_NS)
    status = build_status(head, "a.mcap", 12)
    assert status.board.mode == "legacy"
    assert status.board.state == "open"
    assert status.board.periods_ms.parameters == TaskPeriod(50, chosen=True)
    assert status.simulator.state == "open"
    assert [alarm.id for alarm in status.alarms] == ["gps_lost"]


@pytest.mark.parametrize("seed", range(5))
def test_a_recording_cut_anywhere_plays_to_its_last_whole_record(tmp_path: Path, seed: int) -> None:
    whole = write(tmp_path / "whole.mcap", flight(4.0))
    data = whole.read_bytes()
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(data[: random.Random(seed).randrange(len(data) // 4, len(data))])
    kept, all_of_it = KeptOutlet(), KeptOutlet()
    timeline = Timeline(cut)
    Playhead(timeline, kept).advance(timeline.edge_ns)
    Playhead(Timeline(whole), all_of_it).advance(timeline.edge_ns)
    assert kept.samples
    missing = all_of_it.samples[len(kept.samples) :]
    assert all_of_it.samples[: len(kept.samples)] == kept.samples
    assert len(missing) <= 6, "only what the record that was cut held"


@pytest.mark.uncounted
def test_a_small_recording_cut_at_any_byte_can_be_opened(tmp_path: Path) -> None:
    data = write(tmp_path / "whole.mcap", flight(0.2)).read_bytes()
    cut = tmp_path / "cut.mcap"
    counts = []
    for size in range(8, len(data)):
        cut.write_bytes(data[:size])
        kept, timeline = KeptOutlet(), Timeline(cut)
        Playhead(timeline, kept).advance(timeline.edge_ns)
        counts.append(len(kept.samples))
    assert counts == sorted(counts), "the more of the file, the more of the flight"
    assert counts[-1] > 10


def test_a_packed_recording_is_the_same_flight(recording: Path, tmp_path: Path) -> None:
    pack(recording, tmp_path / "packed.mcap")
    outlets = [KeptOutlet(), KeptOutlet()]
    for path, outlet in zip((recording, tmp_path / "packed.mcap"), outlets, strict=True):
        Playhead(Timeline(path), outlet).advance(STARTS_NS + 24 * SECOND_NS)
    assert outlets[0].samples
    assert outlets[0].samples == outlets[1].samples
    assert outlets[0].events == outlets[1].events
    packed = Timeline(tmp_path / "packed.mcap")
    key = keyed(Timeline(recording)).before(STARTS_NS + 20 * SECOND_NS)
    assert key is not None
    from_key, from_start = Playhead(packed, Silence(), *key), Playhead(packed, Silence())
    for head in (from_key, from_start):
        head.advance(STARTS_NS + 21 * SECOND_NS)
    assert state_of(from_key) == state_of(from_start), "key frames hold before and after packing"


def test_a_recording_without_notes_of_events_has_the_alarms_of_its_bytes(tmp_path: Path) -> None:
    items = [one for one in flight(24.0, gap=(10.0, 14.0)) if one[1] != notes.EVENT]
    path = write(tmp_path / "old.mcap", items)
    timeline, outlet = Timeline(path), KeptOutlet()
    head = Playhead(timeline, outlet)
    head.advance(STARTS_NS + 9 * SECOND_NS)
    before = {alarm.id for alarm in head.alarms}
    head.advance(STARTS_NS + 13 * SECOND_NS)
    assert {alarm.id for alarm in head.alarms if alarm.until_s is None} - before == {"heartbeat_lost"}
    head.advance(STARTS_NS + 20 * SECOND_NS)
    (silence,) = [alarm for alarm in head.alarms if alarm.id == "heartbeat_lost"]
    assert silence.until_s == pytest.approx(STARTS_NS * 1e-9 + 14.5, abs=0.5, rel=0.0)
    told = [event for event in outlet.events if event[0] == "alarm" and event[-1]["id"] == "heartbeat_lost"]
    assert [event[-1]["active"] for event in told] == [True, False]
    for at_s in (13, 20):
        key = keyed(timeline).before(STARTS_NS + at_s * SECOND_NS)
        assert key is not None
        sought, played = Playhead(timeline, Silence(), *key), Playhead(timeline, Silence())
        for one in (sought, played):
            one.advance(STARTS_NS + at_s * SECOND_NS)
        assert (sought.alarms, state_of(sought)) == (played.alarms, state_of(played))


def test_a_replay_finds_the_wrong_profile_and_another_pace_as_the_live_flight_does(tmp_path: Path) -> None:
    """At x2 the aircraft makes 56 m in a second, and the rows of X-Plane 12 are read as those of 10."""
    items = [one for one in flight(0.05) if one[1] not in (notes.EVENT, SIMULATOR_RECEIVED)]
    for frame in range(400):
        rolled_deg = 2.0 * 5.0 * math.sin(0.05 * frame)
        rows = {
            **ROWS,
            3: (55.0, NO, NO, 55.0, NO, NO, NO, NO),
            16: (5.0 * math.cos(0.05 * frame), 0.0, 0.0, NO, NO, NO, NO, NO),
            17: (0.0, rolled_deg, 90.0, NO, NO, NO, NO, NO),
            20: (28.0 + frame * 0.05 * 56.6 / 111_195.0, -15.4, 1000.0, 1000.0, NO, 1000.0, NO, NO),
        }
        at_ns = STARTS_NS + frame * SECOND_NS // 20 + 10_000_000
        items.append((at_ns, SIMULATOR_RECEIVED, build(Record(*one) for one in rows.items())))
    timeline = Timeline(write(tmp_path / "wrong.mcap", sorted(items, key=lambda one: one[0])))
    for at_s in (0, 7, 15):
        key = keyed(timeline).before(STARTS_NS + at_s * SECOND_NS) if at_s else None
        sought, played = Playhead(timeline, Silence(), *(key or ())), Playhead(timeline, Silence())
        for head in (sought, played):
            head.advance(STARTS_NS + at_s * SECOND_NS)
        assert (sought.alarms, state_of(sought)) == (played.alarms, state_of(played))
        found = {alarm.id: alarm.params for alarm in played.alarms}
        simulator = build_status(played, "wrong.mcap", 0).simulator
        if at_s == 0:
            assert (found, simulator.fitting_profile) == ({}, None)
        else:
            assert found["profile_wrong"] == {"profile": "X-Plane 10 / 11", "fits": "X-Plane 12"}
            assert found["simulator_pace"] == {"pace": 2.0}
            assert (simulator.profile, simulator.fitting_profile) == ("xp10", "xp12")
            assert simulator.unusable == []


def test_a_board_that_has_not_answered_the_first_data_yet_has_half_a_second_for_it(tmp_path: Path) -> None:
    told = encode_command("xplane_info", *(0.0,) * 15)
    items = [one for one in flight(2.0) if one[1] not in (notes.EVENT, BOARD_SENT)]
    items += [(STARTS_NS + at_ms * 1_000_000, BOARD_SENT, told) for at_ms in range(20, 2000, 50)]
    timeline = Timeline(write(tmp_path / "old.mcap", sorted(items, key=lambda one: one[0])))
    head = Playhead(timeline, Silence())
    for at_ms, expected in ((300, False), (490, False), (900, True)):
        head.advance(STARTS_NS + at_ms * 1_000_000)
        assert ("hil_lost" in {alarm.id for alarm in head.alarms}) == expected


def test_alarms_that_were_noted_are_not_judged_again(tmp_path: Path) -> None:
    path = write(tmp_path / "new.mcap", flight(24.0, gap=(10.0, 14.0)))
    outlet = KeptOutlet()
    head = Playhead(Timeline(path), outlet)
    head.advance(STARTS_NS + 13 * SECOND_NS)
    assert {alarm.id for alarm in head.alarms} <= {"gps_lost"}


def test_a_recording_that_is_packed_while_it_is_replayed_plays_on(tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", flight(12.0))
    outlet, expected = KeptOutlet(), KeptOutlet()
    Playhead(Timeline(path), expected).advance(STARTS_NS + 12 * SECOND_NS)
    timeline = Timeline(path)
    pack(path)
    head = Playhead(timeline, outlet)
    head.advance(STARTS_NS + 12 * SECOND_NS)
    assert outlet.samples == expected.samples
    again = Timeline(path)
    assert (again.starts_ns, again.edge_ns, again.is_whole) == (timeline.starts_ns, timeline.edge_ns, True)


def test_a_growing_recording_is_followed_to_its_edge(tmp_path: Path) -> None:
    data = write(tmp_path / "whole.mcap", flight(6.0)).read_bytes()
    path = tmp_path / "growing.mcap"
    path.write_bytes(data[:5000])
    timeline = Timeline(path)
    outlet = KeptOutlet()
    head = Playhead(timeline, outlet)
    with path.open("ab") as file:
        for start in range(5000, len(data), 3919):
            file.write(data[start : start + 3919])
            file.flush()
            timeline.look()
            head.advance(timeline.edge_ns)
    assert timeline.is_whole
    expected = KeptOutlet()
    Playhead(Timeline(path), expected).advance(timeline.edge_ns)
    assert outlet.samples == expected.samples


def test_key_frames_of_another_recording_or_a_torn_file_are_not_used(recording: Path, tmp_path: Path) -> None:
    timeline = Timeline(recording)
    file = tmp_path / "a.keys"
    keyed(timeline, file).close()
    size = file.stat().st_size
    other = Keys(file, "other", timeline.starts_ns or 0)
    assert other.latest_ns is None
    other.close()
    keyed(timeline, file).close()
    assert file.stat().st_size == size
    file.write_bytes(file.read_bytes()[:-100])
    again = Keys(file, "a", timeline.starts_ns or 0)
    assert again.latest_ns is not None
    assert again.before(STARTS_NS + 24 * SECOND_NS) is not None


def test_key_frames_of_other_code_are_not_used(
    recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    timeline = Timeline(recording)
    file = tmp_path / "a.keys"
    keyed(timeline, file).close()
    mine = Keys(file, "a", timeline.starts_ns or 0)
    assert mine.latest_ns is not None
    mine.close()
    monkeypatch.setattr("epf_gcs.replay.keys.code_stamp", lambda: "of another checkout")
    assert Keys(file, "a", timeline.starts_ns or 0).latest_ns is None


def test_two_replays_share_key_frames_and_one_of_them_writes(recording: Path, tmp_path: Path) -> None:
    timeline = Timeline(recording)
    first = Keys(tmp_path / "a.keys", "a", timeline.starts_ns or 0)
    second = Keys(tmp_path / "a.keys", "a", timeline.starts_ns or 0)
    assert first.is_writer
    assert not second.is_writer
    assert not Scout(timeline, second).has_work
    scout = Scout(timeline, first)
    while scout.has_work:
        scout.work()
    second.look()
    assert second.latest_ns == first.latest_ns
    assert second.before(STARTS_NS + 9 * SECOND_NS) == first.before(STARTS_NS + 9 * SECOND_NS)
    first.close()
    third = Keys(tmp_path / "a.keys", "a", timeline.starts_ns or 0)
    assert third.is_writer
    third.close()
    second.look()
    assert second.is_writer, "whoever looks next goes on with the key frames of one that has ended"


def paused_and_put_elsewhere(path: Path) -> Path:
    """A simulator that is paused from the 5th second to the 9th, and in the 12th puts its aircraft elsewhere."""
    told = encode_command("xplane_info", *(0.5,) * 15)
    elsewhere = {**ROWS, 20: (28.4532, -13.8661, *ROWS[20][2:])}
    items: Made = []
    for item in flight(16.0):
        at_s = (item[0] - STARTS_NS) / SECOND_NS
        if item[1] == SIMULATOR_RECEIVED and 5.0 <= at_s < 9.0:
            items.append((item[0], SIMULATOR_RECEIVED, WHOLE))
        elif item[1] == SIMULATOR_RECEIVED and 12.0 <= at_s < 13.0:
            rows = {**elsewhere, 17: (at_s, *ROWS[17][1:])}
            items.append((item[0], SIMULATOR_RECEIVED, build(Record(*one) for one in rows.items())))
        elif item[1] not in (notes.EVENT, BOARD_SENT) and (item[1] != SIMULATOR_RECEIVED or at_s < 12.0):
            items.append(item)
    items += [(STARTS_NS + at_ms * 1_000_000, BOARD_SENT, told) for at_ms in range(20, 16000, 50)]
    return write(path, sorted(items, key=lambda one: one[0]))


def test_a_pause_and_a_jump_of_the_simulator_are_those_of_the_flight(tmp_path: Path) -> None:
    timeline, outlet = Timeline(paused_and_put_elsewhere(tmp_path / "old.mcap")), KeptOutlet()
    head = Playhead(timeline, outlet)

    def said(one: Playhead, at_s: float) -> tuple[bool, bool]:
        one.advance(STARTS_NS + round(at_s * SECOND_NS))
        alarms = {alarm.id for alarm in one.alarms if alarm.until_s is None}
        return build_status(one, "a.mcap", 0).simulator.paused, "simulator_paused" in alarms

    for at_s, expected in ((4.9, False), (6.0, True), (8.9, True), (9.2, False), (11.9, False)):
        assert said(head, at_s) == (expected, expected), at_s
        key = keyed(timeline).before(STARTS_NS + round(at_s * SECOND_NS))
        sought = Playhead(timeline, Silence(), *(key or ()))
        assert said(sought, at_s) == (expected, expected), at_s
        assert state_of(sought) == state_of(head)
    assert not [event for event in outlet.events if event[0] == "simulator_jumped"]
    said(head, 12.9)
    (jump,) = [event[-1] for event in outlet.events if event[0] == "simulator_jumped"]
    assert jump["latitude_deg"] == pytest.approx(28.4532)


def test_a_jump_that_was_noted_is_told_once(tmp_path: Path) -> None:
    items = [
        (t_ns, SIMULATOR_RECEIVED, build([Record(20, (degrees, *ROWS[20][1:]))]))
        for t_ns, degrees in ((STARTS_NS + SECOND_NS, 20.0), (STARTS_NS + 2 * SECOND_NS, 40.0))
    ]
    jump = {"distance_m": 7, "latitude_deg": 28.0, "longitude_deg": -15.0, "altitude_ft": 500.0}
    note = (STARTS_NS + 2 * SECOND_NS, notes.EVENT, {"event": "simulator_jumped", "data": jump})
    outlet = KeptOutlet()
    head = Playhead(Timeline(write(tmp_path / "new.mcap", [*items, note])), outlet)
    head.advance(STARTS_NS + 3 * SECOND_NS)
    assert [event for event in outlet.events if event[0] == "simulator_jumped"] == [("simulator_jumped", jump)]
