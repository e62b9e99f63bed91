"""A certificate that the user brings, as PEM files; they are read again when they are replaced."""

from __future__ import annotations

from datetime import datetime, timedelta
from pathlib import Path
from typing import Final, Literal

from cryptography import x509
from cryptography.exceptions import UnsupportedAlgorithm
from cryptography.hazmat.primitives import serialization
from cryptography.hazmat.primitives.asymmetric.types import PrivateKeyTypes

from epf_gcs.errors import GatewayError
from epf_gcs.tls.certificates import EARLIEST
from epf_gcs.tls.source import UsableCertificate

SOON_DAYS: Final = 14
"""A certificate that ends within this is reported."""


class GivenCertificate:
    """`certificate_file` begins with the station's certificate and goes on with its chain; the key may stand in the
    same file."""

    kind: Literal["made", "brought"] = "brought"

    def __init__(self, certificate_file: Path, key_file: Path) -> None:
        self._certificate_file = certificate_file
        self._key_file = key_file

    def find(self, now: datetime) -> UsableCertificate:
        """The certificate. Raises GatewayError with what is wrong and what to do."""
        certificate = _certificate(self._certificate_file)
        key = _key(self._key_file)
        if key.public_key() != certificate.public_key():
            raise GatewayError(
                "tls_key_differs",
                f"The key in {self._key_file} is not the one of the certificate in {self._certificate_file}: name the "
                "two that belong together with --tls-cert and --tls-key.",
                file=str(self._key_file),
                certificate=str(self._certificate_file),
            )
        fault = _fault_of_time(certificate, self._certificate_file, now)
        is_refused = fault is not None and fault.code != "tls_ends_soon"
        return UsableCertificate(
            certificate, self._certificate_file, self._key_file, fault=fault, is_refused=is_refused
        )


def _certificate(file: Path) -> x509.Certificate:
    data = _read(file, "--tls-cert")
    try:
        return x509.load_pem_x509_certificates(data)[0]
    except (ValueError, IndexError):
        raise GatewayError(
            "tls_no_certificate",
            f"{file} holds no certificate in PEM form: name the file that begins with the station's certificate with "
            "--tls-cert.",
            file=str(file),
        ) from None


def _key(file: Path) -> PrivateKeyTypes:
    data = _read(file, "--tls-key")
    try:
        return serialization.load_pem_private_key(data, None)
    except TypeError:
        raise GatewayError(
            "tls_key_locked",
            f"The key in {file} has a password, which nobody could enter when the station starts again: write it "
            "without one (openssl pkey).",
            file=str(file),
        ) from None
    except (ValueError, UnsupportedAlgorithm) as error:
        raise GatewayError(
            "tls_no_key",
            f"{file} holds no private key in PEM form: name the file of the key with --tls-key.",
            file=str(file),
        ) from error


def _read(file: Path, option: str) -> bytes:
    try:
        return file.read_bytes()
    except OSError as error:
        raise GatewayError(
            "tls_file_unreadable",
            f"{file} cannot be read ({error.strerror}): let this user read it, or name another file with {option}.",
            file=str(file),
            reason=error.strerror,
        ) from error


def _fault_of_time(certificate: x509.Certificate, file: Path, now: datetime) -> GatewayError | None:
    """What is wrong with its dates."""
    if now < EARLIEST:  # the clock is not set yet
        return None
    ends, begins = certificate.not_valid_after_utc, certificate.not_valid_before_utc
    if now > ends:
        return GatewayError(
            "tls_certificate_expired",
            f"The certificate in {file} ended on {ends:%Y-%m-%d}: bring a new one.",
            file=str(file),
            until=f"{ends:%Y-%m-%d}",
        )
    if now < begins:
        return GatewayError(
            "tls_certificate_early",
            f"The certificate in {file} holds from {begins:%Y-%m-%d %H:%M} UTC on: wait, or set this computer's clock.",
            file=str(file),
            since=f"{begins:%Y-%m-%d %H:%M}",
        )
    if now > ends - timedelta(days=SOON_DAYS):
        return GatewayError(
            "tls_ends_soon",
            f"The certificate in {file} ends on {ends:%Y-%m-%d}: bring a new one in time.",
            file=str(file),
            until=f"{ends:%Y-%m-%d}",
        )
    return None
