"""All replays of one recording, on a real event loop and real sockets: each viewer has its own moment."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any, cast

import pytest

from epf_gcs.bus.definition import NamedText
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.contract.hello import Hello
from epf_gcs.contract.notices import Notice, StickRelease
from epf_gcs.contract.playback import Loop, Pause, Play, Playback, SampleCredit, Seek, Step, Want
from epf_gcs.contract.requests import ReadPlayback, ReadStatus, ReadTelemetry, SetParameters
from epf_gcs.contract.status import Status
from epf_gcs.errors import GatewayError
from epf_gcs.replay.vehicle_process import VehicleProcess
from tests.replay.recordings import STARTS_NS, flight, write
from tests.support.contract import a_playback
from tests.support.waiting import eventually_async


class Watching:
    """Implements `epf_gcs.bus.station_end.Listener`."""

    def __init__(self, folder: Path) -> None:
        self.end = StationEnd(folder, self)
        self.hello: Hello | None = None
        self.playback = a_playback()
        self.samples: list[NamedText] = []
        self.statuses = 0
        self.is_lost = False

    def on_silence(self, *, silent: bool) -> None:
        """A replay may be silent."""

    def on_hello(self, hello: Hello) -> None:
        assert hello.playback is not None
        self.hello, self.playback = hello, hello.playback

    def on_sample(self, sample: NamedText) -> None:
        self.samples.append(sample)

    def on_samples_end(self) -> None:
        pass

    def on_event(self, event: NamedText) -> None:
        pass

    def on_status(self, status: Status) -> None:
        self.statuses += 1

    def on_playback(self, playback: Playback) -> None:
        self.playback = playback

    def on_lost(self, *, ended: bool) -> None:
        self.is_lost = True

    async def until(self, **wanted: Any) -> None:
        """Wait until the replay says this of itself."""
        await eventually_async(
            lambda: all(getattr(self.playback, name) == value for name, value in wanted.items()), f"it is {wanted}"
        )


@asynccontextmanager
async def watching(process: VehicleProcess, folder: Path, at_s: float) -> AsyncIterator[Watching]:
    watched = Watching(folder)
    process.open(folder, at_s)
    running = asyncio.ensure_future(watched.end.run())
    try:
        await eventually_async(lambda: watched.hello is not None, "hello")
        yield watched
    finally:
        running.cancel()


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("flight") / "a.mcap", flight(12.0))


def run(process: VehicleProcess, viewers: Any) -> None:
    """Run the process beside what the viewers do."""

    async def both() -> None:
        running = asyncio.ensure_future(process.run())
        watched = asyncio.ensure_future(viewers())
        done, _ = await asyncio.wait({running, watched}, return_when=asyncio.FIRST_COMPLETED)
        for task in (running, watched):
            task.cancel()
        for task in done:
            task.result()

    try:
        asyncio.run(both())
    finally:
        process.close()


def test_two_viewers_are_each_at_their_own_moment_and_say_each_what_they_want(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, tmp_path / "a.keys")

    async def viewers() -> None:
        async with (
            watching(process, tmp_path / "1", 2.0) as first,
            watching(process, tmp_path / "2", 9.0) as second,
        ):
            assert (first.playback.at_s, second.playback.at_s) == (2.0, 9.0)
            assert first.hello is not None
            assert first.hello.flight is not None
            assert first.hello.flight.starts_s == pytest.approx(STARTS_NS * 1e-9)
            wishes: list[tuple[Notice, dict[str, Any]]] = [
                (Seek(5.0), {"at_s": 5.0, "state": "paused"}),
                (Loop(3.0, 4.0), {"loop": (3.0, 4.0)}),
                (Loop(), {"loop": None}),
                (Play(0.5), {"rate": 0.5, "state": "playing"}),
                (Pause(), {"state": "paused"}),
            ]
            for wish, expected in wishes:
                first.end.notice(wish)
                await first.until(**expected)
            before = first.playback.at_s
            first.end.notice(Step(1))
            await eventually_async(lambda: first.playback.at_s > before, "a step")
            assert second.playback.at_s == 9.0
            no_wishes: list[Notice] = [
                Seek(cast(float, "5")),
                Seek(1e300),
                Play(float("inf")),
                Step(0),
                StickRelease("c1"),
            ]
            for no_wish in no_wishes:
                second.end.notice(no_wish)
            assert (await second.end.ask(ReadPlayback())).at_s == 9.0, "what is no wish changes nothing"

    run(process, viewers)


def test_what_is_asked_of_the_past_is_answered_and_nothing_can_be_commanded(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 6.0) as viewer:
            status = await viewer.end.ask(ReadStatus())
            assert status.board.frames_received > 100
            snapshot = await viewer.end.ask(ReadTelemetry())
            assert snapshot["ahrs"].age_s < 0.2
            with pytest.raises(GatewayError):
                await viewer.end.ask(SetParameters({"k_pitch": 2.0}))

    run(process, viewers)


def test_a_viewer_of_every_sample_gets_on_as_it_takes_them_to_the_end(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 0.0) as viewer:
            viewer.end.notice(Want(0))
            viewer.end.notice(Play(100.0))
            taken = 0
            while viewer.playback.state != "ended":
                viewer.end.notice(SampleCredit(len(viewer.samples) - taken))
                taken = len(viewer.samples)
                await asyncio.sleep(0.01)
            assert sum(1 for sample in viewer.samples if sample.name == "ahrs") >= 12 * 20 - 5

    run(process, viewers)


def test_key_frames_are_made_in_spare_moments_and_make_a_moment_exact(tmp_path: Path) -> None:
    path = write(tmp_path / "long.mcap", flight(40.0))
    process = VehicleProcess(path, tmp_path / "keys" / "long.keys")

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 39.0) as viewer:
            rough = viewer.playback.jumps
            await eventually_async(lambda: viewer.playback.jumps > rough, "the moment is reached again, from a key")
            status = await viewer.end.ask(ReadStatus())
            assert status.topics["ahrs"].count > 700
            assert viewer.playback.at_s == 39.0

    run(process, viewers)
    assert (tmp_path / "keys" / "long.keys").stat().st_size > 10_000


def test_a_recording_that_begins_now_is_waited_for(tmp_path: Path) -> None:
    data = write(tmp_path / "whole.mcap", flight(3.0)).read_bytes()
    path = tmp_path / "growing.mcap"
    path.write_bytes(data[:200])
    process = VehicleProcess(path, None)

    async def viewers() -> None:
        process.open(tmp_path / "1", 0.0)
        viewer = Watching(tmp_path / "1")
        running = asyncio.ensure_future(viewer.end.run())
        await asyncio.sleep(0)
        path.write_bytes(data)
        await eventually_async(lambda: viewer.hello is not None, "hello, when it has begun")
        running.cancel()

    run(process, viewers)


def test_a_folder_that_has_gone_leaves_the_other_viewers_alone(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)
    (tmp_path / "file").write_bytes(b"")

    async def viewers() -> None:
        process.open(tmp_path / "file" / "folder", 1.0)
        async with watching(process, tmp_path / "1", 3.0) as viewer:
            assert viewer.playback.at_s == 3.0

    run(process, viewers)
