"""Replay is the flight: what a client kept of the live stream is what the replayed recording gives.

The real gateway's two processes, the real board program on a PTY, the embedded simulator; and the replay's own process.
Not compared is what the bytes do not hold: the status (its times are those of the viewing), and figures of the HIL
round trip.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import orjson
from websockets.sync.client import connect

from board_tests.closed_loop.kept_flight import EVENTS, Kept, kept_station, recorded
from tests.support.waiting import DEADLINE_S, eventually


@contextmanager
def flight(folder: Path) -> Iterator[tuple[str, str, Kept]]:
    """Some seconds flown: the gateway's address, the recording's id and what a client kept."""
    with kept_station(folder) as station:
        http, kept = station.http, station.kept
        with station.simulated():
            station.open_board()
            http.post("/commands/start", json={}).raise_for_status()
            http.post("/console", json={"text": "#QT"}).raise_for_status()
            http.post("/parameters/load").raise_for_status()
            _fly(kept)
            http.put("/hil", json={"path": "manual"}).raise_for_status()
            http.post("/ahrs-test").raise_for_status()
            eventually(lambda: len(kept.samples.get("ahrs_test", ())) > 20, "attitudes of the AHRS test")
            http.delete("/ahrs-test").raise_for_status()
            count = len(kept.samples["ahrs"])
            eventually(lambda: len(kept.samples["ahrs"]) > count + 20, "it flies on")
        file = station.closed()
        yield station.url, file.stem, kept


def _fly(kept: Kept) -> None:
    """Until much of every kind has come."""

    wanted = {"ahrs": 60, "simulator": 200, "xplane_info": 200, "hil_surfaces": 100, "gps": 5}
    eventually(
        lambda: all(len(kept.samples.get(topic, ())) >= count for topic, count in wanted.items()), "all of it comes"
    )


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

    for kind in EVENTS:
        expected = [event for event in recorded(live.events, live) if event[0] == kind]
        assert [event for event in recorded(replay.events, live) if event[0] == kind] == expected, kind
    assert {kind for kind, _, _ in replay.events} >= {"command", "console", "parameter", "link"}
