"""TLS as the settings ask for it."""

from __future__ import annotations

import socket
from pathlib import Path

from epf_gcs.errors import GatewayError
from epf_gcs.tls.brought import GivenCertificate
from epf_gcs.tls.identity import Identity, addresses_here, identity_of
from epf_gcs.tls.keeper import Keeper
from epf_gcs.tls.made import OwnCertificate
from epf_gcs.web.serving.settings import Settings

FOLDER = "tls"
"""Folder of the certificates below the data folder."""


def keeper_of(settings: Settings) -> Keeper | None:
    """The certificate to begin with; None without TLS. Raises GatewayError if there can be none."""
    if settings.tls_cert is not None:
        # One file may hold both.
        return Keeper(GivenCertificate(settings.tls_cert, settings.tls_key or settings.tls_cert), again=settings.again)
    if settings.tls_key is not None:
        raise GatewayError(
            "tls_no_certificate",
            f"The key in {settings.tls_key} has no certificate: name its file with --tls-cert.",
            file=str(settings.tls_key),
        )
    if not settings.tls:
        return None

    def identity() -> Identity:
        return identity_of(socket.gethostname(), settings.names, addresses_here())

    return Keeper(OwnCertificate(Path(settings.data_dir) / FOLDER, identity))
