"""Kill the gateway in flight and measure how many of the line's last bytes its recording lacks."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import Final

from mcap.exceptions import McapError
from mcap.records import Channel, Message
from mcap.stream_reader import StreamReader

from bench.station import HEARTBEAT, Line, station
from bench.table import Row
from tests.codec.streams import mixed_frames

KILLS: Final = 5
FLOWN_S: Final = 3.3  # not a multiple of the recorder's flush period, so that the kills fall at different phases of it
LINE_BYTES_PER_S: Final = 11520
REACH_S: Final = 1.0
MARK: Final = b"\rthe flight begins\n"  # a text line, as boards send them; the opening dialogue has none


def run() -> list[Row]:
    """The worst of a few kills at the full line rate; `missing` counts back from the moment of the kill."""
    worst = max(_missing_s() for _ in range(KILLS))
    what = f"kill -9 at the full line: newest byte that the recording lacks, worst of {KILLS}"
    return [Row(what, worst, "s before the kill", f"<= {REACH_S:g} s", worst <= REACH_S)]


def _missing_s() -> float:
    """How long before the kill the first byte was sent that is not in the file, in s."""
    with station() as (gateway, line):
        # The file also holds the bytes of the opening dialogue, before those sent here.
        written = _feed(line)
        killed_s = time.monotonic()
        # Stop the launcher first: it would restart the flight process; killed first, it would end it cleanly.
        os.kill(gateway.process.pid, signal.SIGSTOP)
        flight = gateway.parts["flight"]
        os.kill(flight, signal.SIGKILL)
        gateway.process.kill()
        gateway.process.wait()
        recorded = _board_bytes(next((line.folder / "recordings").glob("*.mcap")))
    stream = b"".join(data for _, data in written)
    start = recorded.find(MARK)
    if start < 0 or not stream.startswith(recorded[start:]):
        raise AssertionError("the recording holds other bytes than the line carried")
    held = len(recorded) - start
    for came_s, data in written:
        held -= len(data)
        if held < 0:
            return killed_s - came_s
    return 0.0


def _feed(line: Line) -> list[tuple[float, bytes]]:
    """Send frames at the line's full rate for a while; returns the bytes sent, with their times."""
    frames = [MARK, *mixed_frames(4000, seed=7)]
    written: list[tuple[float, bytes]] = []
    begun_s = time.monotonic()
    size = 0
    for index, frame in enumerate(frames):
        data = frame + HEARTBEAT if index and index % 10 == 0 else frame
        while size > (time.monotonic() - begun_s) * LINE_BYTES_PER_S:
            time.sleep(0.001)
        if time.monotonic() - begun_s > FLOWN_S:
            break
        line.write(data)
        line.read(0.0)
        written.append((time.monotonic(), data))
        size += len(data)
    return written


def _board_bytes(path: Path) -> bytes:
    """All bytes from the board in a recording that was not closed."""
    topics: dict[int, str] = {}
    data = b""
    with path.open("rb") as file:
        try:
            for record in StreamReader(file).records:
                if isinstance(record, Channel):
                    topics[record.id] = record.topic
                elif isinstance(record, Message) and topics[record.channel_id] == "board/received":
                    data += record.data
        except McapError:
            pass  # the incomplete end of the file
    return data
