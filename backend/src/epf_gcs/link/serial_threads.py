"""Serial ports where an event loop cannot wait for them (Windows): two threads carry the bytes to and from a socket."""

from __future__ import annotations

import contextlib
import errno
import os
import socket
import threading
from typing import Final

import serial

from epf_gcs.errors import LinkError
from epf_gcs.link.address import LinkAddress
from epf_gcs.link.base import Device
from epf_gcs.link.failures import link_error

# A read that brings nothing ends after this time, and looks whether the port was closed.
_LOOK_S: Final = 0.2
_BYTES: Final = 4096


def open_serial(address: LinkAddress) -> Device:
    """Open a serial port for exclusive use, 8N1, without flow control. Raises LinkError."""
    try:
        port = serial.Serial(address.target, address.baud, timeout=_LOOK_S, write_timeout=_LOOK_S)
    except (OSError, ValueError) as error:  # pyserial's own exception is an OSError
        raise link_error(address.target, _as_os_error(error)) from error
    return _carried(port, address)


def open_pty(address: LinkAddress) -> Device:
    """There are no pseudo-terminals. Raises LinkError."""
    raise LinkError(
        "link_address_invalid",
        f"{address.target} is a pseudo-terminal, which this system does not have: give serial://COM3 or tcp://host:port.",
        target=address.target,
    )


def _carried(port: serial.Serial, address: LinkAddress) -> Device:
    ours, theirs = socket.socketpair()
    ours.setblocking(False)
    for work in (_carry_in, _carry_out):
        threading.Thread(
            target=work, args=(port, theirs), name=f"{work.__name__} {address.target}", daemon=True
        ).start()

    def close() -> None:
        ours.close()
        with contextlib.suppress(OSError):
            theirs.shutdown(socket.SHUT_RDWR)
        port.close()

    return Device(
        address.target, ours.fileno(), address.baud, close, lambda: _waiting_to_leave(port), ours.recv, ours.send
    )


def _carry_in(port: serial.Serial, to: socket.socket) -> None:
    """From the port to the socket, until either is closed."""
    with contextlib.suppress(OSError, TypeError, ValueError):  # what a closed port raises differs
        while port.is_open:
            data = port.read(1)
            if data:
                to.sendall(data + port.read(min(port.in_waiting, _BYTES)))
    # Whoever reads the other end learns that the line is gone, and the other thread ends: closing alone wakes neither.
    with contextlib.suppress(OSError):
        to.shutdown(socket.SHUT_RDWR)


def _carry_out(port: serial.Serial, source: socket.socket) -> None:
    """From the socket to the port, until either is closed."""
    with contextlib.suppress(OSError, TypeError, ValueError):
        while data := source.recv(_BYTES):
            left = memoryview(data)
            while left and port.is_open:
                left = left[port.write(left) or 0 :]
    source.close()


def _waiting_to_leave(port: serial.Serial) -> int:
    try:
        return int(port.out_waiting)
    except (OSError, TypeError, ValueError, AttributeError):
        return 0


def _as_os_error(error: OSError | ValueError) -> OSError:
    """Windows' reasons stand in the text of pyserial's exception alone."""
    if isinstance(error, OSError) and error.errno:
        return OSError(error.errno, os.strerror(error.errno))
    said = str(error)
    for words, number in (
        ("FileNotFoundError", errno.ENOENT),
        ("PermissionError", errno.EBUSY),  # another program has it; there are no groups
        ("could not open port", errno.ENOENT),
    ):
        if words in said:
            return OSError(number, os.strerror(number))
    return OSError(errno.EINVAL, said)
