"""Certificates that browsers take for the names they should, and for no others."""

from __future__ import annotations

import ssl
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from cryptography import x509

from epf_gcs.tls import certificates
from epf_gcs.tls.certificates import (
    EARLIEST,
    RENEW_DAYS,
    STATION_DAYS,
    Pair,
    authority_serves,
    fingerprint_of,
    make_authority,
    make_station,
    names_of,
    read_pair,
    station_serves,
    wanted_names,
)
from epf_gcs.tls.context import make_context
from epf_gcs.tls.identity import Identity, identity_of
from tests.support.tls import shake_hands, trusting

NOW = datetime.now(UTC)
HOME = identity_of("Müller", ["club.example"], ["192.168.1.20", "fd00::2"])


@pytest.fixture(scope="module")
def authority() -> Pair:
    return make_authority(HOME, NOW)


def verify(folder: Path, authority: Pair, station: Pair, name: str) -> None:
    """A browser that trusts the authority opens this name. Raises ssl.SSLError if it does not take the certificate."""
    (folder / "authority.crt").write_bytes(authority.certificate_pem())
    (folder / "station.pem").write_bytes(station.pem())
    server = make_context(folder / "station.pem", folder / "station.pem")
    shake_hands(trusting(folder / "authority.crt"), server, name)


@pytest.mark.parametrize(
    "name", ["müller.local", "müller", "localhost", "club.example", "127.0.0.1", "192.168.1.20", "::1", "fd00::2"]
)
def test_a_browser_takes_it_for_every_name_and_address(tmp_path: Path, authority: Pair, name: str) -> None:
    verify(tmp_path, authority, make_station(authority, HOME, NOW), name)


@pytest.mark.parametrize("name", ["evil.example", "192.168.1.21", "fd00::3", "xn--mller-kva.example"])
def test_and_for_no_other(tmp_path: Path, authority: Pair, name: str) -> None:
    with pytest.raises(ssl.SSLCertVerificationError, match="mismatch"):
        verify(tmp_path, authority, make_station(authority, HOME, NOW), name)


def test_a_thief_of_the_authority_can_pose_as_no_site_of_the_internet(
    tmp_path: Path, authority: Pair, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A thief signs whatever name they like.
    monkeypatch.setattr(certificates, "wanted_names", lambda _authority, identity: list(identity.chosen))
    mine = make_station(authority, Identity(HOME.own, ("club.example",), ()), NOW)
    verify(tmp_path, authority, mine, "club.example")
    forged = make_station(authority, Identity(HOME.own, ("bank.example",), ()), NOW)
    with pytest.raises(ssl.SSLCertVerificationError, match="permitted subtree violation"):
        verify(tmp_path, authority, forged, "bank.example")


def test_nor_can_the_stations_own_certificate_sign_another(authority: Pair) -> None:
    station = make_station(authority, HOME, NOW).certificate
    assert not station.extensions.get_extension_for_class(x509.BasicConstraints).value.ca
    limits = authority.certificate.extensions.get_extension_for_class(x509.BasicConstraints)
    assert (limits.value.path_length, limits.critical) == (0, True)


def test_a_new_address_needs_a_new_certificate_and_one_that_went_away_does_not(authority: Pair) -> None:
    station = make_station(authority, HOME, NOW).certificate
    field = identity_of("Müller", ["club.example"], ["10.42.0.1"])
    less = identity_of("Müller", ["club.example"], ["192.168.1.20"])
    assert station_serves(station, authority.certificate, HOME, NOW)
    assert station_serves(station, authority.certificate, less, NOW)
    assert not station_serves(station, authority.certificate, field, NOW)


def test_it_is_renewed_before_its_end_and_after_a_clock_that_was_wrong(authority: Pair) -> None:
    station = make_station(authority, HOME, NOW).certificate

    def serves(days: float) -> bool:
        return station_serves(station, authority.certificate, HOME, NOW + timedelta(days=days))

    assert serves(STATION_DAYS - RENEW_DAYS - 1)
    assert not serves(STATION_DAYS - RENEW_DAYS + 1)
    assert not serves(-2)


def test_another_authoritys_certificate_does_not_do(authority: Pair) -> None:
    other = make_authority(HOME, NOW)
    station = make_station(other, HOME, NOW).certificate
    assert not station_serves(station, authority.certificate, HOME, NOW)


def test_the_authority_lasts_longer_than_what_it_signs_and_is_asked_for_chosen_names_alone(authority: Pair) -> None:
    last = authority.certificate.not_valid_after_utc
    assert authority_serves(authority.certificate, HOME, last - timedelta(days=STATION_DAYS + 1))
    assert not authority_serves(authority.certificate, HOME, last - timedelta(days=STATION_DAYS - 1))
    renamed = identity_of("other", ["club.example"], [])
    assert authority_serves(authority.certificate, renamed, NOW), "phones need not trust again for the machine's name"
    assert wanted_names(authority.certificate, renamed) == ["other.local", "localhost", "club.example"]
    assert names_of(make_station(authority, renamed, NOW).certificate) == ["other.local", "localhost", "club.example"]
    assert not authority_serves(authority.certificate, identity_of("Müller", ["new.example"], []), NOW)


def test_a_clock_that_was_never_set_makes_certificates_of_the_present() -> None:
    unset = datetime(1970, 1, 1, tzinfo=UTC)
    made = make_authority(HOME, unset)
    station = make_station(made, HOME, unset).certificate
    assert station.not_valid_after_utc == EARLIEST + timedelta(days=STATION_DAYS)
    assert station_serves(station, made.certificate, HOME, unset)
    assert authority_serves(made.certificate, HOME, unset)


def test_key_and_certificate_of_one_file_belong_together(authority: Pair) -> None:
    read = read_pair(authority.pem())
    assert read.certificate == authority.certificate
    other = make_authority(HOME, NOW)
    for damaged in (
        b"",
        authority.certificate_pem(),
        authority.pem()[:300],
        Pair(other.certificate, authority.key).pem(),
    ):
        with pytest.raises(ValueError, match="key"):
            read_pair(damaged)


def test_a_fingerprint_is_written_as_browsers_show_it(authority: Pair) -> None:
    shown = fingerprint_of(authority.certificate)
    assert len(shown.split(":")) == 32
    assert shown == shown.upper()
