"""The web server around the application."""

from __future__ import annotations

import asyncio
import contextlib
import signal
import socket
import sys
from functools import partial
from typing import Any, Final, cast

import structlog
import uvicorn

from epf_gcs.listening import listen
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
                create_app(settings, self.visitors),
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

    def serve_until_signal(self) -> None:
        """Raises LinkError where the port cannot be taken; nothing else was begun then."""
        sys.setswitchinterval(_SWITCH_INTERVAL_S)
        self.visitors.limits = fitting(self.visitors.limits, raise_descriptors())
        with self._listener() as listener:
            self.run([listener])

    def _listener(self) -> socket.socket:
        if self._settings.fd is None:
            return listen(self._settings.host, self._settings.port)
        return socket.socket(fileno=self._settings.fd)

    async def serve(self, sockets: list[Any] | None = None) -> None:
        """Run until a signal."""
        with contextlib.suppress(NotImplementedError, RuntimeError, ValueError):
            asyncio.get_running_loop().add_signal_handler(signal.SIGHUP, self._hang_up)
        looking = asyncio.create_task(watch(self.visitors, self._look_every_s))
        try:
            await super().serve(sockets)
        finally:
            looking.cancel()

    async def _serve(self, sockets: list[Any] | None = None) -> None:
        await super()._serve(sockets)
        # uvicorn would send itself the signal again, and end by it: who asks for a polite end is answered with 0.
        self._captured_signals.clear()

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
