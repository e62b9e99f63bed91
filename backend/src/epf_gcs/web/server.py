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
from uvicorn.server import ServerState

from epf_gcs.data_folder.whereabouts import Whereabouts, leave, take_back
from epf_gcs.listening import listen
from epf_gcs.repeating import keep_alive
from epf_gcs.shares.table import SHARES, Shares, fitting
from epf_gcs.system.limits import raise_open_files
from epf_gcs.tls.keeper import Keeper
from epf_gcs.watchdog import feed
from epf_gcs.web.app import create_app
from epf_gcs.web.serving.certificates import keeper_of
from epf_gcs.web.serving.connection import Connection, watch
from epf_gcs.web.serving.doorway import Doorway, Factory
from epf_gcs.web.serving.redirect import Redirect
from epf_gcs.web.serving.settings import Settings
from epf_gcs.web.serving.visitors import Limits, Visitors
from epf_gcs.web.stream.socket import SocketConnection

# How long another thread (one that reads a download) may hold the interpreter while the event loop waits for it.
_SWITCH_INTERVAL_S: Final = 0.0002

log = structlog.get_logger("gateway")


class Server(uvicorn.Server):
    """uvicorn with our connections and their limits; SIGHUP, as from a closed terminal, also shuts it down cleanly."""

    def __init__(
        self, settings: Settings, limits: Limits | None = None, look_every_s: float = 1.0, shares: Shares = SHARES
    ) -> None:
        self.visitors = Visitors(limits, shares)
        self._look_every_s = look_every_s
        self.certificates = keeper_of(settings)
        self._app = create_app(settings, self.visitors, self.certificates)
        super().__init__(
            self._config(self._app, ws=cast(Any, SocketConnection), lifespan="on", headers=self._headers())
        )
        self._settings = settings
        self._fed: asyncio.Task[None] | None = None

    def serve_until_signal(self) -> None:
        """Run until a signal. Raises LinkError before anything else is started if the port cannot be taken."""
        sys.setswitchinterval(_SWITCH_INTERVAL_S)
        self.visitors.share(fitting(self.visitors.shares, raise_open_files()))
        with self._listener() as listener:
            secure = self.certificates is not None
            port = listener.getsockname()[1]
            self._app.state.admission.listen_at(port, secure=secure)
            found = Whereabouts(self._settings.host, port, secure)
            self._leave_whereabouts(found)
            try:
                self.run([listener])
            finally:
                take_back(self._settings.data_dir, found)

    def _leave_whereabouts(self, found: Whereabouts) -> None:
        try:
            leave(self._settings.data_dir, found)
        except OSError as error:
            # Only those who make an invitation by the command line have to name the port then.
            log.warning("where it listens could not be written", why=error.strerror)

    def _listener(self) -> socket.socket:
        if self._settings.fd is None:
            return listen(self._settings.host, self._settings.port)
        listener = socket.socket(fileno=self._settings.fd)
        # It was handed down to us, and would be to every worker: one that outlives us would keep the port.
        listener.set_inheritable(False)
        return listener

    async def serve(self, sockets: list[Any] | None = None) -> None:
        """Run until a signal."""
        if sys.platform != "win32":
            with contextlib.suppress(RuntimeError, ValueError):  # not in the main thread
                asyncio.get_running_loop().add_signal_handler(signal.SIGHUP, self._hang_up)
        jobs = [asyncio.create_task(watch(self.visitors, self._look_every_s))]
        if self.certificates is not None:
            keeping = keep_alive("web", "certificates", self.certificates.keep, lambda: None)
            jobs.append(asyncio.create_task(keeping))
        try:
            await super().serve(sockets)
        finally:
            for job in jobs:
                job.cancel()

    async def _serve(self, sockets: list[Any] | None = None) -> None:
        await super()._serve(sockets)
        # uvicorn would raise the signal again and die of it; a requested end shall have exit status 0.
        self._captured_signals.clear()

    async def startup(self, sockets: list[Any] | None = None) -> None:
        """Start listening and feeding the parent's watchdog, and log the address."""
        if self.certificates is None:
            await super().startup(sockets)
        else:
            await super().startup([])
            self.servers = [cast(Any, self._doorway(one, self.certificates)) for one in sockets or [] if self.started]
        if self.started:
            host = f"[{self._settings.host}]" if ":" in self._settings.host else self._settings.host
            if self._settings.watchdog is not None:
                self._fed = asyncio.create_task(feed(self._settings.watchdog))
                await asyncio.sleep(0)  # its first sign of life comes before the log says that it listens
            scheme = "http" if self.certificates is None else "https"
            log.info("listening", url=f"{scheme}://{host}:{self.port}")

    def _doorway(self, listener: socket.socket, certificates: Keeper) -> Doorway:
        # Ended together with the others, but without their headers: HSTS must not come in plain text (RFC 6797, 7.2).
        plain_state = ServerState()
        plain_state.connections, plain_state.tasks = self.server_state.connections, self.server_state.tasks

        def factory(config: uvicorn.Config, state: ServerState) -> Factory:
            if not config.loaded:
                config.load()
            return lambda arrival: cast(Any, config.http_protocol_class)(
                config=config, server_state=state, app_state=self.lifespan.state, arrival=arrival
            )

        plain = self._config(Redirect(self._app.state.access), ws="none", lifespan="off")
        return Doorway(
            listener,
            lambda: certificates.context,
            factory(self.config, self.server_state),
            factory(plain, plain_state),
            visitors=self.visitors,
        )

    def _config(self, app: Any, **more: Any) -> uvicorn.Config:
        return uvicorn.Config(
            app,
            loop="epf_gcs.system.threaded_loop:new_loop_with_programs",
            http=cast(Any, partial(Connection, self.visitors)),
            access_log=False,
            log_config=None,
            server_header=False,
            timeout_keep_alive=self.visitors.limits.idle_s,
            # Do not let a download or a slow browser delay the shutdown.
            timeout_graceful_shutdown=2,
            **more,
        )

    def _headers(self) -> list[tuple[str, str]]:
        """HSTS only for a brought certificate: a browser that heard it lets nobody pass a warning, which would shut out
        a phone that does not trust the station's own authority yet. A day, for it holds for every port of the name.
        """
        if self.certificates is None or self.certificates.in_use.kind == "made":
            return []
        return [("Strict-Transport-Security", "max-age=86400")]

    @property
    def port(self) -> int:
        """The port in use."""
        return int(self.servers[0].sockets[0].getsockname()[1])

    def _hang_up(self) -> None:
        self.should_exit = True
