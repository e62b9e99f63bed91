"""The player, told the time by the test: pace, end, loop, steps, seeks and what the viewer is told."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from epf_gcs.contract.events import Event
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.status import Status
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.pace import Pace
from epf_gcs.replay.player import Player
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.timeline import Timeline
from tests.replay.recordings import SECOND_NS, STARTS_NS, flight, write


class Viewer:
    """Implements `epf_gcs.replay.player.Audience`."""

    def __init__(self) -> None:
        self.samples: list[tuple[str, float, Any]] = []
        self.flushes: list[int] = []
        self.events: list[str] = []
        self.playbacks: list[Playback] = []
        self.statuses: list[Status] = []
        self._unflushed = 0

    def sample(self, topic: str, t_s: float, values: Any) -> None:
        self.samples.append((topic, t_s, values))
        self._unflushed += 1

    def flush(self) -> None:
        self.flushes += [self._unflushed] if self._unflushed else []
        self._unflushed = 0

    def event(self, event: Event, /) -> None:
        self.events.append(event.NAME)

    def status(self, status: Status) -> None:
        self.statuses.append(status)

    def playback(self, playback: Playback, *, with_samples: bool = False) -> None:
        self.playbacks.append(playback)


class Show:
    """A player, its viewer and a clock that goes only as told."""

    def __init__(self, path: Path, *, keys: bool = False, at_s: float = 0.0) -> None:
        self.timeline = Timeline(path)
        self.keys = Keys(None, "a", self.timeline.starts_ns or 0)
        self.scout = Scout(self.timeline, self.keys)
        while keys and self.scout.has_work:
            self.scout.work()
        self.viewer = Viewer()
        self.player = Player(self.timeline, self.keys, self.viewer, "a", at_s=at_s)
        self.now_s = 1000.0
        self.settle()

    def settle(self) -> float:
        """Turns until nothing is due; returns the wait that the player wants."""
        while (wait_s := self.player.turn(self.now_s)) <= 0.0:
            pass
        return wait_s

    def run(self, seconds: float) -> None:
        """Let that much real time pass, turn by turn."""
        end_s = self.now_s + seconds
        while True:
            wait_s = self.settle()
            if self.now_s + wait_s >= end_s:
                self.now_s = end_s
                self.settle()
                return
            self.now_s += wait_s

    @property
    def at_s(self) -> float:
        return float(self.player.playback().at_s)


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("flight") / "a.mcap", flight(12.0, gap=(6.0, 8.0)))


@pytest.fixture(scope="module")
def long_recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("flight") / "long.mcap", flight(300.0))


@pytest.mark.parametrize("rate", [0.01, 0.5, 1.0, 3.0, 100.0])
def test_ten_minutes_of_any_rate_are_right_to_the_microsecond(rate: float) -> None:
    pace = Pace(STARTS_NS)
    pace.play(50.0, rate)
    now_s = 50.0
    for _ in range(3600):
        now_s += 1.0 / 6.0
        pace.at_ns(now_s)
    assert abs((pace.at_ns(now_s) - STARTS_NS) * 1e-9 - rate * 600.0) < 1e-6 * rate
    pace.pause(now_s)
    assert pace.at_ns(now_s + 100.0) == pace.at_ns(now_s)


def test_a_change_of_rate_goes_on_from_the_moment_shown() -> None:
    pace = Pace(STARTS_NS)
    pace.play(0.0, 2.0)
    pace.play(10.0, 0.5)
    assert pace.at_ns(20.0) - STARTS_NS == 25 * SECOND_NS
    assert pace.wait_s(20.0, STARTS_NS + 26 * SECOND_NS) == 2.0
    pace.jump(20.0, STARTS_NS)
    assert pace.at_ns(22.0) - STARTS_NS == SECOND_NS
    pace.play(22.0, 1e9)
    assert pace.rate == 100.0


@pytest.mark.parametrize("stall_s", [0.3, 3.0, 60.0])
def test_a_replay_that_the_machine_held_up_catches_up_with_its_clock(long_recording: Path, stall_s: float) -> None:
    show = Show(long_recording)
    show.player.play(show.now_s, 1.0)
    show.run(5.0)
    before_s = show.at_s
    show.now_s += stall_s
    turns = 0
    while show.player.turn(show.now_s) <= 0.0:
        show.now_s += 0.005
        turns += 1
    if stall_s > 2.0:
        assert turns > 0, "it was more than a turn takes"
    show.run(2.0)
    assert show.at_s - before_s == pytest.approx(stall_s + 0.005 * turns + 2.0, abs=0.001)


def test_a_replay_that_cannot_keep_up_stays_behind_and_goes_on_from_what_it_shows(long_recording: Path) -> None:
    show = Show(long_recording)
    show.player.play(show.now_s, 100.0)
    shown = []
    # Each turn takes so long that a hundredfold is out of reach, for longer than it tries to catch up.
    for _ in range(43):
        assert show.player.turn(show.now_s) == 0.0
        shown.append(show.at_s)
        show.now_s += 0.06
    assert shown == sorted(set(shown)), "it goes on"
    asked_s = 43 * 0.06 * 100.0
    assert asked_s - shown[-1] > 40.0, "it fell behind"
    # What it did not reach in two seconds of work it does not run after, though it could now.
    show.run(0.2)
    assert show.at_s - shown[-1] < 20.0 + 20.0


def test_a_fast_replay_that_is_behind_goes_on_from_what_it_shows_when_it_is_told_to_go_slower(
    long_recording: Path,
) -> None:
    show = Show(long_recording)
    show.player.play(show.now_s, 100.0)
    show.now_s += 2.0
    assert show.player.turn(show.now_s) == 0.0
    here_s = show.at_s
    assert here_s < 50.0, "it is far behind its clock"
    show.player.play(show.now_s, 1.0)
    show.run(1.0)
    assert show.at_s == pytest.approx(here_s + 1.0, abs=0.001)


@pytest.mark.parametrize(("rate", "seconds"), [(0.5, 6.0), (1.0, 5.0), (100.0, 0.05)])
def test_it_plays_at_its_rate_and_gives_at_most_sixty_batches_a_second(
    recording: Path, rate: float, seconds: float
) -> None:
    show = Show(recording)
    before = len(show.viewer.flushes)
    show.player.play(show.now_s, rate)
    show.run(seconds)
    assert show.at_s == pytest.approx(rate * seconds, abs=0.001)
    batches = show.viewer.flushes[before:]
    assert len(batches) <= 60.0 * seconds + 3
    assert max(batches) <= 8, "each topic once"


def test_playing_through_gives_what_was_there_at_each_batch(recording: Path) -> None:
    show = Show(recording)
    show.player.want(0)
    show.player.play(show.now_s, 1.0)
    show.run(4.0)
    every = [sample for sample in show.viewer.samples if sample[0] == "ahrs"]
    assert len(every) >= 78
    times = [t_s for _, t_s, _ in show.viewer.samples]
    assert times == sorted(times)


def test_a_viewer_of_every_sample_holds_the_replay_up_and_misses_nothing(recording: Path) -> None:
    show = Show(recording)
    show.player.want(0)
    show.viewer.samples.clear()
    show.player.play(show.now_s, 100.0)
    show.run(5.0)
    first = len(show.viewer.samples)
    assert 500 <= first <= 700
    show.run(5.0)
    assert len(show.viewer.samples) == first, "nothing is sent before something was taken"
    assert show.at_s < 11.0
    while show.player.playback().state == "playing":
        taken = sum(show.viewer.flushes)
        show.viewer.flushes.clear()
        show.player.taken(taken)
        show.run(0.05)
    played = Show(recording, at_s=30.0).player.head.vehicle.telemetry.health
    counts = {topic: sum(1 for one in show.viewer.samples if one[0] == topic) for topic in played}
    assert counts == {topic: health.count for topic, health in played.items()}


def test_at_its_end_it_stops_and_says_so_and_plays_again_from_the_start(recording: Path) -> None:
    show = Show(recording, at_s=11.0)
    show.player.play(show.now_s, 1.0)
    show.run(3.0)
    last = show.viewer.playbacks[-1]
    assert (last.state, last.at_s) == ("ended", last.duration_s)
    show.player.play(show.now_s, 1.0)
    show.run(0.5)
    assert show.at_s == pytest.approx(0.5, abs=0.001)
    assert show.player.playback().state == "playing"


def test_a_loop_repeats_its_stretch(recording: Path) -> None:
    show = Show(recording)
    show.player.loop((2.0, 3.0))
    show.player.play(show.now_s, 1.0)
    show.run(5.5)
    assert 2.0 <= show.at_s <= 3.0
    assert show.viewer.playbacks[-1].jumps >= 3
    show.player.loop(None)
    show.run(2.0)
    assert show.at_s > 3.5


def test_a_seek_shows_the_moment_at_once_and_a_paused_replay_stays_there(recording: Path) -> None:
    show = Show(recording, keys=True)
    show.viewer.samples.clear()
    show.player.seek(show.now_s, 9.0)
    show.run(5.0)
    assert show.at_s == 9.0
    assert show.viewer.playbacks[-1].state == "paused"
    assert {topic for topic, _, _ in show.viewer.samples} == {
        "ahrs",
        "heartbeat",
        "statistics",
        "simulator",
        "xplane_info",
        "xplane_rows",
    }
    assert all(t_s <= (STARTS_NS + 9 * SECOND_NS) * 1e-9 for _, t_s, _ in show.viewer.samples)
    assert len(show.viewer.statuses) >= 5, "the status comes each second, or its silence counts as a loss"
    assert (show.viewer.statuses[-1].topics["ahrs"].age_s or 0.0) < 0.1


def test_frames_can_be_stepped_forward_and_back(recording: Path) -> None:
    show = Show(recording, at_s=3.0)
    seen = []
    for _ in range(6):
        show.player.step(show.now_s, 1)
        show.settle()
        seen.append(dict(show.player.head.vehicle.telemetry.samples()))
    assert len({one["ahrs"].t_s for one in seen}) >= 2
    for expected in reversed(seen[:-1]):
        show.player.step(show.now_s, -1)
        show.settle()
        assert show.player.head.vehicle.telemetry.samples() == expected


def test_a_moment_reached_without_key_frames_becomes_exact_when_they_come(tmp_path: Path) -> None:
    path = write(tmp_path / "a.mcap", flight(40.0))
    show = Show(path, at_s=39.0)
    rough = show.player.status()
    assert rough.topics["ahrs"].count < 400
    while show.scout.has_work:
        show.scout.work()
        show.player.keys_came(show.now_s)
    show.settle()
    exact = Show(path, keys=True, at_s=39.0)
    assert show.player.status() == exact.player.status()
    assert exact.player.status().topics["ahrs"].count > 700
    assert show.player.playback().at_s == 39.0


def test_the_growing_edge_is_played_as_it_comes(tmp_path: Path) -> None:
    data = write(tmp_path / "whole.mcap", flight(8.0)).read_bytes()
    path = tmp_path / "growing.mcap"
    path.write_bytes(data[: len(data) // 2])
    show = Show(path, at_s=3.0)
    show.player.play(show.now_s, 1.0)
    show.run(4.0)
    edge_s = show.at_s
    assert edge_s == pytest.approx(show.player.playback().edge_s)
    assert show.player.playback().state == "playing"
    with path.open("ab") as file:
        file.write(data[len(data) // 2 :])
    show.run(2.0)
    assert show.at_s > edge_s + 1.5
    show.run(4.0)
    assert show.player.playback().state == "ended"
