"""The web server around the application."""

from __future__ import annotations

import asyncio
import contextlib
import errno
import signal
import socket
import sys
from functools import partial
from typing import Any, Final, cast

import structlog
import uvicorn

from epf_gcs.errors import LinkError
from epf_gcs.web.app import create_app
from epf_gcs.web.connection import Connection, watch
from epf_gcs.web.settings import Settings
from epf_gcs.web.stream.socket import SocketConnection
from epf_gcs.web.visitors import Limits, Visitors, fitting, raise_descriptors

# A thread that writes a recording or reads a download gives way to the event loop within this time.
_SWITCH_INTERVAL_S: Final = 0.0002

log = structlog.get_logger("gateway")


class Server(uvicorn.Server):
    """uvicorn with our connections and their limits; also a lost terminal ends it as it should."""

    def __init__(self, settings: Settings, limits: Limits | None = None, look_every_s: float = 1.0) -> None:
        self.visitors = Visitors(limits or Limits())
        self._look_every_s = look_every_s
        super().__init__(
            uvicorn.Config(
                create_app(settings),
                loop="auto",
                http=cast(Any, partial(Connection, self.visitors)),
                ws=cast(Any, SocketConnection),
                lifespan="on",
                access_log=False,
                log_config=None,
                server_header=False,
                timeout_keep_alive=self.visitors.limits.idle_s,
                # A download or a slow browser does not keep the board waiting for its farewell.
                timeout_graceful_shutdown=2,
            )
        )
        self._settings = settings

    def fly(self) -> None:
        """Run until a signal. Raises LinkError where the port cannot be taken; nothing else was begun then."""
        sys.setswitchinterval(_SWITCH_INTERVAL_S)
        self.visitors.limits = fitting(self.visitors.limits, raise_descriptors())
        with listen(self._settings.host, self._settings.port) as listener:
            self.run([listener])

    async def serve(self, sockets: list[Any] | None = None) -> None:
        """Run until a signal."""
        with contextlib.suppress(NotImplementedError, RuntimeError, ValueError):
            asyncio.get_running_loop().add_signal_handler(signal.SIGHUP, self._hang_up)
        looking = asyncio.create_task(watch(self.visitors, self._look_every_s))
        try:
            await super().serve(sockets)
        finally:
            looking.cancel()

    async def startup(self, sockets: list[Any] | None = None) -> None:
        """Begin to listen, and say where."""
        await super().startup(sockets)
        if self.started:
            host = f"[{self._settings.host}]" if ":" in self._settings.host else self._settings.host
            log.info("listening", url=f"http://{host}:{self.port}")

    @property
    def port(self) -> int:
        """The port that was taken."""
        return int(self.servers[0].sockets[0].getsockname()[1])

    def _hang_up(self) -> None:
        self.should_exit = True


def listen(host: str, port: int) -> socket.socket:
    """A listening socket. Raises LinkError with what to do where there can be none."""
    try:
        return socket.create_server((host, port), family=socket.AF_INET6 if ":" in host else socket.AF_INET)
    except socket.gaierror as error:
        raise LinkError(
            "listen_unknown_host", f"'{host}' is no address of this machine: choose another with --host.", host=host
        ) from error
    except OSError as error:
        reasons = {
            errno.EADDRINUSE: "is taken by another program: close that program, or choose another with --port",
            errno.EACCES: "is not for this user: choose one above 1023 with --port",
            errno.EADDRNOTAVAIL: "is at no address of this machine: choose another with --host",
        }
        reason = reasons.get(error.errno or 0, f"cannot be taken ({error.strerror}): choose another with --port")
        raise LinkError("listen_failed", f"TCP port {port} of {host} {reason}.", host=host, port=port) from error
