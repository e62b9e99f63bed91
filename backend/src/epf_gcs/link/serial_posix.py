"""Serial ports and pseudo-terminals. pyserial opens and configures; the event loop reads."""

from __future__ import annotations

import array
import contextlib
import errno
import fcntl
import os
import sys
import termios
import time
import tty
from collections.abc import Callable
from functools import partial
from typing import Final

import serial

from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import Device
from epf_gcs.link.failures import link_error

if sys.platform == "win32":
    raise ImportError("There are no terminals on Windows: `serial_threads.py` opens its ports.")

# Size of Linux's struct termios (with room to spare), and in it the place of VMIN, the bytes that a read waits for.
_SETTINGS_BYTES: Final = 64
_VMIN_PLACE: Final = 17 + termios.VMIN
# A change of settings takes 3 us inside this machine, and ten times this limit if it goes over USB.
_CHEAP_S: Final = 50e-6


def open_serial(address: LinkAddress) -> Device:
    """Open a serial port for exclusive use, 8N1, without flow control. Raises LinkError."""
    try:
        port = serial.Serial(
            address.target, address.baud, timeout=0, write_timeout=0, exclusive=True, xonxoff=False, rtscts=False
        )
    except serial.SerialException as error:
        raise link_error(address.target, _as_os_error(error)) from error
    except (OSError, ValueError, termios.error) as error:
        raise link_error(address.target, _as_os_error(error)) from error
    # USB adapters collect bytes for 16 ms unless set to low latency; those without this setting raise an error.
    with contextlib.suppress(OSError, ValueError, NotImplementedError):
        port.set_low_latency_mode(True)
    fd = port.fileno()
    os.set_blocking(fd, False)
    return _device(address, fd, port.close, lambda: _waiting_to_leave(fd))


def open_pty(address: LinkAddress) -> Device:
    """Open the slave side of a pseudo-terminal in raw mode, for exclusive use. Raises LinkError."""
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
    # A pseudo-terminal delivers at once, so its kernel backlog is 0.
    return _device(address, fd, lambda: os.close(fd), lambda: 0)


def _device(address: LinkAddress, fd: int, close: Callable[[], None], backlog: Callable[[], int]) -> Device:
    read, write = partial(os.read, fd), partial(os.write, fd)
    return Device(address.target, fd, address.baud, close, backlog, read, write, waiter(fd), is_serial=True)


def waiter(fd: int) -> Callable[[int], None] | None:
    """A function that makes the terminal readable only when so many bytes are there; None if not supported or slow.

    It sets VMIN. The system passes all settings to the driver each time. Most drivers notice that none of theirs has
    changed; some (FTDI's) still send control messages over USB and block us meanwhile. So the time of a change is
    measured first, and None returned if it is too long.
    """
    if sys.platform != "linux":
        return None
    settings = bytearray(_SETTINGS_BYTES)

    def wait_for(count: int) -> None:
        settings[_VMIN_PLACE] = count
        try:
            fcntl.ioctl(fd, termios.TCSETS, settings)
        except OSError:
            return  # if the device is gone, the next read reports it

    try:
        fcntl.ioctl(fd, termios.TCGETS, settings)
        took_s = []
        for count in (2, 1, 2):
            begun_s = time.perf_counter()
            wait_for(count)
            took_s.append(time.perf_counter() - begun_s)
        # VMIN's place in the structure is the same on nearly all architectures: check it on this one.
        works = termios.tcgetattr(fd)[6][termios.VMIN] == 2
        wait_for(1)
    except (OSError, termios.error):
        return None
    return wait_for if works and min(took_s) < _CHEAP_S else None


def _waiting_to_leave(fd: int) -> int:
    waiting = array.array("i", [0])
    try:
        fcntl.ioctl(fd, termios.TIOCOUTQ, waiting)
    except OSError:
        return 0
    return waiting[0]


def _as_os_error(error: BaseException) -> OSError:
    """The system's error number from the exceptions of pyserial and termios, which keep it in different places."""
    number = error.errno if isinstance(error, OSError) else error.args[0] if error.args else None
    if isinstance(number, int):
        return OSError(number, os.strerror(number))
    if "exclusively lock" in str(error):
        return OSError(errno.EBUSY, str(error))
    if error.__context__ is not None:
        return _as_os_error(error.__context__)
    return OSError(errno.EINVAL if isinstance(error, ValueError) else 0, str(error))
