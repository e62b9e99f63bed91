"""X-Plane's end of the UDP connection: a frame of all rows to send, and the datagrams received."""

from __future__ import annotations

import socket
from types import TracebackType
from typing import Self

from epf_gcs.xplane.datagram import Record, build

NO = -999.0
ROWS = {
    3: (95.5,) + (NO,) * 7,
    4: (0.148, NO, 512.0, NO, 1.02, 0.03, -0.01, NO),
    6: (29.9, 15.0) + (NO,) * 6,
    8: (0.25, -0.5, 0.125) + (NO,) * 5,
    11: (0.2, -0.4, 0.1) + (NO,) * 5,
    16: (0.01, -0.02, 0.03) + (NO,) * 5,
    17: (2.5, -10.25, 135.0) + (NO,) * 5,
    18: (3.25, -1.5, 270.0, 1.75) + (NO,) * 4,
    20: (27.9319, -15.3866, 1234.5, 1200.0, NO, 1235.75, NO, NO),
    25: (0.75,) * 4 + (NO,) * 4,
}
WHOLE = build(Record(row, values) for row, values in ROWS.items())


class Simulator:
    """Sends to `port`; the station sends to its socket."""

    def __init__(self) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.setblocking(False)
        self.got: list[bytes] = []
        self.port = 0

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.socket.close()

    @property
    def own_port(self) -> int:
        """The port that the station must send to."""
        return int(self.socket.getsockname()[1])

    def send(self, datagram: bytes) -> None:
        """Send one datagram to the station."""
        self.socket.sendto(datagram, ("127.0.0.1", self.port))

    def heard(self, datagram: bytes | None) -> bool:
        """Whether this datagram was received."""
        try:
            while True:
                self.got.append(self.socket.recv(2048))
        except BlockingIOError:
            return datagram in self.got
