"""Rehearsals through their program, with the ground from the station's heights."""

from __future__ import annotations

import asyncio
from dataclasses import asdict

import numpy as np
import pytest

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import ConflictError
from epf_gcs.formats.quantized_mesh_reading import SIDE
from epf_gcs.maps.layer import Bounds as LayerBounds
from epf_gcs.maps.layer import Description, Layer
from epf_gcs.rehearsal import rehearsals
from epf_gcs.rehearsal.findings import Bounds, findings
from epf_gcs.rehearsal.flight_model import SteadyWind
from epf_gcs.rehearsal.flown_plan import fly, start_at_first
from epf_gcs.rehearsal.rehearsals import Rehearsal, RehearsalOrder, Rehearsals
from epf_gcs.units import m_from_ft
from tests.rehearsal.plans import OPEN, SQUARE, STRAIGHT
from tests.support.gateway import Gateway
from tests.support.waiting import DEADLINE_S

ISLAND: list[Waypoint] = list(ROUTES["ruta_isla"].waypoints)


class Plain:
    """Heights of a plain, known to a meridian."""

    def __init__(self, height_ft: float, known_to_deg: float = 180.0) -> None:
        self._height_ft = height_ft
        self._known_to_deg = known_to_deg
        self.asked = 0

    async def terrain_layers(self) -> list[Layer]:
        bounds = LayerBounds(east_deg=self._known_to_deg)
        return [Layer("plain", "plain", "mbtiles", Description("plain", "terrain", bounds, 0, 14, ""), 1)]

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        self.asked += 1
        return np.full((SIDE, SIDE), m_from_ft(self._height_ft), dtype="<f4").tobytes()


class Nothing:
    async def terrain_layers(self) -> list[Layer]:
        return []

    async def grid(self, layer_id: str, zoom: int, column: int, row: int) -> bytes | None:
        raise AssertionError("there is no layer")


def order(waypoints: list[Waypoint], first: int = 0, bounds: Bounds = OPEN) -> RehearsalOrder:
    return RehearsalOrder(waypoints, first, None, SteadyWind(240, 15), bounds)


def flown(asked: RehearsalOrder, tiles: Plain | Nothing) -> Rehearsal:
    return asyncio.run(Rehearsals(tiles).fly(asked))


def test_the_program_finds_what_its_parts_find() -> None:
    corners = ((27.8, -15.7), (28.0, -15.7), (28.0, -15.3), (27.8, -15.3))
    asked = order(ISLAND, 3, Bounds(corners, 2200.0, 150.0, 1800.0))
    found = flown(asked, Plain(1400.0))
    here = fly(ISLAND, 3, start_at_first(ISLAND[3:]), asked.wind)
    expected = findings(ISLAND, here, [1400.0] * len(here.samples), asked.bounds)
    assert {one.code for one in expected} >= {"leaves_fence", "above_ceiling", "low_ground", "battery_ends"}
    assert [(one.code, one.row) for one in found.findings] == [(one.code, one.row) for one in expected]
    assert found.time_s == pytest.approx(here.time_s)
    assert (found.last, found.ground) == (19, "whole")
    (judged_by,) = found.heights
    assert (judged_by.name, judged_by.datum) == ("plain", None)
    assert 40.0 < judged_by.geoid_m < 50.0, "over Gran Canaria, once for the whole flight"


def test_the_island_round_is_known_whole_though_it_crosses_more_tiles_than_are_kept() -> None:
    tiles = Plain(0.0)
    found = flown(order(ISLAND), tiles)
    assert (found.ground, found.findings) == ("whole", [])
    assert tiles.asked > 128


def test_ground_that_is_not_known_is_said() -> None:
    unknown = flown(order(STRAIGHT), Nothing())
    assert (unknown.ground, unknown.heights) == ("none", [])
    assert flown(order(SQUARE), Plain(0.0, known_to_deg=-15.39)).ground == "part"


def test_a_program_that_ends_without_a_word_is_no_result(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rehearsals, "_PROGRAM", "epf_gcs.no_such_program")
    with pytest.raises(ConflictError) as failed:
        flown(order(STRAIGHT), Nothing())
    assert failed.value.code == "rehearsal_failed"


def test_heights_that_take_too_long_are_no_result(monkeypatch: pytest.MonkeyPatch) -> None:
    class Stuck(Nothing):
        async def terrain_layers(self) -> list[Layer]:
            await asyncio.sleep(DEADLINE_S)
            return []

    monkeypatch.setattr(rehearsals, "LONGEST_S", 0.5)
    with pytest.raises(ConflictError) as late:
        flown(order(STRAIGHT), Stuck())
    assert late.value.code == "rehearsal_late"


def test_the_third_at_once_is_told_that_it_was_not_flown() -> None:
    async def three() -> list[Rehearsal | BaseException]:
        together = Rehearsals(Nothing())
        return await asyncio.gather(*(together.fly(order(SQUARE)) for _ in range(3)), return_exceptions=True)

    first, second, third = asyncio.run(three())
    assert isinstance(first, Rehearsal)
    assert isinstance(second, Rehearsal)
    assert isinstance(third, ConflictError)
    assert third.code == "rehearsal_busy"


def test_over_rest_it_is_flown_against_the_stations_fence(gateway: Gateway) -> None:
    waypoints = [asdict(waypoint) for waypoint in SQUARE]
    answer = gateway.http.post("/missions/rehearsal", json={"waypoints": waypoints}).raise_for_status().json()
    assert answer["findings"] == []
    assert (answer["last"], answer["ground"], answer["fence"], answer["battery"]) == (4, "none", False, False)
    assert 250.0 < answer["time_s"] < 350.0
    choice = {**gateway.http.get("/surroundings").json(), "ceiling_ft": 900.0}
    gateway.http.put("/surroundings", json=choice).raise_for_status()
    body = {
        "waypoints": waypoints,
        "first": 2,
        "start": {"latitude_deg": 27.9, "longitude_deg": -15.4, "altitude_ft": 500, "track_deg": 0, "speed_kt": 0},
        "wind": {"from_deg": 90, "speed_kt": 10},
        "endurance_min": 60,
    }
    answer = gateway.http.post("/missions/rehearsal", json=body).raise_for_status().json()
    assert (answer["fence"], answer["battery"]) == (True, True)
    assert {(one["code"], one["row"]) for one in answer["findings"]} == {("above_ceiling", row) for row in (2, 3, 4)}
    refused = gateway.http.post("/missions/rehearsal", json={"waypoints": waypoints, "first": 5})
    assert refused.status_code == 422
