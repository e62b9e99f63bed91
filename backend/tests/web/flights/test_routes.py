"""The library over REST, with recordings of the real recorder and the real worker programs."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, cast

import pytest

from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, opening
from epf_gcs.recordings.topics import TOPICS
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually

NOW_NS = 1_767_261_600_000_000_000


def flown(gateway: Gateway, board: FakeBoard) -> str:
    """Record a flight and end it; its id."""
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    eventually(lambda: gateway.status()["recording"]["bytes"] > 2000, "it records")
    file = gateway.status()["recording"]["file"]
    gateway.http.delete("/links/board").raise_for_status()
    eventually(lambda: not gateway.status()["recording"]["active"], "the session ends")
    return str(file).removesuffix(".mcap")


def listed(gateway: Gateway, **query: Any) -> dict[str, Any]:
    return cast(dict[str, Any], gateway.http.get("/flights", params=query).raise_for_status().json())


def recording(times_ns: list[int], data: bytes = b"\rQT,") -> bytes:
    """A whole recording with a message of the board at each of these times."""
    tally, body = Tally(), opening("test", TOPICS)
    for t_ns in times_ns:
        body += message_record(1, tally.add(1, t_ns), t_ns, data)
    body += data_end()
    return body + closing(TOPICS, tally, len(body))


def upload(gateway: Gateway, content: bytes, name: str = "yesterday.mcap") -> dict[str, Any]:
    """Import a file and wait for its job."""
    answer = gateway.http.post("/flights", params={"name": name}, content=content)
    assert answer.status_code == 202, answer.text
    path = f"/jobs/{answer.json()['job']}"
    eventually(lambda: gateway.http.get(path).json()["state"] in ("done", "failed"), "the job ends")
    return cast(dict[str, Any], gateway.http.get(path).json())


def test_a_flight_is_listed_while_it_is_recorded_and_cannot_be_deleted(gateway: Gateway, board: FakeBoard) -> None:
    assert listed(gateway)["flights"] == []
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["bytes"] > 0, "it records")
    (flight,) = listed(gateway)["flights"]
    assert (flight["active"], flight["state"], flight["duration_s"]) == (True, "recording", None)
    assert flight["bytes"] > 0
    refused = gateway.http.delete(f"/flights/{flight['id']}", params={"confirm": flight["id"]})
    assert (refused.status_code, refused.json()["code"]) == (409, "flight_recording")


def test_what_a_person_says_of_a_flight_is_kept_and_found(gateway: Gateway, board: FakeBoard) -> None:
    flight = flown(gateway, board)
    said = {"title": "Viraje a la izquierda", "tags": ["b", " a ", "b"], "notes": "viento", "pinned": True}
    changed = gateway.http.patch(f"/flights/{flight}", json=said).raise_for_status().json()
    assert changed["tags"] == ["a", "b"]
    again = gateway.http.patch(f"/flights/{flight}", json={"notes": ""}).raise_for_status().json()
    assert (again["title"], again["notes"], again["pinned"]) == ("Viraje a la izquierda", "", True)
    assert [one["id"] for one in listed(gateway, text="izquierda")["flights"]] == [flight]
    assert listed(gateway, text="derecha")["total"] == 0
    assert listed(gateway, tag="a")["tags"] == ["a", "b"]
    assert gateway.http.patch("/flights/20200101T000000Z", json={}).json()["code"] == "flight_unknown"


def test_deleting_asks_for_the_id_again_and_can_be_taken_back(gateway: Gateway, board: FakeBoard) -> None:
    flight = flown(gateway, board)
    gateway.http.patch(f"/flights/{flight}", json={"title": "weg"}).raise_for_status()
    for query in ({}, {"confirm": "20200101T000000Z"}):
        refused = gateway.http.delete(f"/flights/{flight}", params=query)
        assert (refused.status_code, refused.json()["code"]) == (422, "flight_delete_unconfirmed")
    (gone,) = gateway.http.delete(f"/flights/{flight}", params={"confirm": flight}).raise_for_status().json()["flights"]
    assert (gone["id"], gone["title"]) == (flight, "weg")
    assert gone["gone_s"] - gone["deleted_s"] == 30 * 86400
    assert listed(gateway)["total"] == 0
    assert gateway.http.get("/recordings").json() == {"recordings": []}
    back = gateway.http.post(f"/flights/{flight}/restore").raise_for_status().json()
    assert back["title"] == "weg"
    assert gateway.http.get("/flights/bin").json() == {"flights": []}
    assert gateway.http.post(f"/flights/{flight}/restore").status_code == 404


def test_the_policy_is_kept_and_deletes_nothing_by_default(gateway: Gateway) -> None:
    disk = listed(gateway)["disk"]
    assert disk["policy"]["delete_oldest"] is False
    assert disk["free_bytes"] > 0
    chosen = {"delete_oldest": True, "keep_free_bytes": 2_000_000_000}
    assert gateway.http.put("/flights/policy", json=chosen).raise_for_status().json()["policy"] == chosen
    assert listed(gateway)["disk"]["policy"] == chosen
    assert gateway.http.put("/flights/policy", json={**chosen, "keep_free_bytes": 5}).status_code == 422


def test_with_the_policy_the_oldest_flights_go_but_none_that_is_pinned(gateway: Gateway) -> None:
    for day in (1, 2):
        assert upload(gateway, recording([NOW_NS + day * 86_400 * 10**9]), f"{day}.mcap")["state"] == "done"
    first = min(one["id"] for one in listed(gateway)["flights"])
    gateway.http.patch(f"/flights/{first}", json={"pinned": True}).raise_for_status()
    # No disk has so much room: every flight that may go goes.
    policy = {"delete_oldest": True, "keep_free_bytes": 10_000_000_000_000}
    gateway.http.put("/flights/policy", json=policy).raise_for_status()
    eventually(lambda: [one["id"] for one in listed(gateway)["flights"]] == [first], "only the pinned one stays")


def test_a_recording_of_another_machine_becomes_a_flight(gateway: Gateway) -> None:
    job = upload(gateway, recording([NOW_NS, NOW_NS + 10**9], b"\x00" * 5000), "Vuelo de ayer.mcap")
    assert (job["state"], job["flight"], job["fault"]) == ("done", "20260101T100000Z", None)
    flight = gateway.http.get(f"/flights/{job['flight']}").raise_for_status().json()
    assert (flight["imported"], flight["title"], flight["active"]) == (True, "Vuelo de ayer", False)
    incoming = Path(gateway.flight_thread.data_dir) / "incoming"
    eventually(lambda: not any(incoming.iterdir()), "nothing of the upload stays")


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "recording_empty"),
        (b"MZ" + os.urandom(5000), "recording_foreign"),
        (recording([]), "recording_empty"),
        (recording([5]), "recording_clock_wrong"),
        (recording([1 << 62]), "recording_clock_wrong"),
        (recording([NOW_NS, NOW_NS + 8 * 86_400 * 10**9]), "recording_clock_wrong"),
    ],
)
def test_a_file_that_is_no_flight_is_refused_with_its_reason(gateway: Gateway, content: bytes, code: str) -> None:
    job = upload(gateway, content)
    assert (job["state"], job["fault"]["code"], job["flight"]) == ("failed", code, None)
    assert listed(gateway)["total"] == 0


def test_two_flights_of_one_second_get_two_ids(gateway: Gateway) -> None:
    first = upload(gateway, recording([NOW_NS]))
    second = upload(gateway, recording([NOW_NS + 5]))
    assert (first["flight"], second["flight"]) == ("20260101T100000Z", "20260101T100000Z-2")


def test_an_upload_that_breaks_off_leaves_nothing(gateway: Gateway) -> None:
    def broken() -> Any:
        yield recording([NOW_NS])
        raise RuntimeError("the cable was pulled")

    with pytest.raises(RuntimeError):
        gateway.http.post("/flights", params={"name": "x.mcap"}, content=broken())
    incoming = Path(gateway.flight_thread.data_dir) / "incoming"
    eventually(lambda: not incoming.exists() or not any(incoming.iterdir()), "nothing of the upload stays")
    assert gateway.http.get("/jobs").json() == {"jobs": []} or not listed(gateway)["total"]


def test_the_bin_and_jobs_refuse_what_they_do_not_know(gateway: Gateway) -> None:
    assert gateway.http.get("/jobs/0123456789ab").json()["code"] == "job_unknown"
    assert gateway.http.get("/flights/20200101T000000Z").json()["code"] == "flight_unknown"
    assert gateway.http.get("/flights/current/topics").json()["code"] == "flight_unknown"
