"""A gateway in a separate process, a pseudo-terminal in the board's place, and minimal WebSocket clients."""

from __future__ import annotations

import base64
import contextlib
import json
import os
import pty
import re
import select
import socket
import ssl
import struct
import subprocess
import sys
import tempfile
import time
import tty
import urllib.request
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final, TypeVar

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE
from tests.support.programs import children_of

HEARTBEAT: Final = encode_telemetry("heartbeat", *([1] * 10), 3, 0)
_DEADLINE_S: Final = 20.0
TICKS_PER_S: Final = os.sysconf("SC_CLK_TCK")


class Line:
    """A pseudo-terminal; this process plays the board at its master end."""

    def __init__(self, folder: Path) -> None:
        self.master, self.slave = pty.openpty()
        tty.setraw(self.slave)
        self.path = os.ttyname(self.slave)
        os.set_blocking(self.master, False)
        self.url = f"pty://{self.path}"
        self.folder = folder

    def write(self, data: bytes) -> None:
        """Send bytes as the board."""
        os.write(self.master, data)

    def read(self, timeout_s: float) -> bytes:
        """Bytes sent to the board; empty if none came in time."""
        ready, _, _ = select.select([self.master], [], [], timeout_s)
        return os.read(self.master, 65536) if ready else b""

    def close(self) -> None:
        """Close both ends."""
        os.close(self.master)
        os.close(self.slave)


class NetworkLine:
    """A TCP connection in the board's place; this process plays the board, and waits for the first who connects.

    For measuring on a busy machine: Linux hands what is written to a pseudo-terminal over in a kernel thread of normal
    priority, which waits for others whoever wrote it. On a connection the writer itself does.
    """

    def __init__(self, _folder: Path) -> None:
        self._waiting = socket.create_server(("127.0.0.1", 0))
        self._peer: socket.socket | None = None
        self.path = f"127.0.0.1:{self._waiting.getsockname()[1]}"
        self.url = f"tcp://{self.path}"

    def write(self, data: bytes) -> None:
        """Send bytes as the board."""
        self._connected().sendall(data)

    def read(self, timeout_s: float) -> bytes:
        """Bytes sent to the board; empty if none came in time."""
        peer = self._connected()
        ready, _, _ = select.select([peer], [], [], timeout_s)
        return peer.recv(65536) if ready else b""

    def close(self) -> None:
        """Close both ends."""
        self._waiting.close()
        if self._peer is not None:
            self._peer.close()

    def _connected(self) -> socket.socket:
        if self._peer is None:
            self._waiting.settimeout(_DEADLINE_S)
            self._peer = self._waiting.accept()[0]
            self._peer.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return self._peer


AnyLine = Line | NetworkLine
LineT = TypeVar("LineT", Line, NetworkLine)


class WebSocket:
    """A minimal client, so that only the server's cost is measured. It expects unfragmented messages."""

    def __init__(self, port: int, path: str, protocol: str = "", trust: ssl.SSLContext | None = None) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if trust is not None:
            self.socket = trust.wrap_socket(self.socket, server_hostname="127.0.0.1")
        key = base64.b64encode(os.urandom(16)).decode()
        wanted = f"Sec-WebSocket-Protocol: {protocol}\r\n" if protocol else ""
        self.socket.sendall(
            f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n{wanted}\r\n".encode()
        )
        self._buffer = b""
        while b"\r\n\r\n" not in self._buffer:
            self._buffer += self.socket.recv(65536)
        head, self._buffer = self._buffer.split(b"\r\n\r\n", 1)
        if not head.startswith(b"HTTP/1.1 101"):
            raise ConnectionError(head.decode())

    def receive(self) -> bytes:
        """The next message."""
        while True:
            message = self._take()
            if message is not None:
                return message
            data = self.socket.recv(65536)
            if not data:
                raise ConnectionError("the server closed the stream")
            self._buffer += data

    def receive_hello(self) -> Any:
        """The hello of the stream, parsed. A replay that takes long says so before."""
        while (message := json.loads(self.receive()))["type"] == "opening":
            pass
        return message

    def send(self, text: str) -> None:
        """Send a short text; with a mask of zeros, which is allowed and changes nothing."""
        data = text.encode()
        head = bytes((0x81, 0x80 | len(data))) if len(data) < 126 else struct.pack("!BBH", 0x81, 0xFE, len(data))
        self.socket.sendall(head + b"\0\0\0\0" + data)

    def acknowledge(self, message: bytes) -> None:
        """Acknowledge a batch to our gateway."""
        found = re.match(rb'\{"type":"batch","seq":(\d+)', message)
        if found is not None:
            self.send(f'{{"type":"ack","seq":{int(found[1])}}}')

    def close(self) -> None:
        """Close the connection."""
        self.socket.close()

    def _take(self) -> bytes | None:
        buffer = self._buffer
        if len(buffer) < 2:
            return None
        size, start = buffer[1] & 0x7F, 2
        if size == 126:
            size, start = int.from_bytes(buffer[2:4], "big"), 4
        elif size == 127:
            size, start = int.from_bytes(buffer[2:10], "big"), 10
        if len(buffer) < start + size:
            return None
        self._buffer = buffer[start + size :]
        return buffer[start : start + size]


class Gateway:
    """`epf-gcs` as a process, with our line open in binary mode."""

    def __init__(self, process: subprocess.Popen[str], port: int, trust: ssl.SSLContext | None = None) -> None:
        """`trust`: under TLS, what trusts its certificate."""
        self.process = process
        self.port = port
        self.trust = trust

    @property
    def parts(self) -> dict[str, int]:
        """The process ids of `flight` and `web`."""
        found = {}
        for pid in children_of(self.process.pid):
            words = Path(f"/proc/{pid}/cmdline").read_bytes().decode().split("\0")
            found[words[words.index("-m") + 1].rpartition(".")[2]] = pid
        return found

    def put(self, path: str, body: dict[str, Any]) -> None:
        """Make a PUT request."""
        request = urllib.request.Request(
            f"{self._base}{path}",
            json.dumps(body).encode(),
            {"Content-Type": "application/json"},
            method="PUT",
        )
        urllib.request.urlopen(request, timeout=_DEADLINE_S, context=self.trust).close()

    def get(self, path: str) -> Any:
        """Make a GET request; returns the decoded answer."""
        with urllib.request.urlopen(f"{self._base}{path}", timeout=_DEADLINE_S, context=self.trust) as answer:
            return json.load(answer)

    def open(self, line: AnyLine) -> None:
        """Open the line and answer the opening dialogue as a deployed board does."""
        self.put("/links/board", {"url": line.url})
        give_up_s = time.monotonic() + _DEADLINE_S
        heard = b""
        while OPEN_BINARY_MODE not in heard and time.monotonic() < give_up_s:
            heard += line.read(0.1)
        # Send heartbeats until the gateway's request for capabilities times out: then it takes us for a legacy board.
        while self._state() != "open" and time.monotonic() < give_up_s:
            line.write(HEARTBEAT)
            line.read(0.05)

    def stream(self, rate: int) -> WebSocket:
        """Connect a viewer."""
        return WebSocket(self.port, f"/api/v1/stream?rate={rate}", trust=self.trust)

    @property
    def _base(self) -> str:
        return f"{'http' if self.trust is None else 'https'}://127.0.0.1:{self.port}/api/v1"

    def _state(self) -> str:
        return str(self.get("/status")["board"]["state"])


@contextlib.contextmanager
def station(
    make_line: Callable[[Path], LineT] = Line,  # type: ignore[assignment]
    *,
    tls: bool = False,
) -> Iterator[tuple[Gateway, LineT]]:
    """A running gateway and the line it has open."""
    with tempfile.TemporaryDirectory() as folder:
        line = make_line(Path(folder))
        process = subprocess.Popen(
            [sys.executable, "-m", "epf_gcs.launcher.gateway", "--port", "0", "--data-dir", folder]
            + (["--tls"] if tls else []),
            stderr=subprocess.PIPE,
            text=True,
        )
        try:
            assert process.stderr is not None
            found = None
            while found is None:
                found = re.search(r"url=https?://[^:]+:(\d+)", process.stderr.readline())
            trust = ssl.create_default_context(cafile=f"{folder}/tls/authority.crt") if tls else None
            gateway = Gateway(process, int(found[1]), trust)
            gateway.open(line)
            yield gateway, line
        finally:
            process.terminate()
            process.wait()
            if process.stderr is not None:
                process.stderr.close()
            line.close()


def cpu_s(*pids: int) -> float:
    """CPU time in s that the processes have used, user and system."""
    used = 0
    for pid in pids:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        used += int(fields[11]) + int(fields[12])
    return used / TICKS_PER_S


def run_s(*pids: int) -> float:
    """CPU time in s that all threads of the processes have used, to the nanosecond; a thread that ended is left out."""
    used_ns = 0
    for pid in pids:
        for thread in Path(f"/proc/{pid}/task").iterdir():
            used_ns += int((thread / "schedstat").read_text().split()[0])
    return used_ns * 1e-9


def wakes(*pids: int) -> int:
    """How often the threads of the processes gave the processor up to wait; each of them is woken once for it."""
    found = 0
    for pid in pids:
        for thread in Path(f"/proc/{pid}/task").iterdir():
            said = re.search(r"^voluntary_ctxt_switches:\s+(\d+)", (thread / "status").read_text(), re.MULTILINE)
            found += int(said[1]) if said is not None else 0
    return found


def percentile(values: Sequence[float], share: float) -> float:
    """The value below which this share (0..1) of all values lies."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]
