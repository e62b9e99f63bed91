"""A certificate that the user brings: what is wrong with it is said in a sentence that says what to do."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric import ec

from epf_gcs.errors import GatewayError
from epf_gcs.tls.brought import GivenCertificate
from epf_gcs.tls.keeper import Keeper
from tests.support.tls import private_pem, self_signed

NOW = datetime.now(UTC)


def fault(certificate: Path, key: Path) -> GatewayError:
    with pytest.raises(GatewayError) as caught:
        Keeper(GivenCertificate(certificate, key))
    return caught.value


def test_certificate_and_key_that_belong_together_are_used(tmp_path: Path) -> None:
    for kind in ("ec", "2048"):
        certificate, key = self_signed(tmp_path, kind=kind)
        keeper = Keeper(GivenCertificate(certificate, key))
        assert (keeper.in_use.kind, keeper.in_use.names) == ("brought", ["station.example"])
        assert keeper.in_use.authority_der() is None
        assert keeper.fault is None


def test_both_may_be_in_one_file(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    both = tmp_path / "both.pem"
    both.write_bytes(certificate.read_bytes() + key.read_bytes())
    assert Keeper(GivenCertificate(both, both)).in_use.names == ["station.example"]


def test_a_file_that_is_not_there_or_no_file_is_named_with_its_option(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    missing = tmp_path / "missing"
    found = fault(missing, key)
    assert found.code == "tls_file_unreadable"
    assert found.detail.startswith(f"{missing} cannot be read (No such file or directory)")
    assert found.detail.endswith("--tls-cert.")
    found = fault(certificate, tmp_path)
    assert found.code == "tls_file_unreadable"
    assert "Is a directory" in found.detail
    assert found.detail.endswith("--tls-key.")


def test_files_that_hold_something_else_are_told(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    assert fault(key, key).code == "tls_no_certificate"
    assert fault(certificate, certificate).code == "tls_no_key"
    other = tmp_path / "other"
    for content in (b"", b"-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n", bytes(range(256))):
        other.write_bytes(content)
        assert fault(other, key).code == "tls_no_certificate"
        assert fault(certificate, other).code == "tls_no_key"


def test_another_certificates_key_is_told(tmp_path: Path) -> None:
    certificate, _ = self_signed(tmp_path)
    _, key = self_signed(tmp_path, name="other")
    found = fault(certificate, key)
    assert found.code == "tls_key_differs"
    assert str(key) in found.detail
    assert str(certificate) in found.detail


def test_a_key_with_a_password_is_told(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    key.write_bytes(private_pem(ec.generate_private_key(ec.SECP256R1()), b"secret"))
    assert fault(certificate, key).code == "tls_key_locked"


def test_a_key_that_is_too_weak_for_browsers_is_told(tmp_path: Path) -> None:
    found = fault(*self_signed(tmp_path, kind="1024"))
    assert found.code == "tls_certificate_refused"
    assert "2048 bits" in found.detail


def test_one_that_has_ended_or_not_begun_is_told_with_the_day(tmp_path: Path) -> None:
    ended = NOW - timedelta(days=3)
    found = fault(*self_signed(tmp_path, begins=NOW - timedelta(days=9), ends=ended))
    assert (found.code, found.params["until"]) == ("tls_certificate_expired", f"{ended:%Y-%m-%d}")
    found = fault(*self_signed(tmp_path, begins=NOW + timedelta(days=1)))
    assert found.code == "tls_certificate_early"


def test_after_a_restart_which_may_be_in_flight_one_that_has_ended_is_better_than_no_page(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path, begins=NOW - timedelta(days=9), ends=NOW - timedelta(days=3))
    keeper = Keeper(GivenCertificate(certificate, key), again=True)
    assert keeper.fault is not None
    assert keeper.fault.code == "tls_certificate_expired"


def test_one_that_ends_soon_is_used_and_said(tmp_path: Path) -> None:
    keeper = Keeper(GivenCertificate(*self_signed(tmp_path, ends=NOW + timedelta(days=5))))
    assert keeper.fault is not None
    assert keeper.fault.code == "tls_ends_soon"


def test_a_clock_that_was_never_set_does_not_shut_the_station(tmp_path: Path) -> None:
    certificate, key = self_signed(tmp_path)
    Keeper(GivenCertificate(certificate, key), now=lambda: datetime(1970, 1, 1, tzinfo=UTC))
