"""X-Plane's beacon, as its manual describes it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.xplane.beacon import parse_beacon
from tests.support.x_plane import beacon


@pytest.mark.parametrize(
    ("version", "profile", "text"),
    [(104103, "xp10", "10.41"), (115502, "xp10", "11.55"), (120012, "xp12", "12.00"), (121405, "xp12", "12.14")],
)
@pytest.mark.parametrize("minor", [1, 2])
def test_an_x_plane_says_its_name_its_port_and_how_its_rows_are_read(
    version: int, profile: str, text: str, minor: int
) -> None:
    heard = parse_beacon(beacon(version, 49000, "sim-pc", minor=minor))
    assert heard is not None
    assert (heard.name, heard.port, heard.profile, heard.version_text) == ("sim-pc", 49000, profile, text)


@pytest.mark.parametrize(
    "datagram",
    [
        beacon(120012, 49000, program=2),
        beacon(120012, 49000, role=2),
        beacon(0, 49000),
        beacon(120012, 0),
        beacon(120012, 49000)[:20],
        b"BECN",
        b"DATA\0",
    ],
    ids=["Plane-Maker", "a second screen", "no version", "no port", "cut", "shorter", "rows"],
)
def test_what_does_not_fly_is_no_beacon(datagram: bytes) -> None:
    assert parse_beacon(datagram) is None


def test_a_stranger_s_name_is_shown_as_letters_and_short() -> None:
    heard = parse_beacon(beacon(120012, 49000, "\x1b[31mred\n" + 200 * "x"))
    assert heard is not None
    assert heard.name.startswith("[31mred")
    assert len(heard.name) <= 64


@given(st.binary(max_size=64))
def test_no_bytes_raise(tail: bytes) -> None:
    parse_beacon(b"BECN\0" + tail)
