"""What a board with extensions must do."""

from __future__ import annotations

from typing import Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import frame_bytes
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS, END
from epf_gcs.lab.peer import LEVEL, Check, Peer, must_be

_UNUSED_TYPE: Final = 44
_DONE, _BAD_VALUE, _BAD_STATE, _UNKNOWN, _STORAGE_FAILED = range(5)
_STORES: Final = 2
_HIL_PLAN: Final = 1
_PLACES: Final = ((27.94, -15.39, 900.0, 55.0), (27.95, -15.38, 1100.0, 60.0))


def _features(peer: Peer) -> int:
    peer.frames.clear()
    peer.command("capabilities")
    return int(peer.awaited("capabilities", "in answer to command 0x100").values[1])


def _acknowledges(peer: Peer) -> None:
    for name in ("ahrs_on", "ahrs_off", "stop", "hil_load_gando", "servos_control_mode_hil"):
        must_be(peer.result(name), _DONE, f"the acknowledgement of {name}")
    must_be(peer.result("servo_out", 3, 0.25), _DONE, "the acknowledgement of servo_out")
    peer.frames.clear()
    peer.command("do_nothing")
    peer.command("xplane_info", *LEVEL)
    peer.result("ahrs_off")
    must_be(peer.count("acknowledgement"), 1, "acknowledgements of commands 0, 50 and 6 together: only 6 has one")


def _refuses(peer: Peer) -> None:
    bad = frame_bytes(TO_BOARD, COMMANDS["control_source"], (7).to_bytes(4, "little"))
    must_be(
        peer.result_of(COMMANDS["control_source"].id, bad), _BAD_VALUE, "the result of control source 7 (bad value)"
    )
    body = _UNUSED_TYPE.to_bytes(4, "little")
    unknown = TO_BOARD.header + body + checksum(body).to_bytes(4, "little") + END
    must_be(peer.result_of(_UNUSED_TYPE, unknown), _UNKNOWN, "the result of command 44 (unknown)")
    must_be(
        peer.result("mission_commit", _HIL_PLAN), _BAD_STATE, "the result of a commit without an upload (bad state)"
    )


def _status(peer: Peer) -> None:
    peer.result("select_airspeed_source", 0)
    peer.result("select_altitude_source", 0)
    must_be(tuple(peer.next("board_status", "each second").values[:2]), (0, 0), "the sources in the status, both GPS")
    peer.result("select_airspeed_source", 1)
    peer.result("select_altitude_source", 1)
    must_be(
        tuple(peer.next("board_status", "each second").values[:2]), (1, 1), "the sources in the status, chosen back"
    )


def _stores(peer: Peer) -> None:
    wanted = _DONE if _features(peer) & _STORES else _STORAGE_FAILED
    must_be(peer.result("store_parameters"), wanted, "the result of storing, by feature bit 1")


def _missions(peer: Peer) -> None:
    must_be(peer.result("mission_begin", _HIL_PLAN, len(_PLACES)), _DONE, "the result of mission begin")
    for index, place in enumerate(_PLACES):
        must_be(peer.result("mission_item", _HIL_PLAN, index, *place), _DONE, "the result of mission item")
    must_be(peer.result("mission_commit", _HIL_PLAN), _DONE, "the result of mission commit")
    _is_read_back(peer)
    must_be(peer.result("go_to_waypoint", _HIL_PLAN, 1), _DONE, "the result of go to waypoint")
    peer.result("mission_begin", _HIL_PLAN, 3)
    peer.result("mission_item", _HIL_PLAN, 0, *_PLACES[1])
    must_be(peer.result("mission_commit", _HIL_PLAN), _BAD_STATE, "the result of committing one waypoint of three")
    _is_read_back(peer)


def _is_read_back(peer: Peer) -> None:
    peer.frames.clear()
    peer.command("mission_read", _HIL_PLAN)
    count = peer.awaited("mission_count", "in answer to mission read").values
    must_be(tuple(count), (_HIL_PLAN, len(_PLACES)), "plan and number of waypoints read back")
    peer.wait(lambda: peer.count("mission_item") >= len(_PLACES), "the waypoints of the plan did not all come back")
    told = [frame.values[2:] for frame in peer.frames if frame.message.name == "mission_item"]
    must_be([tuple(values) for values in told], list(_PLACES), "the waypoints read back")


EXTENDED: Final[tuple[tuple[str, Check], ...]] = (
    ("commands are acknowledged", _acknowledges),
    ("what cannot be done is refused with the reason", _refuses),
    ("the status comes each second, with the sources", _status),
    ("parameters are stored, or refused", _stores),
    ("a plan is taken whole or not at all, and read back", _missions),
)
"""Names, and what raises Lack where the board does not do so."""
