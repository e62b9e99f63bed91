"""Starts and wind."""

import math

import pytest

from epf_gcs.simulator.situation import (
    FINAL_ALTITUDE_FT,
    RUNWAY_HEADING_DEG,
    Situation,
    Start,
    Wind,
    parse_wind,
)


def test_wind_is_read_as_direction_it_comes_from_and_speed() -> None:
    assert parse_wind("330/20") == Wind(330.0, 20.0)
    north, east = parse_wind("90/10").towards_ft_s()
    assert north == pytest.approx(0.0, abs=1e-9)
    assert east == pytest.approx(-16.878, abs=0.001)


@pytest.mark.parametrize("text", ["", "330", "330/", "/20", "330/fast", "330/-1", "nan/5", "330/inf", "1/2/3"])
def test_wind_that_cannot_be_read_is_refused_with_its_text(text: str) -> None:
    with pytest.raises(ValueError, match="as in 330/20") as caught:
        parse_wind(text)
    assert repr(text) in str(caught.value)


def test_final_is_1500_m_short_of_the_place_on_a_three_degree_path() -> None:
    there = Situation(start=Start.RUNWAY).place()
    here = Situation(start=Start.FINAL).place()
    north_m = (there[0] - here[0]) * 111_132.0
    east_m = (there[1] - here[1]) * 111_132.0 * math.cos(math.radians(there[0]))
    assert math.hypot(north_m, east_m) == pytest.approx(1500.0, rel=1e-3)
    assert math.degrees(math.atan2(east_m, north_m)) == pytest.approx(RUNWAY_HEADING_DEG, abs=0.05)
    assert pytest.approx(78.0 + 1500.0 / 0.3048 * math.tan(math.radians(3.0))) == FINAL_ALTITUDE_FT
