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
# Of other services: browsers open no address with them (WHATWG, Fetch, "bad port").
_REFUSED_BY_BROWSERS: Final = frozenset(
    {
        *(1, 7, 9, 11, 13, 15, 17, 19, 20, 21, 22, 23, 25, 37, 42, 43, 53, 69, 77, 79, 87, 95, 101, 102, 103, 104, 109),
        *(110, 111, 113, 115, 117, 119, 123, 135, 137, 139, 143, 161, 179, 389, 427, 465, 512, 513, 514, 515, 526, 530),
        *(531, 532, 540, 548, 554, 556, 563, 587, 601, 636, 989, 990, 993, 995, 1719, 1720, 1723, 2049, 3659, 4045),
        *(4190, 5060, 5061, 6000, 6566, 6665, 6666, 6667, 6668, 6669, 6679, 6697, 10080),
    }
)


def is_refused_by_browsers(port: int) -> bool:
    """Whether browsers refuse to open an address with this TCP port."""
    return port in _REFUSED_BY_BROWSERS


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
