"""The alarms that a board's bytes tell: judged only by what is live, and gone on with after a jump in a replay."""

from __future__ import annotations

import math

import pytest

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.error_log import ErrorLog
from epf_gcs.vehicle.judges import Line, Loop
from epf_gcs.vehicle.thresholds import chosen
from epf_gcs.vehicle.vehicle import Vehicle
from epf_gcs.vehicle.watch import VehicleWatch
from tests.support.outlet import KeptOutlet

NAN = math.nan
GPS = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, ord("8"), ord("3"), ord("A"))
MANY = encode_telemetry("gps", 27.9, -15.4, 30.0, 0.0, 0.0, 0x3132, ord("3"), ord("A"))
EMPTY = encode_telemetry("analog", 1013.0, 10.0, NAN, NAN, NAN, NAN, NAN, 20.0, 9.04, NAN)
FULL = encode_telemetry("analog", 1013.0, 10.0, NAN, NAN, NAN, NAN, NAN, 20.0, 12.0, NAN)
BUSY = encode_telemetry("statistics", 99, 20)


def heartbeat(*, gps: bool) -> bytes:
    return encode_telemetry("heartbeat", 1, 1, 1, 1, int(gps), 1, 1, 1, 1, 1, 0, 0)


class Told:
    """A board whose bytes come ten times a second, and its watch."""

    def __init__(self) -> None:
        self.at_s = 1000.0
        self.limits: dict[str, float] = {}
        self.vehicle = Vehicle(self, KeptOutlet(), ErrorLog(), lambda _: 0.1)
        self.watch = VehicleWatch(self.vehicle.board, self.vehicle.telemetry, self.at_s)

    def now_s(self) -> float:
        return self.at_s

    def steady_s(self) -> float:
        return self.at_s

    def after(self, seconds: float, *frames: bytes, wants_gps: bool = False) -> dict[str, object]:
        """What is wrong after these frames came again and again for so long: the findings' names and values."""
        found: dict[str, object] = {}
        for _ in range(round(seconds * 10)):
            self.at_s += 0.1
            self.vehicle.board.on_bytes(b"".join(frames))
            told = self.watch.look(self.at_s, chosen(self.limits), None, None, wants_gps=wants_gps)
            found = {finding.id: finding.params for finding in told}
        return found


def test_a_position_that_was_switched_off_is_not_lost_and_one_that_is_on_or_wanted_is() -> None:
    told = Told()
    assert told.after(2.0, heartbeat(gps=True), GPS) == {}
    assert told.after(3.0, heartbeat(gps=False)) == {}
    assert told.after(3.0, heartbeat(gps=False), wants_gps=True) == {"gps_lost": {"reason": "silent"}}
    assert told.after(3.0, heartbeat(gps=False)) == {}
    assert told.after(3.0, heartbeat(gps=True)) == {"gps_lost": {"reason": "silent"}}


def test_of_a_silent_board_no_receiver_is_blamed() -> None:
    told = Told()
    told.after(2.0, heartbeat(gps=True), GPS)
    assert told.after(5.0, wants_gps=True) == {}


def test_once_no_board_was_wanted_nobody_waits_for_its_position() -> None:
    told = Told()
    told.after(2.0, heartbeat(gps=True), GPS)
    told.watch.forget_gps()
    told.at_s += 10.0
    assert told.after(3.0, heartbeat(gps=True)) == {}


@pytest.mark.parametrize(
    ("bad", "good", "found"),
    [
        (EMPTY, FULL, {"battery_low": {"battery_v": 9.0, "limit_v": 10.5, "cells": 3}}),
        (BUSY, encode_telemetry("statistics", 20, 20), {"cpu_high": {"percent": 99}}),
    ],
)
def test_what_lasts_three_seconds_is_an_alarm_for_as_long_as_it_is_live(
    bad: bytes, good: bytes, found: dict[str, object]
) -> None:
    told = Told()
    assert told.after(2.0, heartbeat(gps=False), good) == {}
    assert told.after(2.9, heartbeat(gps=False), bad) == {}
    assert told.after(0.3, heartbeat(gps=False), bad) == found
    assert told.after(3.5, heartbeat(gps=False), good) == {}
    assert told.after(3.5, heartbeat(gps=False), bad) == found
    assert told.after(2.0, heartbeat(gps=False)) == {}, "what is not live says nothing"


def test_damaged_frames_are_an_alarm_and_their_share_is_known() -> None:
    told = Told()
    assert told.watch.damaged_percent == 0.0
    damaged = bytearray(GPS)
    damaged[-9] ^= 1
    found = told.after(5.0, heartbeat(gps=True), GPS, GPS, bytes(damaged))
    assert told.watch.damaged_percent == pytest.approx(25.0, abs=1.0)
    assert set(found) == {"frames_damaged"}


def test_a_watch_that_was_kept_goes_on_with_what_is_wrong_and_how_long() -> None:
    told = Told()
    damaged = bytearray(GPS)
    damaged[-9] ^= 1
    told.after(2.0, heartbeat(gps=True), GPS, FULL)
    told.after(2.9, heartbeat(gps=True), bytes(damaged), EMPTY, BUSY)
    again = Told()
    again.at_s = told.at_s
    again.vehicle.restore(told.vehicle.kept())
    again.watch.restore(told.watch.kept())
    assert again.watch.damaged_percent == told.watch.damaged_percent > 0
    for one in (told, again):
        found = one.after(0.3, heartbeat(gps=True), EMPTY, BUSY)
        assert set(found) == {"gps_lost", "battery_low", "cpu_high", "frames_damaged"}


def test_heartbeat_and_loop_have_each_their_own_patience() -> None:
    told = Told()
    line = Line("/dev/ttyUSB0", 100.0, False, True, 2.0, None, None)
    loop = Loop(2.0, 2.0, True, True, ())
    for heartbeat_s, hil_s, found in (
        (1.0, 1.0, ["heartbeat_lost", "hil_lost"]),
        (3.0, 1.0, ["hil_lost"]),
        (1.0, 3.0, ["heartbeat_lost"]),
    ):
        limits = {**chosen({}), "heartbeat_lost_s": heartbeat_s, "hil_lost_s": hil_s}
        seen = told.watch.look(told.at_s, limits, line, loop, wants_gps=False)
        assert [one.id for one in seen] == found, "the most urgent is first"


def analog(*, altitude_m: float = 10.0, airspeed_kt: float = NAN, battery_v: float = NAN) -> bytes:
    return encode_telemetry("analog", 1013.0, altitude_m, NAN, NAN, airspeed_kt, NAN, NAN, 20.0, battery_v, NAN)


@pytest.mark.parametrize(("full_v", "low_v", "cells"), [(12.5, 10.4, 3), (25.1, 20.9, 6), (41.0, 34.9, 10)])
def test_a_battery_is_low_by_the_cells_that_its_voltage_tells(full_v: float, low_v: float, cells: int) -> None:
    told = Told()
    assert told.after(5.0, heartbeat(gps=False), analog(battery_v=full_v)) == {}
    assert told.after(5.0, heartbeat(gps=False), analog(battery_v=low_v + 0.2)) == {}
    low = told.after(5.0, heartbeat(gps=False), analog(battery_v=low_v))
    assert low == {"battery_low": {"battery_v": low_v, "limit_v": 3.5 * cells, "cells": cells}}
    pack = told.watch.battery.pack(chosen({}))
    assert pack is not None
    assert (pack.cells, pack.is_guessed, pack.low_v) == (cells, True, 3.5 * cells)


def test_what_the_operator_says_of_the_battery_counts_and_not_the_guess() -> None:
    told = Told()
    told.limits = {"battery_cells": 11.0}
    frames = heartbeat(gps=False), analog(battery_v=38.0)
    assert told.after(5.0, *frames)["battery_low"] == {"battery_v": 38.0, "limit_v": 38.5, "cells": 11}
    told.limits = {"battery_cells": 11.0, "battery_low_v": 39.0}
    assert told.after(5.0, *frames)["battery_low"] == {"battery_v": 38.0, "limit_v": 39.0}
    told.limits = {"battery_low_v": 37.0}
    assert told.after(5.0, *frames) == {}


@pytest.mark.parametrize(
    ("limit", "bad", "good", "found"),
    [
        ({"altitude_high_ft": 400.0}, analog(altitude_m=130.0), analog(altitude_m=100.0), "altitude_high"),
        ({"airspeed_high_kt": 60.0}, analog(airspeed_kt=61.0), analog(airspeed_kt=59.0), "airspeed_high"),
        ({"satellites_few": 9.0}, GPS, MANY, "satellites_few"),
    ],
)
def test_a_limit_that_was_set_is_an_alarm_beyond_it_and_none_without_it(
    limit: dict[str, float], bad: bytes, good: bytes, found: str
) -> None:
    told = Told()
    assert told.after(5.0, heartbeat(gps=False), bad) == {}
    told.limits = limit
    assert list(told.after(5.0, heartbeat(gps=False), bad)) == [found]
    assert told.after(5.0, heartbeat(gps=False), good) == {}
    told.limits = {}
    assert told.after(0.2, heartbeat(gps=False), bad) == {}


def test_the_least_airspeed_counts_only_in_flight() -> None:
    told = Told()
    told.limits = {"airspeed_low_kt": 30.0}
    at = {speed: analog(airspeed_kt=speed) for speed in (5.0, 25.0, 40.0)}
    assert told.after(5.0, heartbeat(gps=False), at[5.0]) == {}, "before take-off"
    assert told.after(5.0, heartbeat(gps=False), at[40.0]) == {}
    assert told.after(5.0, heartbeat(gps=False), at[25.0]) == {"airspeed_low": {"value": 25, "limit": 30}}
    assert told.after(5.0, heartbeat(gps=False), at[5.0]) == {}, "landed"


def test_the_distance_counts_from_the_first_valid_position() -> None:
    told = Told()
    told.limits = {"distance_far_m": 1000.0}
    away = encode_telemetry("gps", 27.92, -15.4, 30.0, 0.0, 0.0, ord("8"), ord("3"), ord("A"))
    void = encode_telemetry("gps", 0.0, 0.0, 0.0, 0.0, 0.0, ord("0"), ord("0"), ord("V"))
    told.after(2.0, heartbeat(gps=True), void)
    assert told.after(2.0, heartbeat(gps=True), GPS) == {}
    found = told.after(5.0, heartbeat(gps=True), away)["distance_far"]
    assert found == {"value": pytest.approx(2224, abs=3), "limit": 1000}


def test_channels_that_the_board_does_not_hear_any_more_are_a_lost_receiver() -> None:
    told = Told()
    servos = encode_telemetry("servos_in", *[0.0] * 12)
    assert told.after(5.0, heartbeat(gps=False)) == {}, "a receiver that was never heard may not be there"
    assert told.after(2.0, heartbeat(gps=False), servos) == {}
    unheard = encode_telemetry("servos_in", *[NAN] * 12)
    assert told.after(5.0, heartbeat(gps=False), unheard) == {"receiver_lost": {}}
    assert told.after(5.0, heartbeat(gps=False), servos) == {}
    assert told.after(5.0, heartbeat(gps=False)) == {}, "a stream that is off tells nothing"
