"""What a board must do by the page of its protocol, check by check; each that fails says what the board lacks."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Final

from epf_gcs.codec.checksum import checksum
from epf_gcs.codec.encode import encode_command, frame_bytes
from epf_gcs.codec.frame import TO_BOARD
from epf_gcs.codec.messages_gen import COMMANDS, END, PARAMETERS
from epf_gcs.lab.peer import LEVEL, Lack, Peer, Wire

Check = Callable[[Peer], None]

_FLAG_OF: Final = {
    **{name: name for name in ("ahrs", "inertial", "analog", "statistics", "gps", "fly_by_wire")},
    "servos_in": "servos",
}
_ROUTES: Final = ("gando", "ruta_isla", "alternativa", "vuelo")
_UNUSED_TYPE: Final = 44
_DONE, _BAD_VALUE, _BAD_STATE, _UNKNOWN, _STORAGE_FAILED = range(5)
_STORES: Final = 2
_HIL_PLAN: Final = 1
_PLACES: Final = ((27.94, -15.39, 900.0, 55.0), (27.95, -15.38, 1100.0, 60.0))


@dataclass(frozen=True, slots=True)
class Outcome:
    """Of one check. `lacks`: None where the board does as it must."""

    name: str
    lacks: str | None


def conform(line: Wire, patience_s: float = 2.0, *, is_program: bool = True) -> Iterator[Outcome]:
    """Judge the board at the other end of a line, check by check. `is_program`: it has a shell, and can start anew."""
    peer = Peer(line, patience_s)
    opened = _outcome(peer, "binary mode opens by #QT and a line feed", Peer.open)
    yield opened
    if opened.lacks is not None:
        return
    for name, check in (*_ORIGINAL, *(_PROGRAM if is_program else ())):
        yield _outcome(peer, name, check)
    extended = _outcome(peer, "extensions: the capabilities are told, in version 1", _capabilities)
    if extended.lacks is not None:
        yield _outcome(peer, "without extensions it goes on as before it was asked for them", _goes_on)
    yield extended
    if extended.lacks is None:
        for name, check in _EXTENDED:
            yield _outcome(peer, f"extensions: {name}", check)


def _outcome(peer: Peer, name: str, check: Check) -> Outcome:
    try:
        check(peer)
    except Lack as lack:
        return Outcome(name, str(lack))
    except OSError as error:
        return Outcome(name, f"the line broke: {error}")
    return Outcome(name, None)


# ---- every board


def _stream(name: str) -> Check:
    def check(peer: Peer) -> None:
        peer.command(f"{name}_on")
        peer.next(name, f"after command {COMMANDS[f'{name}_on'].id} ({name} on)")
        flag = _FLAG_OF.get(name)
        if flag and peer.flags()[flag] != 1:
            raise Lack(f"the heartbeat's {flag} is not 1 while the stream is on")
        peer.command(f"{name}_off")
        if flag:
            _is(peer.flags()[flag], 0, f"the heartbeat's {flag} after {name} off")
        peer.flags()
        peer.frames.clear()
        peer.look(0.5)
        _is(peer.count(name), 0, f"frames of {name} after it was switched off")

    return check


def _stop_and_start(peer: Peer) -> None:
    peer.command("start")
    _is([peer.flags()[flag] for flag in _FLAG_OF.values()], [1] * len(_FLAG_OF), "the heartbeat's streams after start")
    peer.command("stop")
    _is([peer.flags()[flag] for flag in _FLAG_OF.values()], [0] * len(_FLAG_OF), "the heartbeat's streams after stop")


def _read_all(peer: Peer) -> None:
    peer.command("stop")
    peer.flags()
    peer.frames.clear()
    peer.command("read_all")
    for name in (*_FLAG_OF, "fms_plan", "fms_hil_plan"):
        peer.awaited(name, "after command 3 (read all)")


def _rates(peer: Peer) -> None:
    peer.command("set_parameter_task_rate", 1000)
    peer.flags()
    peer.frames.clear()
    peer.look(1.0)
    slow = peer.count("heartbeat")
    for task in ("parameter", "fms", "servos"):
        peer.command(f"set_{task}_task_rate", 100)
    peer.flags()
    if slow > 3:  # one, and what was on its way
        raise Lack(f"{slow} heartbeats came in a second although a period of 1000 ms was asked for (command 46)")


def _answers(peer: Peer) -> None:
    for number in range(20):
        peer.frames.clear()
        peer.command("xplane_info", *LEVEL[:10], LEVEL[10] + number, *LEVEL[11:])
        values = peer.awaited("hil_surfaces", f"in answer to command 50, number {number + 1} of 20").values
        if not all(math.isfinite(value) and -1.0 <= value <= 1.0 for value in values):
            raise Lack(f"the surfaces that answer command 50 must be -1..+1, and are {values}")


def _stick(peer: Peer) -> None:
    peer.command("control_source", 1)
    peer.command("autopilot_off")
    surfaces: list[float] = []
    for aileron in (0.3, -0.3):
        for step in range(60):
            peer.frames.clear()
            peer.command("xplane_info", 0.0, aileron, *LEVEL[2:10], LEVEL[10] + 0.01 * step, *LEVEL[11:])
            surfaces.append(peer.awaited("hil_surfaces", "in answer to command 50").values[1])
    right, left = surfaces[59], surfaces[-1]
    if not right > left:
        raise Lack(f"the stick to the right must move the aileron to the right: {right:.3f}, left {left:.3f}")


def _parameters(peer: Peer) -> None:
    before = _loaded(peer)
    for place, parameter in enumerate(PARAMETERS):
        wanted = parameter.minimum + 0.25 * (parameter.maximum - parameter.minimum)
        value = round(wanted) if parameter.is_integer else wanted
        peer.command(f"set_{parameter.name}", value)
        told = _loaded(peer)[place]
        peer.command(f"set_{parameter.name}", before[place])
        if abs(told - value) > 1e-3 * abs(value):
            raise Lack(f"{parameter.name} was set to {value:g} (command {parameter.set_id}) and is told as {told:g}")


def _loaded(peer: Peer) -> tuple[float, ...]:
    peer.frames.clear()
    peer.command("load_autopilot_parameters")
    return peer.awaited("autopilot_parameters", "after command 59 (load the parameters)").values


def _routes(peer: Peer) -> None:
    peer.command("fms_hil_plan_on")
    for route in _ROUTES:
        peer.command(f"hil_load_{route}")
        peer.command("xplane_info", *LEVEL)
        peer.next("fms_hil_plan", "with its stream on")
        _is(_waypoint(peer), 0, f"the waypoint after loading {route}")
    for command, wanted in (("next", 1), ("next", 2), ("previous", 1)):
        peer.command(f"hil_fms_{command}_waypoint")
        peer.next("fms_hil_plan", "with its stream on")
        _is(_waypoint(peer), wanted, f"the waypoint after HIL FMS {command} waypoint")
    peer.command("fms_hil_plan_off")


def _waypoint(peer: Peer) -> int:
    return int(peer.next("fms_hil_plan", "with its stream on").values[4])


def _switches(peer: Peer) -> None:
    peer.command("control_source", 1)
    peer.command("autopilot_on")
    peer.command("autotrim_on")
    flags = peer.flags()
    _is((flags["autopilot_hil"], flags["autotrim_hil"]), (3, 1), "autopilot_hil and autotrim_hil, all on, joystick")
    peer.command("autopilot_off")
    peer.command("autotrim_off")
    flags = peer.flags()
    _is((flags["autopilot_hil"], flags["autotrim_hil"]), (2, 0), "autopilot_hil and autotrim_hil, off, joystick")
    peer.command("control_source", 0)
    _is(peer.flags()["autopilot_hil"] & 2, 0, "the joystick's bit with the transmitter as source")
    peer.command("control_source", 1)


def _goes_on(peer: Peer) -> None:
    peer.flags()
    peer.frames.clear()
    peer.command("xplane_info", *LEVEL)
    peer.awaited("hil_surfaces", "in answer to command 50")


# ---- damage


def _damaged(why: str, damage: Callable[[bytes], bytes], *, is_done: bool = False) -> Check:
    """A command to switch a stream on, as it arrives damaged; then whole ones, which must be understood."""

    def check(peer: Peer) -> None:
        peer.command("ahrs_off")
        peer.flags()
        peer.send(damage(encode_command("ahrs_on")))
        # A board may wait for the rest of a frame; what it then finds in it counts.
        peer.look(0.4)
        _is(peer.flags()["ahrs"], int(is_done), f"the stream that {why} asked for")
        peer.command("ahrs_on")
        peer.look(0.4)
        _is(peer.flags()["ahrs"], 1, f"the stream that a whole frame after {why} asked for")
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
    _is(peer.flags()["ahrs"], 1, "the stream that a frame in pieces of one byte asked for")
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
    _is(peer.count("hil_surfaces"), 1, "answers to it")


def _cut(peer: Peer) -> None:
    peer.send(encode_command("xplane_info", *LEVEL)[:20])
    peer.look(0.4)
    peer.command("ahrs_on")
    peer.look(0.4)
    _is(peer.flags()["ahrs"], 1, "the stream that a frame after one that broke off asked for")
    peer.command("ahrs_off")


# ---- a program of its own


def _leaves(peer: Peer) -> None:
    peer.command("stop")
    peer.command("exit_binary_mode")
    peer.look(0.6)
    peer.frames.clear()
    peer.look(0.6)
    _is(peer.count("heartbeat"), 0, "heartbeats after command 49 (exit the binary mode)")
    peer.open()


def _starts_anew(peer: Peer) -> None:
    peer.command("control_source", 1)
    peer.command("ahrs_on")
    peer.flags()
    peer.command("reset")
    peer.look(1.0)
    peer.open()
    flags = peer.flags()
    _is((flags["ahrs"], flags["autopilot_hil"]), (0, 0), "ahrs and autopilot_hil after command 4 (reset)")


# ---- extensions


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
    _is(version, 1, "the version of the extensions")


def _features(peer: Peer) -> int:
    peer.frames.clear()
    peer.command("capabilities")
    return int(peer.awaited("capabilities", "in answer to command 0x100").values[1])


def _acknowledges(peer: Peer) -> None:
    for name in ("ahrs_on", "ahrs_off", "stop", "hil_load_gando", "servos_control_mode_hil"):
        _is(peer.result(name), _DONE, f"the acknowledgement of {name}")
    _is(peer.result("servo_out", 3, 0.25), _DONE, "the acknowledgement of servo_out")
    peer.frames.clear()
    peer.command("do_nothing")
    peer.command("xplane_info", *LEVEL)
    peer.result("ahrs_off")
    _is(peer.count("acknowledgement"), 1, "acknowledgements of commands 0, 50 and 6 together: only 6 has one")


def _refuses(peer: Peer) -> None:
    bad = frame_bytes(TO_BOARD, COMMANDS["control_source"], (7).to_bytes(4, "little"))
    _is(peer.result_of(COMMANDS["control_source"].id, bad), _BAD_VALUE, "the result of control source 7 (bad value)")
    body = _UNUSED_TYPE.to_bytes(4, "little")
    unknown = TO_BOARD.header + body + checksum(body).to_bytes(4, "little") + END
    _is(peer.result_of(_UNUSED_TYPE, unknown), _UNKNOWN, "the result of command 44 (unknown)")
    _is(peer.result("mission_commit", _HIL_PLAN), _BAD_STATE, "the result of a commit without an upload (bad state)")


def _status(peer: Peer) -> None:
    peer.result("select_airspeed_source", 0)
    peer.result("select_altitude_source", 0)
    _is(tuple(peer.next("board_status", "each second").values[:2]), (0, 0), "the sources in the status, both GPS")
    peer.result("select_airspeed_source", 1)
    peer.result("select_altitude_source", 1)
    _is(tuple(peer.next("board_status", "each second").values[:2]), (1, 1), "the sources in the status, chosen back")


def _stores(peer: Peer) -> None:
    wanted = _DONE if _features(peer) & _STORES else _STORAGE_FAILED
    _is(peer.result("store_parameters"), wanted, "the result of storing, by feature bit 1")


def _missions(peer: Peer) -> None:
    _is(peer.result("mission_begin", _HIL_PLAN, len(_PLACES)), _DONE, "the result of mission begin")
    for index, place in enumerate(_PLACES):
        _is(peer.result("mission_item", _HIL_PLAN, index, *place), _DONE, "the result of mission item")
    _is(peer.result("mission_commit", _HIL_PLAN), _DONE, "the result of mission commit")
    _is_read_back(peer)
    _is(peer.result("go_to_waypoint", _HIL_PLAN, 1), _DONE, "the result of go to waypoint")
    peer.result("mission_begin", _HIL_PLAN, 3)
    peer.result("mission_item", _HIL_PLAN, 0, *_PLACES[1])
    _is(peer.result("mission_commit", _HIL_PLAN), _BAD_STATE, "the result of committing one waypoint of three")
    _is_read_back(peer)


def _is_read_back(peer: Peer) -> None:
    peer.frames.clear()
    peer.command("mission_read", _HIL_PLAN)
    count = peer.awaited("mission_count", "in answer to mission read").values
    _is(tuple(count), (_HIL_PLAN, len(_PLACES)), "plan and number of waypoints read back")
    peer.wait(lambda: peer.count("mission_item") >= len(_PLACES), "the waypoints of the plan did not all come back")
    told = [frame.values[2:] for frame in peer.frames if frame.message.name == "mission_item"]
    _is([tuple(values) for values in told], list(_PLACES), "the waypoints read back")


def _is(told: object, wanted: object, what: str) -> None:
    if told != wanted:
        raise Lack(f"{what}: must be {wanted}, is {told}")


_ORIGINAL: Final[tuple[tuple[str, Check], ...]] = (
    *((f"stream {name}: on and off", _stream(name)) for name in _FLAG_OF),
    ("start and stop switch every stream", _stop_and_start),
    ("read all sends every stream once", _read_all),
    ("each command 50 is answered by surfaces", _answers),
    ("the stick moves the surfaces the way it says", _stick),
    ("each parameter is set, and told back", _parameters),
    ("each route is loaded; waypoints go on and back", _routes),
    ("control source, autopilot and autotrim show in the heartbeat", _switches),
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
    ("no extension is sent unasked", _nothing_unasked),
)
_PROGRAM: Final[tuple[tuple[str, Check], ...]] = (
    ("the rate of the parameter task is settable", _rates),
    ("a frame that breaks off costs nothing else", _cut),
    ("the binary mode is left, and opened again", _leaves),
    ("a reset starts it anew, with all streams off", _starts_anew),
)
_EXTENDED: Final[tuple[tuple[str, Check], ...]] = (
    ("commands are acknowledged", _acknowledges),
    ("what cannot be done is refused with the reason", _refuses),
    ("the status comes each second, with the sources", _status),
    ("parameters are stored, or refused", _stores),
    ("a plan is taken whole or not at all, and read back", _missions),
)
