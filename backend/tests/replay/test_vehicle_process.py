"""All replays of one recording, on a real event loop and real sockets: each viewer has its own moment."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.bus.definition import Named
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.errors import GatewayError
from epf_gcs.replay.vehicle_process import VehicleProcess
from tests.replay.recordings import STARTS_NS, flight, write
from tests.support.waiting import eventually_async


class Watching:
    """Implements `epf_gcs.bus.station_end.Listener`."""

    def __init__(self, folder: Path) -> None:
        self.end = StationEnd(folder, self)
        self.hello: dict[str, Any] = {}
        self.playback: dict[str, Any] = {}
        self.samples: list[Named] = []
        self.statuses = 0
        self.is_lost = False

    def on_silence(self, *, silent: bool) -> None:
        """A replay may be silent."""

    def on_hello(self, hello: dict[str, Any]) -> None:
        self.hello, self.playback = hello, hello["playback"]

    def on_sample(self, sample: Named) -> None:
        self.samples.append(sample)

    def on_samples_end(self) -> None:
        pass

    def on_event(self, event: Named) -> None:
        pass

    def on_status(self, status: dict[str, Any]) -> None:
        self.statuses += 1

    def on_playback(self, playback: dict[str, Any]) -> None:
        self.playback = playback

    def on_lost(self, *, ended: bool) -> None:
        self.is_lost = True

    async def until(self, **wanted: Any) -> None:
        """Wait until the replay says this of itself."""
        await eventually_async(
            lambda: all(self.playback.get(name) == value for name, value in wanted.items()), f"it is {wanted}"
        )


@asynccontextmanager
async def watching(process: VehicleProcess, folder: Path, at_s: float) -> AsyncIterator[Watching]:
    watched = Watching(folder)
    process.open(folder, at_s)
    running = asyncio.ensure_future(watched.end.run())
    try:
        await eventually_async(lambda: bool(watched.hello), "hello")
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
            assert (first.playback["at_s"], second.playback["at_s"]) == (2.0, 9.0)
            assert first.hello["starts_s"] == pytest.approx(STARTS_NS * 1e-9)
            wishes: list[tuple[str, dict[str, Any], dict[str, Any]]] = [
                ("seek", {"at_s": 5.0}, {"at_s": 5.0, "state": "paused"}),
                ("loop", {"from_s": 3.0, "to_s": 4.0}, {"loop": [3.0, 4.0]}),
                ("loop", {}, {"loop": None}),
                ("play", {"rate": 0.5}, {"rate": 0.5, "state": "playing"}),
                ("pause", {}, {"state": "paused"}),
            ]
            for name, wished, expected in wishes:
                first.end.notice(name, **wished)
                await first.until(**expected)
            before = first.playback["at_s"]
            first.end.notice("step", frames=1)
            await eventually_async(lambda: first.playback["at_s"] > before, "a step")
            assert second.playback["at_s"] == 9.0
            no_wishes: list[tuple[str, dict[str, Any]]] = [
                ("seek", {"at_s": "5"}),
                ("seek", {"at_s": 1e300}),
                ("play", {"rate": float("inf")}),
                ("step", {"frames": 0}),
                ("command", {"name": "start"}),
            ]
            for name, arguments in no_wishes:
                second.end.notice(name, **arguments)
            assert (await second.end.request("playback"))["at_s"] == 9.0, "what is no wish changes nothing"

    run(process, viewers)


def test_what_is_asked_of_the_past_is_answered_and_nothing_can_be_commanded(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 6.0) as viewer:
            status = await viewer.end.request("status")
            assert status["board"]["frames_received"] > 100
            snapshot = await viewer.end.request("telemetry")
            assert snapshot["ahrs"]["age_s"] < 0.2
            with pytest.raises(GatewayError):
                await viewer.end.request("parameters.set")

    run(process, viewers)


def test_a_viewer_of_every_sample_gets_on_as_it_takes_them_to_the_end(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 0.0) as viewer:
            viewer.end.notice("want", rate_hz=0)
            viewer.end.notice("play", rate=100.0)
            taken = 0
            while viewer.playback["state"] != "ended":
                viewer.end.notice("taken", count=len(viewer.samples) - taken)
                taken = len(viewer.samples)
                await asyncio.sleep(0.01)
            assert sum(1 for sample in viewer.samples if sample.name == "ahrs") >= 12 * 20 - 5

    run(process, viewers)


def test_key_frames_are_made_in_spare_moments_and_make_a_moment_exact(tmp_path: Path) -> None:
    path = write(tmp_path / "long.mcap", flight(40.0))
    process = VehicleProcess(path, tmp_path / "keys" / "long.keys")

    async def viewers() -> None:
        async with watching(process, tmp_path / "1", 39.0) as viewer:
            rough = viewer.playback["jumps"]
            await eventually_async(lambda: viewer.playback["jumps"] > rough, "the moment is reached again, from a key")
            status = await viewer.end.request("status")
            assert status["topics"]["ahrs"]["count"] > 700
            assert viewer.playback["at_s"] == 39.0

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
        await eventually_async(lambda: bool(viewer.hello), "hello, when it has begun")
        running.cancel()

    run(process, viewers)


def test_a_folder_that_has_gone_leaves_the_other_viewers_alone(recording: Path, tmp_path: Path) -> None:
    process = VehicleProcess(recording, None)
    (tmp_path / "file").write_bytes(b"")

    async def viewers() -> None:
        process.open(tmp_path / "file" / "folder", 1.0)
        async with watching(process, tmp_path / "1", 3.0) as viewer:
            assert viewer.playback["at_s"] == 3.0

    run(process, viewers)
