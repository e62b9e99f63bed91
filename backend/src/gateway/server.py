"""The web server around the application."""

from __future__ import annotations

import asyncio
import contextlib
import signal
from typing import Any, cast

import structlog
import uvicorn

from gateway.api.socket import SocketConnection
from gateway.app import create_app
from gateway.settings import Settings

log = structlog.get_logger("gateway")


class Server(uvicorn.Server):
    """uvicorn with our WebSocket connections; also a lost terminal ends it as it should."""

    def __init__(self, settings: Settings) -> None:
        super().__init__(
            uvicorn.Config(
                create_app(settings),
                host=settings.host,
                port=settings.port,
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

    async def serve(self, sockets: list[Any] | None = None) -> None:
        """Run until a signal."""
        with contextlib.suppress(NotImplementedError, RuntimeError, ValueError):
            asyncio.get_running_loop().add_signal_handler(signal.SIGHUP, self._hang_up)
        await super().serve(sockets)

    async def startup(self, sockets: list[Any] | None = None) -> None:
        """Begin to listen, and say where."""
        await super().startup(sockets)
        if self.started:
            log.info("listening", url=f"http://{self.config.host}:{self.port}")

    @property
    def port(self) -> int:
        """The port that was taken."""
        return int(self.servers[0].sockets[0].getsockname()[1])

    def _hang_up(self) -> None:
        self.should_exit = True
