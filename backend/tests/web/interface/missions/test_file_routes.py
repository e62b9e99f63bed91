"""Plan files over REST: down and up again, refused in one sentence, and never sent to the board by themselves."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import quote

import pytest

from epf_gcs.codec.messages_gen import ROUTES
from epf_gcs.formats.quantized_mesh import CELLS
from epf_gcs.formats.recognise import MAX_FILE_BYTES
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.kml import schema_faults
from tests.surroundings.test_ground import SIZE_DEG, SOUTH, WEST, write_terrain

GANDO = [
    {name: getattr(at, name) for name in ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")}
    for at in ROUTES["gando"].waypoints
]
MEDIA_TYPES = {
    "kml": "application/vnd.google-earth.kml+xml",
    "kmz": "application/vnd.google-earth.kmz",
    "gpx": "application/gpx+xml",
    "csv": "text/csv; charset=utf-8",
    "plan": "application/octet-stream",
}


@pytest.mark.parametrize("format_name", MEDIA_TYPES)
def test_a_plan_goes_out_and_comes_back(gateway: Gateway, format_name: str) -> None:
    answer = gateway.http.post(
        f"/missions/export?format={format_name}", json={"name": "Vuelta a Gando", "waypoints": GANDO}
    ).raise_for_status()
    assert answer.headers["content-type"] == MEDIA_TYPES[format_name]
    assert f'filename="Vuelta a Gando.{format_name}"' in answer.headers["content-disposition"]
    if format_name == "kml":
        assert schema_faults(answer.content) == []
    read = gateway.http.post(f"/missions/import?name=x.{format_name}", content=answer.content)
    assert read.raise_for_status().json() == {
        "format": "kml" if format_name == "kmz" else format_name,
        "waypoints": [{**waypoint, "origin": None} for waypoint in GANDO],
        "notes": [],
        "heights": [],
    }


def test_neither_needs_nor_touches_a_board(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    before = list(board.received)
    exported = gateway.http.post("/missions/export?format=gpx", json={"name": "x", "waypoints": GANDO})
    gateway.http.post("/missions/import?name=x.gpx", content=exported.content).raise_for_status()
    assert [name for name in board.received[len(before) :] if name.startswith("mission")] == []


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        (
            '../../etc/passwd"\r\nX-Evil: 1',
            "filename=\"_.._etc_passwd_X-Evil_ 1.csv\"; filename*=UTF-8''_.._etc_passwd_X-Evil_%201.csv",
        ),
        ("Peña Ñ 1", "filename=\"Pe_a _ 1.csv\"; filename*=UTF-8''Pe%C3%B1a%20%C3%91%201.csv"),
        ("\u202e\x00 . ", "filename=\"plan.csv\"; filename*=UTF-8''plan.csv"),
    ],
)
def test_the_name_of_a_download_is_safe_on_every_system(gateway: Gateway, name: str, expected: str) -> None:
    answer = gateway.http.post("/missions/export?format=csv", json={"name": name, "waypoints": GANDO})
    assert answer.raise_for_status().headers["content-disposition"] == f"attachment; {expected}"
    assert "x-evil" not in answer.headers


def test_a_foreign_file_comes_with_notes(gateway: Gateway) -> None:
    text = "latitude_deg;longitude_deg\n27,9;-15,4\n"
    answer = gateway.http.post("/missions/import?name=ruta.csv", content=text).raise_for_status().json()
    assert answer == {
        "format": "csv",
        "waypoints": [
            {"latitude_deg": 27.9, "longitude_deg": -15.4, "altitude_ft": 1000.0, "speed_kt": 55.0, "origin": None}
        ],
        "notes": [
            {"code": "altitude_missing", "params": {"count": 1, "altitude_ft": 1000.0}},
            {"code": "speed_missing", "params": {"count": 1, "speed_kt": 55.0}},
        ],
        "heights": [],
    }


def test_a_file_that_is_no_plan_is_refused_by_its_name(gateway: Gateway) -> None:
    name = "fotos de mañana.png"
    answer = gateway.http.post(f"/missions/import?name={quote(name)}", content=b"\x89PNG\r\n\x1a\n" + bytes(2000))
    assert (answer.status_code, answer.json()["code"]) == (422, "mission_file_unknown")
    assert answer.json()["detail"].startswith(f"'{name}' cannot be read as a flight plan because ")
    assert answer.json()["params"] == {"name": name}


RELATIVE = "QGC WPL 110\n1\t0\t3\t16\t0\t0\t0\t0\t{place}\t100\t1\n2\t0\t{frame}\t16\t0\t0\t0\t0\t{place}\t60\t1\n"


def test_heights_above_an_unknown_home_are_a_question_and_its_answer_reads_the_file(gateway: Gateway) -> None:
    text = RELATIVE.format(place="27.9\t-15.4", frame=0)
    problem = gateway.http.post("/missions/import?name=x.waypoints", content=text)
    assert (problem.status_code, problem.json()["code"]) == (422, "mission_file_no_home")
    assert problem.json()["params"]["ground_ft"] is None
    found = gateway.http.post("/missions/import?name=x.waypoints&home_ft=80", content=text).raise_for_status().json()
    first, second = found["waypoints"]
    assert first["altitude_ft"] == pytest.approx(80 + 100 / 0.3048, abs=1e-3)
    assert first["origin"] == {"frame": "home", "height_ft": pytest.approx(328.084, abs=1e-3), "reference_ft": 80.0}
    assert second["origin"] is None
    assert found["heights"] == []
    assert gateway.http.post("/missions/import?name=x&home_ft=nan", content=text).status_code == 422


def test_heights_above_the_ground_are_read_by_the_stations_terrain_and_refused_beside_it(
    gateway: Gateway, tmp_path: Path
) -> None:
    write_terrain(tmp_path / "data" / "maps" / "field.mbtiles")
    inside = f"{SOUTH + SIZE_DEG / 2}\t{WEST + SIZE_DEG / 4}"
    path = "/missions/import?name=x.waypoints"
    asked = gateway.http.post(path, content=RELATIVE.format(place=inside, frame=10)).json()
    ground_ft = CELLS / 2 * 10.0 / 0.3048
    assert asked["params"]["ground_ft"] == pytest.approx(ground_ft, abs=1.0), "the proposal for home"
    found = gateway.http.post(f"{path}&home_ft=80", content=RELATIVE.format(place=inside, frame=10)).json()
    assert found["waypoints"][1]["origin"]["reference_ft"] == pytest.approx(ground_ft, abs=1.0)
    assert found["waypoints"][1]["altitude_ft"] == pytest.approx(ground_ft + 60 / 0.3048, abs=1.0)
    (judged_by,) = found["heights"]
    assert (judged_by["name"], judged_by["datum"]) == ("field", None), "the set does not say what it counts from"
    assert abs(judged_by["geoid_m"]) > 10.0, "and its heights may be wrong by this"
    unknown = f"{SOUTH + SIZE_DEG / 2}\t{WEST + SIZE_DEG * 0.9}"
    refused = gateway.http.post(f"{path}&home_ft=80", content=RELATIVE.format(place=unknown, frame=10)).json()
    assert (refused["code"], refused["params"]["nth"]) == ("mission_file_above_ground", 3)


def test_a_flown_track_is_a_question_too(gateway: Gateway) -> None:
    points = "".join(f'<trkpt lat="{28 + nth / 1000}" lon="-15"><ele>200</ele></trkpt>' for nth in range(300))
    text = f"<gpx><trk><trkseg>{points}</trkseg></trk></gpx>"
    problem = gateway.http.post("/missions/import?name=x.gpx", content=text).json()
    assert (problem["code"], problem["params"]["points"]) == ("mission_file_track", 300)
    found = gateway.http.post("/missions/import?name=x.gpx&thin=true", content=text).raise_for_status().json()
    assert len(found["waypoints"]) == problem["params"]["waypoints"] == 2


def test_the_place_of_a_fault_is_in_the_problem(gateway: Gateway) -> None:
    text = "latitude_deg,longitude_deg\n27.9,-15.4\n27.9,north\n"
    problem = gateway.http.post("/missions/import?name=x.csv", content=text).json()
    assert problem["code"] == "mission_file_unreadable"
    assert problem["params"] == {
        "name": "x.csv",
        "place": "@problem.place_line",
        "nth": 3,
        "field": "longitude_deg",
        "value": "north",
    }


def test_the_largest_file_is_read_and_a_larger_one_is_not(gateway: Gateway) -> None:
    table = b"latitude_deg,longitude_deg\n27.9,-15.4\n"
    full = table + b"\n" * (MAX_FILE_BYTES - len(table))
    assert gateway.http.post("/missions/import?name=x", content=full).status_code == 200
    for size in (len(full) + 1, 2_000_000):
        answer = gateway.http.post("/missions/import?name=x", content=full + b"\n" * (size - len(full)))
        assert (answer.status_code, answer.json()["code"]) == (413, "body_too_large")
        assert answer.json()["params"] == {"limit": MAX_FILE_BYTES}
    elsewhere = gateway.http.post("/missions/export?format=csv", content=full)
    assert elsewhere.json()["params"] == {"limit": 65536}, "only this address takes files"


@pytest.mark.parametrize(
    ("body", "field"),
    [
        ({"name": "x", "waypoints": []}, "waypoints"),
        ({"name": "x", "waypoints": GANDO * 13}, "waypoints"),
        ({"name": "", "waypoints": GANDO}, "name"),
        ({"name": "x", "waypoints": [{**GANDO[0], "latitude_deg": 91}]}, "waypoints.0.latitude_deg"),
    ],
)
def test_a_plan_that_cannot_be_written_is_named(gateway: Gateway, body: dict[str, object], field: str) -> None:
    answer = gateway.http.post("/missions/export?format=kml", json=body)
    assert (answer.status_code, answer.json()["params"]["field"]) == (422, field)


def test_an_unknown_format_is_refused(gateway: Gateway) -> None:
    answer = gateway.http.post("/missions/export?format=shp", json={"name": "x", "waypoints": GANDO})
    assert (answer.status_code, answer.json()["params"]["field"]) == (422, "format")
