"""A board is held against the page of its protocol, check by check; each that fails says what the board lacks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.values import meaning
from epf_gcs.lab.checks import ORIGINAL, PROGRAM
from epf_gcs.lab.checks_of_damage import DAMAGE
from epf_gcs.lab.checks_of_description import DESCRIBED
from epf_gcs.lab.checks_of_extensions import EXTENDED
from epf_gcs.lab.peer import LEVEL, Check, Lack, Peer, Wire, must_be


@dataclass(frozen=True, slots=True)
class Outcome:
    """Of one check. `lacks`: None where the board does as it must."""

    name: str
    lacks: str | None


def conform(line: Wire, patience_s: float = 2.0, *, is_program: bool = True) -> Iterator[Outcome]:
    """Judge the board at the other end of a line, check by check. `is_program`: it has a shell, and can start anew."""
    peer = Peer(line, patience_s)
    checks = (*ORIGINAL, *DAMAGE, _UNASKED, *(PROGRAM if is_program else ()))
    opened = _outcome(peer, "binary mode opens by #QT and a line feed", Peer.open)
    yield opened
    if opened.lacks is not None:
        return
    for name, check in checks:
        yield _outcome(peer, name, check)
    extended = _outcome(peer, "extensions: the capabilities are told, in version 1", _capabilities)
    if extended.lacks is not None:
        yield _outcome(peer, "without extensions it goes on as before it was asked for them", _goes_on)
    yield extended
    if extended.lacks is None:
        for name, check in (*EXTENDED, *(DESCRIBED if _describes_itself(peer) else ())):
            yield _outcome(peer, f"extensions: {name}", check)


def _outcome(peer: Peer, name: str, check: Check) -> Outcome:
    try:
        check(peer)
    except Lack as lack:
        return Outcome(name, str(lack))
    except OSError as error:
        return Outcome(name, f"the line broke: {error}")
    return Outcome(name, None)


def _goes_on(peer: Peer) -> None:
    peer.flags()
    peer.frames.clear()
    peer.command("xplane_info", *LEVEL)
    peer.awaited("hil_surfaces", "in answer to command 50")


def _nothing_unasked(peer: Peer) -> None:
    peer.open()
    peer.command("ahrs_on")
    peer.look(1.5)
    others = {frame.message.name for frame in peer.frames if frame.message.extension}
    peer.command("ahrs_off")
    if others:
        raise Lack(
            f"{', '.join(sorted(others))} came although no capabilities were asked for since the line was opened"
        )


def _capabilities(peer: Peer) -> None:
    peer.frames.clear()
    peer.command("capabilities")
    version = peer.awaited("capabilities", "in answer to command 0x100").values[0]
    must_be(version, 1, "the version of the extensions")


def _describes_itself(peer: Peer) -> bool:
    """By the capabilities that came last."""
    told = meaning(peer.awaited("capabilities", "in answer to command 0x100"))
    return told.values["describes_itself"] is True


_UNASKED: Final[tuple[str, Check]] = ("no extension is sent unasked", _nothing_unasked)
