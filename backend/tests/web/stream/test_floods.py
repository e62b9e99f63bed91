"""Browsers that send more than anybody needs: they are ended with a reason, and the others notice nothing."""

from __future__ import annotations

import os
import socket
import struct
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager

import orjson
import pytest
from websockets.sync.client import connect

from epf_gcs.shares.allowance import Allowance
from epf_gcs.web.stream.socket import BYTES_PER_TURN, PINGS_PER_S
from tests.support.gateway import Gateway
from tests.support.waiting import DEADLINE_S

KEY = "dGhlIHNhbXBsZSBub25jZQ=="
PING = b"\x89\x80\x00\x00\x00\x00"
MOST_FLOOD_BYTES = 8_000_000


def test_an_allowance_grows_back_with_time_and_no_further_than_full() -> None:
    allowance = Allowance(2.0, 3.0)
    assert [allowance.take(0.0) for _ in range(4)] == [True, True, True, False]
    assert [allowance.take(1.0) for _ in range(3)] == [True, True, False]
    assert [allowance.take(100.0) for _ in range(4)] == [True, True, True, False]


def raw_stream(gateway: Gateway) -> socket.socket:
    """A WebSocket whose frames the test makes itself."""
    made = socket.create_connection(("127.0.0.1", gateway.server.port))
    made.settimeout(DEADLINE_S)
    head = f"GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nSec-WebSocket-Key: {KEY}\r\n"
    made.sendall(f"{head}Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
    assert made.recv(12).startswith(b"HTTP/1.1 101")
    return made


def flood(stream: socket.socket, frame: bytes) -> None:
    """Until the gateway takes no more, or for as long as a flood in a test may last."""
    some = frame * 5000
    try:
        for _ in range(MOST_FLOOD_BYTES // len(some)):
            stream.sendall(some)
    except OSError:
        return


@contextmanager
def flooding(gateway: Gateway, count: int, frame: bytes) -> Iterator[list[socket.socket]]:
    with ExitStack() as opened:
        streams = [opened.enter_context(closing(raw_stream(gateway))) for _ in range(count)]
        threads = [threading.Thread(target=flood, args=(stream, frame)) for stream in streams]
        for thread in threads:
            thread.start()
        try:
            yield streams
        finally:
            for stream in streams:
                stream.close()
            for thread in threads:
                thread.join()


def frames(stream: socket.socket) -> Iterator[tuple[int, bytes]]:
    """Opcode and content of every frame that the gateway sends, until it ends."""
    data = b""
    while True:
        while len(data) >= 2:
            size, start = data[1], 2
            if size >= 126:
                kind, width = ("!H", 2) if size == 126 else ("!Q", 8)
                if len(data) < 2 + width:
                    break
                (size,), start = struct.unpack_from(kind, data, 2), 2 + width
            if len(data) < start + size:
                break
            yield data[0] & 15, data[start : start + size]
            data = data[start + size :]
        try:
            more = stream.recv(65536)
        except ConnectionResetError:
            return
        if not more:
            return
        data += more


def test_a_flood_of_pings_is_ended_with_a_reason(gateway: Gateway) -> None:
    with closing(raw_stream(gateway)) as stream:
        stream.sendall(PING * 1000)
        heard = [(opcode, content) for opcode, content in _after_head(stream) if opcode in (8, 10)]
    assert heard[-1][0] == 8
    assert struct.unpack_from("!H", heard[-1][1]) == (1008,)
    assert len(heard) - 1 <= 2 * PINGS_PER_S + BYTES_PER_TURN // len(PING), "the others were not answered"


def test_a_flood_of_messages_is_ended_too(gateway: Gateway) -> None:
    text = b'{"type":"ack","seq":0}'
    mask = os.urandom(4)
    masked = bytes(byte ^ mask[index % 4] for index, byte in enumerate(text))
    with closing(raw_stream(gateway)) as stream:
        flood(stream, bytes((0x81, 0x80 | len(text))) + mask + masked)
        closes = [content for opcode, content in _after_head(stream) if opcode == 8]
    # Where the flood fills the line it may be cut before it reads why.
    assert all(struct.unpack_from("!H", content) == (1008,) for content in closes)
    assert gateway.status()["viewers"] == 0


def test_while_four_flood_another_is_served(gateway: Gateway) -> None:
    with gateway.stream() as calm, flooding(gateway, 4, PING):
        for _ in range(20):
            calm.next("batch")
        assert gateway.http.get("/status").status_code == 200


def test_a_browser_that_pings_now_and_then_is_answered(gateway: Gateway) -> None:
    with connect(f"ws://127.0.0.1:{gateway.server.port}/api/v1/stream") as stream:
        for _ in range(PINGS_PER_S):
            assert stream.ping().wait(20)


@pytest.mark.parametrize("rate", ["9" * 5000, "0" * 5000])
def test_a_rate_of_thousands_of_digits_is_refused(gateway: Gateway, rate: str) -> None:
    with closing(socket.create_connection(("127.0.0.1", gateway.server.port))) as made:
        made.settimeout(DEADLINE_S)
        head = f"GET /api/v1/stream?rate={rate} HTTP/1.1\r\nHost: 127.0.0.1\r\nSec-WebSocket-Key: {KEY}\r\n"
        made.sendall(f"{head}Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        assert made.recv(12) == b"HTTP/1.1 400"


def test_a_long_message_in_many_pieces_is_still_one(gateway: Gateway) -> None:
    with gateway.stream() as stream:
        stream.connection.send([" " * 5000, " " * 5000, '{"type":"rate","rate":61}'])
        assert "rate must be" in stream.event("error")["detail"]


def _after_head(stream: socket.socket) -> Iterator[tuple[int, bytes]]:
    head = b""
    while not head.endswith(b"\r\n\r\n"):
        head += stream.recv(1)
    return frames(stream)


def masked(opcode: int, content: bytes) -> bytes:
    """A browser's frame, which is always masked."""
    mask = b"\x5a\x01\xf0\x33"
    return (
        bytes((0x80 | opcode, 0x80 | len(content)))
        + mask
        + bytes(letter ^ mask[place % 4] for place, letter in enumerate(content))
    )


def test_however_messages_are_cut_and_mixed_with_pings_each_is_understood(gateway: Gateway) -> None:
    asked = [b'{"type":"rate","rate":%d}' % number for number in range(1001, 1007)]
    first, second, third, fourth, fifth, sixth = (masked(1, text) for text in asked)
    ping = masked(9, b"hello")
    with closing(raw_stream(gateway)) as stream:
        heard = _after_head(stream)
        for piece in (
            first + second,
            third + ping,
            ping,
            *(fourth[place : place + 1] for place in range(len(fourth))),
            fifth + sixth[:9],
            sixth[9:],
            # A text whose second part looks like a message of its own.
            bytes((0x81, 0x80 | len(first))) + bytes(4),
            first,
        ):
            stream.sendall(piece)
            time.sleep(0.01)  # so that pieces arrive apart; together they would only prove less
        answers: list[bytes] = []
        pongs = 0
        for opcode, content in heard:
            pongs += opcode == 10 and content == b"hello"
            if content.startswith(b'{"type":"event","event":"error"'):
                answers.append(content)
            elif content.startswith(b'{"type":"batch"'):
                # Without acknowledgements what follows would be held back.
                stream.sendall(masked(1, b'{"type":"ack","seq":%d}' % orjson.loads(content)["seq"]))
            if len(answers) == len(asked) + 1 and pongs == 2:
                break
    assert sum(b"rate must be" in answer for answer in answers) == len(asked)
    assert sum(b"not JSON" in answer for answer in answers) == 1
    assert pongs == 2
