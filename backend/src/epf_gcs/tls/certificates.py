"""Certificates as values: an authority of this station's own, and the station's certificate that it signs.

Nothing here touches a disk or a clock. All keys are on the curve P-256.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Final

from cryptography import x509
from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.hazmat.primitives.asymmetric.types import PrivateKeyTypes
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from epf_gcs.tls.identity import Address, Identity

AUTHORITY_DAYS: Final = 3650
STATION_DAYS: Final = 90
RENEW_DAYS: Final = 30
"""A certificate with less than this left is made again."""
EARLIEST: Final = datetime(2026, 1, 1, tzinfo=UTC)
"""A clock that is before this was never set, and a certificate of that time would be no use to others."""
_PERMITTED: Final = ("local", "localhost")
# Clocks of phones that are a little behind ours take the certificate, too.
_BEFORE: Final = timedelta(days=1)
_MOST_COMMON_NAME: Final = 64


@dataclass(frozen=True, slots=True)
class Pair:
    """A certificate and its private key."""

    certificate: x509.Certificate
    key: PrivateKeyTypes

    def pem(self) -> bytes:
        """Both in PEM: key and certificate of one file always belong together."""
        return (
            self.key.private_bytes(
                serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
            )
            + self.certificate_pem()
        )

    def certificate_pem(self) -> bytes:
        """The certificate alone, which is no secret."""
        return self.certificate.public_bytes(serialization.Encoding.PEM)


def read_pair(pem: bytes) -> Pair:
    """What `Pair.pem` made. Raises ValueError for anything else."""
    try:
        pair = Pair(x509.load_pem_x509_certificate(pem), serialization.load_pem_private_key(pem, None))
    except (TypeError, ValueError) as error:
        raise ValueError("no key and certificate in PEM") from error
    if pair.key.public_key() != pair.certificate.public_key():
        raise ValueError("the key is another certificate's")
    return pair


def make_authority(identity: Identity, now: datetime) -> Pair:
    """An authority for ten years that can vouch for addresses and this machine's names, and for no other name.

    A phone that trusts it trusts it for everything that it may sign, and its key lies on a field computer: with the
    name constraints a thief of the key can pose as no site of the internet.
    """
    now = max(now, EARLIEST)
    key = ec.generate_private_key(ec.SECP256R1())
    name = _name(f"EPF GCS {identity.own[0]}")
    names = dict.fromkeys((*_PERMITTED, *identity.own, *identity.chosen))
    certificate = (
        _builder(name, name, key, now, AUTHORITY_DAYS)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(_usage(signs=True), critical=True)
        .add_extension(
            x509.NameConstraints([*(x509.DNSName(one) for one in names), *_EVERY_ADDRESS], None), critical=True
        )
        .sign(key, hashes.SHA256())
    )
    return Pair(certificate, key)


def make_station(authority: Pair, identity: Identity, now: datetime) -> Pair:
    """The station's certificate, signed by the authority; own names that it may not sign are left out."""
    now = max(now, EARLIEST)
    key = ec.generate_private_key(ec.SECP256R1())
    names = wanted_names(authority.certificate, identity)
    certificate = (
        _builder(_name(names[0]), authority.certificate.subject, key, now, STATION_DAYS)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(_usage(signs=False), critical=True)
        .add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
        .add_extension(
            x509.SubjectAlternativeName(
                [*(x509.DNSName(one) for one in names), *(x509.IPAddress(one) for one in identity.addresses)]
            ),
            critical=False,
        )
        .add_extension(
            x509.AuthorityKeyIdentifier.from_issuer_public_key(authority.certificate.public_key()),  # type: ignore[arg-type]
            critical=False,
        )
        .sign(authority.key, hashes.SHA256())  # type: ignore[arg-type]
    )
    return Pair(certificate, key)


def authority_serves(authority: x509.Certificate, identity: Identity, now: datetime) -> bool:
    """Whether it outlives a certificate that it signs now, and may sign every chosen name."""
    now = max(now, EARLIEST)
    if not authority.not_valid_before_utc <= now <= authority.not_valid_after_utc - timedelta(days=STATION_DAYS):
        return False
    permitted = _permitted(authority)
    return all(_is_within(name, permitted) for name in identity.chosen)


def station_serves(station: x509.Certificate, authority: x509.Certificate, identity: Identity, now: datetime) -> bool:
    """Whether it is the authority's, lasts for a while yet, and names all that it has to.

    An address that went away does not count: a laptop that goes to and fro between two networks would else get a new
    certificate each time.
    """
    now = max(now, EARLIEST)
    if not station.not_valid_before_utc <= now <= station.not_valid_after_utc - timedelta(days=RENEW_DAYS):
        return False
    try:
        station.verify_directly_issued_by(authority)
    except (ValueError, TypeError, InvalidSignature):
        return False
    names, addresses = names_of(station), addresses_of(station)
    return set(wanted_names(authority, identity)) <= set(names) and set(identity.addresses) <= set(addresses)


def wanted_names(authority: x509.Certificate, identity: Identity) -> list[str]:
    """The names for the station's certificate."""
    permitted = _permitted(authority)
    return [name for name in dict.fromkeys((*identity.own, *identity.chosen)) if _is_within(name, permitted)]


def names_of(certificate: x509.Certificate) -> list[str]:
    """The DNS names that it is for."""
    return _alternatives(certificate).get_values_for_type(x509.DNSName)


def addresses_of(certificate: x509.Certificate) -> list[Address]:
    """The addresses that it is for."""
    found = _alternatives(certificate).get_values_for_type(x509.IPAddress)
    return [one for one in found if isinstance(one, ipaddress.IPv4Address | ipaddress.IPv6Address)]


def fingerprint_of(certificate: x509.Certificate) -> str:
    """SHA-256 as browsers show it: pairs of hexadecimal digits with colons."""
    return certificate.fingerprint(hashes.SHA256()).hex(":").upper()


_EVERY_ADDRESS: Final = (
    x509.IPAddress(ipaddress.ip_network("0.0.0.0/0")),
    x509.IPAddress(ipaddress.ip_network("::/0")),
)


def _builder(
    subject: x509.Name, issuer: x509.Name, key: ec.EllipticCurvePrivateKey, now: datetime, days: int
) -> x509.CertificateBuilder:
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - _BEFORE)
        .not_valid_after(now + timedelta(days=days))
        .add_extension(x509.SubjectKeyIdentifier.from_public_key(key.public_key()), critical=False)
    )


def _usage(*, signs: bool) -> x509.KeyUsage:
    return x509.KeyUsage(
        digital_signature=not signs,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        key_cert_sign=signs,
        crl_sign=signs,
        encipher_only=False,
        decipher_only=False,
    )


def _name(common: str) -> x509.Name:
    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, common[:_MOST_COMMON_NAME])])


def _alternatives(certificate: x509.Certificate) -> x509.SubjectAlternativeName:
    try:
        return certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except (x509.ExtensionNotFound, x509.DuplicateExtension, ValueError):  # a brought one may be malformed
        return x509.SubjectAlternativeName([])


def _permitted(authority: x509.Certificate) -> list[str]:
    try:
        found = authority.extensions.get_extension_for_class(x509.NameConstraints).value.permitted_subtrees or []
    except x509.ExtensionNotFound:
        found = []
    return [one.value for one in found if isinstance(one, x509.DNSName)]


def _is_within(name: str, permitted: Iterable[str]) -> bool:
    return any(name == one or name.endswith(f".{one}") for one in permitted)
