"""Exports over REST: as a job with progress, or in one request; cancelled, and refused with a reason."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path
from typing import Any, cast

import httpx
import pytest
from lxml import etree

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually
from tests.web.interface.flights.test_routes import flown, listed, upload


def started(gateway: Gateway, flight: str, **asked: Any) -> str:
    answer = gateway.http.post(f"/flights/{flight}/exports", json=asked)
    assert answer.status_code == 202, answer.text
    return str(answer.json()["job"])


def job(gateway: Gateway, job_id: str) -> dict[str, Any]:
    return cast(dict[str, Any], gateway.http.get(f"/jobs/{job_id}").raise_for_status().json())


def left(gateway: Gateway) -> set[str]:
    """What lies where exports are made."""
    return {path.name for path in (Path(gateway.flight_thread.data_dir) / "exports").glob("*")}


def exports(gateway: Gateway) -> dict[str, str]:
    """The state of each export by its job."""
    return {one["id"]: one["state"] for one in gateway.http.get("/jobs").json()["jobs"] if one["kind"] == "export"}


def made_by(gateway: Gateway, job: str) -> str:
    eventually(lambda: gateway.http.get(f"/jobs/{job}/result").is_success, "the file is made")
    return gateway.http.get(f"/jobs/{job}/result").text


def test_an_export_is_a_job_whose_file_is_fetched(station: Gateway, kept: str) -> None:
    with station.stream() as stream:
        job_id = started(station, kept, format="csv", topics=["gps"], from_s=5, to_s=10)
        while (told := stream.event("job"))["id"] != job_id or told["state"] != "done":
            assert told["state"] != "failed", told
    assert (told["kind"], told["flight"], told["progress"]) == ("export", kept, 1.0)
    assert station.http.get(f"/jobs/{job_id}").json()["file"] == f"{kept}-gps.csv", "known before it is made"
    assert told["result"]["name"] == f"{kept}-gps.csv"
    answer = station.http.get(f"/jobs/{job_id}/result").raise_for_status()
    assert len(answer.content) == told["result"]["bytes"]
    assert len(answer.text.splitlines()) == 51 + 1


def test_one_request_makes_and_sends_the_file_and_keeps_nothing(station: Gateway, kept: str) -> None:
    before = left(station)
    answer = station.http.get(f"/flights/{kept}/export", params={"format": "kmz", "lang": "en"}).raise_for_status()
    assert answer.headers["content-type"] == "application/vnd.google-earth.kmz"
    assert f'filename="{kept}.kmz"' in answer.headers["content-disposition"]
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert b"HIL track" in archive.read("doc.kml")
    single = station.http.get(f"/flights/{kept}/export", params={"format": "csv", "topics": "gps"})
    assert single.headers["content-type"].startswith("text/csv")
    gpx = station.http.get(f"/flights/{kept}/export", params={"format": "gpx"})
    assert etree.fromstring(gpx.content).get("version") == "1.1"
    eventually(lambda: left(station) <= before, "what was fetched is deleted")


def test_a_file_whose_language_nobody_names_is_in_the_browsers(station: Gateway, kept: str) -> None:
    for accepted, name, title in (
        ("es-ES,en;q=0.5", "Recorrido HIL", "Recorrido"),
        ("en-US,es;q=0.5", "HIL track", "Track"),
        ("de", "HIL track", "Track"),
    ):
        headers = {"Accept-Language": accepted}
        asked = station.http.get(f"/flights/{kept}/export", params={"format": "kml"}, headers=headers)
        assert name in asked.raise_for_status().text
        assert title in station.http.get("/track.kml", headers=headers).raise_for_status().text
        job = station.http.post(f"/flights/{kept}/exports", json={"format": "kml"}, headers=headers).json()["job"]
        assert name in made_by(station, job)


def test_the_recording_exported_and_imported_again_is_the_same_flight(gateway: Gateway, flight: str) -> None:
    content = gateway.http.get(f"/flights/{flight}/export", params={"format": "mcap"}).raise_for_status().content
    again = upload(gateway, content)
    assert (again["state"], again["fault"]["code"], again["fault"]["params"]) == (
        "failed",
        "flight_known",
        {"flight": flight},
    )
    gateway.http.delete(f"/flights/{flight}", params={"confirm": flight}).raise_for_status()
    before = {"duration_s", "frames", "distance_nm", "highest_ft", "aircraft", "thumbnail"}
    back = str(upload(gateway, content)["flight"])
    eventually(lambda: gateway.http.get(f"/flights/{back}").json()["state"] == "indexed", "it is indexed")
    restored = gateway.http.post(f"/flights/{flight}/restore").raise_for_status().json()
    eventually(lambda: gateway.http.get(f"/flights/{flight}").json()["state"] == "indexed", "it is indexed")
    restored = gateway.http.get(f"/flights/{flight}").json()
    found = gateway.http.get(f"/flights/{back}").json()
    assert {name: found[name] for name in before} == {name: restored[name] for name in before}


def test_a_cancelled_export_leaves_nothing(station: Gateway, kept: str) -> None:
    before = left(station)
    job_id = started(station, kept, format="mcap-decoded")
    gone = station.http.delete(f"/jobs/{job_id}").raise_for_status().json()
    assert gone["state"] in ("cancelled", "done")
    eventually(lambda: gone["state"] == "done" or left(station) <= before, "nothing stays")


def test_who_hangs_up_cancels_the_export(station: Gateway, kept: str) -> None:
    before, others = left(station), exports(station).keys()
    with httpx.Client(base_url=station.http.base_url, timeout=0.05) as impatient, pytest.raises(httpx.TimeoutException):
        impatient.get(f"/flights/{kept}/export", params={"format": "mcap-decoded"})
    eventually(
        lambda: [state for job, state in exports(station).items() if job not in others] == ["cancelled"],
        "the job is cancelled",
    )
    assert left(station) <= before


def test_what_can_never_be_exported_is_refused_at_once(station: Gateway, kept: str) -> None:
    before = exports(station)
    for asked, code in (
        ({"format": "kml", "topics": ["gps"]}, "export_topics_unused"),
        ({"format": "csv", "from_s": 5.0, "to_s": 5.0}, "export_stretch_empty"),
        ({"format": "docx"}, "invalid_request"),
        ({"format": "csv", "topics": ["../x"]}, "invalid_request"),
    ):
        answer = station.http.post(f"/flights/{kept}/exports", json=asked)
        assert (answer.status_code, answer.json()["code"]) == (422, code)
    assert exports(station).keys() <= before.keys()


def test_what_the_worker_refuses_is_the_answer(station: Gateway, kept: str) -> None:
    unknown = station.http.get(f"/flights/{kept}/export", params={"format": "csv", "topics": "nothing"})
    assert (unknown.status_code, unknown.json()["code"]) == (404, "export_topic_unknown")
    late = station.http.get(f"/flights/{kept}/export", params={"format": "mcap", "from_s": 500})
    assert (late.status_code, late.json()["code"]) == (422, "export_stretch_empty")
    job_id = started(station, kept, format="csv", topics=["nothing"])
    eventually(lambda: job(station, job_id)["state"] == "failed", "the job ends")
    assert job(station, job_id)["fault"]["code"] == "export_topic_unknown"
    assert station.http.get("/flights/20200101T000000Z/export?format=csv").json()["code"] == "flight_unknown"


def test_a_flight_that_is_recorded_is_exported_when_it_has_ended(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["bytes"] > 0, "it records")
    (active,) = listed(gateway)["flights"]
    refused = gateway.http.post(f"/flights/{active['id']}/exports", json={"format": "mcap"})
    assert (refused.status_code, refused.json()["code"]) == (409, "flight_recording")
    gateway.http.delete("/links/board").raise_for_status()
    ended = flown(gateway, board)
    file = Path(gateway.flight_thread.data_dir) / "recordings" / f"{ended}.mcap"
    # It may be packed at any moment after its end.
    before = file.read_bytes()
    answer = gateway.http.get(f"/flights/{ended}/export", params={"format": "mcap"}).raise_for_status()
    assert answer.content in {before, file.read_bytes()}


def test_a_file_that_nobody_fetches_goes_after_an_hour_and_at_once_where_room_is_wanted(
    gateway: Gateway, flight: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def exported() -> str:
        job_id = started(gateway, flight, format="gpx")
        eventually(lambda: job(gateway, job_id)["state"] == "done", "it is made")
        return job_id

    job_id = exported()
    policy = {"delete_oldest": False, "keep_free_bytes": 10**9}
    gateway.http.put("/flights/policy", json=policy).raise_for_status()
    gateway.http.get("/flights/bin").raise_for_status()
    assert job(gateway, job_id)["result"] is not None
    monkeypatch.setattr("epf_gcs.library.flights._RESULT_KEPT_S", 0.0)
    gateway.http.put("/flights/policy", json=policy).raise_for_status()
    eventually(lambda: job(gateway, job_id)["result"] is None, "it goes")
    assert job(gateway, job_id)["state"] == "done"
    assert gateway.http.get(f"/jobs/{job_id}/result").json()["code"] == "job_over"
    assert left(gateway) == set()
    monkeypatch.setattr("epf_gcs.library.flights._RESULT_KEPT_S", 3600.0)
    job_id = exported()
    gateway.http.patch(f"/flights/{flight}", json={"pinned": True}).raise_for_status()
    wanted = {"delete_oldest": True, "keep_free_bytes": 10_000_000_000_000}
    gateway.http.put("/flights/policy", json=wanted).raise_for_status()
    eventually(lambda: job(gateway, job_id)["result"] is None, "files of jobs go before flights do")
    assert listed(gateway)["total"] == 1


def test_two_exports_of_one_flight_at_once_are_two_whole_files(station: Gateway, kept: str) -> None:
    jobs = [started(station, kept, format="mcap-decoded") for _ in range(2)]
    eventually(lambda: all(job(station, one)["state"] == "done" for one in jobs), "both are made")
    first, second = (station.http.get(f"/jobs/{one}/result").raise_for_status().content for one in jobs)
    assert first == second
    assert first.endswith(b"\x89MCAP0\r\n")


def test_a_flight_that_is_deleted_while_it_is_exported_leaves_no_file(gateway: Gateway, flight: str) -> None:
    job_id = started(gateway, flight, format="mcap-decoded")
    gateway.http.delete(f"/flights/{flight}", params={"confirm": flight}).raise_for_status()
    assert job(gateway, job_id)["state"] in ("cancelled", "done")
    assert gateway.http.get(f"/flights/{flight}/export", params={"format": "gpx"}).status_code == 404
    if job(gateway, job_id)["state"] == "cancelled":
        assert left(gateway) == set()
