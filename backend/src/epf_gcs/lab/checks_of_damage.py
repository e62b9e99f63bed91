"""What a board must do with damage, and with frames in pieces."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import END
from epf_gcs.lab.peer import LEVEL, Check, Peer, must_be


def _damaged(why: str, damage: Callable[[bytes], bytes], *, is_done: bool = False) -> Check:
    """A command to switch a stream on, as it arrives damaged; then whole ones, which must be understood."""

    def check(peer: Peer) -> None:
        peer.command("ahrs_off")
        peer.flags()
        peer.send(damage(encode_command("ahrs_on")))
        # A board may wait for the rest of a frame; what it then finds in it counts.
        peer.look(0.4)
        must_be(peer.flags()["ahrs"], int(is_done), f"the stream that {why} asked for")
        peer.command("ahrs_on")
        peer.look(0.4)
        must_be(peer.flags()["ahrs"], 1, f"the stream that a whole frame after {why} asked for")
        peer.command("ahrs_off")

    return check


def _with_type(bits: int) -> Callable[[bytes], bytes]:
    def change(frame: bytes) -> bytes:
        body = (int.from_bytes(frame[4:8], "little") | bits).to_bytes(4, "little")
        return frame[:4] + body + checksum(body).to_bytes(4, "little") + END

    return change


def _swapped(frame: bytes) -> bytes:
    body = frame[4:8][::-1]
    return frame[:4] + body + checksum(body).to_bytes(4, "little") + END


def _in_pieces(peer: Peer) -> None:
    peer.command("ahrs_off")
    peer.flags()
    for byte in encode_command("ahrs_on"):
        peer.send(bytes([byte]))
    must_be(peer.flags()["ahrs"], 1, "the stream that a frame in pieces of one byte asked for")
    peer.command("ahrs_off")


def _in_one_piece(peer: Peer) -> None:
    peer.flags()
    peer.frames.clear()
    frames = b"".join(encode_command("xplane_info", *LEVEL[:10], 1000.0 + n, *LEVEL[11:]) for n in range(20))
    peer.send(frames)
    peer.wait(
        lambda: peer.count("hil_surfaces") == 20,
        "20 commands 50 in one piece were not answered 20 times",
    )


def _marks_inside(peer: Peer) -> None:
    (header,) = struct.unpack("<f", b"#QT,")
    (end,) = struct.unpack("<f", END)
    peer.frames.clear()
    peer.command("xplane_info", *LEVEL[:4], header, end, *LEVEL[6:])
    peer.awaited("hil_surfaces", "in answer to a command 50 with a header and an end marker among its values")
    peer.look(0.3)
    must_be(peer.count("hil_surfaces"), 1, "answers to it")


DAMAGE: Final[tuple[tuple[str, Check], ...]] = (
    (
        "rubbish before a frame costs nothing else",
        _damaged("a frame after rubbish", b"\xff#Q\r\n".__add__, is_done=True),
    ),
    (
        "a false header before a frame costs nothing else",
        _damaged("a frame after a header", b"#QT,".__add__, is_done=True),
    ),
    ("a wrong checksum is refused", _damaged("a wrong checksum", lambda f: f[:8] + b"\0\0\0\0" + f[12:])),
    ("a wrong end is refused", _damaged("a wrong end", lambda f: f[:-1] + b"\x0b")),
    ("forbidden bits of the type are refused", _damaged("a forbidden type", _with_type(0x40000000))),
    ("a type with its bytes swapped is refused", _damaged("a swapped type", _swapped)),
    (
        "an unknown type is left alone",
        _damaged("an unknown type", lambda _: _with_type(0)(TO_BOARD.header + bytes([44, 0, 0, 0]))),
    ),
    ("a frame may come a byte at a time", _in_pieces),
    ("many frames may come in one piece", _in_one_piece),
    ("values may look like a header or an end", _marks_inside),
)
"""Names, and what raises Lack where the board does not do so."""
