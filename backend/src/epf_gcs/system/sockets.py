"""Local sockets that only their owner may use, where the system has them."""

from __future__ import annotations

import os
import socket
import sys
from pathlib import Path
from typing import Any, Final

HAS_LOCAL: Final = hasattr(socket, "AF_UNIX")
"""Whether there are sockets with the name of a file; Windows' Python has none."""


def local_socket(kind: int = socket.SOCK_STREAM) -> socket.socket:
    """A socket for the name of a file. Raises OSError where there are none."""
    if sys.platform == "win32":
        raise OSError("There are no local sockets on Windows.")
    return socket.socket(socket.AF_UNIX, kind)


def bound_for_owner(path: Path) -> socket.socket:
    """A listening stream socket of this name; from its first moment only its owner may open it. Raises OSError."""
    made = local_socket()
    before = os.umask(0o177)
    try:
        made.bind(str(path))
    except BaseException:
        made.close()
        raise
    finally:
        os.umask(before)
    return made


if sys.platform == "win32":

    def receive_with_notes(sock: socket.socket, most: int, _most_notes: int) -> tuple[bytes, list[Any], int, Any]:
        """A datagram, what the kernel notes about it (nothing there), flags, and its sender. Raises OSError."""
        data, sender = sock.recvfrom(most)
        return data, [], 0, sender

else:

    def receive_with_notes(sock: socket.socket, most: int, most_notes: int) -> tuple[bytes, list[Any], int, Any]:
        """A datagram, what the kernel notes about it, flags, and its sender. Raises OSError."""
        return sock.recvmsg(most, most_notes)
