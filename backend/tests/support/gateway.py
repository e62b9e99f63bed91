"""The whole gateway in this process: flight and web as two threads, a real server on a free port, real sockets."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, cast

import httpx
import orjson
from websockets.sync.client import ClientConnection

from epf_gcs.flight.flight import Flight
from epf_gcs.logs import set_up_logging
from epf_gcs.shares.table import SHARES, Shares
from epf_gcs.web.server import Server
from epf_gcs.web.serving.settings import Settings
from epf_gcs.web.serving.visitors import Limits
from tests.support.tls import connected, trust_in
from tests.support.waiting import DEADLINE_S, eventually, first_of


class FlightThread:
    """A flight process as a thread with its own event loop."""

    def __init__(self, data_dir: Path, **options: Any) -> None:
        self.loop = asyncio.new_event_loop()
        self.data_dir = data_dir
        self._options = options
        self._ready = threading.Event()
        self._end = asyncio.Event()
        self._thread = threading.Thread(target=self._run, name="flight", daemon=True)
        self.flight: Flight | None = None

    def start(self) -> None:
        """Start it and wait until its socket is open."""
        self._thread.start()
        assert self._ready.wait(DEADLINE_S), "the flight does not start"

    def stop(self) -> None:
        """Stop it as SIGTERM would."""
        self.loop.call_soon_threadsafe(self._end.set)
        self._thread.join(DEADLINE_S)
        assert not self._thread.is_alive(), "the flight did not end"

    def _run(self) -> None:
        asyncio.set_event_loop(self.loop)
        self.loop.run_until_complete(self._fly())
        self.loop.run_until_complete(self.loop.shutdown_default_executor())
        self.loop.close()

    async def _fly(self) -> None:
        self.flight = Flight(self.data_dir, **self._options)
        async with self.flight.running():
            self._ready.set()
            await self._end.wait()


class Gateway:
    """A running gateway and a client of it."""

    def __init__(self, server: Server, flight: FlightThread) -> None:
        self.server = server
        self.flight_thread = flight
        # Under TLS: a browser that trusts what the station shows.
        self.trust = None if server.certificates is None else trust_in(server.certificates)
        self.base = f"{'http' if self.trust is None else 'https'}://127.0.0.1:{server.port}"
        self.http = httpx.Client(base_url=f"{self.base}/api/v1", timeout=DEADLINE_S, verify=self.trust or True)

    @property
    def flight(self) -> Flight:
        """The parts of the flight process; only to be read."""
        assert self.flight_thread.flight is not None
        return self.flight_thread.flight

    @property
    def web(self) -> Any:
        """The parts of the web process by name; only to be read."""
        return cast(Any, self.server.config.app).state

    def status(self) -> dict[str, Any]:
        """GET /status."""
        return cast(dict[str, Any], self.http.get("/status").raise_for_status().json())

    def open_board(self, url: str) -> None:
        """Open the board's link and wait until commands work."""
        self.http.put("/links/board", json={"url": url}).raise_for_status()
        eventually(lambda: self.status()["board"]["state"] == "open", "the board opens")

    @contextmanager
    def stream(self, query: str = "") -> Iterator[Stream]:
        """Connect to the stream like a browser."""
        address = f"{self.base.replace('http', 'ws')}/api/v1/stream{query}"
        with connected(address, self.trust) as connection:
            yield Stream(connection)


class Stream:
    """A browser's end of the stream; batches are acknowledged unless told otherwise."""

    def __init__(self, connection: ClientConnection) -> None:
        self.connection = connection
        # A replay that takes long says so before.
        self.hello = first_of(self.receive, lambda told: None if told["type"] == "opening" else told, "a hello")

    def receive(self) -> dict[str, Any]:
        """The next message."""
        return cast(dict[str, Any], orjson.loads(self.connection.recv(timeout=DEADLINE_S)))

    def send(self, message: dict[str, Any]) -> None:
        """Send a message to the gateway."""
        self.connection.send(orjson.dumps(message).decode())

    def acknowledge(self, batch: dict[str, Any]) -> None:
        """Acknowledge this batch."""
        self.send({"type": "ack", "seq": batch["seq"]})

    def next(self, kind: str) -> dict[str, Any]:
        """The next message of this kind; batches before it are acknowledged."""
        return self._first(lambda message: message if message["type"] == kind else None, f"a message '{kind}'")

    def event(self, kind: str) -> dict[str, Any]:
        """The data of the next event of this kind."""
        return self._first(
            lambda message: message["data"] if message["type"] == "event" and message["event"] == kind else None,
            f"an event '{kind}'",
        )

    def sample(self, topic: str) -> dict[str, Any]:
        """The values of the next sample of this topic."""

        def values(message: dict[str, Any]) -> dict[str, Any] | None:
            samples = message["samples"] if message["type"] == "batch" else ()
            return next((sample["values"] for sample in samples if sample["topic"] == topic), None)

        return self._first(values, f"a sample of '{topic}'")

    def _first(self, found: Callable[[dict[str, Any]], dict[str, Any] | None], what: str) -> dict[str, Any]:
        """What `found` makes of the first message that it knows; batches up to it are acknowledged."""

        def receive() -> dict[str, Any]:
            message = self.receive()
            if message["type"] == "batch":
                self.acknowledge(message)
            return message

        return first_of(receive, found, what)


@contextmanager
def running_gateway(
    data_dir: Path,
    limits: Limits | None = None,
    *,
    shares: Shares = SHARES,
    recording: bool = True,
    board: str | None = None,
    **settings: Any,
) -> Iterator[Gateway]:
    """A running gateway, stopped at the end as by SIGTERM. With `limits`, it checks them more often than normal."""
    set_up_logging(verbose=False)
    flight = FlightThread(data_dir, record=recording, board_url=board)
    flight.start()
    chosen = Settings(data_dir=data_dir, port=0, **settings)
    server = Server(chosen, limits, look_every_s=1.0 if limits is None else 0.02, shares=shares)
    thread = threading.Thread(target=server.serve_until_signal, name="web", daemon=True)
    thread.start()
    # Under TLS uvicorn has "started" a moment before the doorway listens.
    eventually(lambda: (server.started and bool(server.servers)) or not thread.is_alive(), "the gateway starts")
    gateway = Gateway(server, flight)
    try:
        yield gateway
    finally:
        gateway.http.close()
        server.should_exit = True
        thread.join(DEADLINE_S)
        gateway.flight_thread.stop()
        assert not thread.is_alive(), "the gateway did not end"
