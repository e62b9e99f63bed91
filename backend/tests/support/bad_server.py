"""A server of tiles as bad as told: cuts, lies about sizes, says 429; sockets by hand, so that it can."""

from __future__ import annotations

import socket
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

Answer = Callable[[socket.socket, bytes], None]
"""Answers with these bytes of a tile, somehow."""


class BadServer:
    """`plan(number, path)`: how the request with this number, from 0, is answered; None: as a good server does.

    `tile(path)`: the bytes of a tile; None: there is none (404).
    """

    def __init__(self, tile: Callable[[str], bytes | None]) -> None:
        self.tile = tile
        self.plan: Callable[[int, str], Answer | None] = lambda _number, _path: None
        self.paths: list[str] = []
        self.good: Counter[str] = Counter()
        self._lock = threading.Lock()
        self._listening = socket.create_server(("127.0.0.1", 0))
        self._closing = False

    @property
    def base(self) -> str:
        """Its address."""
        return f"http://127.0.0.1:{self._listening.getsockname()[1]}"

    def run(self) -> None:
        """Answer until it is closed, a thread for each connection."""
        while not self._closing:
            try:
                connection, _ = self._listening.accept()
            except OSError:
                return
            threading.Thread(target=self._serve, args=(connection,), daemon=True).start()

    def close(self) -> None:
        """Stop."""
        self._closing = True
        with suppress(OSError):
            self._listening.shutdown(socket.SHUT_RDWR)
        self._listening.close()

    def _serve(self, connection: socket.socket) -> None:
        with connection, suppress(OSError):
            head = b""
            while b"\r\n\r\n" not in head:
                got = connection.recv(4096)
                if not got:
                    return
                head += got
            path = head.split(b" ", 2)[1].decode()
            with self._lock:
                number = len(self.paths)
                self.paths.append(path)
            data = self.tile(path)
            answer = self.plan(number, path)
            if data is None:
                connection.sendall(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
                return
            if answer is None:
                with self._lock:
                    self.good[path] += 1
                answer = well
            answer(connection, data)


def well(connection: socket.socket, data: bytes) -> None:
    """As it should be."""
    connection.sendall(_head(len(data)) + data)


def cut_in_head(connection: socket.socket, _data: bytes) -> None:
    """Cut before there is an answer."""
    connection.sendall(b"HTTP/1.1 200")


def cut_in_body(connection: socket.socket, data: bytes) -> None:
    """Cut in the middle of the tile."""
    connection.sendall(_head(len(data)) + data[: len(data) // 2])


def says_too_short(connection: socket.socket, data: bytes) -> None:
    """A length shorter than the tile: a client that believes it has half a tile and no error."""
    connection.sendall(_head(len(data) // 2) + data)


def says_huge(connection: socket.socket, data: bytes) -> None:
    """A length that no tile has."""
    connection.sendall(_head(10**12) + data)


def refuses_for_now(connection: socket.socket, _data: bytes) -> None:
    """429, and when to come again."""
    connection.sendall(
        b"HTTP/1.1 429 Too Many Requests\r\nRetry-After: 0\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
    )


def refuses_for_a_second(connection: socket.socket, _data: bytes) -> None:
    """503, and when to come again."""
    connection.sendall(b"HTTP/1.1 503 Busy\r\nRetry-After: 1\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")


def fails(connection: socket.socket, _data: bytes) -> None:
    """An error of its own."""
    connection.sendall(b"HTTP/1.1 500 Oops\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")


def answers_a_page(connection: socket.socket, _data: bytes) -> None:
    """A page in the tile's place, as the doorway of a hotel's network does."""
    well(connection, b"<html>Welcome to our WLAN</html>")


def _head(length: int) -> bytes:
    return f"HTTP/1.1 200 OK\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n".encode()


@contextmanager
def bad_server(tile: Callable[[str], bytes | None]) -> Iterator[BadServer]:
    """A running one."""
    server = BadServer(tile)
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    try:
        yield server
    finally:
        server.close()
        thread.join()
