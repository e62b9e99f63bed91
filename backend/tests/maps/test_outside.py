"""Which addresses are the internet's, and how the others are reached with somebody's consent."""

from __future__ import annotations

import pytest

from epf_gcs.maps.outside import Consent, is_local_as_written, is_outside


@pytest.mark.parametrize("number", ["1.1.1.1", "193.110.128.199", "2606:4700::1111", "64:ff9b::101:101"])
def test_these_are_outside(number: str) -> None:
    assert is_outside(number)


@pytest.mark.parametrize(
    "number",
    [
        "127.0.0.1",
        "0.0.0.0",  # noqa: S104
        "10.1.2.3",
        "172.16.0.1",
        "192.168.0.1",
        "169.254.169.254",
        "100.64.0.1",
        "224.0.0.251",
        "239.1.1.1",
        "255.255.255.255",
        "240.0.0.1",
        "::",
        "::1",
        "fe80::1%eth0",
        "fec0::1",
        "fd12::1",
        "ff02::1",
        "ff0e::1",
        "::ffff:10.0.0.1",
        "::7f00:1",
        "64:ff9b::a00:1",
        "2002:7f00:1::",
        "2002:c0a8:101::1",
    ],
)
def test_these_are_inside(number: str) -> None:
    assert not is_outside(number)


def test_a_name_on_the_internet_is_not_known_before_it_is_asked_for() -> None:
    assert not is_local_as_written("tile.openstreetmap.org")
    assert not is_local_as_written("1.1.1.1")


def test_consent_is_for_a_server_or_for_one_of_its_ports() -> None:
    consent = Consent(["Tiles.lan", "10.0.0.5:8080", "[::1]:80"])
    assert consent.covers("http", "tiles.lan", 9999)
    assert consent.covers("http", "10.0.0.5", 8080)
    assert not consent.covers("http", "10.0.0.5", 22)
    assert not consent.covers("http", "10.0.0.6", 8080)
    assert consent.covers("http", "::1", None)
    assert not consent.covers("https", "::1", None)
