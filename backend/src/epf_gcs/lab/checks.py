"""What every board must do by the page of its protocol."""

from __future__ import annotations

import math
from typing import Final

from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.messages_gen import COMMANDS, PARAMETERS
from epf_gcs.lab.peer import LEVEL, Check, Lack, Peer, must_be

_FLAG_OF: Final = {
    **{name: name for name in ("ahrs", "inertial", "analog", "statistics", "gps", "fly_by_wire")},
    "servos_in": "servos",
}
_ROUTES: Final = ("gando", "ruta_isla", "alternativa", "vuelo")


def _stream(name: str) -> Check:
    def check(peer: Peer) -> None:
        peer.command(f"{name}_on")
        peer.next(name, f"after command {COMMANDS[f'{name}_on'].id} ({name} on)")
        flag = _FLAG_OF.get(name)
        if flag and peer.flags()[flag] != 1:
            raise Lack(f"the heartbeat's {flag} is not 1 while the stream is on")
        peer.command(f"{name}_off")
        if flag:
            must_be(peer.flags()[flag], 0, f"the heartbeat's {flag} after {name} off")
        peer.flags()
        peer.frames.clear()
        peer.look(0.5)
        must_be(peer.count(name), 0, f"frames of {name} after it was switched off")

    return check


def _stop_and_start(peer: Peer) -> None:
    for command, flag in (("start", 1), ("stop", 0)):
        peer.command(command)
        flags = peer.flags()
        told = [flags[name] for name in _FLAG_OF.values()]
        must_be(told, [flag] * len(_FLAG_OF), f"the heartbeat's streams after {command}")


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
        must_be(_waypoint(peer), 0, f"the waypoint after loading {route}")
    for command, wanted in (("next", 1), ("next", 2), ("previous", 1)):
        peer.command(f"hil_fms_{command}_waypoint")
        peer.next("fms_hil_plan", "with its stream on")
        must_be(_waypoint(peer), wanted, f"the waypoint after HIL FMS {command} waypoint")
    peer.command("fms_hil_plan_off")


def _waypoint(peer: Peer) -> int:
    return int(peer.next("fms_hil_plan", "with its stream on").values[4])


def _switches(peer: Peer) -> None:
    peer.command("control_source", 1)
    peer.command("autopilot_on")
    peer.command("autotrim_on")
    flags = peer.flags()
    must_be((flags["autopilot_hil"], flags["autotrim_hil"]), (3, 1), "autopilot_hil and autotrim_hil, all on, joystick")
    peer.command("autopilot_off")
    peer.command("autotrim_off")
    flags = peer.flags()
    must_be((flags["autopilot_hil"], flags["autotrim_hil"]), (2, 0), "autopilot_hil and autotrim_hil, off, joystick")
    peer.command("control_source", 0)
    must_be(peer.flags()["autopilot_hil"] & 2, 0, "the joystick's bit with the transmitter as source")
    peer.command("control_source", 1)


def _leaves(peer: Peer) -> None:
    peer.command("stop")
    peer.command("exit_binary_mode")
    peer.look(0.6)
    peer.frames.clear()
    peer.look(0.6)
    must_be(peer.count("heartbeat"), 0, "heartbeats after command 49 (exit the binary mode)")
    peer.open()


def _starts_anew(peer: Peer) -> None:
    peer.command("control_source", 1)
    peer.command("ahrs_on")
    peer.flags()
    peer.command("reset")
    peer.look(1.0)
    peer.open()
    flags = peer.flags()
    must_be((flags["ahrs"], flags["autopilot_hil"]), (0, 0), "ahrs and autopilot_hil after command 4 (reset)")


def _cut(peer: Peer) -> None:
    peer.send(encode_command("xplane_info", *LEVEL)[:20])
    peer.look(0.4)
    peer.command("ahrs_on")
    peer.look(0.4)
    must_be(peer.flags()["ahrs"], 1, "the stream that a frame after one that broke off asked for")
    peer.command("ahrs_off")


ORIGINAL: Final[tuple[tuple[str, Check], ...]] = (
    *((f"stream {name}: on and off", _stream(name)) for name in _FLAG_OF),
    ("start and stop switch every stream", _stop_and_start),
    ("read all sends every stream once", _read_all),
    ("each command 50 is answered by surfaces", _answers),
    ("the stick moves the surfaces the way it says", _stick),
    ("each parameter is set, and told back", _parameters),
    ("each route is loaded; waypoints go on and back", _routes),
    ("control source, autopilot and autotrim show in the heartbeat", _switches),
)
"""Names, and what raises Lack where the board does not do so."""
PROGRAM: Final[tuple[tuple[str, Check], ...]] = (
    ("a frame that breaks off costs nothing else", _cut),
    ("the rate of the parameter task is settable", _rates),
    ("the binary mode is left, and opened again", _leaves),
    ("a reset starts it anew, with all streams off", _starts_anew),
)
"""The same for a board that runs as a program: it has a clock and a text shell."""
