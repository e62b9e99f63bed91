"""Judgements of what is wrong; time is a number."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.vehicle.flight_judges import BatteryJudge
from epf_gcs.vehicle.judges import (
    HICCUP_S,
    CpuJudge,
    DamageJudge,
    Debounce,
    GpsJudge,
    Line,
    Loop,
    judge_card,
    judge_heartbeat,
    judge_hil,
    judge_parameters,
    judge_recording,
    judge_stick,
)
from epf_gcs.vehicle.thresholds import chosen
from epf_gcs.vehicle.traffic_judges import FloodJudge, StrangersJudge
from epf_gcs.vehicle.unusable_value import UnusableValue

VALID = {"fix": 3, "valid": True}
NO_FIX = {"fix": 0, "valid": True}
VOID = {"fix": 3, "valid": False}


@given(st.lists(st.tuples(st.floats(0.01, 2.0), st.sampled_from((True, False, None)))))
def test_a_condition_counts_only_once_it_has_lasted(looks: list[tuple[float, bool | None]]) -> None:
    lasting = Debounce(3.0)
    now_s, held, same_since_s, previous = 0.0, False, 0.0, None
    for after_s, condition in looks:
        now_s += after_s
        if condition != previous:
            same_since_s, previous = now_s, condition
        lasted_s = now_s - same_since_s
        holds = lasting.look(now_s, condition=condition)
        if condition is None:
            assert holds == (held and lasted_s < HICCUP_S)
        elif holds != held:
            assert holds == condition
            assert lasted_s >= 3.0
        elif lasted_s >= 3.0:
            assert holds == condition
        held = holds


def test_what_nobody_knows_for_a_moment_changes_nothing_and_for_longer_does_not_hold() -> None:
    lasting = Debounce(3.0)
    lasting.look(0.0, condition=True)
    assert lasting.look(3.0, condition=True)
    assert lasting.look(3.5, condition=None)
    assert lasting.look(4.4, condition=None)
    assert lasting.look(4.5, condition=True)
    assert lasting.look(5.0, condition=None)
    assert not lasting.look(6.0, condition=None)
    lasting.look(6.1, condition=True)
    assert not lasting.look(9.0, condition=True)


BATTERY = chosen({"battery_low_v": 10.5, "battery_cells": 3})


def battery(judge: BatteryJudge, *samples: tuple[float, float | None]) -> list[bool]:
    return [judge.look(now_s, {"battery_v": battery_v}, BATTERY) is not None for now_s, battery_v in samples]


def test_a_battery_is_low_after_three_seconds_below_its_limit() -> None:
    assert battery(BatteryJudge(), (0, 10.4), (2.9, 10.4), (3.0, 10.3)) == [False, False, True]
    assert battery(BatteryJudge(), (0, 10.5), (9, 10.5)) == [False, False], "at the limit it is not below"


def test_a_battery_that_sags_for_a_moment_is_no_alarm_and_a_spike_is_no_rescue() -> None:
    assert battery(BatteryJudge(), (0, 9.0), (2, 11.0), (3, 9.0), (5, 9.0), (6, 9.0)) == [False] * 4 + [True]
    assert battery(BatteryJudge(), (0, 9.0), (3, 9.0), (4, 11.0), (6, 9.0), (8, 11.0)) == [False] + [True] * 4


def test_a_battery_that_nobody_measures_is_no_alarm() -> None:
    judge = BatteryJudge()
    assert battery(judge, (0, 9.0), (4, 9.0), (5, None), (6, None), (7, 9.0)) == [False, True, True, False, False]
    assert judge.look(60, None, BATTERY) is None


def test_the_battery_says_the_low_voltage_also_while_a_spike_lasts() -> None:
    judge = BatteryJudge()
    battery(judge, (0, 9.04), (3, 9.04))
    found = judge.look(4, {"battery_v": 12.0}, BATTERY)
    assert found is not None
    assert (found.level, found.params) == ("critical", {"battery_v": 9.0, "limit_v": 10.5})
    assert "9.0 V" in found.text


@pytest.mark.parametrize("busy", ["sensor_dsc_percent", "control_dsc_percent"])
def test_either_processor_can_be_too_busy(busy: str) -> None:
    judge = CpuJudge()
    load = {"sensor_dsc_percent": 5, "control_dsc_percent": 5, busy: 91}
    assert judge.look(0, load, 90) is None
    found = judge.look(3, load, 90)
    assert found is not None
    assert (found.id, found.level, found.params) == ("cpu_high", "warning", {"percent": 91})
    judge.look(4, None, 90)
    assert judge.look(5, None, 90) is None, "a load that is not live is none"


def test_a_processor_at_its_limit_or_without_a_value_is_not_busy() -> None:
    judge = CpuJudge()
    for now_s in range(9):
        assert judge.look(now_s, {"sensor_dsc_percent": None, "control_dsc_percent": 90}, 90) is None
        assert judge.look(now_s, {"sensor_dsc_percent": None, "control_dsc_percent": None}, 90) is None


@pytest.mark.parametrize("lost", [NO_FIX, VOID, {"fix": None, "valid": None}])
def test_a_gps_without_a_position_is_a_warning_at_first_and_critical_once_there_was_one(
    lost: dict[str, object],
) -> None:
    judge = GpsJudge()
    assert judge.look(0, lost, is_wanted=True) is None
    found = judge.look(1, lost, is_wanted=True)
    assert found is not None
    assert (found.id, found.level, found.params) == ("gps_lost", "warning", {"reason": "no_fix"})
    judge.look(2, VALID, is_wanted=True)
    assert judge.look(3, VALID, is_wanted=True) is None
    judge.look(4, lost, is_wanted=True)
    again = judge.look(5, lost, is_wanted=True)
    assert again is not None
    assert again.level == "critical"


def test_a_gps_whose_stream_stopped_is_lost_only_where_it_is_wanted_and_was_there() -> None:
    never = GpsJudge()
    assert [never.look(now_s, None, is_wanted=True) for now_s in (0, 5)] == [None, None]
    judge = GpsJudge()
    judge.look(0, VALID, is_wanted=True)
    assert [judge.look(now_s, None, is_wanted=False) for now_s in (1, 5)] == [None, None]
    judge.look(6, None, is_wanted=True)
    found = judge.look(7, None, is_wanted=True)
    assert found is not None
    assert (found.level, found.params) == ("critical", {"reason": "silent"})
    judge.forget()
    assert judge.look(8, None, is_wanted=True) is None
    assert judge.look(20, None, is_wanted=True) is None


def test_after_a_silence_of_the_whole_board_the_gps_has_its_time_again() -> None:
    judge = GpsJudge()
    judge.look(0, VALID, is_wanted=True)
    assert judge.look(1, None, is_wanted=True) is None
    judge.wait()
    assert judge.look(9, None, is_wanted=True) is None
    found = judge.look(10, None, is_wanted=True)
    assert found is not None
    assert found.level == "critical"


def test_a_gps_that_nobody_wants_any_more_is_no_alarm_at_once() -> None:
    judge = GpsJudge()
    judge.look(0, NO_FIX, is_wanted=True)
    assert judge.look(1, NO_FIX, is_wanted=True) is not None
    assert judge.look(1.1, None, is_wanted=False) is None


def test_a_hiccup_of_the_stream_makes_a_missing_position_neither_worse_nor_better() -> None:
    judge = GpsJudge()
    judge.look(0, NO_FIX, is_wanted=True)
    before = judge.look(1, NO_FIX, is_wanted=True)
    assert before is not None
    assert judge.look(1.5, None, is_wanted=True) == before
    assert judge.look(1.6, NO_FIX, is_wanted=True) == before


def test_more_damaged_frames_than_allowed_are_an_alarm_until_the_window_is_past_them() -> None:
    judge = DamageJudge(0.0)
    assert judge.look(1, 1000, 0, 1.0) is None
    assert judge.look(2, 1980, 20, 1.0) is None, "one in a hundred is allowed"
    found = judge.look(3, 1980, 40, 1.0)
    assert found is not None
    assert found.params == {"percent": 2.0}
    assert judge.look(3, 1980, 40, 2.5) is None
    assert judge.look(14, 2000, 40, 1.0) is None
    assert judge.percent == 0.0


def test_a_few_bad_frames_on_a_quiet_line_are_no_bad_line() -> None:
    judge = DamageJudge(0.0)
    assert judge.look(1, 0, 4, 1.0) is None
    assert judge.look(2, 0, 5, 1.0) is not None


def test_strangers_that_keep_sending_are_a_warning_until_they_have_been_quiet() -> None:
    judge = StrangersJudge(0.0)
    assert judge.look(1, 0, None) is None
    assert judge.look(2, 9, "192.0.2.7:5000") is None, "a few may be a mistake"
    found = judge.look(3, 10, "192.0.2.7:5000")
    assert found is not None
    assert (found.id, found.level) == ("foreign_datagrams", "warning")
    assert found.params == {"per_s": 1, "host": "192.0.2.7:5000"}
    assert "192.0.2.7:5000" in found.text
    flood = judge.look(4, 50_010, "192.0.2.7:5000")
    assert flood is not None
    assert flood.params["per_s"] == 5001
    assert judge.look(13, 50_010, "192.0.2.7:5000") is not None
    assert judge.look(14.5, 50_010, "192.0.2.7:5000") is None


LINE = Line("/dev/ttyUSB0", 100.0, False, True, 0.1, 0.3, None)


@pytest.mark.parametrize(
    ("line", "limit_s", "found"),
    [
        (None, 1.0, None),
        (LINE, 1.0, None),
        (replace(LINE, heartbeat_age_s=1.1), 1.0, "heartbeat_lost"),
        (replace(LINE, heartbeat_age_s=1.1), 2.0, None),
        (replace(LINE, heartbeat_age_s=2.9, stale_after_s=3.0), 1.0, None),
        (replace(LINE, heartbeat_age_s=3.1, stale_after_s=3.0), 1.0, "heartbeat_lost"),
        (replace(LINE, failure="Gone."), 1.0, "heartbeat_lost"),
        (replace(LINE, failure="Gone.", was_heard=False, is_lost=True), 1.0, "heartbeat_lost"),
        (replace(LINE, was_heard=False, heartbeat_age_s=None), 1.0, "no_heartbeat"),
        (replace(LINE, was_heard=False, heartbeat_age_s=None, wanted_for_s=4.0), 1.0, None),
        (replace(LINE, was_heard=False, heartbeat_age_s=None, wanted_for_s=4.0, failure="Not yet."), 1.0, None),
        (replace(LINE, was_heard=False, heartbeat_age_s=None, wanted_for_s=5.1), 1.0, "no_heartbeat"),
        (replace(LINE, heartbeat_age_s=1.1, stale_after_s=None), 1.0, "heartbeat_lost"),
        (replace(LINE, heartbeat_age_s=0.9, stale_after_s=None), 1.0, None),
    ],
)
def test_the_heartbeat(line: Line | None, limit_s: float, found: str | None) -> None:
    finding = judge_heartbeat(line, limit_s)
    assert (None if finding is None else finding.id) == found
    if finding is not None:
        assert finding.level == ("critical" if found == "heartbeat_lost" else "warning")
        assert finding.params == {"target": "/dev/ttyUSB0"}


def test_why_a_line_failed_is_said_in_place_of_the_silence_that_follows_from_it() -> None:
    finding = judge_heartbeat(replace(LINE, failure="The cable was pulled.", heartbeat_age_s=9.0), 1.0)
    assert finding is not None
    assert finding.text == "The cable was pulled."


LOOP = Loop(0.1, 0.1, True, True, ())
BAD = UnusableValue(16, "p_rad_s", math.nan)


@pytest.mark.parametrize(
    ("loop", "words"),
    [
        (None, None),
        (LOOP, None),
        (replace(LOOP, to_board_age_s=0.6, is_board_open=False), "Check the board's link"),
        (replace(LOOP, to_board_age_s=0.6, is_board_open=False, missing_rows=[17]), "Check the board's link"),
        (replace(LOOP, to_board_age_s=0.6, missing_rows=[17, 20]), "rows [17, 20] are missing"),
        (replace(LOOP, to_board_age_s=0.6, unusable=[BAD]), "in row 16 (angular_velocities) the simulator sends nan"),
        (replace(LOOP, to_board_age_s=0.6, missing_rows=[17], unusable=[BAD]), "rows [17] are missing"),
        (replace(LOOP, to_board_age_s=0.6, is_simulator_open=False, unusable=[BAD]), "the simulator sends nothing"),
        (replace(LOOP, unusable=[BAD]), None),
        (replace(LOOP, to_board_age_s=0.6), "the simulator sends nothing"),
        (replace(LOOP, to_board_age_s=0.6, is_simulator_open=False, missing_rows=[17]), "the simulator sends nothing"),
        (replace(LOOP, unanswered_s=0.6), "the board does not answer"),
    ],
)
def test_the_loop_says_where_it_is_open(loop: Loop | None, words: str | None) -> None:
    finding = judge_hil(loop, 0.5)
    assert (finding is None) == (words is None)
    if finding is not None and words is not None:
        assert words in finding.text
        assert (finding.id, finding.level) == ("hil_lost", "critical")


def test_a_longer_patience_with_the_loop() -> None:
    assert judge_hil(replace(LOOP, to_board_age_s=0.6, unanswered_s=0.6), 0.7) is None


def test_the_card_is_judged_by_what_the_board_tells_of_it() -> None:
    assert judge_card({}) is None
    assert judge_card({"has_store": True, "has_card_alarm": False}) is None
    found = judge_card({"has_store": True, "has_card_alarm": True})
    assert found is not None
    assert (found.id, found.level) == ("card_failed", "critical")


def test_parameters_and_recording() -> None:
    assert judge_parameters(()) is None
    found = judge_parameters(("k_pitch", "k_roll"))
    assert found is not None
    assert (found.id, found.level) == ("parameter_not_confirmed", "warning")
    assert found.params == {"names": "k_pitch, k_roll"}
    assert judge_recording(None) is None
    failed = judge_recording("no space")
    assert failed is not None
    assert (failed.id, failed.level, failed.params) == ("recorder_failed", "critical", {"reason": "no space"})


def test_the_share_of_damage_is_of_both_counts_since_ten_seconds_ago() -> None:
    judge = DamageJudge(0.0)
    judge.look(1.0, 1000, 0, 5.0)
    judge.look(11.5, 2000, 40, 5.0)
    assert judge.look(12.0, 2060, 40, 5.0) is None
    assert judge.percent == 0.0
    judge.look(13.0, 2090, 50, 5.0)
    assert judge.percent == pytest.approx(10.0), "90 good and 10 damaged ones since the first that counts"


def test_what_was_said_of_the_gps_is_said_on_from_a_kept_state() -> None:
    judge = GpsJudge()
    judge.look(0, NO_FIX, is_wanted=True)
    said = judge.look(1, NO_FIX, is_wanted=True)
    again = GpsJudge()
    again.restore(judge.kept())
    assert said is not None
    assert again.look(1.5, None, is_wanted=True) == said
    assert GpsJudge().kept()[1] is None


def test_a_stick_whose_gamepad_is_silent_is_critical_while_it_flies_and_a_warning_while_it_does_not() -> None:
    assert judge_stick(None, None, flies=True) is None
    assert judge_stick("Pad", "live", flies=True) is None
    for flies, level in ((True, "critical"), (False, "warning")):
        found = judge_stick("Pad", "lost", flies=flies)
        assert found is not None
        assert (found.id, found.level, found.params) == ("stick_lost", level, {"gamepad": "Pad"})


def test_the_processor_says_the_high_load_also_while_it_rests_for_a_moment() -> None:
    judge = CpuJudge()
    for now_s in (0, 3):
        judge.look(now_s, {"sensor_dsc_percent": 97}, 90)
    found = judge.look(4, {"sensor_dsc_percent": 20}, 90)
    assert found is not None
    assert found.params == {"percent": 97}
    assert "97 % busy" in found.text


def test_a_kept_state_goes_on_with_what_was_said_and_since_when_nothing_is_known() -> None:
    battery_judge, again = BatteryJudge(), BatteryJudge()
    battery(battery_judge, (0, 9.0), (3, 9.0), (4, 11.0))
    again.restore(battery_judge.kept())
    found = again.look(5, {"battery_v": 11.0}, BATTERY)
    assert found is not None
    assert found.params == {"battery_v": 9.0, "limit_v": 10.5}
    assert again.look(6, None, BATTERY) is not None
    battery_judge.restore(again.kept())
    assert battery_judge.look(7, None, BATTERY) is None, "unknown for a second, of which most was before"
    cpu, cpu_again = CpuJudge(), CpuJudge()
    for now_s in (0, 3):
        cpu.look(now_s, {"sensor_dsc_percent": 97}, 90)
    cpu_again.restore(cpu.kept())
    busy = cpu_again.look(4, {"sensor_dsc_percent": 20}, 90)
    assert busy is not None
    assert busy.params == {"percent": 97}


def test_a_gps_that_had_a_position_before_a_kept_state_is_critical_after_it() -> None:
    judge, again = GpsJudge(), GpsJudge()
    judge.look(0, VALID, is_wanted=True)
    again.restore(judge.kept())
    again.look(1, NO_FIX, is_wanted=True)
    found = again.look(2, NO_FIX, is_wanted=True)
    assert found is not None
    assert found.level == "critical"


def test_the_window_of_damage_goes_on_from_a_kept_state() -> None:
    judge, again = DamageJudge(0.0), DamageJudge(99.0)
    judge.look(1, 1000, 0, 1.0)
    judge.look(8, 1090, 10, 1.0)
    again.restore(judge.kept())
    assert again.percent == judge.percent
    found = again.look(11, 1090, 10, 1.0)
    assert found is not None
    assert found.params == {"percent": 10.0}, "of the hundred frames since the first that counts"
    assert again.look(18.5, 1090, 10, 1.0) is None


def test_a_line_that_floods_is_a_warning_while_its_reading_is_paused_and_a_new_link_starts_anew() -> None:
    judge = FloodJudge()
    assert judge.look(0.0, 0, 320_000.0) is None
    found = judge.look(1.0, 3, 320_000.0)
    assert found is not None
    assert (found.id, found.params) == ("line_floods", {"kb_per_s": 320})
    assert judge.look(1.5, 3, 320_000.0) is not None
    assert judge.look(2.5, 3, 320_000.0) is None
    assert judge.look(3.0, 0, 320_000.0) is None
    assert judge.look(3.1, 1, 320_000.0) is not None
