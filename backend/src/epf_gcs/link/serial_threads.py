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
# What is written at once leaves within half of that time, or the port would say that it is stuck.
_BITS_OF_A_BYTE: Final = 10
# How long closing waits for what was said last: the board is told to leave its mode.
_LAST_WORDS_S: Final = 0.1


class _Backlog:
    """Bytes on their way between the socket and the port. Each of the two counts is written by one thread."""

    def __init__(self) -> None:
        self.given = 0
        self.written = 0


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
    unsent = _Backlog()
    most = max(1, int(address.baud * _LOOK_S / 2.0 / _BITS_OF_A_BYTE))
    reading = threading.Thread(target=_carry_in, args=(port, theirs), name=f"from {address.target}", daemon=True)
    writing = threading.Thread(
        target=_carry_out, args=(port, theirs, unsent, most), name=f"to {address.target}", daemon=True
    )
    reading.start()
    writing.start()

    def send(data: bytes | bytearray) -> int:
        count = ours.send(data)
        unsent.given += count
        return count

    def close() -> None:
        with contextlib.suppress(OSError):
            ours.shutdown(socket.SHUT_WR)
        writing.join(_LAST_WORDS_S)
        ours.close()
        with contextlib.suppress(OSError):
            theirs.shutdown(socket.SHUT_RDWR)
        port.close()

    def backlog() -> int:
        return unsent.given - unsent.written + _waiting_to_leave(port)

    return Device(address.target, ours.fileno(), address.baud, close, backlog, ours.recv, send)


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


def _carry_out(port: serial.Serial, source: socket.socket, unsent: _Backlog, most: int) -> None:
    """From the socket to the port, `most` bytes at once, until either is closed."""
    with contextlib.suppress(OSError, TypeError, ValueError):
        while data := source.recv(most):
            left = memoryview(data)
            while left and port.is_open:
                count = port.write(left) or 0
                unsent.written += count
                left = left[count:]
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
