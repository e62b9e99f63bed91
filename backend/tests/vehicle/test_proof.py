"""What counts as proof, and what does not."""

from __future__ import annotations

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.vehicle.proof import NOT_REPEATABLE, heartbeat_proves, plan_proves

ALL_ON = dict.fromkeys(("ahrs", "inertial", "analog", "statistics", "gps", "servos", "fly_by_wire"), True)


def test_all_flags_must_be_as_the_command_sets_them() -> None:
    start = COMMANDS["start"].confirm
    assert heartbeat_proves(start, (), ALL_ON)
    assert not heartbeat_proves(start, (), {**ALL_ON, "gps": False})
    assert not heartbeat_proves(start, (), {**ALL_ON, "gps": None})
    assert not heartbeat_proves(start, (), {})


def test_the_argument_is_the_flag() -> None:
    source = COMMANDS["control_source"].confirm
    assert heartbeat_proves(source, (1,), {"source_joystick": True})
    assert heartbeat_proves(source, (0,), {"source_joystick": False})
    assert not heartbeat_proves(source, (0,), {"source_joystick": True})
    assert heartbeat_proves(source, (1, 0), {"source_joystick": True}), "the first argument is the flag"


def test_a_plan_must_have_moved() -> None:
    following = COMMANDS["hil_fms_next_waypoint"].confirm
    assert plan_proves(following, 2, 3)
    assert plan_proves(following, 2, 0), "after the last waypoint comes the first"
    assert not plan_proves(following, 2, 2)
    assert not plan_proves(following, None, 3)
    assert not plan_proves(following, 2, None)


def test_a_loaded_plan_begins_at_its_first_waypoint() -> None:
    load = COMMANDS["hil_load_gando"].confirm
    assert plan_proves(load, 0, 0)
    assert plan_proves(load, None, 0)
    assert not plan_proves(load, 3, 3)
    assert not plan_proves(load, 3, -1)


def test_everything_that_steps_is_never_repeated() -> None:
    steps = {name for name in COMMANDS if name.endswith(("_next_waypoint", "_previous_waypoint")) or name == "reset"}
    assert steps == NOT_REPEATABLE
