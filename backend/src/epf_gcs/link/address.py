"""The address of a board link, as people and the REST interface write it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal
from urllib.parse import parse_qs, urlsplit

from epf_gcs.errors import InvalidInputError

BAUD_RATES: Final = (9600, 57600, 115200, 230400, 460800, 921600)
DEFAULT_BAUD: Final = 115200
_EXAMPLES: Final = "serial:///dev/ttyUSB0?baud=115200, tcp://192.168.1.5:4000 or pty:///run/board"

Scheme = Literal["serial", "tcp", "pty", "emulation"]


@dataclass(frozen=True, slots=True)
class LinkAddress:
    """Where the board is. `target` is a path, a COM name or the host of a TCP address; empty for the emulation.

    `baud` is the speed of a serial line; for the other kinds it only serves to state the line's load in percent.
    """

    scheme: Scheme
    target: str
    port: int = 0
    baud: int = DEFAULT_BAUD

    @property
    def url(self) -> str:
        """The canonical spelling of this address."""
        if self.scheme == "emulation":
            return f"{self.scheme}:"
        if self.scheme == "tcp":
            host = f"[{self.target}]" if ":" in self.target else self.target
            base = f"tcp://{host}:{self.port}"
        else:
            base = f"{self.scheme}://{'' if self.target.startswith(('/', '.')) else '/'}{self.target}"
        if self.scheme == "serial" or self.baud != DEFAULT_BAUD:
            return f"{base}?baud={self.baud}"
        return base

    @property
    def name(self) -> str:
        """The short name for messages."""
        return f"{self.target}:{self.port}" if self.scheme == "tcp" else self.target or self.url

    def same_device(self, other: LinkAddress) -> bool:
        """Whether both are the same device, so that one must be closed before the other is opened."""
        return (self.scheme, self.target, self.port) == (other.scheme, other.target, other.port)


EMULATION: Final = LinkAddress("emulation", "")
"""No board: example values."""


def parse_address(text: str) -> LinkAddress:
    """Read an address; a plain path or COM name means a serial port.

    Raises InvalidInputError, which says what is wrong with it.
    """
    text = text.strip()
    if len(text) > 500 or not text.isprintable():
        raise _bad(text[:60], "it is too long or holds unprintable characters")
    if text.startswith(("/", "./", "../")) or text.upper().startswith("COM"):
        return LinkAddress("serial", text)
    try:
        parts = urlsplit(text)
        port = parts.port
    except ValueError as error:
        raise _bad(text, str(error)) from error
    baud = _baud(text, parts.query)
    match parts.scheme:
        case "tcp":
            if not parts.hostname or not port:
                raise _bad(text, "a TCP address needs a host and a port from 1 to 65535")
            return LinkAddress("tcp", parts.hostname, port, baud)
        case "emulation" if text == "emulation:":
            return EMULATION
        case "serial" | "pty" as scheme:
            if parts.netloc not in ("", ".", "..") or len(parts.path) < 2:
                raise _bad(text, f"after {scheme}: come three slashes and the device")
            device = parts.path[1:] if parts.path[1:].upper().startswith("COM") else parts.netloc + parts.path
            return LinkAddress(scheme, device, baud=baud)
        case _:
            raise _bad(text, "its kind is none of serial, tcp, pty and emulation")


def _baud(text: str, query: str) -> int:
    given = parse_qs(query, keep_blank_values=True)
    if set(given) - {"baud"}:
        raise _bad(text, "baud is the only option")
    value = given.get("baud", [str(DEFAULT_BAUD)])[-1]
    if not value.isascii() or not value.isdigit() or int(value) not in BAUD_RATES:
        raise _bad(text, f"the baud rate must be one of {', '.join(map(str, BAUD_RATES))}")
    return int(value)


def _bad(text: str, why: str) -> InvalidInputError:
    return InvalidInputError(
        "link_address_invalid",
        f"'{text}' is not the address of a board link because {why}: write it like {_EXAMPLES}.",
        url=text,
    )
