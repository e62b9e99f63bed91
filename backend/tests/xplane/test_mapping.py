"""Rows in our names, units and axes, for both generations of the simulator."""

from __future__ import annotations

import math
from typing import Any

import pytest

from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.messages_gen import COMMANDS, XPLANE_ROWS
from epf_gcs.codec.values import single
from epf_gcs.xplane.datagram import Surfaces, parse
from epf_gcs.xplane.mapping import (
    INFO_SOURCES,
    NEEDED_ROWS,
    XplaneInfo,
    info_from_rows,
    row_meaning,
    surfaces_from_servos_in,
)
from tests.codec.vectors import load

VECTORS = [vector for vector in load("simulator.jsonl") if "datagram_in_hex" in vector and not vector.get("dropped")]
NONE = -999.0


def _info(datagram: bytes, profile: str = "xp10") -> XplaneInfo | None:
    records = parse(datagram)
    assert records is not None
    return info_from_rows({record.row: row_meaning(record.row, record.values, profile).values for record in records})


@pytest.mark.parametrize("vector", VECTORS, ids=lambda vector: vector["case"])
def test_captured_datagrams_become_the_captured_command(vector: dict[str, Any]) -> None:
    info = _info(bytes.fromhex(vector["datagram_in_hex"]))
    if not vector["board_out_hex"]:
        assert info is None
        return
    assert info is not None
    assert info._asdict() == {name: single(value) for name, value in vector["xplane_info"].items()}
    assert encode_command("xplane_info", *info).hex() == vector["board_out_hex"]


def test_the_fields_are_those_of_the_command_in_its_order() -> None:
    names = [value.name for value in COMMANDS["xplane_info"].values]
    assert list(XplaneInfo._fields) == names
    assert list(INFO_SOURCES) == names
    assert sorted(NEEDED_ROWS) == [3, 4, 8, 16, 17, 20, 25]


def test_every_source_is_a_value_of_its_row_in_every_profile() -> None:
    for profile in XPLANE_ROWS:
        for row, name in INFO_SOURCES.values():
            assert name in row_meaning(row, (0.0,) * 8, profile).values


def test_angular_rates_of_the_newer_simulator_are_p_q_r_in_degrees() -> None:
    old, _ = row_meaning(16, (0.2, 0.1, 0.3, *[NONE] * 5), "xp10")
    new, _ = row_meaning(16, (*(math.degrees(rate) for rate in (0.1, 0.2, 0.3)), *[NONE] * 5), "xp12")
    assert old == {"p_rad_s": 0.1, "q_rad_s": 0.2, "r_rad_s": 0.3}
    assert new == pytest.approx(old)


def test_no_value_is_no_data_and_no_fault() -> None:
    values, implausible = row_meaning(17, (NONE, 5.0, NONE, *[NONE] * 5), "xp10")
    assert values == {"pitch_deg": None, "roll_deg": 5.0, "true_heading_deg": None}
    assert implausible == ()


def test_what_is_not_plausible_is_no_data_and_is_named() -> None:
    values, implausible = row_meaning(20, (math.nan, 181.0, math.inf, 0, 0, 100.0, 0, 0), "xp10")
    assert values == {
        "latitude_deg": None,
        "longitude_deg": None,
        "altitude_msl_ft": None,
        "altitude_indicated_ft": 100.0,
    }
    assert implausible == ("latitude_deg", "longitude_deg", "altitude_msl_ft")


def test_a_stick_beyond_its_end_is_at_its_end() -> None:
    values, implausible = row_meaning(8, (1.02, -1.5, math.nan, *[NONE] * 5), "xp10")
    assert values == {"stick_elevator": 1.0, "stick_aileron": -1.0, "stick_rudder": None}
    assert implausible == ("stick_rudder",)
    assert row_meaning(25, (-0.3, *[NONE] * 7), "xp10").values == {"throttle_command": 0.0}


def test_an_unknown_row_has_no_values() -> None:
    assert row_meaning(1, (1.0,) * 8, "xp10") == ({}, ())


def test_the_track_wins_over_the_heading() -> None:
    rows = {row: row_meaning(row, (0.5,) * 8, "xp10").values for row in NEEDED_ROWS}
    without = info_from_rows(rows)
    with_track = info_from_rows({18: row_meaning(18, (1.0, 2.0, 123.0, 4.0, *[NONE] * 4), "xp10").values, **rows})
    assert without is not None
    assert with_track is not None
    assert (without.yaw_deg, with_track.yaw_deg) == (0.5, 123.0)
    assert with_track.stick == Surfaces(0.5, 0.5, 0.5, 0.5)


def test_the_receivers_channels_have_throttle_before_rudder() -> None:
    assert surfaces_from_servos_in([0.1, 0.2, 0.3, 0.4] + [0.0] * 8) == Surfaces(0.2, 0.1, 0.4, 0.3)


def test_what_is_at_its_limit_is_plausible() -> None:
    values, implausible = row_meaning(20, (-90.0, 180.0, 0, 0, 0, 0, 0, 0), "xp10")
    assert (values["latitude_deg"], values["longitude_deg"]) == (-90.0, 180.0)
    assert implausible == ()


def test_surfaces_beyond_their_ends_are_at_their_ends_too() -> None:
    values, implausible = row_meaning(11, (1.5, -1.5, 0.5, *[NONE] * 5), "xp10")
    assert list(values.values()) == [1.0, -1.0, 0.5]
    assert implausible == ()


def test_the_track_stands_in_for_a_heading_without_a_value_and_the_heading_for_the_track() -> None:
    rows: dict[int, dict[str, float | None]] = {
        row: row_meaning(row, (0.5,) * 8, "xp10").values for row in (*NEEDED_ROWS, 18)
    }
    without_track = info_from_rows({**rows, 18: row_meaning(18, (NONE,) * 8, "xp10").values})
    without_heading = info_from_rows({**rows, 17: {**rows[17], "true_heading_deg": None}})
    assert without_track == without_heading == info_from_rows(rows)
    assert info_from_rows({**rows, 17: {**rows[17], "roll_deg": None}}) is None
