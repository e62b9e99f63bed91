"""What makes X-Plane send its rows to us without a click in it: where to, which, and how often.

Source: "Exchanging Data with X-Plane", which X-Plane's folder `Instructions` holds, sections ISE4, DSEL and DREF.
"""

from __future__ import annotations

from collections.abc import Iterable
from struct import Struct, pack
from typing import Final

# The row "data output target" of X-Plane's table of network addresses.
_DATA_TARGET: Final = 64
_ADDRESS: Final = Struct("<5si16s8si")
_VALUE: Final = Struct("<5sf500s")
_RATE_NAME: Final = b"sim/network/dataout/network_data_rate"
RATE_HZ: Final = 50.0
"""Half of the most that X-Plane offers: the board takes a row set each 20 ms."""


def output_datagrams(host: str, port: int, rows: Iterable[int]) -> list[bytes]:
    """Have X-Plane send `rows` to an IPv4 address and port, `RATE_HZ` times a second. Raises ValueError for a name."""
    return [_target(host, port), _select(rows), _VALUE.pack(b"DREF\0", RATE_HZ, _RATE_NAME.ljust(500, b"\0"))]


def _target(host: str, port: int) -> bytes:
    if len(host) > len("255.255.255.255") or not host.replace(".", "").isdigit():
        raise ValueError(f"'{host}' is no IPv4 address")
    return _ADDRESS.pack(b"ISE4\0", _DATA_TARGET, host.encode(), str(port).encode(), 1)


def _select(rows: Iterable[int]) -> bytes:
    chosen = sorted(rows)
    return b"DSEL\0" + pack(f"<{len(chosen)}i", *chosen)
