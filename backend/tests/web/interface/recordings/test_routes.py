"""Recordings over REST: list, size, download."""

from __future__ import annotations

import contextlib
from io import BytesIO
from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap.records import Message
from mcap.stream_reader import StreamReader

from epf_gcs.recordings.limits import RecordingError
from epf_gcs.recordings.mcap_file import Tally, closing, data_end
from epf_gcs.recordings.packing import pack
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually

END = data_end() + closing({}, Tally(), 0)


def test_a_flight_is_recorded_listed_and_downloaded(gateway: Gateway, board: FakeBoard) -> None:
    assert gateway.http.get("/recordings").json() == {"recordings": []}
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["active"], "it records")
    (running,) = gateway.http.get("/recordings").json()["recordings"]
    assert running["active"]
    assert f"{running['id']}.mcap" == gateway.status()["recording"]["file"]
    gateway.http.delete("/links/board")
    eventually(lambda: not gateway.status()["recording"]["active"], "the session ends with the last link")
    info = gateway.http.get(f"/recordings/{running['id']}").raise_for_status().json()
    assert not info["active"]
    answer = gateway.http.get(f"/recordings/{running['id']}/export?format=mcap").raise_for_status()
    assert len(answer.content) == info["bytes"]
    assert running["id"] in answer.headers["content-disposition"]
    messages = [r for r in StreamReader(BytesIO(answer.content)).records if isinstance(r, Message)]
    sent = b"".join(message.data for message in messages if message.channel_id == 2)
    received = b"".join(message.data for message in messages if message.channel_id == 1)
    assert sent == board.raw
    assert len(received) == gateway.status()["board"]["bytes_in"]


def test_a_recording_that_was_packed_is_listed_and_downloaded_as_it_is(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["active"], "it records")
    gateway.http.delete("/links/board")
    eventually(lambda: not gateway.status()["recording"]["active"], "it ended")
    (file,) = (gateway.flight_thread.data_dir / "recordings").glob("*.mcap")
    with contextlib.suppress(RecordingError):  # the station may be packing it itself
        pack(file)

    def is_packed() -> bool:
        summary = make_reader(BytesIO(file.read_bytes())).get_summary()
        return summary is not None and summary.chunk_indexes != []

    eventually(is_packed, "it is packed")
    (listed,) = gateway.http.get("/recordings").json()["recordings"]
    assert listed["bytes"] == file.stat().st_size
    path = f"/recordings/{listed['id']}/export"
    answer = gateway.http.get(path).raise_for_status()
    assert answer.content == file.read_bytes()
    assert gateway.http.get(path, headers={"Range": "bytes=100-199"}).content == answer.content[100:200]
    found = list(make_reader(BytesIO(answer.content), validate_crcs=True).iter_messages())
    assert b"".join(message.data for _, channel, message in found if channel.topic == "board/sent") == board.raw


def test_a_recording_is_downloaded_again_and_again_while_it_grows(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    eventually(lambda: gateway.status()["recording"]["bytes"] > 0, "it records")
    (running,) = gateway.http.get("/recordings").json()["recordings"]
    path = f"/recordings/{running['id']}/export"
    sizes = []
    for _ in range(8):
        answer = gateway.http.get(path).raise_for_status()
        assert len(answer.content) == int(answer.headers["content-length"])
        sizes.append(len(answer.content))
        size = sizes[-1]
        eventually(lambda size=size: gateway.status()["recording"]["bytes"] > size, "it grows")  # type: ignore[misc]
    assert sizes == sorted(sizes)
    part = gateway.http.get(path, headers={"Range": "bytes=0-7"})
    assert (part.status_code, part.content) == (206, b"\x89MCAP0\r\n")


def test_a_slow_reader_of_a_growing_recording_gets_what_was_there_when_it_asked(
    gateway: Gateway, board: FakeBoard
) -> None:
    gateway.open_board(board.url)
    recorder = gateway.flight.recorder
    assert recorder is not None
    for _ in range(32):  # more than all buffers on the way
        recorder.simulator_tap.received(b"x" * 1_000_000)
    eventually(lambda: gateway.status()["recording"]["bytes"] > 32_000_000, "it is large")
    (running,) = gateway.http.get("/recordings").json()["recordings"]
    with gateway.http.stream("GET", f"/recordings/{running['id']}/export") as answer:
        size = int(answer.headers["content-length"])
        eventually(lambda: recorder.bytes_written > size, "it grows while it is read")
        content = answer.read()
    assert len(content) == size
    assert sum(isinstance(r, Message) for r in StreamReader(BytesIO(content + END)).records) > 32


def test_the_viewers_hear_when_a_file_begins_and_ends(gateway: Gateway, board: FakeBoard) -> None:
    with gateway.stream() as stream:
        operator = {"X-Client": stream.hello["client"]}
        gateway.http.put("/links/board", json={"url": board.url}, headers=operator).raise_for_status()
        begun = stream.event("recording")
        assert begun["active"]
        gateway.http.delete("/links/board", headers=operator)
        assert stream.event("recording") == {"active": False, "file": None}
    assert begun["file"] == f"{gateway.http.get('/recordings').json()['recordings'][0]['id']}.mcap"


@pytest.mark.parametrize(
    ("path", "status", "code"),
    [
        ("20260101T000000Z", 404, "recording_unknown"),
        ("20260101T000000Z/export", 404, "recording_unknown"),
        ("20260101T000000Z/export?format=gpx", 422, "invalid_request"),
        ("state", 422, "invalid_request"),
        ("..%2Fstate.json/export", 404, "no_such_address"),
    ],
)
def test_what_is_no_recording_is_said_to_be_none(gateway: Gateway, path: str, status: int, code: str) -> None:
    answer = gateway.http.get(f"/recordings/{path}")
    assert (answer.status_code, answer.json()["code"]) == (status, code)


def test_foreign_files_in_the_folder_are_not_listed(gateway: Gateway, tmp_path: Path) -> None:
    folder = tmp_path / "data" / "recordings"
    folder.mkdir(parents=True)
    (folder / "holiday.mcap").write_text("")
    (folder / "20260101T000000Z.mcap").write_text("abc")
    (folder / "20260102T000000Z-2.mcap").write_text("abcd")
    listed = gateway.http.get("/recordings").json()["recordings"]
    assert [(one["id"], one["bytes"]) for one in listed] == [("20260102T000000Z-2", 4), ("20260101T000000Z", 3)]
