"""TLS for the launcher: which options go on to the programs, and whom its own requests trust."""

from __future__ import annotations

import ssl
from pathlib import Path


def tls_arguments(certificate: Path | None, key: Path | None, *, tls: bool) -> list[str]:
    """The options for `epf-gcs` and `epf-web`."""
    return [
        *(["--tls"] if tls else []),
        *([] if certificate is None else ["--tls-cert", str(certificate)]),
        *([] if key is None else ["--tls-key", str(key)]),
    ]


def trusting(file: Path) -> ssl.SSLContext:
    """Trust this one authority or certificate alone, whatever name it has: it comes from our own disk.

    Raises OSError while there is no such file, or if it holds no certificate.
    """
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    context.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN
    context.load_verify_locations(file)
    return context
