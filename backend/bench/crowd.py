"""Viewers that keep up: `python -m bench.crowd PORT COUNT`; prints `ready` when all have their first batch."""

from __future__ import annotations

import os
import selectors
import sys

from bench.station import WebSocket


def main() -> None:
    """Read and acknowledge forever."""
    port, count = int(sys.argv[1]), int(sys.argv[2])
    waiting = selectors.DefaultSelector()
    for _ in range(count):
        viewer = WebSocket(port, "/api/v1/stream?rate=60")
        waiting.register(viewer.socket, selectors.EVENT_READ, viewer)
    served: set[int] = set()
    while True:
        for key, _ in waiting.select():
            message = key.data.receive()
            key.data.acknowledge(message)
            served.add(key.fd)
        if len(served) == count:
            os.write(1, b"ready\n")
            served = set(range(-count - 1, 0))


if __name__ == "__main__":
    main()
