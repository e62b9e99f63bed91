"""What a raw socket hears."""

from __future__ import annotations

import socket


def everything(made: socket.socket) -> bytes:
    """What comes until the other end closes, or breaks off."""
    data = b""
    try:
        while more := made.recv(65536):
            data += more
    except ConnectionResetError:
        pass
    return data
