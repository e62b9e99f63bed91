"""How a station finds a vehicle's stream: a small file in the data folder names a socket of this machine.

It is a Unix socket that only its owner may open. Where the system has none (Windows), it is TCP on the loopback, with
a secret that only a reader of the file knows.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import os
import secrets
import socket
import tempfile
from pathlib import Path
from typing import Any, Final

import orjson

from epf_gcs.system.sockets import HAS_LOCAL, bound_for_owner, local_socket

FILE: Final = "flight.json"
_SOCKET: Final = "flight.sock"
# The kernel's limit for the path of a Unix socket is 108 bytes, 104 on macOS.
_LONGEST_PATH: Final = 100
_SECRET_BYTES: Final = 32


class Listener:
    """The vehicle's listening socket, and the file that names it."""

    def __init__(self, folder: Path) -> None:
        """Listen in this folder. Raises OSError."""
        folder.mkdir(parents=True, exist_ok=True)
        self._file = folder / FILE
        self._path: Path | None = None
        self.secret = b""
        where: dict[str, Any]
        if HAS_LOCAL:
            self._path = _socket_path(folder)
            self._path.unlink(missing_ok=True)
            self.socket = bound_for_owner(self._path)
            where = {"unix": str(self._path)}
        else:
            self.socket = socket.create_server(("127.0.0.1", 0))
            self.secret = secrets.token_bytes(_SECRET_BYTES)
            where = {"tcp": self.socket.getsockname()[1], "secret": self.secret.hex()}
        self.socket.listen(16)
        self.socket.setblocking(False)
        temporary = self._file.with_suffix(".new")
        temporary.touch(mode=0o600)
        temporary.write_bytes(orjson.dumps({**where, "pid": os.getpid()}))
        temporary.replace(self._file)

    async def accept(self) -> socket.socket | None:
        """The next connection; None if it did not send the secret. Raises OSError."""
        loop = asyncio.get_running_loop()
        connection, _ = await loop.sock_accept(self.socket)
        connection.setblocking(False)
        if not self.secret:
            return connection
        try:
            async with asyncio.timeout(1.0):
                said = b""
                while len(said) < _SECRET_BYTES and (more := await loop.sock_recv(connection, _SECRET_BYTES)):
                    said += more
        except (OSError, TimeoutError):
            said = b""
        if hmac.compare_digest(said, self.secret):
            return connection
        connection.close()
        return None

    def close(self) -> None:
        """Stop listening. The file stays: the next vehicle overwrites it."""
        self.socket.close()
        if self._path is not None:
            with contextlib.suppress(OSError):
                self._path.unlink()


async def connect(folder: Path) -> socket.socket:
    """A connection to the vehicle of this data folder. Raises OSError or ValueError if there is none."""
    where = orjson.loads((folder / FILE).read_bytes())
    loop = asyncio.get_running_loop()
    if "unix" in where:
        connection = local_socket()
        target: Any = where["unix"]
    else:
        connection = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        target = ("127.0.0.1", int(where["tcp"]))
    try:
        connection.setblocking(False)
        await loop.sock_connect(connection, target)
        if "secret" in where:
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            await loop.sock_sendall(connection, bytes.fromhex(where["secret"]))
    except BaseException:
        connection.close()
        raise
    return connection


def _socket_path(folder: Path) -> Path:
    path = folder.absolute() / _SOCKET
    if len(os.fsencode(path)) <= _LONGEST_PATH:
        return path
    return Path(tempfile.mkdtemp(prefix="epf-gcs-")) / _SOCKET
