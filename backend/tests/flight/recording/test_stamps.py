"""The times in a recording are the times that the flight told its viewers, to the bit."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from mcap.records import Message
from mcap.stream_reader import StreamReader

from epf_gcs.bus.vehicle_end import Broadcast
from epf_gcs.error_log import ErrorLog
from epf_gcs.flight.clock.line_clock import LineClock
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.flight.recording.recorder import Recorder
from epf_gcs.link.address import parse_address
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT, SIMULATOR_RECEIVED
from epf_gcs.vehicle.vehicle import Vehicle
from tests.support.fake_board import FakeBoard
from tests.support.outlet import KeptOutlet
from tests.support.ports import free_udp_port
from tests.support.simulator import WHOLE, Simulator
from tests.support.waiting import eventually_async

Heard = list[tuple[str, float, Mapping[str, Any]]]

SIMULATOR_TOPICS = ("simulator", "xplane_info", "xplane_rows")


def records(folder: Path) -> list[tuple[int, int, bytes]]:
    """Topic, time in ns and bytes of each record of the only file."""
    (file,) = folder.glob("*.mcap")
    with file.open("rb") as stream:
        found = [one for one in StreamReader(stream).records if isinstance(one, Message)]
    return [(one.channel_id, one.log_time, one.data) for one in found]


@pytest.fixture
def heard(monkeypatch: pytest.MonkeyPatch) -> Heard:
    """All samples that a flight made in this test sends to its viewers."""
    kept: Heard = []

    def sample(_: Broadcast, topic: str, t_s: float, values: Mapping[str, Any]) -> None:
        kept.append((topic, t_s, values))

    monkeypatch.setattr(Broadcast, "sample", sample)
    return kept


class SetClock:
    """The time of the record that is decoded."""

    def __init__(self) -> None:
        self.t_ns = 0

    def now_s(self) -> float:
        return self.t_ns * 1e-9

    steady_s = now_s


async def fly(data_dir: Path, board: FakeBoard, *, record: bool) -> None:
    flight = Flight(data_dir, record=record)
    with Simulator() as simulator:
        simulator.port = free_udp_port()
        async with flight.running():
            address = SimulatorAddress(simulator.port, "127.0.0.1", simulator.own_port, "xp10")
            await flight.lines.open_simulator(address)
            await flight.lines.open_board(parse_address(board.url))
            await eventually_async(lambda: flight.supervisor.state == "open", "the board opens")
            for _ in range(5):
                before = flight.telemetry.health["heartbeat"].count
                simulator.send(WHOLE)
                await eventually_async(
                    lambda before=before: flight.telemetry.health["heartbeat"].count > before + 3,  # type: ignore[misc]
                    "it flies",
                )


@pytest.mark.anyio
async def test_what_is_decoded_from_the_file_has_the_times_it_had_live(
    tmp_path: Path, board: FakeBoard, heard: Heard
) -> None:
    await fly(tmp_path, board, record=True)
    found = records(tmp_path / "recordings")
    clock, outlet = SetClock(), KeptOutlet()
    replayed = Vehicle(clock, outlet, ErrorLog(), lambda _: 1.0).board
    for topic, t_ns, data in found:
        if topic == BOARD_RECEIVED:
            clock.t_ns = t_ns
            replayed.on_bytes(data)
    assert [one for one in heard if one[0] not in SIMULATOR_TOPICS] == outlet.samples
    datagrams_s = {t_ns * 1e-9 for topic, t_ns, _ in found if topic == SIMULATOR_RECEIVED}
    shown_s = {t_s for topic, t_s, _ in heard if topic in SIMULATOR_TOPICS}
    assert shown_s
    assert shown_s <= datagrams_s


@pytest.mark.anyio
async def test_without_a_recorder_samples_have_the_time_of_their_read_too(
    tmp_path: Path, board: FakeBoard, heard: Heard, monkeypatch: pytest.MonkeyPatch
) -> None:
    stamps: set[float] = set()
    received = LineClock.received

    def note(clock: LineClock, topic: int, ago_s: float = 0.0) -> int:
        stamp = received(clock, topic, ago_s)
        stamps.add(stamp * 1e-9)
        return stamp

    monkeypatch.setattr(LineClock, "received", note)
    await fly(tmp_path, board, record=False)
    assert heard
    assert {t_s for _, t_s, _ in heard} <= stamps


def test_reads_of_a_millisecond_are_one_record_and_cause_stays_before_effect(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tick_ns = 1024  # of the flight's clock
    now_ns = start_ns = 1_000_000 * tick_ns
    monkeypatch.setattr(time, "monotonic_ns", lambda: now_ns)
    monkeypatch.setattr(time, "time_ns", lambda: now_ns)
    clock = LineClock()
    recorder = Recorder(tmp_path, clock, "test")
    board, simulator = recorder.board_tap, recorder.simulator_tap
    for ticks, take, data in (
        (0, board.received, b"a"),
        (400, board.received, b"b"),
        (400, board.sent, b"answer"),
        (100, board.received, b"c"),
        (976, board.received, b"d"),
        (1, board.received, b"e"),
        (10, simulator.received, b"DATA1"),
        (10, simulator.received, b"DATA2"),
        (10, board.received, b"f"),
        (900, board.received, b"g"),
    ):
        now_ns += tick_ns * ticks
        take(data)
    recorder.start()
    recorder.stop()
    assert [(topic, (t_ns - start_ns) // tick_ns, data) for topic, t_ns, data in records(tmp_path)] == [
        (BOARD_RECEIVED, 0, b"ab"),
        (BOARD_SENT, 800, b"answer"),
        (BOARD_RECEIVED, 900, b"cd"),
        (BOARD_RECEIVED, 1877, b"e"),
        (SIMULATOR_RECEIVED, 1887, b"DATA1"),
        (SIMULATOR_RECEIVED, 1897, b"DATA2"),
        (BOARD_RECEIVED, 1907, b"fg"),
    ]
