"""A tile server on the loopback that records its requests and answers as configured."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from tests.support.maps import png


class TileServer:
    """`url`: the address an operator enters. While the event `hold` is not set, answers are held back."""

    def __init__(self) -> None:
        self.paths: list[str] = []
        self.agents: set[str] = set()
        self.conditions: list[str | None] = []
        self.status = 200
        self.body = png(7)
        self.headers: dict[str, str] = {"Cache-Control": "max-age=3600", "ETag": '"one"'}
        self.hold = threading.Event()
        self.hold.set()
        self.at_once = 0
        self.most_at_once = 0
        self._lock = threading.Lock()
        self.server = ThreadingHTTPServer(("127.0.0.1", 0), self._handler())

    @property
    def url(self) -> str:
        """The URL template of its tiles."""
        return f"http://127.0.0.1:{self.server.server_address[1]}/{{z}}/{{x}}/{{y}}.png"

    def _handler(self) -> type[BaseHTTPRequestHandler]:
        outer = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                outer.answer(self)

            def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - the base class's name
                """The requests are counted, not printed."""

        return Handler

    def answer(self, request: BaseHTTPRequestHandler) -> None:
        """Answer one request."""
        with self._lock:
            self.paths.append(request.path)
            self.agents.add(request.headers.get("User-Agent", ""))
            self.conditions.append(request.headers.get("If-None-Match"))
            self.at_once += 1
            self.most_at_once = max(self.most_at_once, self.at_once)
        self.hold.wait(20)
        with self._lock:
            self.at_once -= 1
        request.send_response(self.status)
        for name, value in self.headers.items():
            request.send_header(name, value)
        body = b"" if self.status in (204, 304) else self.body
        request.send_header("Content-Length", str(len(body)))
        request.end_headers()
        request.wfile.write(body)


@contextmanager
def tile_server() -> Iterator[TileServer]:
    """A running tile server."""
    server = TileServer()
    thread = threading.Thread(target=server.server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True)
    thread.start()
    try:
        yield server
    finally:
        server.hold.set()
        server.server.shutdown()
        server.server.server_close()
        thread.join()
