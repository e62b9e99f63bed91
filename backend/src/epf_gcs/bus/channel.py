"""One connection of the stream, on a stream socket of this machine. Calls never block."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from typing import Final

_READ_BYTES: Final = 262_144


class Channel:
    """Made on a running loop. `on_closed` is called once, when the other side has gone; not after `close`."""

    def __init__(
        self, connection: socket.socket, on_data: Callable[[bytes], None], on_closed: Callable[[], None]
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._socket = connection
        self._on_data = on_data
        self._on_closed = on_closed
        self._pending = bytearray()
        self._closed = False
        connection.setblocking(False)
        self._loop.add_reader(connection, self._readable)

    @property
    def unsent_bytes(self) -> int:
        """Bytes that the system has not taken yet."""
        return len(self._pending)

    def send(self, data: bytes) -> None:
        """Send at once what the system takes; queue the rest, without a limit."""
        if self._closed:
            return
        sent = 0
        if not self._pending:
            try:
                sent = self._socket.send(data)
            except (BlockingIOError, InterruptedError):
                sent = 0
            except OSError:
                return  # the reader notices it too, and calls on_closed
        if sent < len(data):
            if not self._pending:
                self._loop.add_writer(self._socket, self._writable)
            self._pending += memoryview(data)[sent:]

    def close(self) -> None:
        """End the connection; what was not sent is dropped."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._socket)
        self._loop.remove_writer(self._socket)
        self._socket.close()

    def lose(self) -> None:
        """End the connection as if the other side had gone: `on_closed` is called."""
        if not self._closed:
            self.close()
            self._on_closed()

    def _readable(self) -> None:
        try:
            data = self._socket.recv(_READ_BYTES)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            data = b""
        if data:
            self._on_data(data)
        else:
            self.lose()

    def _writable(self) -> None:
        try:
            sent = self._socket.send(self._pending)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            sent = len(self._pending)
        del self._pending[:sent]
        if not self._pending and not self._closed:
            self._loop.remove_writer(self._socket)
