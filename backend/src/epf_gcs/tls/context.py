"""What is spoken under TLS: versions and cipher suites."""

from __future__ import annotations

import ssl
from pathlib import Path
from typing import Final

SUITES: Final = "ECDHE+AESGCM:ECDHE+CHACHA20"
"""Of TLS 1.2: forward secrecy, and encryption that also authenticates (AEAD). All suites of TLS 1.3 are like that."""


def make_context(certificate_file: Path, key_file: Path) -> ssl.SSLContext:
    """TLS 1.2 or newer, with this certificate. Raises OSError (ssl.SSLError) if OpenSSL does not take it."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    context.set_ciphers(SUITES)
    context.options |= ssl.OP_NO_RENEGOTIATION | ssl.OP_NO_COMPRESSION
    context.set_alpn_protocols(["http/1.1"])
    context.num_tickets = 1  # each costs a write after the handshake, and a browser resumes with one
    context.load_cert_chain(certificate_file, key_file, password=_no_password)
    return context


def _no_password() -> str:
    """OpenSSL would else ask at the terminal."""
    return ""
