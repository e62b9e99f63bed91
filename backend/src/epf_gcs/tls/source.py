"""Where the station's certificate comes from: made by the station in its data folder, or brought by the user."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Literal, Protocol

from cryptography import x509

from epf_gcs.errors import GatewayError


@dataclass(frozen=True, slots=True)
class UsableCertificate:
    """A certificate that can be used now, in PEM files. `authority` is the one that made it, None if it was brought.

    `fault` says what a person has to do, soon or, where `is_refused`, now: browsers refuse the certificate.
    """

    certificate: x509.Certificate
    certificate_file: Path
    key_file: Path
    authority: x509.Certificate | None = None
    fault: GatewayError | None = None
    is_refused: bool = False


class Source(Protocol):
    """Implemented by `made.Made` and `brought.Brought`."""

    kind: Literal["made", "brought"]

    def find(self, now: datetime) -> UsableCertificate:
        """The certificate to use from now on; makes or reads it. Blocks. Raises GatewayError or OSError."""
