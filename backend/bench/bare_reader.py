"""Reads a pseudo-terminal and prints arrival times in ns of the steady clock: `python -m bench.bare_reader PTY`."""

from __future__ import annotations

import os
import sys
import time


def main() -> None:
    """Read forever."""
    fd = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
    os.write(1, b"ready\n")
    while True:
        os.read(fd, 65536)
        os.write(1, f"{time.monotonic_ns()}\n".encode())


if __name__ == "__main__":
    main()
