"""The certificate in use: found at the start, looked after as long as the station runs."""

from __future__ import annotations

import asyncio
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final, Literal

import structlog
from cryptography.hazmat.primitives import serialization

from epf_gcs.errors import GatewayError
from epf_gcs.repeating import repeat
from epf_gcs.tls.certificates import addresses_of, fingerprint_of, names_of
from epf_gcs.tls.context import make_context
from epf_gcs.tls.source import Source, UsableCertificate

LOOK_EVERY_S: Final = 60.0
_SAID_AGAIN: Final = timedelta(hours=1)
"""A fault that lasts is said again, for those who have come since."""

log = structlog.get_logger("gateway")


@dataclass(frozen=True, slots=True)
class InUse:
    """What the station shows to browsers."""

    kind: Literal["made", "brought"]
    found: UsableCertificate

    @property
    def names(self) -> list[str]:
        """Its DNS names."""
        return names_of(self.found.certificate)

    @property
    def addresses(self) -> list[str]:
        """Its addresses."""
        return [str(one) for one in addresses_of(self.found.certificate)]

    @property
    def fingerprint(self) -> str:
        """SHA-256 of it."""
        return fingerprint_of(self.found.certificate)

    def authority_der(self) -> bytes | None:
        """The authority's certificate as phones take it; None if the certificate was brought."""
        authority = self.found.authority
        return None if authority is None else authority.public_bytes(serialization.Encoding.DER)


def _now() -> datetime:
    return datetime.now(UTC)


class Keeper:
    """Raises GatewayError when it is made, if there is no certificate to begin with; at a restart (`again`), which may
    be in flight, one that browsers refuse is better than none: a person can pass their warning.

    `context` is replaced as a whole when the certificate changes, so that no connection gets a mixture; those that are
    open stay as they are. `on_fault` hears each new fault, and each hour one that lasts.
    """

    def __init__(self, source: Source, now: Callable[[], datetime] = _now, *, again: bool = False) -> None:
        self._source = source
        self._now = now
        found = self._find()
        if isinstance(found, GatewayError):
            raise found
        if found.fault is not None and found.is_refused and not again:
            raise found.fault
        self.in_use = InUse(source.kind, found)
        self.context = _context(found)
        self.fault: GatewayError | None = found.fault
        self.on_fault: Callable[[GatewayError], None] = lambda _fault: None
        self._said = datetime.min.replace(tzinfo=UTC)

    async def keep(self) -> None:
        """Look every minute, forever."""
        await repeat(LOOK_EVERY_S, "the certificate", self.look, at_once=True)

    async def look(self) -> None:
        """Take a new certificate into use if there is one; else keep the old one, and say what is wrong."""
        found = await asyncio.to_thread(self._find)
        if isinstance(found, UsableCertificate) and self._is_better(found):
            try:
                self.context = _context(found)
            except GatewayError as error:
                found = error
            else:
                self.in_use = InUse(self._source.kind, found)
                log.info("a new certificate is in use", until=str(found.certificate.not_valid_after_utc))
        self._set_fault(found.fault if isinstance(found, UsableCertificate) else found)

    def _is_better(self, found: UsableCertificate) -> bool:
        return found.certificate != self.in_use.found.certificate and not found.is_refused

    def _find(self) -> UsableCertificate | GatewayError:
        try:
            return self._source.find(self._now())
        except GatewayError as error:
            return error
        except OSError as error:
            return GatewayError(
                "tls_not_renewed",
                f"The certificate cannot be made or renewed ({error.strerror}): make room on the disk, or let this "
                f"user write to {_folder(error)}.",
                reason=error.strerror,
                folder=_folder(error),
            )

    def _set_fault(self, fault: GatewayError | None) -> None:
        now = self._now()
        is_new = fault is not None and (self.fault is None or fault.detail != self.fault.detail)
        if fault is not None and (is_new or not timedelta() <= now - self._said < _SAID_AGAIN):
            log.warning("the certificate has a fault", code=fault.code, detail=fault.detail)
            self._said = now
            self.on_fault(fault)
        self.fault = fault


def _context(found: UsableCertificate) -> ssl.SSLContext:
    try:
        return make_context(found.certificate_file, found.key_file)
    except (OSError, ssl.SSLError) as error:
        raise GatewayError(
            "tls_certificate_refused",
            f"The certificate in {found.certificate_file} cannot be used ({error}): it needs an EC key, or an RSA key "
            "of 2048 bits or more.",
            file=str(found.certificate_file),
            reason=str(error),
        ) from error


def _folder(error: OSError) -> str:
    return str(Path(error.filename).parent) if isinstance(error.filename, str) else "the data folder"
