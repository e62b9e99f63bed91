"""Google Earth's files: valid, true, marked where they are not live; and the drawn track, cleared and brought back."""

from __future__ import annotations

import time
from urllib.parse import parse_qs, urlsplit

import httpx
import pytest
from lxml import etree

from epf_gcs.codec.messages_gen import ROUTES
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.kml import child_texts, element, schema_faults, texts
from tests.support.waiting import DEADLINE_S, eventually

KML = "application/vnd.google-earth.kml+xml"
GANDO = [
    {name: getattr(at, name) for name in ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")}
    for at in ROUTES["gando"].waypoints
]


def get(gateway: Gateway, path: str) -> bytes:
    answer = gateway.http.get(path).raise_for_status()
    assert answer.headers["content-type"] == KML
    assert schema_faults(answer.content) == []
    return answer.content


@pytest.fixture
def emulated(gateway: Gateway) -> Gateway:
    gateway.open_board("emulation:")
    eventually(lambda: min(points(gateway)) > 20, "a track is flown")
    return gateway


def points(gateway: Gateway) -> tuple[int, int]:
    state = gateway.http.get("/track").raise_for_status().json()
    return state["flight_points"], state["hil_points"]


@pytest.mark.parametrize("path", ["/earth.kml", "/earth/live.kml"])
def test_without_anything_flown_the_files_are_valid_and_empty(gateway: Gateway, path: str) -> None:
    data = get(gateway, path)
    assert texts(data, "Placemark") == []
    assert texts(data, "LookAt") == []


def test_the_link_document_asks_each_second_under_the_name_it_was_asked_for(emulated: Gateway) -> None:
    port = urlsplit(emulated.base).port
    answer = httpx.get(
        f"{emulated.base}/api/v1/earth.kml?follow=flight", headers={"Host": f"localhost:{port}"}, timeout=DEADLINE_S
    )
    data = answer.raise_for_status().content
    assert schema_faults(data) == []
    hrefs = texts(data, "href")
    assert all(href.startswith(f"http://localhost:{port}/api/v1/") for href in hrefs)
    assert urlsplit(hrefs[0]).path == "/api/v1/earth/live.kml"
    assert parse_qs(urlsplit(hrefs[0]).query) == {"lang": ["en"], "follow": ["flight"]}
    assert texts(data, "refreshMode")[0] == "onInterval"
    assert texts(data, "refreshInterval")[0] == "1"
    assert texts(data, "flyToView")[0] == "1"
    for href in hrefs:
        path = f"{urlsplit(href).path.removeprefix('/api/v1')}?{urlsplit(href).query}"
        emulated.http.get(path).raise_for_status()


def test_a_free_camera_leaves_the_view_alone(gateway: Gateway) -> None:
    assert set(texts(get(gateway, "/earth.kml?camera=free"), "flyToView")) == {"0"}


def test_the_plans_are_linked_where_the_board_has_them(gateway: Gateway, board: FakeBoard) -> None:
    assert not any("plan.kml" in href for href in texts(get(gateway, "/earth.kml"), "href"))
    gateway.open_board(board.url)
    assert sum("plan.kml" in href for href in texts(get(gateway, "/earth.kml"), "href")) == 2


def test_the_live_document_shows_both_aircraft_with_their_attitude(emulated: Gateway) -> None:
    data = get(emulated, "/earth/live.kml?lang=en&follow=flight")
    assert texts(data, "name")[1:3] == ["Aircraft (emulation)", "HIL aircraft (emulation)"]
    model = element(data, "Model")
    orientation = child_texts(model.find("{*}Orientation"))
    attitude = emulated.http.get("/telemetry").json()["ahrs"]["values"]
    assert float(orientation["roll"]) == pytest.approx(-attitude["roll_deg"], abs=0.5)
    assert float(orientation["tilt"]) == pytest.approx(-attitude["pitch_deg"], abs=3)
    turned = (attitude["yaw_deg"] - float(orientation["heading"])) % 360
    assert turned < 30 or turned > 330
    view = child_texts(element(data, "LookAt"))
    place = child_texts(model.find("{*}Location"))
    assert [view[name] for name in ("longitude", "latitude", "altitude")] == list(place.values())
    assert "Altitude: " in texts(data, "description")[0]


def test_a_client_that_follows_the_link_sees_the_aircraft_fly_each_second(emulated: Gateway) -> None:
    """As Google Earth does: opens the link once, then asks for what it names as often as it says."""
    link = element(get(emulated, "/earth.kml?follow=hil&lang=en"), "Link")
    said = child_texts(link)
    assert (said["refreshMode"], said["refreshInterval"]) == ("onInterval", "1")
    seen: list[tuple[str, str]] = []
    headings: list[float] = []
    with httpx.Client(timeout=DEADLINE_S) as client:
        for look in range(3):
            if look > 0:
                time.sleep(float(said["refreshInterval"]))  # what a client of this link does, not waiting for something
            answer = client.get(said["href"]).raise_for_status()
            assert schema_faults(answer.content) == []
            assert answer.headers["cache-control"] == "no-store", "an old answer is no flight"
            models = {
                one.getparent().getparent().findtext("{*}name"): one
                for one in etree.fromstring(answer.content).iter("{*}Model")
            }
            model = models["HIL aircraft (emulation)"]
            place, turn = (child_texts(model.find(f"{{*}}{name}")) for name in ("Location", "Orientation"))
            view = child_texts(element(answer.content, "LookAt"))
            assert [view[name] for name in ("longitude", "latitude", "altitude")] == list(place.values())
            assert view["heading"] == turn["heading"], "the view stays behind the aircraft"
            seen.append((place["longitude"], place["latitude"]))
            headings.append(float(turn["heading"]))
    assert len(set(seen)) == len(seen)
    assert len(set(headings)) == len(headings), "it turns with the example flight"


def test_everything_that_the_link_leads_to_is_in_its_language(emulated: Gateway) -> None:
    for lang, aircraft, track in (("es", "Aeronave", "Recorrido HIL"), ("en", "Aircraft", "HIL track")):
        data = get(emulated, f"/earth.kml?lang={lang}")
        found = texts(data, "name")
        for href in texts(data, "href"):
            assert parse_qs(urlsplit(href).query)["lang"] == [lang]
            found += texts(httpx.get(href, timeout=DEADLINE_S).raise_for_status().content, "name")
        assert any(name.startswith(aircraft) for name in found)
        assert track in found


def test_the_model_is_a_file_that_can_be_had(emulated: Gateway) -> None:
    href = next(href for href in texts(get(emulated, "/earth/live.kml"), "href"))
    answer = httpx.get(href, timeout=DEADLINE_S).raise_for_status()
    assert answer.headers["content-type"] == "model/vnd.collada+xml"
    assert etree.fromstring(answer.content).tag.endswith("COLLADA")


def test_an_aircraft_that_is_not_heard_any_more_is_shown_at_its_last_place_without_attitude(
    gateway: Gateway, board: FakeBoard
) -> None:
    gateway.open_board(board.url)
    board.send_gps(27.93, -15.38, 300.0)
    eventually(lambda: points(gateway)[0] == 1, "the position is heard")
    eventually(lambda: gateway.http.get("/telemetry").json()["gps"]["stale"], "it grows old")
    data = get(gateway, "/earth/live.kml?lang=es")
    assert texts(data, "name")[1] == "Aeronave (última posición conocida)"
    assert texts(data, "coordinates") == ["-15.380000114,27.930000305,300.000000"]
    assert texts(data, "Model") == []
    assert texts(data, "description") == []


def test_a_position_without_a_fix_is_no_position(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    board.send_gps(0.0, 0.0, 0.0, valid=False)
    eventually(lambda: "gps" in gateway.http.get("/telemetry").json(), "it is heard")
    assert points(gateway) == (0, 0)
    assert texts(get(gateway, "/earth/live.kml"), "Placemark") == []


def test_the_plan_is_as_the_board_has_it(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.put("/missions/hil", json={"waypoints": GANDO}).raise_for_status()
    data = get(gateway, "/plan.kml?plan=hil&lang=en")
    assert texts(data, "name")[0] == "HIL flight plan"
    answer = gateway.http.post("/missions/import?name=plan.kml", content=data).raise_for_status().json()
    assert answer["waypoints"] == [{**waypoint, "origin": None} for waypoint in GANDO]
    assert answer["notes"] == []
    assert texts(get(gateway, "/plan.kml"), "Placemark") == []


def test_a_legacy_board_has_no_plan_to_show(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    answer = gateway.http.get("/plan.kml")
    assert (answer.status_code, answer.json()["code"]) == (409, "not_supported")
    assert not any("plan.kml" in href for href in texts(get(gateway, "/earth.kml"), "href"))
