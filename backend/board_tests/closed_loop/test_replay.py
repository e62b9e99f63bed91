"""Replay is the flight: what a client kept of the live stream is what the replayed recording gives.

The real gateway's two processes, the real board program on a PTY, the embedded simulator; and the replay's own process.
Not compared is what the bytes do not hold: the status (its times are those of the viewing), and figures of the HIL
round trip.
"""

from __future__ import annotations

import sys
import threading
import time
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
_EVENTS = {"alarm", "board_restarted", "command", "console", "control", "link", "mission", "parameter"}


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
            case "event" if message["event"] in _EVENTS:
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


@contextmanager
def flight(folder: Path) -> Iterator[tuple[str, str, Kept]]:
    """Some seconds flown: the gateway's address, the recording's id and what a client kept."""
    make("board")
    receive_port, send_port = free_udp_port(), free_udp_port()
    with (
        board_process(folder / "board") as _,
        gateway_process(folder / "data") as gateway,
        httpx.Client(timeout=DEADLINE_S) as http,
    ):
        url = gateway.wait_for_words(r"url=(http://\S+)")
        http.base_url = f"{url}/api/v1"
        eventually(lambda: http.put("/hil", json={"path": "assisted"}).is_success, "the flight process is there")
        client = Client(url)
        eventually(lambda: client.kept.client is not None, "the stream says hello")
        http.headers["X-Client"] = client.kept.client or ""
        address = {"receive_port": receive_port, "send_port": send_port, "profile": "xp10"}
        http.put("/links/simulator", json=address).raise_for_status()
        http.put("/links/board", json={"url": f"pty://{folder / 'board'}"}).raise_for_status()
        simulator = Program(
            [
                *(sys.executable, "-m", "epf_gcs.simulator", "--listen", str(send_port)),
                *("--send-to", f"127.0.0.1:{receive_port}"),
            ]
        )
        try:
            eventually(lambda: http.get("/status").json()["board"]["state"] == "open", "the board opens")
            http.post("/commands/start", json={}).raise_for_status()
            http.post("/console", json={"text": "#QT"}).raise_for_status()
            http.post("/parameters/load").raise_for_status()
            _fly(client.kept)
            http.put("/hil", json={"path": "manual"}).raise_for_status()
            http.post("/ahrs-test").raise_for_status()
            eventually(lambda: len(client.kept.samples.get("ahrs_test", ())) > 20, "attitudes of the AHRS test")
            http.delete("/ahrs-test").raise_for_status()
            count = len(client.kept.samples["ahrs"])
            eventually(lambda: len(client.kept.samples["ahrs"]) > count + 20, "it flies on")
        finally:
            simulator.end()
        http.delete("/links/board").raise_for_status()
        http.delete("/links/simulator").raise_for_status()
        file = next((folder / "data" / "recordings").glob("*.mcap"))
        # Told by the stream itself: all that it said before has come too.
        eventually(lambda: client.kept.is_recorded is False, "the recording ends")
        yield url, file.stem, client.stop()


def _fly(kept: Kept) -> None:
    """Until much of every kind has come."""

    wanted = {"ahrs": 60, "simulator": 200, "xplane_info": 200, "hil_surfaces": 100, "gps": 5}
    eventually(
        lambda: all(len(kept.samples.get(topic, ())) >= count for topic, count in wanted.items()), "all of it comes"
    )


def recorded(events: list[tuple[str, float, Any]], live: Kept) -> list[tuple[str, float, Any]]:
    """Without what happened before the first byte of a line or after the last line was closed: no recording has it."""
    begun_s = min(samples[0][0] for samples in live.samples.values())
    ended_s = max(t_s for kind, t_s, _ in live.events if kind == "link")
    return [event for event in events if begun_s < event[1] <= ended_s]


def replayed(url: str, flight_id: str, live: Kept) -> Kept:
    """The whole of a recording, each sample of it, as fast as it comes."""
    kept = Kept()
    address = f"{url.replace('http', 'ws')}/api/v1/stream?rate=0&flight={flight_id}"
    with connect(address, max_size=None) as connection:
        connection.send(orjson.dumps({"type": "play", "rate": 100}).decode())
        # The end is told before the last samples of a viewer that has not acknowledged those before.
        give_up_s = time.monotonic() + DEADLINE_S
        while kept.state != "ended" or (kept.lacks(live) and time.monotonic() < give_up_s):
            kept.take(connection)
        kept.take(connection)
    return kept


def test_the_replay_gives_the_samples_of_the_flight_value_for_value_with_their_times_and_its_events(
    tmp_path: Path,
) -> None:
    with flight(tmp_path) as (url, flight_id, live):
        replay = replayed(url, flight_id, live)
    assert live.missed == replay.missed == 0
    assert set(replay.samples) == set(live.samples)
    for topic, samples in live.samples.items():
        assert len(samples) >= 1
        assert replay.samples[topic] == samples, topic

    for kind in _EVENTS:
        expected = [event for event in recorded(live.events, live) if event[0] == kind]
        assert [event for event in recorded(replay.events, live) if event[0] == kind] == expected, kind
    assert {kind for kind, _, _ in replay.events} >= {"command", "console", "parameter", "link"}
