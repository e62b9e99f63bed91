"""The ten rows, value by value where the wire's description says them."""

import math

import pytest

from epf_gcs.codec.messages_gen import XPLANE_ROWS
from epf_gcs.simulator.rows import RowWriter
from epf_gcs.simulator.state import Controls, FlightState
from epf_gcs.xplane.datagram import build, parse

# Every quantity is a number of its own, so that no two can be mistaken for each other.
STATE = FlightState(
    latitude_deg=101.0,
    longitude_deg=102.0,
    altitude_ft=103.0,
    altitude_agl_ft=104.0,
    altitude_indicated_ft=105.0,
    roll_deg=106.0,
    pitch_deg=107.0,
    heading_deg=108.0,
    p_rad_s=109.0,
    q_rad_s=110.0,
    r_rad_s=111.0,
    airspeed_indicated_kt=112.0,
    airspeed_true_kt=113.0,
    speed_ground_kt=114.0,
    mach=115.0,
    vvi_ft_min=116.0,
    load_normal_g=117.0,
    load_axial_g=118.0,
    load_side_g=119.0,
    alpha_deg=120.0,
    beta_deg=121.0,
    track_deg=122.0,
    path_deg=123.0,
    pressure_inhg=124.0,
    temperature_degc=125.0,
    on_ground=False,
    touching=None,
    surfaces=Controls(0.1, -0.2, 0.3, 0.4),
)
STICK = Controls(-0.5, 0.6, -0.7, 0.8)


def rows(profile: str) -> dict[int, tuple[float, ...]]:
    return {record.row: record.values for record in RowWriter(profile).rows(STATE, STICK)}


def test_the_ten_rows_are_sent_in_ascending_order() -> None:
    assert list(rows("xp10")) == [3, 4, 6, 8, 11, 16, 17, 18, 20, 25]


def test_each_value_stands_where_x_plane_10_has_it() -> None:
    s = STATE
    none = -999.0
    assert rows("xp10") == {
        3: (s.airspeed_indicated_kt, none, none, s.speed_ground_kt, none, none, none, none),
        4: (s.mach, none, s.vvi_ft_min, none, s.load_normal_g, s.load_axial_g, s.load_side_g, none),
        6: (s.pressure_inhg, s.temperature_degc, none, none, none, none, none, none),
        8: (-0.5, 0.6, -0.7, none, none, none, none, none),
        11: (0.1, -0.2, 0.3, none, none, none, none, none),
        16: (s.q_rad_s, s.p_rad_s, s.r_rad_s, none, none, none, none, none),
        17: (s.pitch_deg, s.roll_deg, s.heading_deg, none, none, none, none, none),
        18: (s.alpha_deg, s.beta_deg, s.track_deg, s.path_deg, none, none, none, none),
        20: (s.latitude_deg, s.longitude_deg, s.altitude_ft, none, none, s.altitude_indicated_ft, none, none),
        25: (0.8, none, none, none, none, none, none, none),
    }


def test_x_plane_12_differs_in_row_16_only_which_is_p_q_r_in_degrees() -> None:
    old, new = rows("xp10"), rows("xp12")
    expected = [math.degrees(rate) for rate in (STATE.p_rad_s, STATE.q_rad_s, STATE.r_rad_s)]
    assert new[16][:3] == pytest.approx(expected)
    assert {number for number in old if old[number] != new[number]} == {16}


@pytest.mark.parametrize("profile", list(XPLANE_ROWS))
def test_all_rows_in_one_datagram_are_365_bytes_with_the_tag_at_sign(profile: str) -> None:
    datagram = build(RowWriter(profile).rows(STATE, STICK))
    assert len(datagram) == 365
    assert datagram[:5] == b"DATA@"
    assert [record.row for record in parse(datagram) or []] == list(rows(profile))
