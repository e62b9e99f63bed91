"""The stream under TLS: the same bytes as in plain text, nothing past the encryption, and slow readers are counted."""

from __future__ import annotations

import ssl
from collections.abc import Callable
from contextlib import ExitStack, closing
from pathlib import Path
from typing import Any

import pytest
from uvicorn.config import Config
from uvicorn.server import ServerState
from websockets.exceptions import ConnectionClosed

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.tls.context import make_context
from epf_gcs.web.stream.socket import SocketConnection
from tests.support.fake_board import FakeBoard
from tests.support.gateway import running_gateway
from tests.support.tls import LOOPS, careless, connected, open_door, self_signed
from tests.support.waiting import DEADLINE_S, eventually

TEXTS = [b"{}", b"x" * 125, b"y" * 126, b"z" * 16384, "ñ".encode() * 40000, b"w" * 300_000]
"""Around the sizes at which heads of frames and records of TLS change."""


class Talker:
    """An endpoint that answers each text of the browser with all TEXTS, in one write and one by one."""

    def __init__(self) -> None:
        self.connections: list[SocketConnection] = []
        self.heard: list[str] = []
        self.closed = 0

    def check(self, values: object) -> None:
        pass

    def open(self, connection: SocketConnection, *_: object) -> Any:
        self.connections.append(connection)
        return Conversation(self, connection)

    def opened(self, conversation: object) -> None:
        pass


class Conversation:
    def __init__(self, talker: Talker, connection: SocketConnection) -> None:
        self._talker = talker
        self._connection = connection

    def on_text(self, text: str) -> None:
        self._talker.heard.append(text)
        self._connection.send(TEXTS)
        for one in TEXTS:
            self._connection.send([one])

    def on_closed(self) -> None:
        self._talker.closed += 1


def maker(talker: Talker) -> Callable[[], SocketConnection]:
    config, state = Config(app=lambda: None, log_config=None), ServerState()
    return lambda: SocketConnection(config, state, {"socket_endpoint": talker})


@pytest.fixture
def context(tmp_path: Path) -> ssl.SSLContext:
    return make_context(*self_signed(tmp_path))


@pytest.mark.parametrize("kind", LOOPS)
def test_what_comes_through_tls_is_what_comes_in_plain_text(kind: str, context: ssl.SSLContext) -> None:
    talker = Talker()
    make = maker(talker)
    got = []
    with open_door(kind, context, encrypted=make, plain=make) as door:
        for scheme in ("ws", "wss"):
            trust = careless() if scheme == "wss" else None
            with connected(f"{scheme}://127.0.0.1:{door.port}/", trust, compression=None) as browser:
                for question in ("a", "b" * 5000):
                    browser.send(question)
                    got.append([browser.recv(DEADLINE_S, decode=False) for _ in range(2 * len(TEXTS))])
        eventually(lambda: talker.closed == 2, "both conversations end")
    assert got == [TEXTS + TEXTS] * 4
    assert talker.heard == ["a", "b" * 5000] * 2


@pytest.mark.parametrize("kind", LOOPS)
def test_a_slow_reader_is_counted_and_later_gets_all_of_it(kind: str, context: ssl.SSLContext) -> None:
    talker = Talker()
    with open_door(kind, context, encrypted=maker(talker)) as door, ExitStack() as opened:
        address = f"wss://127.0.0.1:{door.port}/"
        # Few messages are taken from the transport before they are asked for: the reader is slow.
        browser = opened.enter_context(
            connected(address, careless(), compression=None, max_queue=1, ping_interval=None)
        )
        for _ in range(16):
            browser.send("more")
        eventually(lambda: len(talker.heard) == 16, "all questions are heard")
        (connection,) = talker.connections
        # 64 KiB of it may be in the transport below, which counts apart.
        eventually(lambda: connection.unsent_bytes() > 1_000_000, "what the browser does not take is counted")
        assert [browser.recv(DEADLINE_S, decode=False) for _ in range(32 * len(TEXTS))] == TEXTS * 32
        eventually(lambda: connection.unsent_bytes() == 0, "nothing is left")


@pytest.mark.parametrize("kind", LOOPS)
def test_nothing_is_written_to_the_descriptor_past_tls(
    kind: str, context: ssl.SSLContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every byte on the wire belongs to a record of TLS."""
    written: list[int] = []
    real = __import__("os").write

    def write(descriptor: int, data: bytes) -> int:
        written.append(len(data))
        return int(real(descriptor, data))

    monkeypatch.setattr("epf_gcs.web.stream.socket.os.write", write)
    talker = Talker()
    with open_door(kind, context, encrypted=maker(talker)) as door, closing(door.connect()) as raw:
        incoming, outgoing = ssl.MemoryBIO(), ssl.MemoryBIO()
        ours = careless().wrap_bio(incoming, outgoing)
        wire = b""

        def until(step: Callable[[], Any]) -> Any:
            nonlocal wire
            while True:
                try:
                    done = step()
                except ssl.SSLWantReadError:
                    done = None
                raw.sendall(outgoing.read())
                if done is not None:
                    return done
                data = raw.recv(65536)
                wire += data
                incoming.write(data)

        until(lambda: (ours.do_handshake(), True)[1])  # type: ignore[func-returns-value]
        ours.write(
            b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
        )
        assert until(lambda: ours.read(65536)).startswith(b"HTTP/1.1 101")
        ours.write(b"\x81\x81\0\0\0\0a")
        got = b""
        while len(got) < 2 * sum(map(len, TEXTS)):
            got += until(lambda: ours.read(65536))
        while wire:
            assert wire[:3] in (b"\x16\x03\x03", b"\x14\x03\x03", b"\x17\x03\x03"), wire[:20]
            wire = wire[5 + int.from_bytes(wire[3:5], "big") :]
    assert 2 * sum(map(len, TEXTS)) not in written
    assert not [size for size in written if size > 100], written


def test_a_viewer_under_tls_sees_the_board_and_hears_that_the_station_ends(tmp_path: Path, board: FakeBoard) -> None:
    with running_gateway(tmp_path / "data", tls=True) as gateway:
        gateway.open_board(board.url)
        with gateway.stream("?rate=0") as stream:
            board.send(encode_telemetry("ahrs", 10.0, 2.0, 30.0))
            assert stream.sample("ahrs")["roll_deg"] == 30.0
            gateway.server.should_exit = True
            with pytest.raises(ConnectionClosed, match="1012"):
                stream.next("never")
