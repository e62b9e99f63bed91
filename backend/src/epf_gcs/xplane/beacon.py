"""X-Plane's beacon: once a second it says on the network that it is there, which version it is, and where it listens.

Source: "Exchanging Data with X-Plane", which X-Plane's folder `Instructions` holds, section BECN.
"""

from __future__ import annotations

from struct import Struct
from typing import Final, Literal, NamedTuple

BEACON_GROUP: Final = "239.255.1.1"
BEACON_PORT: Final = 49707

_MAGIC: Final = b"BECN\0"
# Beacon version (two bytes), program, X-Plane's version, role, port.
_BODY: Final = Struct("<BBiiIH")
_BEACON_VERSION: Final = 1
_IS_XPLANE: Final = 1
_IS_MASTER: Final = 1
_LONGEST_NAME: Final = 64
# 104103 is 10.41, 120012 is 12.00.
_VERSIONS_PER_GENERATION: Final = 10_000


class Beacon(NamedTuple):
    """An X-Plane that flies: its computer's name, its version (120012 is 12.00) and the UDP port that it listens on."""

    name: str
    version: int
    port: int

    @property
    def profile(self) -> Literal["xp10", "xp12"]:
        """How its rows are read: 10 and 11 send the same."""
        return "xp12" if self.version >= 12 * _VERSIONS_PER_GENERATION else "xp10"

    @property
    def version_text(self) -> str:
        """The version as its users know it: 11.55."""
        hundredths = self.version // 100
        return f"{hundredths // 100}.{hundredths % 100:02d}"


def parse_beacon(datagram: bytes) -> Beacon | None:
    """The beacon of an X-Plane; None for anything else, and for a second computer that only draws its pictures."""
    if not datagram.startswith(_MAGIC) or len(datagram) < len(_MAGIC) + _BODY.size:
        return None
    major, _, program, version, role, port = _BODY.unpack_from(datagram, len(_MAGIC))
    if (major, program, role) != (_BEACON_VERSION, _IS_XPLANE, _IS_MASTER) or version <= 0 or port == 0:
        return None
    name = datagram[len(_MAGIC) + _BODY.size :].split(b"\0", 1)[0][:_LONGEST_NAME]
    # A stranger may have sent it: what is shown is letters, no control characters.
    shown = "".join(letter for letter in name.decode(errors="replace") if letter.isprintable())
    return Beacon(shown, version, port)
