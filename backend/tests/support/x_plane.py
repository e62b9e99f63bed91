"""A stand-in for X-Plane 10, 11 or 12 on the loopback: it says that it is there, and sends what it is told to."""

from __future__ import annotations

import socket
import struct
from types import TracebackType
from typing import Self

from epf_gcs.xplane.beacon import BEACON_GROUP
from epf_gcs.xplane.datagram import Record, build
from tests.support.simulator import ROWS


def beacon(version: int, port: int, name: str = "sim-pc", *, program: int = 1, role: int = 1, minor: int = 2) -> bytes:
    """As X-Plane sends it; since beacon 1.2 another port follows the name."""
    body = struct.pack("<5sBBiiIH", b"BECN\0", 1, minor, program, version, role, port) + name.encode() + b"\0"
    return body + (struct.pack("<H", 49100) if minor >= 2 else b"")


class XPlane:
    """`target` and `rows` are what it was told; nothing is sent before."""

    def __init__(self, version: int) -> None:
        self.version = version
        self.target: tuple[str, int] | None = None
        self.rows: list[int] = []
        self.values: dict[str, float] = {}
        self.datagrams: list[bytes] = []
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self._socket.setblocking(False)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._socket.close()

    @property
    def port(self) -> int:
        """The port that it listens on."""
        return int(self._socket.getsockname()[1])

    def say(self, port: int) -> None:
        """Its beacon, once."""
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
            sender.sendto(beacon(self.version, self.port), (BEACON_GROUP, port))

    def turn(self) -> None:
        """Take what came, as its manual says, and send a frame of the rows that were chosen."""
        while True:
            try:
                datagram = self._socket.recv(2048)
            except BlockingIOError:
                break
            self.datagrams.append(datagram)
            self._take(datagram)
        if self.target is not None and self.rows:
            self._socket.sendto(build(Record(row, ROWS[row]) for row in self.rows), self.target)

    def _take(self, datagram: bytes) -> None:
        head, body = datagram[:5], datagram[5:]
        match head:
            case b"ISE4\0":
                index, host, port, is_used = struct.unpack("<i16s8si", body)
                if index == 64:
                    where = host.rstrip(b"\0").decode(), int(port.rstrip(b"\0"))
                    self.target = where if is_used else None
            case b"DSEL\0":
                self.rows = list(struct.unpack(f"<{len(body) // 4}i", body))
            case b"DREF\0":
                value, name = struct.unpack("<f500s", body)
                self.values[name.rstrip(b"\0").decode()] = value
