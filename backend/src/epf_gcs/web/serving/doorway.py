"""The listening socket under TLS. The first byte of a connection says what it is: TLS, or HTTP in plain text.

asyncio's own server can only expect one of the two. A connection counts as a visitor from its first moment, so those
that never finish their handshake take nobody's place but that of their own host, and they are ended in time; those that
finish one after another are slowed down (`Visitors.begin_handshake`).
"""

from __future__ import annotations

import asyncio
import contextlib
import errno
import socket
import ssl
from collections.abc import Callable
from typing import Any, Final

import structlog

from epf_gcs.repeating import Repeating
from epf_gcs.web.serving.visitors import Visitor, Visitors

SHUTDOWN_S: Final = 5.0
"""How long the goodbye of TLS is waited for; then the connection is closed without it."""
_HANDSHAKE: Final = b"\x16"  # content type of the first record of TLS (RFC 8446, 5.1)
_AT_ONCE: Final = 32
_NO_DESCRIPTORS: Final = frozenset({errno.EMFILE, errno.ENFILE, errno.ENOBUFS, errno.ENOMEM})
_PAUSE_S: Final = 1.0

log = structlog.get_logger("gateway")

Factory = Callable[[Visitor], asyncio.Protocol]
"""Makes the protocol of a connection, which takes over the place of the visitor."""


class Doorway:
    """Stands in the place of an `asyncio.Server` (`sockets`, `close`, `wait_closed`). Made on the running loop."""

    def __init__(
        self,
        listener: socket.socket,
        context: Callable[[], ssl.SSLContext],
        encrypted: Factory,
        plain: Factory,
        *,
        visitors: Visitors,
    ) -> None:
        """`context` is asked for each connection. `plain` gets those that do not speak TLS."""
        listener.setblocking(False)
        self.sockets = (listener,)
        self.context = context
        self.encrypted = encrypted
        self.plain = plain
        self.visitors = visitors
        self.loop = asyncio.get_running_loop()
        self._listener = listener
        self._arrivals: dict[Arrival, None] = {}
        self._is_open = True
        self._pause = Repeating(self.loop, "the listening socket", self._accept_again)
        self.loop.add_reader(listener, self._accept)

    def close(self) -> None:
        """Accept no more, and end the connections that are not handed over yet."""
        if self._is_open:
            self._is_open = False
            self._pause.stop()
            self.loop.remove_reader(self._listener)
            for arrival in tuple(self._arrivals):
                arrival.make_room()

    async def wait_closed(self) -> None:
        """Wait until `close` has had its effect."""
        await asyncio.gather(*[arrival.task for arrival in self._arrivals if arrival.task], return_exceptions=True)

    def forget(self, arrival: Arrival) -> None:
        """This one is handed over, or over."""
        self._arrivals.pop(arrival, None)

    def _accept(self) -> None:
        for _ in range(_AT_ONCE):
            try:
                connection, peer = self._listener.accept()
            except (BlockingIOError, InterruptedError, ConnectionAbortedError):
                return
            except OSError as error:
                if error.errno not in _NO_DESCRIPTORS:
                    raise
                log.warning("no connection can be accepted", reason=error.strerror)
                self.loop.remove_reader(self._listener)
                self._pause.arm(_PAUSE_S)
                return
            self._let_in(connection, peer)

    def _accept_again(self) -> None:
        self.loop.add_reader(self._listener, self._accept)

    def _let_in(self, connection: socket.socket, peer: Any) -> None:
        connection.setblocking(False)
        arrival = Arrival(self, connection, str(peer[0]))
        if not self.visitors.come_in(arrival):
            # There is no answer that both kinds would understand.
            log.warning("a connection was refused", host=arrival.host)
            connection.close()
            return
        self._arrivals[arrival] = None
        arrival.begin()


class Arrival:
    """A connection that is not handed over yet: nothing was heard of it, or it shakes hands.

    Implements `epf_gcs.web.serving.visitors.Visitor`; it is always idle, for nobody depends on it yet.
    """

    def __init__(self, doorway: Doorway, connection: socket.socket, host: str) -> None:
        self.host = host
        self.since_s = doorway.loop.time()
        self.idle_since_s: float | None = self.since_s
        self.has_shown_key = False
        self.task: asyncio.Task[None] | None = None
        self._doorway = doorway
        self._connection = connection
        self._timer = doorway.loop.call_later(doorway.visitors.limits.handshake_s, self.make_room)

    def begin(self) -> None:
        """Wait for the first byte."""
        self._doorway.loop.add_reader(self._connection, self._look)

    def make_room(self) -> None:
        """End it at once."""
        if self.task is None:
            self._doorway.loop.remove_reader(self._connection)
            self._end()
            self._connection.close()
            return
        # The transport owns the descriptor; it sees the end, and the handshake fails.
        with contextlib.suppress(OSError):
            self._connection.shutdown(socket.SHUT_RDWR)

    def _look(self) -> None:
        try:
            first = self._connection.recv(1, socket.MSG_PEEK)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            first = b""
        if not first:
            self.make_room()
            return
        is_tls = first == _HANDSHAKE
        if is_tls and not self._doorway.visitors.begin_handshake(self.host):
            self.make_room()
            return
        self._doorway.loop.remove_reader(self._connection)
        self.task = self._doorway.loop.create_task(self._hand_over(is_tls=is_tls))

    async def _hand_over(self, *, is_tls: bool) -> None:
        doorway = self._doorway
        try:
            if is_tls:
                await doorway.loop.connect_accepted_socket(
                    lambda: doorway.encrypted(self),
                    self._connection,
                    ssl=doorway.context(),
                    ssl_handshake_timeout=doorway.visitors.limits.handshake_s,
                    ssl_shutdown_timeout=SHUTDOWN_S,
                )
            else:
                await doorway.loop.connect_accepted_socket(lambda: doorway.plain(self), self._connection)
        except OSError:
            # No TLS that we speak, a certificate that is not trusted, or gone: ssl.SSLError and TimeoutError, too.
            doorway.visitors.refused["handshake"] += 1
        finally:
            self._end()

    def _end(self) -> None:
        self._timer.cancel()
        self._doorway.visitors.leave(self)
        self._doorway.forget(self)
