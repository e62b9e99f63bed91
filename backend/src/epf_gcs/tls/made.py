"""Certificates that the station makes for itself and keeps in its data folder."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import Final, Literal

import structlog

from epf_gcs.disk import replace_file
from epf_gcs.tls.certificates import (
    Pair,
    authority_serves,
    make_authority,
    make_station,
    read_pair,
    station_serves,
)
from epf_gcs.tls.identity import Identity
from epf_gcs.tls.source import UsableCertificate

AUTHORITY: Final = "authority.pem"
"""Key and certificate of the authority."""
AUTHORITY_CERTIFICATE: Final = "authority.crt"
"""The certificate alone, for people and for the launcher."""
STATION: Final = "station.pem"
"""Key and certificate of the station."""
_OWNER_ALONE: Final = 0o600
_FOLDER: Final = 0o700
_ANYBODY: Final = 0o644

log = structlog.get_logger("gateway")


class OwnCertificate:
    """An authority and a certificate in `folder`, made when they are missing, damaged, near their end or no longer fit.

    `identity` is asked each time, for addresses change.
    """

    kind: Literal["made", "brought"] = "made"

    def __init__(self, folder: Path, identity: Callable[[], Identity]) -> None:
        self._folder = folder
        self._identity = identity

    def find(self, now: datetime) -> UsableCertificate:
        """The certificate, which lasts for a while yet. Raises OSError if it cannot be written."""
        identity = self._identity()
        authority = self._read(AUTHORITY)
        if authority is None or not authority_serves(authority.certificate, identity, now):
            authority = make_authority(identity, now)
            self._write(AUTHORITY, authority.pem(), _OWNER_ALONE)
            log.info("a new authority was made for TLS", folder=str(self._folder))
        if self._bytes(AUTHORITY_CERTIFICATE) != authority.certificate_pem():
            self._write(AUTHORITY_CERTIFICATE, authority.certificate_pem(), _ANYBODY)
        station = self._read(STATION)
        if station is None or not station_serves(station.certificate, authority.certificate, identity, now):
            station = make_station(authority, identity, now)
            self._write(STATION, station.pem(), _OWNER_ALONE)
            log.info("a new certificate was made for TLS", until=str(station.certificate.not_valid_after_utc))
        file = self._folder / STATION
        return UsableCertificate(station.certificate, file, file, authority.certificate)

    def _read(self, name: str) -> Pair | None:
        """None if it is missing or damaged; a damaged one is kept beside the new one."""
        data = self._bytes(name)
        if data is None:
            return None
        file = self._folder / name
        # Rights may have been lost where the folder was copied.
        if os.name == "posix" and stat.S_IMODE(file.stat().st_mode) & ~_OWNER_ALONE:
            log.warning("a key could be read by others; now it cannot", file=str(file))
            file.chmod(_OWNER_ALONE)
        try:
            return read_pair(data)
        except ValueError:
            log.warning("a damaged certificate is made again", file=str(file))
            with contextlib.suppress(OSError):
                file.replace(file.with_name(f"{name}.damaged"))
            return None

    def _bytes(self, name: str) -> bytes | None:
        try:
            return (self._folder / name).read_bytes()
        except FileNotFoundError:
            return None

    def _write(self, name: str, data: bytes, mode: int) -> None:
        self._folder.mkdir(mode=_FOLDER, parents=True, exist_ok=True)
        replace_file(self._folder / name, data, mode)
