"""One table from the operating system's errors to sentences that tell a person what to do."""

from __future__ import annotations

import errno
from typing import Final

from epf_gcs.errors import ErrorCode, LinkError

_SENTENCES: Final[dict[int, tuple[ErrorCode, str]]] = {
    errno.ENOENT: ("link_no_device", "{name} does not exist: plug the board in, or choose another port."),
    errno.ENXIO: ("link_no_device", "{name} has no device behind it: plug the board in, or choose another port."),
    errno.ENODEV: ("link_no_device", "{name} has no device behind it: plug the board in, or choose another port."),
    errno.EACCES: (
        "link_permission",
        "{name} may not be opened by this user: add the user to the device's group (often dialout) and log in again.",
    ),
    errno.EPERM: (
        "link_permission",
        "{name} may not be opened by this user: add the user to the device's group (often dialout) and log in again.",
    ),
    errno.EBUSY: ("link_busy", "{name} is in use by another program: close that program and open again."),
    errno.EAGAIN: ("link_busy", "{name} is in use by another program: close that program and open again."),
    errno.ENOTTY: ("link_not_serial", "{name} is not a serial port: choose one from the list of ports."),
    errno.EISDIR: ("link_not_serial", "{name} is a folder, not a serial port: choose one from the list of ports."),
    errno.EINVAL: ("link_not_serial", "{name} does not take these line settings: choose another port or baud rate."),
    errno.ECONNREFUSED: (
        "link_refused",
        "{name} refuses connections: start the board's server there, or correct host and port.",
    ),
    errno.ETIMEDOUT: ("link_timeout", "{name} does not answer: check the network, the host and the port."),
    errno.EHOSTUNREACH: ("link_unreachable", "{name} cannot be reached: check the network and the host."),
    errno.ENETUNREACH: ("link_unreachable", "{name} cannot be reached: check the network and the host."),
    errno.EADDRINUSE: (
        "port_taken",
        "{name} is taken by another program: close that program, or choose another receive port.",
    ),
    errno.EADDRNOTAVAIL: ("link_unreachable", "{name} is no address of this machine: correct it."),
    errno.EMFILE: (
        "link_failed",
        "{name} cannot be opened because this program has too many files and connections open: close pages of it.",
    ),
    errno.ENFILE: (
        "link_failed",
        "{name} cannot be opened because this machine has too many files open: close other programs.",
    ),
}


def link_error(name: str, error: OSError) -> LinkError:
    """The sentence for a device or socket that could not be opened."""
    number = error.errno or 0
    code, sentence = _SENTENCES.get(
        number, ("link_failed", "{name} cannot be opened ({reason}): check the device and open again.")
    )
    return LinkError(code, sentence.format(name=name, reason=error.strerror or error), target=name)


def unexpected_error(name: str, error: Exception) -> LinkError:
    """The sentence for any other exception while opening; opening is retried after it as after every LinkError."""
    if isinstance(error, LinkError):
        return error
    if isinstance(error, OSError):
        return link_error(name, error)
    return LinkError(
        "link_failed",
        f"{name} cannot be opened ({type(error).__name__}: {error}): correct the address; it is tried again.",
        target=name,
    )


def lost_error(name: str, reason: str) -> LinkError:
    """The sentence for an open link that was lost."""
    return LinkError(
        "link_lost",
        f"The line to {name} was lost ({reason}): check cable and power; it is opened again as soon as it is back.",
        target=name,
        reason=reason,
    )
