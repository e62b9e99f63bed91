"""Both aircraft watched: what the flight process is told, and what the status says."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from epf_gcs.contract.notices import Notice, SurroundingsReport
from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.quantized_mesh_reading import SIDE
from epf_gcs.maps.layer import Bounds, Description, Layer
from epf_gcs.surroundings.choice import FenceCorner
from epf_gcs.surroundings.kept import FILE_NAME, OFF, KeptSurroundings
from epf_gcs.surroundings.watch import Surroundings
from tests.support.waiting import DEADLINE_S

FIELD = Description("field", "terrain", Bounds(-16, 27, -15, 29), 0, 6, "")


class FlatTiles:
    """Ground at 400 m everywhere in the layer."""

    async def terrain_layers(self) -> list[Layer]:
        return [Layer("field", "field", "mbtiles", FIELD, 1)]

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        del layer_id, zoom, column, row
        return np.full((SIDE, SIDE), 400.0, dtype="<f4").tobytes()


class Mirror:
    """The newest values of each topic, and whether they are live."""

    def __init__(self) -> None:
        self.topics: dict[str, tuple[float, dict[str, Any]]] = {}
        self.live: set[str] = set()
        self.latitude_deg = 28.0

    def newest(self, topic: str) -> dict[str, Any] | None:
        return self.topics[topic][1] if topic in self.topics else None

    def newest_at_s(self, topic: str) -> float | None:
        return self.topics[topic][0] if topic in self.topics else None

    def is_live(self, topic: str) -> bool:
        return topic in self.live

    def gps(self, t_s: float, altitude_m: float, *, valid: bool = True) -> None:
        east_deg = -15.5 + 30.0 * t_s / 111_195.0 / math.cos(math.radians(28.0))
        values = {
            "valid": valid,
            "fix": 3,
            "latitude_deg": self.latitude_deg,
            "longitude_deg": east_deg,
            "altitude_m": altitude_m,
        }
        self.topics["gps"] = (t_s, {**values, "speed_kt": 58.3, "heading_deg": 90.0})
        self.live.add("gps")


class Station:
    """A watch with its clock, its notices, and a flight towards lower and lower ground clearance."""

    def __init__(self, folder: Path) -> None:
        self.mirror, self.now_s = Mirror(), 0.0
        self.told: list[list[Mapping[str, Any]]] = []
        self.watch = Surroundings(
            self.mirror,
            FlatTiles(),
            KeptSurroundings(folder),
            lambda: self.now_s,
            self._notice,
        )

    def _notice(self, notice: Notice) -> None:
        assert isinstance(notice, SurroundingsReport)
        self.told.append(notice.findings)
        self.watched, self.blind = notice.watched, notice.blind

    async def fly(self, until_s: float, altitude_m: float, climb_mps: float = 0.0) -> None:
        while self.now_s < until_s:
            self.now_s += 0.2
            self.mirror.gps(self.now_s, altitude_m + climb_mps * self.now_s)
            self.watch.gather()
            self.watch.look()
            await asyncio.sleep(0)

    def flight(self) -> dict[str, Any]:
        return asdict(self.watch.state().flight)


async def run(station: Station) -> asyncio.Task[None]:
    """Begin to look for heights, and wait until the layer is known."""
    running = asyncio.create_task(station.watch.run())
    async with asyncio.timeout(DEADLINE_S):
        while station.watch.state().flight.ground_ft is None:
            station.now_s += 0.2
            station.mirror.gps(station.now_s, 1000.0)
            station.watch.gather()
            station.watch.look()
            await asyncio.sleep(0.01)
    return running


def test_height_is_shown_to_all_and_nothing_is_told_until_somebody_chooses(tmp_path: Path) -> None:
    async def fly() -> None:
        station = Station(tmp_path)
        running = await run(station)
        await station.fly(station.now_s + 20, 420.0)
        assert abs(station.flight()["height_ft"] - 20 / 0.3048) < 0.5
        assert station.flight()["terrain"] is None
        assert not any(station.told)
        assert station.watched == []
        running.cancel()

    asyncio.run(fly())


def test_a_chosen_warning_is_told_again_and_again_and_ends_when_it_is_switched_off(tmp_path: Path) -> None:
    async def fly() -> None:
        station = Station(tmp_path)
        running = await run(station)
        await station.watch.choose(OFF.model_copy(update={"terrain_on": True}))
        # It was at 1,000 m: long enough for that to be forgotten.
        await station.fly(station.now_s + 25, 700.0)
        assert (station.told[-1], station.watched, station.blind) == ([], ["terrain"], [])
        start_s = station.now_s
        await station.fly(start_s + 25, 700.0 + 6.0 * start_s, climb_mps=-6.0)
        assert [one["id"] for one in station.told[-1]] == ["terrain_ahead"]
        assert station.told[-1][0]["aircraft"] == "flight"
        assert station.flight()["terrain"]["what"] == "terrain"
        assert len(station.flight()["path"]) > 5
        await station.watch.choose(OFF)
        assert station.told[-1] == []
        assert station.flight()["terrain"] is None
        running.cancel()

    asyncio.run(fly())


def test_ground_that_was_seen_and_cannot_be_seen_any_more_is_said_not_to_be_watched(tmp_path: Path) -> None:
    async def fly() -> None:
        station = Station(tmp_path)
        running = await run(station)
        await station.watch.choose(OFF.model_copy(update={"terrain_on": True}))
        await station.fly(station.now_s + 5, 700.0)
        assert station.blind == []
        station.mirror.latitude_deg += 5.0  # where the map ends
        await station.fly(station.now_s + 30, 700.0)
        assert station.flight()["blind"] == "no_heights_here"
        assert station.blind == ["terrain"]
        running.cancel()

    asyncio.run(fly())


@pytest.mark.parametrize("content", [b"{", b"", b'{"terrain_on": true}'])
def test_a_choice_that_cannot_be_read_is_said_to_be_unknown_until_another_replaces_it(
    tmp_path: Path, content: bytes
) -> None:
    """It stays where it is, so that no restart takes it for none."""

    async def fly() -> None:
        (tmp_path / FILE_NAME).write_bytes(content)
        before = Station(tmp_path)
        (await run(before)).cancel()
        assert before.watched == ["unknown"]
        station = Station(tmp_path)
        (await run(station)).cancel()
        assert station.watched == ["unknown"]
        await station.watch.choose(OFF.model_copy(update={"terrain_on": True}))
        assert station.watched == ["terrain"]
        assert KeptSurroundings(tmp_path).read() == station.watch.choice

    asyncio.run(fly())
    assert [path.read_bytes() for path in tmp_path.glob(f"{FILE_NAME}.damaged-*")] == [content]


def test_a_fence_that_crosses_itself_is_not_taken_and_one_that_is_kept_so_is_no_choice(tmp_path: Path) -> None:
    corners = [(28.0, -15.0), (29.0, -14.0), (29.0, -15.0), (28.0, -14.0)]
    crossed = OFF.model_copy(
        update={"fence_on": True, "corners": [FenceCorner(latitude_deg=a, longitude_deg=b) for a, b in corners]}
    )

    async def fly() -> None:
        station = Station(tmp_path)
        with pytest.raises(InvalidInputError) as caught:
            await station.watch.choose(crossed)
        assert (caught.value.code, caught.value.params) == ("fence_crosses", {"first": 1, "second": 3})
        assert station.watch.choice == OFF

    asyncio.run(fly())
    KeptSurroundings(tmp_path).write(crossed)
    assert KeptSurroundings(tmp_path).read() is None, "nobody knows what is inside"


def test_without_a_valid_live_position_nothing_is_shown_or_told(tmp_path: Path) -> None:
    async def fly() -> None:
        station = Station(tmp_path)
        running = await run(station)
        await station.watch.choose(OFF.model_copy(update={"terrain_on": True}))
        await station.fly(station.now_s + 10, 410.0)
        assert station.told[-1] != []
        station.mirror.gps(station.now_s + 0.1, 410.0, valid=False)
        station.now_s += 1.5
        station.watch.gather()
        station.watch.look()
        assert station.told[-1] == []
        assert (station.flight()["blind"], station.flight()["height_ft"]) == ("no_position", None)
        running.cancel()

    asyncio.run(fly())
