"""Attacks on a station from its network, each a process that runs for a limited time and ends by itself.

`with attack("pings", port, udp_port):` runs one; `python -m bench.attacks pings PORT UDP_PORT SECONDS` is that process,
and prints `ready` when the attack is fully under way. All traffic stays on the loopback, limited in number and time.
"""

from __future__ import annotations

import contextlib
import json
import os
import selectors
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Final
from urllib.parse import quote

from bench.lookers import exporting, indexing, rewinding
from bench.station import WebSocket

LONGEST_S: Final = 120.0
_SOCKETS: Final = 4
_PINGS: Final = b"\x89\x80\0\0\0\0" * 2000
_DATAGRAMS_PER_S: Final = 10_000
_IDLE: Final = 2000
TLS_HALF_OPEN: Final = "tls-half-open"
_HALF_OPEN: Final = 500
_HELLO: Final = b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc"  # the beginning of a handshake
_UPLOADS: Final = 3
_WRONG_KEYS_PER_S: Final = 20
_BEGIN_S: Final = 30.0
_EVERY_S: Final = 1.0


def _pings(port: int, _udp_port: int, until_s: float) -> None:
    """Four streams that send nothing but pings; a closed one is opened again."""
    streams: list[socket.socket] = []
    while time.monotonic() < until_s:
        while len(streams) < _SOCKETS:
            try:
                made = WebSocket(port, "/api/v1/stream").socket
            except OSError:
                time.sleep(0.1)
                break
            made.setblocking(False)
            streams.append(made)
            _ready()
        streams = [stream for stream in streams if _flooded(stream)]


def _flooded(stream: socket.socket) -> bool:
    """Send some pings and discard the answers; False if the station closed the stream."""
    try:
        with contextlib.suppress(BlockingIOError):
            stream.send(_PINGS)
        with contextlib.suppress(BlockingIOError):
            while data := stream.recv(65536):
                del data
            stream.close()
            return False
    except OSError:
        stream.close()
        return False
    return True


def _datagrams(_port: int, udp_port: int, until_s: float) -> None:
    """Datagrams of an unknown sender to the simulator's port, half of them in X-Plane's format."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        shapes = (b"DATA*" + bytes(36 * 5), os.urandom(200))
        begun_s, sent = time.monotonic(), 0
        _ready()
        while (now_s := time.monotonic()) < until_s:
            owed = int((now_s - begun_s) * _DATAGRAMS_PER_S) - sent
            for number in range(min(owed, 200)):
                with contextlib.suppress(OSError):
                    sender.sendto(shapes[number % 2], ("127.0.0.1", udp_port))
            sent += max(0, owed)
            time.sleep(0.001)


def _bombs(port: int, _udp_port: int, until_s: float) -> None:
    """Small map files that unpack to huge sizes, uploaded again and again."""
    from tests.support.bombs import ENDLESS, SLOW, write_directory_bomb, write_lying_zip, write_view  # noqa: PLC0415

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = [
            write_directory_bomb(folder / "bomb.pmtiles", 20_000_000),
            write_view(folder / "endless.mbtiles", ENDLESS),
            write_view(folder / "slow.mbtiles", SLOW),
            write_lying_zip(folder / "bomb.zip", 400_000_000, 1000),
        ]
        _ready()
        while time.monotonic() < until_s:
            for file in files:
                _send_in(port, file, until_s)
            time.sleep(0.05)


def _send_in(port: int, file: Path, until_s: float) -> None:
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}/api/v1/map/imports?name={quote(file.name)}", file.read_bytes(), method="POST"
    )
    with contextlib.suppress(urllib.error.URLError, OSError):
        urllib.request.urlopen(request, timeout=max(1.0, until_s - time.monotonic())).close()


def _idle(port: int, _udp_port: int, until_s: float) -> None:
    """Two thousand connections that send nothing or half a request; some of the closed ones are opened again."""
    _hold_open(port, _IDLE, (b"", b"GET /api/v1/sta"), until_s)


def _tls_half_open(port: int, _udp_port: int, until_s: float) -> None:
    """500 connections that begin a TLS handshake and never finish it; some of the ended ones are begun again."""
    _hold_open(port, _HALF_OPEN, (b"\x16", _HELLO), until_s)


def _hold_open(port: int, most: int, beginnings: tuple[bytes, bytes], until_s: float) -> None:
    """So many connections, each with one of both beginnings by turns and no more."""
    waiting = selectors.DefaultSelector()
    count = 0
    while time.monotonic() < until_s:
        # All of them at first; then 20 a round, to replace those that the station closed.
        for _ in range(most if count == 0 else 20):
            if count >= most:
                break
            try:
                made = socket.create_connection(("127.0.0.1", port), timeout=1.0)
                if beginning := beginnings[count % 2]:
                    made.send(beginning)
            except OSError:
                break
            waiting.register(made, selectors.EVENT_READ)
            count += 1
        _ready()
        time.sleep(0.05)
        for key, _ in waiting.select(0.0):
            waiting.unregister(key.fileobj)
            with contextlib.suppress(OSError):
                key.fileobj.close()  # type: ignore[union-attr]
            count -= 1


def _wrong_keys(port: int, _udp_port: int, until_s: float) -> None:
    """Twenty clients a second, each of another address, that enter with a wrong key and ask with another."""
    begun_s, sent = time.monotonic(), 0
    while (now_s := time.monotonic()) < until_s:
        if sent >= (now_s - begun_s) * _WRONG_KEYS_PER_S:
            time.sleep(0.005)
            continue
        sent += 1
        address = f"127.0.{sent // 200 % 200}.{sent % 200 + 2}"
        body = b'{"key": "0000-0000-0000-%04d", "name": "x"}' % (sent % 10000)
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), 5.0, (address, 0)) as client:
            client.sendall(
                b"POST /api/v1/access/enter HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"
                b"Content-Length: %d\r\n\r\n%bGET /api/v1/status HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n"
                b"Authorization: Bearer epf_%08x_%043d\r\n\r\n" % (len(body), body, sent, sent)
            )
            while client.recv(65536):
                pass
        _ready()


def _uploads(port: int, _udp_port: int, until_s: float) -> None:
    """Three uploads of a few bytes a second that never complete."""
    sending: dict[int, socket.socket] = {}
    while time.monotonic() < until_s:
        for number in range(_UPLOADS):
            try:
                if number not in sending:
                    made = socket.create_connection(("127.0.0.1", port), timeout=1.0)
                    made.sendall(
                        f"POST /api/v1/map/imports?name=slow{number}.mbtiles HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                        "Content-Length: 900000000\r\n\r\n".encode()
                    )
                    sending[number] = made
                sending[number].send(bytes(10))
            except OSError:
                if number in sending:
                    sending.pop(number).close()
        _ready()
        time.sleep(_EVERY_S)


def _viewers(count: int) -> Callable[[int, int, float], None]:
    def view(port: int, _udp_port: int, until_s: float) -> None:
        """Viewers that acknowledge every batch."""
        waiting = selectors.DefaultSelector()
        for _ in range(count):
            viewer = WebSocket(port, "/api/v1/stream?rate=60")
            waiting.register(viewer.socket, selectors.EVENT_READ, viewer)
        _ready()
        while time.monotonic() < until_s:
            for key, _ in waiting.select(0.1):
                key.data.acknowledge(key.data.receive())

    return view


ATTACKS: Final[dict[str, Callable[[int, int, float], None]]] = {
    "pings": _pings,
    "datagrams": _datagrams,
    "wrong-keys": _wrong_keys,
    "bombs": _bombs,
    "idle": _idle,
    "uploads": _uploads,
    TLS_HALF_OPEN: _tls_half_open,
    "rewinding": lambda *where: rewinding(_ready, *where),
    "indexing": lambda *where: indexing(_ready, *where),
    "exporting": lambda *where: exporting(_ready, *where),
    "viewers50": _viewers(50),
    "viewers200": _viewers(200),
}
"""The attacks by name. 200 viewers are below this computer's limit of streams."""

_said = False


def _ready() -> None:
    global _said  # noqa: PLW0603 - one process, one attack
    if not _said:
        _said = True
        os.write(1, b"ready\n")


@contextlib.contextmanager
def attack(
    name: str, port: int, udp_port: int, idle: Callable[[], None] = lambda: None
) -> Iterator[subprocess.Popen[bytes]]:
    """Run one of ATTACKS inside the block. `idle` is called repeatedly until the attack has begun, so that a caller
    that plays the board can send its heartbeats meanwhile."""
    process = subprocess.Popen(
        [sys.executable, "-m", "bench.attacks", name, str(port), str(udp_port), str(LONGEST_S)],
        stdout=subprocess.PIPE,
        bufsize=0,
    )
    assert process.stdout is not None
    try:
        waiting = selectors.DefaultSelector()
        waiting.register(process.stdout, selectors.EVENT_READ)
        give_up_s = time.monotonic() + _BEGIN_S
        while not waiting.select(0.05):
            idle()
            if time.monotonic() > give_up_s:
                raise TimeoutError(f"the attack '{name}' did not begin")
        if process.stdout.readline() != b"ready\n":
            raise RuntimeError(f"the attack '{name}' ended before it began")
        yield process
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


def main() -> None:
    """Run one attack; arguments: name, port, UDP port, seconds."""
    name, port, udp_port, seconds = sys.argv[1:5]
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource  # noqa: PLC0415 - not on every system

        hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
        resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    ATTACKS[name](int(port), int(udp_port), time.monotonic() + min(float(seconds), LONGEST_S))
    print(json.dumps({"ended": name}), flush=True)


if __name__ == "__main__":
    main()
