"""Those who look at flights while one is flown: they rewind it, have one indexed again and again, and export it."""

from __future__ import annotations

import json
import random
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from typing import Any, Final

from bench.station import WebSocket
from tests.flights.flown_flights import recording

_REWINDERS: Final = 4
_EVERY_S: Final = 0.5
_FLIGHT_S: Final = 120.0
_LOOK_S: Final = 0.1

Ready = Callable[[], None]


def rewinding(ready: Ready, port: int, _udp_port: int, until_s: float) -> None:
    """Four viewers of the flight in the air, each going back to another moment twice a second and playing on."""
    readers = [threading.Thread(target=_rewind, args=(port, until_s, ready), daemon=True) for _ in range(_REWINDERS)]
    for reader in readers:
        reader.start()
    for reader in readers:
        reader.join()


def _rewind(port: int, until_s: float, ready: Ready) -> None:
    viewer = WebSocket(port, "/api/v1/stream?flight=current")
    hello = viewer.receive_hello()
    rng, next_s = random.Random(1), 0.0
    viewer.send('{"type":"play","rate":1.0}')
    while time.monotonic() < until_s:
        viewer.acknowledge(viewer.receive())
        ready()
        if time.monotonic() > next_s:
            next_s = time.monotonic() + _EVERY_S
            viewer.send(json.dumps({"type": "seek", "at_s": rng.uniform(0.0, hello["duration_s"])}))


def indexing(ready: Ready, port: int, _udp_port: int, until_s: float) -> None:
    """A flight of two minutes whose columns are made again as soon as they are there."""
    flight = _imported(port)
    ready()
    while time.monotonic() < until_s:
        _ask(port, f"/flights/{flight}/index", {})
        _wait(port, flight)


def exporting(ready: Ready, port: int, _udp_port: int, until_s: float) -> None:
    """The same flight in every form, one export after the other."""
    flight = _imported(port)
    ready()
    while time.monotonic() < until_s:
        for form in ("mcap-decoded", "csv", "parquet", "kmz", "czml"):
            job = _ask(port, f"/flights/{flight}/exports", {"format": form})["job"]
            while _get(port, f"/jobs/{job}")["state"] in ("waiting", "running") and time.monotonic() < until_s:
                time.sleep(_LOOK_S)


def _imported(port: int) -> str:
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}/api/v1/flights?name=flown.mcap", recording(_FLIGHT_S), method="POST"
    )
    job = _opened(request)["job"]
    while (found := _get(port, f"/jobs/{job}"))["state"] in ("waiting", "running"):
        time.sleep(_LOOK_S)
    flight = str(found["flight"])
    _wait(port, flight)
    return flight


def _wait(port: int, flight: str) -> None:
    while _get(port, f"/flights/{flight}")["state"] not in ("indexed", "fault"):
        time.sleep(_LOOK_S)


def _get(port: int, path: str) -> dict[str, Any]:
    return _opened(urllib.request.Request(f"http://127.0.0.1:{port}/api/v1{path}"))


def _ask(port: int, path: str, body: dict[str, Any]) -> dict[str, Any]:
    return _opened(
        urllib.request.Request(
            f"http://127.0.0.1:{port}/api/v1{path}",
            json.dumps(body).encode(),
            {"Content-Type": "application/json"},
            method="POST",
        )
    )


def _opened(request: urllib.request.Request) -> dict[str, Any]:
    with urllib.request.urlopen(request, timeout=30.0) as answer:
        found: dict[str, Any] = json.loads(answer.read() or b"{}")
        return found
