"""A page as a browser keeps it: everything that comes is acknowledged at once, whatever the test does meanwhile."""

from __future__ import annotations

import queue
import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import httpx
import orjson
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from tests.support.waiting import DEADLINE_S, first_of


class Page:
    """Reads in a thread. `hangs`: what comes is taken, but not acknowledged, as by a page that is stuck."""

    def __init__(self, connection: ClientConnection, base: str, headers: dict[str, str]) -> None:
        self.connection = connection
        self.hangs = False
        self.closed: tuple[int, str] | None = None
        self.hello: dict[str, Any] = orjson.loads(self.connection.recv(timeout=DEADLINE_S))
        self.client: str = self.hello["client"]
        self.http = httpx.Client(
            base_url=f"{base}/api/v1", headers={**headers, "X-Client": self.client}, timeout=DEADLINE_S
        )
        self._told: queue.Queue[tuple[str, dict[str, Any]]] = queue.Queue()
        self._unacknowledged: int | None = None
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def act(self, action: str, **others: Any) -> httpx.Response:
        """POST /control for this page."""
        return self.http.post("/control", json={"client": self.client, "action": action, **others})

    def event(self, kind: str) -> dict[str, Any]:
        """The data of the next event of this kind."""
        return first_of(
            lambda: self._told.get(timeout=DEADLINE_S),
            lambda told: told[1] if told[0] == kind else None,
            f"an event '{kind}'",
        )

    def unread(self) -> list[str]:
        """The kinds of the events that nobody asked for yet."""
        return [name for name, _ in list(self._told.queue)]

    def send(self, message: dict[str, Any]) -> None:
        """Send a message."""
        self.connection.send(orjson.dumps(message).decode())

    def wake(self) -> None:
        """Go on after it hung."""
        self.hangs = False
        if self._unacknowledged is not None:
            self.send({"type": "ack", "seq": self._unacknowledged})

    def wait_closed(self) -> tuple[int, str]:
        """Wait until the station closes the stream; its code and reason."""
        self._thread.join(DEADLINE_S)
        assert self.closed is not None, "the stream is open still"
        return self.closed

    def close(self) -> None:
        """Close the page."""
        self.connection.close()
        self.http.close()
        self._thread.join(DEADLINE_S)

    def _read(self) -> None:
        try:
            while True:
                message = orjson.loads(self.connection.recv())
                if message["type"] == "event":
                    self._told.put((message["event"], message["data"]))
                elif message["type"] == "batch":
                    self._unacknowledged = message["seq"]
                    if not self.hangs:
                        self.send({"type": "ack", "seq": message["seq"]})
        except ConnectionClosed as error:
            self.closed = (error.rcvd.code, error.rcvd.reason) if error.rcvd is not None else (1006, "")


@contextmanager
def page(
    base: str, path: str = "/api/v1/stream", key: str | None = None, line: int | None = None, cookie: str | None = None
) -> Iterator[Page]:
    """A page that is closed at the end. `base`: address of the station; `key`: of a program; `line`: port to go through
    in place of the station's own; `cookie`: of a person's session."""
    url = httpx.URL(base)
    headers = {} if key is None else {"Authorization": f"Bearer {key}"}
    if cookie is not None:
        headers["Cookie"] = cookie
    through = socket.create_connection(("127.0.0.1", line or url.port or 80))
    address = f"ws://{url.netloc.decode()}{path}"
    with connect(address, sock=through, additional_headers=headers, max_size=None) as connection:
        made = Page(connection, base, headers)
        # A page of which nothing was heard yet only loads: to the station its line is not cut, whatever the test does.
        assert connection.ping().wait(DEADLINE_S), "the station does not answer"
        try:
            yield made
        finally:
            made.close()


class CutLine:
    """A line between a page and the station that can be cut as a radio is: nothing comes through, nothing is closed."""

    def __init__(self, port: int) -> None:
        self._listening = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listening.getsockname()[1]
        self._to = port
        self._flows = threading.Event()
        self._flows.set()
        self._sockets: list[socket.socket] = []
        threading.Thread(target=self._accept, daemon=True).start()

    def cut(self) -> None:
        """Nothing comes through from now on."""
        self._flows.clear()

    def mend(self) -> None:
        """What waited comes through, and all that follows."""
        self._flows.set()

    def close(self) -> None:
        """End all of it."""
        self._listening.close()
        self._flows.set()
        for one in self._sockets:
            one.close()

    def _accept(self) -> None:
        try:
            while True:
                near, _ = self._listening.accept()
                far = socket.create_connection(("127.0.0.1", self._to))
                self._sockets += [near, far]
                for source, sink in ((near, far), (far, near)):
                    threading.Thread(target=self._pump, args=(source, sink), daemon=True).start()
        except OSError:
            pass

    def _pump(self, source: socket.socket, sink: socket.socket) -> None:
        try:
            while data := source.recv(65536):
                self._flows.wait()
                sink.sendall(data)
            sink.shutdown(socket.SHUT_WR)
        except OSError:
            pass
