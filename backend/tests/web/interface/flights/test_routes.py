"""The library over REST, with recordings of the real recorder and the real worker programs."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import Any, cast

import pyarrow as pa
import pytest

from epf_gcs import extras
from epf_gcs.library.imports import most_import_bytes
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
    eventually(lambda: gateway.status()["topics"].get("ahrs", {"count": 0})["count"] > 5, "attitudes come")
    eventually(lambda: gateway.status()["recording"]["file"] is not None, "the recorder's thread has opened its file")
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


def test_a_recording_that_was_renamed_in_its_folder_is_named_in_the_list(gateway: Gateway) -> None:
    folder = Path(gateway.flight_thread.data_dir) / "recordings"
    folder.mkdir(exist_ok=True)
    (folder / "my flight.mcap").write_bytes(recording([NOW_NS, NOW_NS + 10**9]))
    assert (listed(gateway)["flights"], listed(gateway)["unnamed"]) == ([], ["my flight.mcap"])
    (folder / "my flight.mcap").unlink()
    assert listed(gateway)["unnamed"] == []


def test_a_file_larger_than_a_recording_may_be_is_refused_and_nothing_of_it_stays(
    gateway: Gateway, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("epf_gcs.library.imports.MOST_BYTES", 1000)
    assert listed(gateway)["disk"]["most_import_bytes"] == 1000
    refused = gateway.http.post("/flights", params={"name": "huge.mcap"}, content=bytes(1001))
    assert (refused.status_code, refused.json()["code"]) == (422, "recording_too_large")
    assert not any((Path(gateway.flight_thread.data_dir) / "incoming").iterdir()), "nothing of the upload stays"


@pytest.mark.parametrize(("free_bytes", "most"), [(None, 8_000_000_000), (6_500_000_000, 2_500_000_000), (10**9, 0)])
def test_a_file_may_take_half_of_the_space_that_flights_do_not_need(free_bytes: int | None, most: int) -> None:
    assert most_import_bytes(free_bytes) == most


def test_what_was_wrong_with_an_imported_file_is_told_with_its_flight(gateway: Gateway) -> None:
    content = recording([NOW_NS, NOW_NS + 10**9, NOW_NS + 2 * 10**9])
    job = upload(gateway, content[: content.index(data_end())] + b"\x77" * 20)
    flight = indexed(gateway, str(job["flight"]))
    assert flight["damage"] is not None
    assert "begins no record" in flight["damage"]
    whole = upload(gateway, recording([NOW_NS + 10**12, NOW_NS + 2 * 10**12]))
    assert indexed(gateway, str(whole["flight"]))["damage"] is None


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


def indexed(gateway: Gateway, flight: str) -> dict[str, Any]:
    """Wait until the workers have prepared a flight; its row."""
    path = f"/flights/{flight}"
    eventually(lambda: gateway.http.get(path).json()["state"] in ("indexed", "damaged"), "it is prepared")
    found = gateway.http.get(path).raise_for_status().json()
    assert found["state"] == "indexed", found["fault"]
    return cast(dict[str, Any], found)


def asked(gateway: Gateway, path: str, **query: Any) -> dict[str, Any]:
    return cast(dict[str, Any], gateway.http.get(path, params=query).raise_for_status().json())


def test_a_flight_is_prepared_by_itself_and_answers_what_is_in_it(gateway: Gateway, board: FakeBoard) -> None:
    assert gateway.http.put("/flights/aircraft", json={"name": " Ala fija "}).json() == {"name": "Ala fija"}
    assert listed(gateway)["aircraft"] == "Ala fija"
    assert gateway.http.put("/flights/aircraft", json={"name": "x" * 61}).status_code == 422
    flight = flown(gateway, board)
    row = indexed(gateway, flight)
    assert row["frames"] > 0
    assert row["aircraft"] == "Ala fija"
    assert listed(gateway, text="ala fija")["total"] == 1
    assert row["duration_s"] > 0
    path = f"/flights/{flight}"
    topics = {one["name"]: one for one in asked(gateway, f"{path}/topics")["topics"]}
    assert {field["name"]: field["unit"] for field in topics["ahrs"]["fields"]}["roll_deg"] == "deg"
    found = asked(gateway, f"{path}/signals", names="ahrs.roll_deg,heartbeat.ahrs")
    roll, switch = found["signals"]
    assert (roll["name"], roll["unit"], roll["count"]) == ("ahrs.roll_deg", "deg", topics["ahrs"]["count"])
    assert 0.0 <= roll["at_s"][0] <= roll["at_s"][-1] <= row["duration_s"]
    assert set(switch["max"]) <= {0.0, 1.0}
    assert asked(gateway, f"{path}/overview", points=20)["duration_s"] == pytest.approx(row["duration_s"])
    assert asked(gateway, f"{path}/known", at_s=1)["at_s"] == 1.0
    kinds = [(event["kind"], event["name"]) for event in asked(gateway, f"{path}/events")["events"]]
    assert all(kind in ("link", "command", "parameter", "mode", "gap", "alarm", "control") for kind, _ in kinds)
    track = gateway.http.get(f"{path}/track", params={"source": "flight"}).raise_for_status().content
    assert track[:4] == b"EPT1"
    refused = gateway.http.get(f"{path}/plan", params={"source": "hil", "thin": True})
    assert (refused.status_code, refused.json()["code"]) == (422, "mission_file_no_waypoints")
    arrow = gateway.http.get(
        f"{path}/signals",
        params={"names": "ahrs.roll_deg"},
        headers={"Accept": "application/vnd.apache.arrow.stream"},
    ).raise_for_status()
    with pa.ipc.open_stream(arrow.content) as reader:
        table = reader.read_all()
    assert table.column("max").to_pylist() == roll["max"]
    assert asked(gateway, f"{path}/signals", names="servos_in.channel_11")["signals"][0]["at_s"] == []
    for wrong in ("ahrs.nothing", "nothing.roll_deg", "capabilities.firmware_name"):
        refused = gateway.http.get(f"{path}/signals", params={"names": wrong})
        assert (refused.status_code, refused.json()["code"]) == (404, "signal_unknown")


def test_the_flight_in_the_air_gives_the_answers_that_it_gives_when_it_is_over(
    gateway: Gateway, board: FakeBoard
) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    path = "/flights/current"
    eventually(lambda: gateway.http.get(f"{path}/topics").status_code == 200, "a message is on the disk")
    eventually(
        lambda: any(one["name"] == "ahrs" for one in asked(gateway, f"{path}/topics")["topics"]), "attitudes are in it"
    )
    live = asked(gateway, f"{path}/signals", names="ahrs.roll_deg", points=20_000)["signals"][0]
    eventually(
        lambda: asked(gateway, f"{path}/signals", names="ahrs.roll_deg")["signals"][0]["count"] > live["count"],
        "it grows",
    )
    flight = gateway.status()["recording"]["file"].removesuffix(".mcap")
    assert asked(gateway, f"/flights/{flight}/overview", points=10)["duration_s"] > 0
    gateway.http.delete("/links/board").raise_for_status()
    indexed(gateway, flight)
    after = asked(gateway, f"/flights/{flight}/signals", names="ahrs.roll_deg", points=20_000)["signals"][0]
    # As many as were there, with the breaks that a slow computer made.
    count = len(live["at_s"])
    assert after["at_s"][:count] == live["at_s"]
    assert after["min"][:count] == live["min"]


def test_a_flight_that_nothing_here_can_look_into_is_unread_and_not_damaged(
    gateway: Gateway, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as without:
        without.setattr(extras, "find_spec", lambda _name: None)
        flight = flown(gateway, board)
        eventually(lambda: gateway.http.get(f"/flights/{flight}").json()["state"] == "unread", "it is unread")
        assert gateway.http.get(f"/flights/{flight}").json()["fault"]["code"] == "extra_missing"
    gateway.http.post(f"/flights/{flight}/index").raise_for_status()
    assert indexed(gateway, flight)["fault"] is None


def test_a_mark_is_set_changed_and_removed_and_survives_a_new_index(gateway: Gateway, board: FakeBoard) -> None:
    flight = flown(gateway, board)
    indexed(gateway, flight)
    path = f"/flights/{flight}"

    def marks(found: dict[str, Any]) -> list[tuple[str, float]]:
        return [(one["data"]["text"], one["at_s"]) for one in found["events"] if one["kind"] == "mark"]

    set_now = gateway.http.post(f"{path}/marks", json={"text": " aquí ", "at_s": 0.5}).raise_for_status().json()
    assert marks(set_now) == [("aquí", 0.5)]
    assert gateway.http.get(path).json()["marks"] == 1
    mark = next(one["id"] for one in set_now["events"] if one["kind"] == "mark")
    gateway.http.patch(f"{path}/marks/{mark}", json={"text": "allí"}).raise_for_status()
    gateway.http.post(f"{path}/index").raise_for_status()
    indexed(gateway, flight)
    assert marks(asked(gateway, f"{path}/events")) == [("allí", 0.5)]
    assert marks(gateway.http.delete(f"{path}/marks/{mark}").raise_for_status().json()) == []
    assert gateway.http.delete(f"{path}/marks/{mark}").json()["code"] == "mark_unknown"
    assert gateway.http.post(f"{path}/marks", json={"text": "jetzt"}).status_code == 422


def test_a_mark_set_in_flight_stands_in_the_recording_and_can_be_worded_anew(
    gateway: Gateway, board: FakeBoard
) -> None:
    gateway.open_board(board.url)
    eventually(lambda: gateway.http.get("/flights/current/topics").status_code == 200, "it is recorded")
    set_s = time.time()
    gateway.http.post("/flights/current/marks", json={"text": "ahora", "ago_s": 0.2}).raise_for_status()

    def marks(flight: str) -> list[str]:
        found = asked(gateway, f"/flights/{flight}/events")["events"]
        return [one["data"]["text"] for one in found if one["kind"] == "mark"]

    eventually(lambda: marks("current") == ["ahora"], "the mark is in the file")
    (mark,) = [one for one in asked(gateway, "/flights/current/events")["events"] if one["kind"] == "mark"]
    assert mark["t_s"] < set_s, "it is of the moment when the key was pressed"
    flight = gateway.status()["recording"]["file"].removesuffix(".mcap")
    gateway.http.delete("/links/board").raise_for_status()
    assert indexed(gateway, flight)["marks"] == 1
    events = asked(gateway, f"/flights/{flight}/events")["events"]
    mark = next(one["id"] for one in events if one["kind"] == "mark")
    gateway.http.patch(f"/flights/{flight}/marks/{mark}", json={"text": "entonces"}).raise_for_status()
    assert (marks(flight), gateway.http.get(f"/flights/{flight}").json()["marks"]) == (["entonces"], 1)
    gateway.http.delete(f"/flights/{flight}/marks/{mark}").raise_for_status()
    assert (marks(flight), gateway.http.get(f"/flights/{flight}").json()["marks"]) == ([], 0)


def test_the_same_recording_is_taken_once(gateway: Gateway, board: FakeBoard) -> None:
    flight = flown(gateway, board)
    content = gateway.http.get(f"/recordings/{flight}/export").raise_for_status().content
    indexed(gateway, flight)
    job = upload(gateway, content)
    assert (job["state"], job["fault"]["code"], job["fault"]["params"]) == (
        "failed",
        "flight_known",
        {"flight": flight},
    )
    assert listed(gateway)["total"] == 1


def test_a_question_about_a_flight_that_is_not_prepared_says_so(gateway: Gateway) -> None:
    data_dir = Path(gateway.flight_thread.data_dir)
    (data_dir / "recordings").mkdir(exist_ok=True)
    (data_dir / "recordings" / "20260101T100000Z.mcap").write_bytes(b"no recording at all")
    refused = gateway.http.get("/flights/20260101T100000Z/topics")
    assert (refused.status_code, refused.json()["code"]) == (409, "flight_not_indexed")


def test_a_flight_that_the_disk_had_no_room_for_is_prepared_when_it_has(
    gateway: Gateway, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("epf_gcs.library.flights._AGAIN_S", 0.0)
    columns = Path(gateway.flight_thread.data_dir) / "columns"
    # No folder can be made there, as on a disk that refuses.
    columns.write_bytes(b"")
    flight = str(upload(gateway, recording([NOW_NS, NOW_NS + 10**9]))["flight"])

    def failed() -> list[str]:
        jobs = gateway.http.get("/jobs").json()["jobs"]
        return [job["fault"]["code"] for job in jobs if (job["kind"], job["state"]) == ("index", "failed")]

    eventually(lambda: bool(failed()), "the disk refuses")
    assert set(failed()) == {"flight_not_written"}
    assert gateway.http.get(f"/flights/{flight}").json()["state"] in ("waiting", "indexing"), "it is not damaged"
    columns.unlink()
    # Whatever wakes the station: here the policy of the disk, which nobody changes.
    gateway.http.put("/flights/policy", json={"delete_oldest": False, "keep_free_bytes": 10**9}).raise_for_status()
    indexed(gateway, flight)


def test_a_flight_that_is_prepared_has_its_key_frames_before_anybody_opens_it(
    gateway: Gateway, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    keyframes = Path(gateway.flight_thread.data_dir) / "keyframes"
    short = flown(gateway, board)
    indexed(gateway, short)
    monkeypatch.setattr("epf_gcs.library.flights._WORTH_KEYS_NS", 0)
    flight = flown(gateway, board)
    indexed(gateway, flight)

    def jobs() -> list[tuple[str, str]]:
        found = gateway.http.get("/jobs").json()["jobs"]
        return [(one["flight"], one["state"]) for one in found if one["kind"] == "keys"]

    eventually(lambda: jobs() == [(flight, "done")], "its key frames are made")
    assert [path.name for path in keyframes.iterdir()] == [f"{flight}.keys"]
    gateway.http.delete(f"/flights/{flight}", params={"confirm": flight}).raise_for_status()
    assert list(keyframes.iterdir()) == []
