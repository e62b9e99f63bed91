"""A flight of the real board program with the embedded simulator, through the gateway's two processes, and all that a
client of the live stream kept of it."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import orjson
from websockets.sync.client import ClientConnection, connect

from tests.support.firmware import make
from tests.support.ports import free_udp_port
from tests.support.programs import Program, board_process, gateway_process
from tests.support.waiting import DEADLINE_S, eventually

# Told by both, from the bytes or from the notes; the others are of the station and not of the vehicle.
EVENTS = {"alarm", "board_restarted", "command", "console", "control", "link", "mission", "parameter"}


class Kept:
    """All that a stream brought: samples and events, in the order of their coming."""

    def __init__(self) -> None:
        self.samples: dict[str, list[tuple[float, Any]]] = {}
        self.events: list[tuple[str, float, Any]] = []
        self.missed = 0
        self.state: str | None = None
        self.client: str | None = None
        self.is_recorded: bool | None = None

    def lacks(self, other: Kept) -> bool:
        """Whether it has fewer samples of any topic, or fewer events of the other's recording."""
        return len(recorded(self.events, other)) < len(recorded(other.events, other)) or any(
            len(self.samples.get(topic, ())) < len(samples) for topic, samples in other.samples.items()
        )

    def take(self, connection: ClientConnection) -> None:
        """Keep the next message."""
        message = orjson.loads(connection.recv(timeout=DEADLINE_S))
        match message["type"]:
            case "batch":
                self.missed += message["missed"] + message["missed_events"]
                for one in message["samples"]:
                    self.samples.setdefault(one["topic"], []).append((one["t_s"], one["values"]))
                connection.send(orjson.dumps({"type": "ack", "seq": message["seq"]}).decode())
            case "event" if message["event"] in EVENTS:
                self.events.append((message["event"], message["t_s"], message["data"]))
            case "hello":
                self.client = message["client"]
            case "status":
                self.is_recorded = message["data"]["recording"]["active"]
            case "playback":
                self.state = message["state"]


class Client:
    """A client of the live stream, from before the lines are opened on."""

    def __init__(self, url: str) -> None:
        self.kept = Kept()
        self._address = f"{url.replace('http', 'ws')}/api/v1/stream?rate=0"
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        with connect(self._address, max_size=None) as connection:
            while not self._end.is_set():
                self.kept.take(connection)

    def stop(self) -> Kept:
        self._end.set()
        self._thread.join(DEADLINE_S)
        assert not self._thread.is_alive(), "the stream fell silent"
        return self.kept


def recorded(events: list[tuple[str, float, Any]], live: Kept) -> list[tuple[str, float, Any]]:
    """Without what happened before the first byte of a line or after the last line was closed: no recording has it."""
    begun_s = min(samples[0][0] for samples in live.samples.values())
    ended_s = max(t_s for kind, t_s, _ in live.events if kind == "link")
    return [event for event in events if begun_s < event[1] <= ended_s]


class KeptStation:
    """A running gateway with a board on a PTY in `folder`, asked in the name of the client that keeps its stream."""

    def __init__(self, folder: Path, url: str, http: httpx.Client) -> None:
        self.url = url
        self.http = http
        self._folder = folder
        http.base_url = f"{url}/api/v1"
        eventually(lambda: http.put("/hil", json={"path": "assisted"}).is_success, "the flight process is there")
        self.client = Client(url)
        eventually(lambda: self.client.kept.client is not None, "the stream says hello")
        http.headers["X-Client"] = self.client.kept.client or ""

    @property
    def kept(self) -> Kept:
        """What came until now."""
        return self.client.kept

    def open_board(self) -> None:
        """Open the board's line and wait until commands work."""
        self.http.put("/links/board", json={"url": f"pty://{self._folder / 'board'}"}).raise_for_status()
        eventually(lambda: self.http.get("/status").json()["board"]["state"] == "open", "the board opens")

    @contextmanager
    def simulated(self) -> Iterator[None]:
        """The simulator flies inside."""
        receive_port, send_port = free_udp_port(), free_udp_port()
        address = {"receive_port": receive_port, "send_port": send_port, "profile": "xp10"}
        self.http.put("/links/simulator", json=address).raise_for_status()
        program = [sys.executable, "-m", "epf_gcs.simulator", "--listen", str(send_port)]
        simulator = Program([*program, "--send-to", f"127.0.0.1:{receive_port}"])
        try:
            yield
        finally:
            simulator.end()

    def closed(self) -> Path:
        """Close both lines; the recording, once it has ended."""
        self.http.delete("/links/board").raise_for_status()
        self.http.delete("/links/simulator").raise_for_status()
        file = next((self._folder / "data" / "recordings").glob("*.mcap"))
        # Told by the stream itself: all that it said before has come too.
        eventually(lambda: self.kept.is_recorded is False, "the recording ends")
        self.client.stop()
        return file


@contextmanager
def kept_station(folder: Path) -> Iterator[KeptStation]:
    """The station, its lines closed still."""
    make("board")
    with (
        board_process(folder / "board"),
        gateway_process(folder / "data") as gateway,
        httpx.Client(timeout=DEADLINE_S) as http,
    ):
        yield KeptStation(folder, gateway.wait_for_words(r"url=(http://\S+)"), http)
