"""The stream, as a browser sees it over a real WebSocket."""

from __future__ import annotations

import contextlib
import itertools
import socket
import time
from typing import Any

import orjson
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

from epf_gcs.contract.status import Status
from tests.support.contract import read_as
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, Stream
from tests.support.waiting import DEADLINE_S, eventually

HANDSHAKE = (
    b"GET /api/v1/stream HTTP/1.1\r\nHOST\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)


def everything_within(stream: Stream, seconds: float) -> list[dict[str, Any]]:
    """What comes until nothing came for this long, or until twice as long passed."""
    messages: list[dict[str, Any]] = []
    end_s = time.monotonic() + 2 * seconds
    with contextlib.suppress(TimeoutError):
        while time.monotonic() < end_s:
            messages.append(orjson.loads(stream.connection.recv(timeout=seconds)))
    return messages


def everything_until_closed(stream: Stream) -> list[dict[str, Any]]:
    """What comes until the gateway ends the stream; fails where it does not."""
    messages: list[dict[str, Any]] = []
    try:
        while True:
            messages.append(stream.receive())
    except ConnectionClosed:
        return messages


def test_hello_says_who_and_what_and_how_everything_stands(gateway: Gateway) -> None:
    with gateway.stream("?name=Tower") as stream:
        hello = stream.hello
        assert (hello["type"], hello["role"], hello["name"]) == ("hello", "owner", "Tower")
        assert hello["has_control"]
        assert {"ahrs", "heartbeat", "simulator", "xplane_info", "hil_surfaces"} <= set(hello["topics"])
        assert abs(hello["server_time_s"] - time.time()) < 60
        read_as(Status, hello["status"])


def test_samples_arrive_with_their_time_and_values(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/commands/ahrs_on").raise_for_status()
    with gateway.stream() as stream:
        assert stream.sample("ahrs") == {"yaw_deg": 10.0, "pitch_deg": 5.0, "roll_deg": -3.0}


def test_every_sample_comes_at_rate_zero(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream("?rate=0") as stream:
        sent = [float(place) for place in range(30)]
        for latitude_deg in sent:
            board.send_gps(latitude_deg, 0.0, 0.0)
        samples: list[dict[str, Any]] = []
        while len(samples) < len(sent):
            samples += [sample for sample in stream.next("batch")["samples"] if sample["topic"] == "gps"]
        assert [sample["values"]["latitude_deg"] for sample in samples] == sent
        times = [sample["t_s"] for sample in samples]
        assert times == sorted(times), "those that were read together have one time"


def test_the_sequence_has_no_gap(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        assert [stream.next("batch")["seq"] for _ in range(20)] == list(range(1, 21))


def test_a_browser_that_stops_acknowledging_is_not_sent_more_and_then_gets_the_newest(
    gateway: Gateway, board: FakeBoard
) -> None:
    gateway.open_board(board.url)
    with gateway.stream() as stream:
        batches: list[dict[str, Any]] = []
        while len(batches) < 4:
            message = stream.receive()
            if message["type"] == "batch":
                batches.append(message)
        assert "batch" not in [message["type"] for message in everything_within(stream, 1.0)]
        asked_s = gateway.flight.clock.now_s()
        stream.acknowledge(batches[-1])
        newest = stream.next("batch")
        assert newest["missed"] > 0
        assert newest["t_s"] > asked_s - 0.5


def test_status_comes_without_a_board_too_and_each_is_paced_by_a_batch(gateway: Gateway) -> None:
    with gateway.stream() as stream:
        for _ in range(3):
            read_as(Status, stream.next("status")["data"])
            assert stream.next("batch")["samples"] == []


def test_a_change_is_told_at_once(gateway: Gateway, board: FakeBoard) -> None:
    with gateway.stream() as stream:
        gateway.http.put(
            "/links/board", json={"url": board.url}, headers={"X-Client": stream.hello["client"]}
        ).raise_for_status()
        while stream.next("status")["data"]["board"]["state"] != "open":
            pass
        board.unplug()
        alarm = stream.event("alarm")
        assert (alarm["id"], alarm["active"]) == ("heartbeat_lost", True)


def test_the_rate_can_be_changed(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream("?rate=1") as stream:
        stream.send({"type": "rate", "rate": 0})
        times: list[float] = []
        while len(times) < 20:
            times += [s["t_s"] for s in stream.next("batch")["samples"] if s["topic"] == "heartbeat"]
        gaps = sorted(later - earlier for earlier, later in itertools.pairwise(times))
        assert gaps[len(gaps) // 2] < 0.5


def test_a_page_that_is_loaded_again_keeps_its_name_and_control(gateway: Gateway) -> None:
    with gateway.stream() as first, gateway.stream() as watching:
        client = first.hello["client"]
        first.connection.close()
        eventually(lambda: not gateway.web.control.is_connected(client), "it is gone")
        with gateway.stream(f"?client={client}") as again:
            assert (again.hello["client"], again.hello["has_control"]) == (client, True)
        assert not watching.hello["has_control"]


@pytest.mark.parametrize("client", ["0123456789abcde", "0123456789ABCDEF", "x" * 100, ""])
def test_an_id_that_we_never_gave_is_not_taken(gateway: Gateway, client: str) -> None:
    with gateway.stream(f"?client={client}") as stream:
        assert stream.hello["client"] != client


def test_two_pages_never_have_one_id(gateway: Gateway) -> None:
    with gateway.stream() as first, gateway.stream(f"?client={first.hello['client']}") as second:
        assert second.hello["client"] != first.hello["client"]


@pytest.mark.parametrize(
    "text",
    [
        "rubbish",
        "[]",
        "5",
        '{"type": "ack"}',
        '{"type": "ack", "seq": 99}',
        '{"type": "ack", "seq": -1}',
        '{"type": "rate", "rate": 61}',
        '{"type": "rate", "rate": "fast"}',
        '{"type": "fly"}',
        "{" * 5000,
    ],
)
def test_a_wrong_message_is_answered_counted_and_harms_nothing(gateway: Gateway, text: str) -> None:
    with gateway.stream() as stream, gateway.stream() as other:
        stream.connection.send(text)
        error = stream.event("error")
        assert error["code"] == "stream_message_invalid"
        assert error["detail"].endswith(".")
        assert gateway.status()["errors"] == {"stream_message_invalid": 1}
        stream.next("status")
        other.next("status")


def test_a_message_that_is_too_long_ends_only_its_own_stream(gateway: Gateway) -> None:
    with gateway.stream() as stream, gateway.stream() as other:
        stream.connection.send("x" * 100_000)
        assert everything_until_closed(stream) is not None
        other.next("status")


def test_a_split_message_is_put_together(gateway: Gateway) -> None:
    with gateway.stream("?rate=1") as stream:
        stream.connection.send(iter(['{"type": "ra', 'te", "rate"', ": 0}"]))
        eventually(lambda: [v.rate_hz for v in gateway.web.status._hub.viewers] == [0], "the rate is changed")


@pytest.mark.parametrize("rate", ["61", "-1", "fast", "1.5", ""])
def test_a_rate_that_is_none_is_refused_with_a_sentence(gateway: Gateway, rate: str) -> None:
    with pytest.raises(InvalidStatus) as caught, gateway.stream(f"?rate={rate}&x=1"):
        pass
    assert caught.value.response.status_code == 400
    assert b"rate must be 0" in caught.value.response.body


def test_another_address_is_no_stream(gateway: Gateway) -> None:
    with pytest.raises(InvalidStatus) as caught, connect(f"ws://127.0.0.1:{gateway.server.port}/api/v1/other"):
        pass
    assert caught.value.response.status_code == 404


@pytest.mark.parametrize("origin", ["http://evil.example", "https://127.0.0.1:1", "null", "http://127.0.0.1"])
def test_a_foreign_page_gets_no_stream(gateway: Gateway, origin: str) -> None:
    url = f"ws://127.0.0.1:{gateway.server.port}/api/v1/stream"
    with pytest.raises(InvalidStatus) as caught, connect(url, origin=Origin(origin)):
        pass
    assert caught.value.response.status_code == 403
    assert gateway.status()["errors"] == {"foreign_origin": 1}


def test_our_own_page_gets_the_stream(gateway: Gateway) -> None:
    with connect(f"ws://127.0.0.1:{gateway.server.port}/api/v1/stream", origin=Origin(gateway.base)) as stream:
        assert orjson.loads(stream.recv(DEADLINE_S))["type"] == "hello"


def test_a_page_that_pointed_its_own_name_at_us_gets_no_stream(gateway: Gateway) -> None:
    with socket.create_connection(("127.0.0.1", gateway.server.port), DEADLINE_S) as peer:
        peer.sendall(HANDSHAKE.replace(b"HOST", b"Host: evil.example"))
        assert peer.recv(4096).startswith(b"HTTP/1.1 403")
    with socket.create_connection(("127.0.0.1", gateway.server.port), DEADLINE_S) as peer:
        peer.sendall(HANDSHAKE.replace(b"HOST", b"Host: 127.0.0.1\r\nHost: evil.example"))
        assert peer.recv(4096).startswith(b"HTTP/1.1 4")


def test_the_number_of_viewers_is_known(gateway: Gateway) -> None:
    with gateway.stream(), gateway.stream():
        assert gateway.status()["viewers"] == 2
    eventually(lambda: gateway.status()["viewers"] == 0, "they are gone")
