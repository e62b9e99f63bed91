"""The listening TCP socket of the page and the interface."""

from __future__ import annotations

import errno
import socket
import time
from typing import Final

from epf_gcs.errors import LinkError

# A gateway that was killed a moment ago lets its port go within this time.
_PATIENCE_S: Final = 2.0
_RETRY_S: Final = 0.05


def listen(host: str, port: int) -> socket.socket:
    """A listening socket. Raises LinkError with what to do where there can be none."""
    give_up_s = time.monotonic() + _PATIENCE_S
    while True:
        try:
            return socket.create_server((host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
        except socket.gaierror as error:
            raise LinkError(
                "listen_unknown_host",
                f"'{host}' is no address of this machine: choose another with --host.",
                host=host,
            ) from error
        except OSError as error:
            if error.errno != errno.EADDRINUSE or time.monotonic() > give_up_s:
                raise _failure(host, port, error) from error
        time.sleep(_RETRY_S)


def _failure(host: str, port: int, error: OSError) -> LinkError:
    reasons = {
        errno.EADDRINUSE: "is taken by another program: close that program, or choose another with --port",
        errno.EACCES: "is not for this user: choose one above 1023 with --port",
        errno.EADDRNOTAVAIL: "is at no address of this machine: choose another with --host",
    }
    reason = reasons.get(error.errno or 0, f"cannot be taken ({error.strerror}): choose another with --port")
    return LinkError("listen_failed", f"TCP port {port} of {host} {reason}.", host=host, port=port)
