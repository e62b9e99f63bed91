"""Serial ports and pseudo-terminals. pyserial opens and configures; the event loop reads."""

from __future__ import annotations

import array
import contextlib
import errno
import fcntl
import os
import termios
import tty

import serial

from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import Device
from epf_gcs.link.failures import link_error


def open_serial(address: LinkAddress) -> Device:
    """Open a serial port for ourselves alone, 8N1, no flow control. Raises LinkError."""
    try:
        port = serial.Serial(
            address.target, address.baud, timeout=0, write_timeout=0, exclusive=True, xonxoff=False, rtscts=False
        )
    except serial.SerialException as error:
        raise link_error(address.target, _as_os_error(error)) from error
    except (OSError, ValueError, termios.error) as error:
        raise link_error(address.target, _as_os_error(error)) from error
    # Adapters collect bytes for 16 ms unless told not to; those that cannot be told say so by an error.
    with contextlib.suppress(OSError, ValueError, NotImplementedError):
        port.set_low_latency_mode(True)
    fd = port.fileno()
    os.set_blocking(fd, False)
    return Device(address.target, fd, address.baud, port.close, lambda: _waiting_to_leave(fd))


def open_pty(address: LinkAddress) -> Device:
    """Open the slave side of a pseudo-terminal in raw mode, for ourselves alone. Raises LinkError."""
    try:
        fd = os.open(address.target, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    except OSError as error:
        raise link_error(address.target, error) from error
    try:
        fcntl.flock(fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
        tty.setraw(fd)
    except (OSError, termios.error) as error:
        os.close(fd)
        raise link_error(address.target, _as_os_error(error)) from error
    # What is written to a pseudo-terminal is at the other side at once.
    return Device(address.target, fd, address.baud, lambda: os.close(fd), lambda: 0)


def _waiting_to_leave(fd: int) -> int:
    waiting = array.array("i", [0])
    try:
        fcntl.ioctl(fd, termios.TIOCOUTQ, waiting)
    except OSError:
        return 0
    return waiting[0]


def _as_os_error(error: BaseException) -> OSError:
    """The system's own error inside what pyserial and termios raise, which keep it in different places."""
    number = error.errno if isinstance(error, OSError) else error.args[0] if error.args else None
    if isinstance(number, int):
        return OSError(number, os.strerror(number))
    if "exclusively lock" in str(error):
        return OSError(errno.EBUSY, str(error))
    if error.__context__ is not None:
        return _as_os_error(error.__context__)
    return OSError(errno.EINVAL if isinstance(error, ValueError) else 0, str(error))
