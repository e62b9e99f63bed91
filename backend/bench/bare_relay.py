"""Relays datagrams to a line and its bytes back as datagrams, and does nothing else.

`python -m bench.bare_relay LINE RECEIVE_PORT SEND_PORT`. Its writes have the size of the gateway's frames, its priority
and core are those of the flight process: what it takes is the machine's part.
"""

from __future__ import annotations

import os
import select
import socket
import sys

from epf_gcs.codec.encode import encode_command
from epf_gcs.system.priority import go_first, take_own_core

_FRAME = encode_command("xplane_info", *([0.0] * 15))


def main() -> None:
    """Relay forever."""
    if go_first() == "real-time":
        take_own_core()
    path, receive_port, send_port = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    fd = _open(path)
    simulator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    simulator.bind(("127.0.0.1", receive_port))
    os.write(1, b"ready\n")
    flying = False
    while True:
        for ready in select.select([fd, simulator.fileno()], [], [])[0]:
            if ready == fd:
                os.read(fd, 65536)
                if flying:
                    simulator.sendto(_FRAME, ("127.0.0.1", send_port))
                    flying = False
            else:
                simulator.recv(65536)
                os.write(fd, _FRAME)
                flying = True


def _open(name: str) -> int:
    """The descriptor of a pseudo-terminal, or of a connection to `host:port`."""
    if name.startswith("/"):
        return os.open(name, os.O_RDWR | os.O_NOCTTY)
    host, _, port = name.rpartition(":")
    line = socket.create_connection((host, int(port)))
    line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return line.detach()


if __name__ == "__main__":
    main()
