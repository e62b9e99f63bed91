"""Ground and fence over REST and in the status, and their file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from epf_gcs.errors import ConflictError
from epf_gcs.surroundings.kept import FILE_NAME, OFF, KeptSurroundings
from tests.support.gateway import Gateway

CORNERS = [
    {"latitude_deg": 28.0, "longitude_deg": -15.5},
    {"latitude_deg": 28.0, "longitude_deg": -15.4},
    {"latitude_deg": 28.1, "longitude_deg": -15.4},
]
CHOICE = {
    "terrain_on": True,
    "margin_ft": 200.0,
    "fence_on": True,
    "corners": CORNERS,
    "ceiling_ft": 1500.0,
    "fence_margin_ft": 60.0,
}


def off() -> dict[str, Any]:
    return OFF.model_dump()


def test_nothing_warns_until_it_is_chosen_and_the_choice_is_kept_and_told(gateway: Gateway) -> None:
    found = gateway.http.get("/surroundings").json()
    assert found == off()
    assert not found["terrain_on"]
    assert not found["fence_on"]
    with gateway.stream() as stream:
        assert gateway.http.put("/surroundings", json=CHOICE).raise_for_status().json() == CHOICE
        stream.event("surroundings")
    assert gateway.http.get("/surroundings").json() == CHOICE
    gateway.http.put("/surroundings", json=off()).raise_for_status()


def test_without_a_position_the_status_says_that_it_is_blind(gateway: Gateway) -> None:
    around = gateway.http.get("/status").json()["surroundings"]
    assert around["flight"]["blind"] == "no_position"
    assert (around["flight"]["height_ft"], around["flight"]["terrain"], around["flight"]["path"]) == (None, None, [])


@pytest.mark.parametrize(
    "part",
    [
        {"margin_ft": 0},
        {"margin_ft": None},
        {"corners": CORNERS[:2]},
        {"corners": CORNERS * 40},
        {"corners": [{"latitude_deg": 91, "longitude_deg": 0}, *CORNERS]},
        {"corners": [], "ceiling_ft": None},
        {"ceiling": 3},
    ],
)
def test_what_is_no_fence_is_refused_and_the_old_one_stays(gateway: Gateway, part: dict[str, Any]) -> None:
    assert gateway.http.put("/surroundings", json={**CHOICE, **part}).status_code == 422
    assert gateway.http.get("/surroundings").json() == off()


def test_without_a_file_everything_is_off_and_one_that_is_damaged_is_no_choice(tmp_path: Path) -> None:
    assert KeptSurroundings(tmp_path).read() == OFF
    (tmp_path / FILE_NAME).write_bytes(b"\xff{")
    assert KeptSurroundings(tmp_path).read() is None


def test_a_kept_choice_is_read_again_and_a_disk_that_does_not_take_it_is_said(tmp_path: Path) -> None:
    choice = OFF.model_copy(update={"terrain_on": True})
    KeptSurroundings(tmp_path).write(choice)
    assert KeptSurroundings(tmp_path).read() == choice
    with pytest.raises(ConflictError, match="cannot be kept"):
        KeptSurroundings(tmp_path / "gone").write(choice)


@pytest.mark.parametrize("form", ["kml", "plan"])
def test_the_fence_goes_into_a_file_and_comes_out_of_it_without_being_chosen(gateway: Gateway, form: str) -> None:
    assert gateway.http.get(f"/surroundings/fence?format={form}").json()["code"] == "surroundings_no_fence"
    gateway.http.put("/surroundings", json=CHOICE).raise_for_status()
    answer = gateway.http.get(f"/surroundings/fence?format={form}").raise_for_status()
    assert f'filename="epf-gcs-fence.{form}"' in answer.headers["content-disposition"]
    gateway.http.put("/surroundings", json=off()).raise_for_status()
    found = gateway.http.post("/surroundings/fence/import?name=mine", content=answer.content).raise_for_status().json()
    assert (found["corners"], found["notes"], found["format"]) == (CORNERS, [], form)
    # QGroundControl's has no place for a ceiling.
    assert found["ceiling_ft"] == (1500.0 if form == "kml" else None)
    assert gateway.http.get("/surroundings").json() == off(), "nothing is watched that nobody chose"


def test_a_file_that_is_no_fence_is_refused_by_its_name(gateway: Gateway) -> None:
    answer = gateway.http.post("/surroundings/fence/import?name=photo.jpg", content=b"\xff\xd8" * 200_000)
    assert (answer.status_code, answer.json()["code"]) == (422, "fence_file_unknown")
    assert "photo.jpg" in answer.json()["detail"]
    assert gateway.http.post("/surroundings/fence/import?name=x", content=bytes(1_000_001)).status_code == 413
