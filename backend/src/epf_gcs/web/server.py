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
from epf_gcs.watchdog import feed
from epf_gcs.web.app import create_app
from epf_gcs.web.connection import Connection, watch
from epf_gcs.web.settings import Settings
from epf_gcs.web.stream.socket import SocketConnection
from epf_gcs.web.visitors import Limits, Visitors, fitting, raise_descriptors

# How long another thread (one that reads a download) may hold the interpreter while the event loop waits for it.
_SWITCH_INTERVAL_S: Final = 0.0002

log = structlog.get_logger("gateway")


class Server(uvicorn.Server):
    """uvicorn with our connections and their limits; SIGHUP, as from a closed terminal, also shuts it down cleanly."""

    def __init__(self, settings: Settings, limits: Limits | None = None, look_every_s: float = 1.0) -> None:
        self.visitors = Visitors(limits or Limits())
        self._look_every_s = look_every_s
        self._app = create_app(settings, self.visitors)
        super().__init__(
            uvicorn.Config(
                self._app,
                loop="auto",
                http=cast(Any, partial(Connection, self.visitors)),
                ws=cast(Any, SocketConnection),
                lifespan="on",
                access_log=False,
                log_config=None,
                server_header=False,
                timeout_keep_alive=self.visitors.limits.idle_s,
                # Do not let a download or a slow browser delay the shutdown.
                timeout_graceful_shutdown=2,
            )
        )
        self._settings = settings
        self._fed: asyncio.Task[None] | None = None

    def serve_until_signal(self) -> None:
        """Run until a signal. Raises LinkError before anything else is started if the port cannot be taken."""
        sys.setswitchinterval(_SWITCH_INTERVAL_S)
        self.visitors.limits = fitting(self.visitors.limits, raise_descriptors())
        with self._listener() as listener:
            self._app.state.admission.listen_at(listener.getsockname()[1])
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
        # uvicorn would raise the signal again and die of it; a requested end shall have exit status 0.
        self._captured_signals.clear()

    async def startup(self, sockets: list[Any] | None = None) -> None:
        """Start listening and feeding the parent's watchdog, and log the address."""
        await super().startup(sockets)
        if self.started:
            host = f"[{self._settings.host}]" if ":" in self._settings.host else self._settings.host
            if self._settings.watchdog is not None:
                self._fed = asyncio.create_task(feed(self._settings.watchdog))
                await asyncio.sleep(0)  # its first sign of life comes before the log says that it listens
            log.info("listening", url=f"http://{host}:{self.port}")

    @property
    def port(self) -> int:
        """The port in use."""
        return int(self.servers[0].sockets[0].getsockname()[1])

    def _hang_up(self) -> None:
        self.should_exit = True
