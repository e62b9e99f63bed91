"""What is asked for again when the board starts anew."""

from __future__ import annotations

import pytest

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.vehicle.wanted import RATE_COMMANDS, STREAM_FLAGS, IntendedSettings

ALL_OFF = {flag: False for flag in STREAM_FLAGS.values() if flag is not None} | {"source_joystick": False}


def test_streams_follow_the_commands() -> None:
    wanted = (
        IntendedSettings().after("ahrs_on", ()).after("servos_in_on", ()).after("fms_plan_on", ()).after("ahrs_off", ())
    )
    assert wanted.streams == {"servos_in", "fms_plan"}
    assert wanted.after("start", ()).streams == set(STREAM_FLAGS)
    assert wanted.after("stop", ()).streams == set()
    others = [name for name in COMMANDS if name not in ("start", "stop") and not name.endswith(("_on", "_off"))]
    assert {wanted.after(name, (1.0,)).streams for name in others} == {wanted.streams}


def test_every_stream_has_a_command_for_on_and_off() -> None:
    for stream in STREAM_FLAGS:
        assert f"{stream}_on" in COMMANDS
        assert f"{stream}_off" in COMMANDS


def test_only_what_is_missing_is_asked_for() -> None:
    wanted = IntendedSettings().after("ahrs_on", ()).after("gps_on", ())
    assert wanted.missing({**ALL_OFF, "ahrs": True}) == [("gps_on", ())]
    assert wanted.missing({**ALL_OFF, "ahrs": True, "gps": True}) == []


def test_streams_without_a_flag_are_always_asked_for() -> None:
    assert IntendedSettings().after("fms_hil_plan_on", ()).missing(ALL_OFF) == [("fms_hil_plan_on", ())]


def test_rates_and_source_come_back_before_the_streams() -> None:
    wanted = IntendedSettings().after("ahrs_on", ()).after("control_source", (1,)).after("set_servos_task_rate", (50,))
    assert wanted.missing(ALL_OFF) == [("set_servos_task_rate", (50,)), ("control_source", (1,)), ("ahrs_on", ())]
    assert wanted.missing({**ALL_OFF, "source_joystick": True, "ahrs": True}) == [("set_servos_task_rate", (50,))]


def test_an_autopilot_is_never_switched_on_by_itself() -> None:
    assert IntendedSettings().after("autopilot_on", ()).after("autotrim_on", ()) == IntendedSettings()


def test_periods_are_the_boards_own_until_they_are_set() -> None:
    assert IntendedSettings().period_s(RATE_COMMANDS[2]) == 0.02
    assert IntendedSettings().after(RATE_COMMANDS[2], (500,)).period_s(RATE_COMMANDS[2]) == 0.5


def test_every_rate_command_has_a_period_of_the_boards_own() -> None:
    defaults_ms = [COMMANDS[name].values[0].default for name in RATE_COMMANDS]
    assert None not in defaults_ms
    assert [IntendedSettings().period_s(name) * 1000.0 for name in RATE_COMMANDS] == pytest.approx(defaults_ms)


def test_a_source_that_was_never_chosen_is_never_asked_for() -> None:
    assert IntendedSettings().missing({**ALL_OFF, "source_joystick": True}) == []
    assert IntendedSettings().after("control_source", (0,)).missing({**ALL_OFF, "source_joystick": True}) == [
        ("control_source", (0,))
    ]


def test_a_stream_s_flag_in_the_heartbeat_is_the_one_that_its_command_sets() -> None:
    for stream, flag in STREAM_FLAGS.items():
        assert COMMANDS[f"{stream}_on"].confirm.flags == ({} if flag is None else {flag: True})
