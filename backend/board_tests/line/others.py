"""What stations that are not ours see: the same of every board, whatever processor it runs on."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Final

from board_tests.line.station import EXTENSIONS, LEVEL_FLIGHT, Station
from epf_gcs.codec.messages_gen import COMMANDS, PARAMETERS

ARGUMENTS: Final[dict[str, tuple[float, ...]]] = {
    "set_parameter_task_rate": (20,),
    "set_fms_task_rate": (100,),
    "set_servos_task_rate": (20,),
    "control_source": (1,),
    "servo_out": (3, 0.5),
    "select_airspeed_source": (1,),
    "select_altitude_source": (0,),
    "mission_begin": (1, 2),
    "mission_item": (1, 0, 27.95, -15.38, 1000.0, 55.0),
    "mission_commit": (1,),
    "mission_read": (1,),
    "go_to_waypoint": (1, 0),
    "describe_blocks": (0, 1),
    "own_gain_get": (0,),
    "own_gain_set": (0, 1.0),
    "own_topics": (1,),
} | {f"set_{parameter.name}": (parameter.default,) for parameter in PARAMETERS}
"""What each command that takes something is given."""

VECTORS: Final = Path(__file__).parents[3] / "protocol" / "vectors" / "commands.jsonl"


def a_foreign_station_gets_no_extension(binary: Station) -> None:
    """Every captured frame of the old station, one after the other, and then its streams."""
    lines = [json.loads(line) for line in VECTORS.read_text().splitlines() if line.strip()]
    frames = [bytes.fromhex(line["hex"]) for line in lines if line["hex"]]
    assert len(frames) > 200
    for frame in frames:
        binary.send(frame)
        binary.send(b"#QT\n")  # whatever mode the last one left, a reset too
    binary.command("load_autopilot_parameters")
    binary.next("autopilot_parameters")
    binary.command("start")
    binary.command("set_parameter_task_rate", 50)
    binary.heartbeats(12)
    assert binary.failed == 0
    assert binary.names() & EXTENSIONS == set()


def extensions_are_ignored_to_the_byte(legacy: Station) -> None:
    """A deployed board answers none of them, and nothing but its heartbeat is on the line."""
    legacy.heartbeats(2)
    quiet = legacy.next("heartbeat").payload
    legacy.received.clear()
    legacy.frames.clear()
    for name, command in COMMANDS.items():
        if command.extension:
            legacy.command(name, *ARGUMENTS.get(name, ()))
    legacy.heartbeats(4)
    assert legacy.names() == {"heartbeat"}
    assert {frame.payload for frame in legacy.frames} == {quiet}
    assert legacy.failed == 0
    # Whole heartbeats, but for the last one, and not a byte between them.
    assert bytes(legacy.received).replace(b"\r\n\r\n", b"").count(b"\rQT,") == len(legacy.received) // 28


def original_commands_are_answered_by_no_extension(legacy: Station) -> None:
    """Each of them, after the capabilities were asked for."""
    legacy.command("capabilities")
    for name, command in COMMANDS.items():
        if not command.extension and name not in ("reset", "exit_binary_mode", "xplane_info"):
            legacy.command(name, *ARGUMENTS.get(name, ()))
    legacy.command("load_autopilot_parameters")
    legacy.next("autopilot_parameters")
    legacy.command("start")
    legacy.heartbeats(6)
    assert legacy.failed == 0
    assert legacy.names() & EXTENSIONS == set()


def commands_do_what_they_do_on_any_board(legacy: Station) -> None:
    """A switch, a gain and a HIL frame."""
    legacy.command("control_source", 1)
    legacy.command("autopilot_on")
    legacy.wait(lambda: legacy.heartbeat()["autopilot_hil"] == 3)
    legacy.command("set_k_pitch", 2.5)
    legacy.command("load_autopilot_parameters")
    values = legacy.next("autopilot_parameters").values
    assert values[[parameter.name for parameter in PARAMETERS].index("k_pitch")] == 2.5
    legacy.command("xplane_info", *LEVEL_FLIGHT)
    legacy.next("hil_surfaces")
