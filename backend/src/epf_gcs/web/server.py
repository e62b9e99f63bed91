"""The web server around the application."""

from __future__ import annotations

import asyncio
import contextlib
import signal
import socket
import sys
from typing import Any, Final, cast

import structlog
import uvicorn

from epf_gcs.listening import listen
from epf_gcs.web.app import create_app
from epf_gcs.web.settings import Settings
from epf_gcs.web.stream.socket import SocketConnection

# A thread that writes a recording or reads a download gives way to the event loop within this time.
_SWITCH_INTERVAL_S: Final = 0.0002

log = structlog.get_logger("gateway")


class Server(uvicorn.Server):
    """uvicorn with our WebSocket connections; also a lost terminal ends it as it should."""

    def __init__(self, settings: Settings) -> None:
        super().__init__(
            uvicorn.Config(
                create_app(settings),
                loop="auto",
                http="httptools",
                ws=cast(Any, SocketConnection),
                lifespan="on",
                access_log=False,
                log_config=None,
                server_header=False,
                # A download or a slow browser does not keep the board waiting for its farewell.
                timeout_graceful_shutdown=2,
            )
        )
        self._settings = settings

    def serve_until_signal(self) -> None:
        """Raises LinkError where the port cannot be taken; nothing else was begun then."""
        sys.setswitchinterval(_SWITCH_INTERVAL_S)
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
        await super().serve(sockets)

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
