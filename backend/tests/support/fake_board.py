"""A board with faults on demand: real frames over a real pseudo-terminal, answered by a thread.

The real firmware is `epf-board`; this one does what that cannot: refuse on demand, lose an answer, send garbage.
"""

from __future__ import annotations

import os
import pty
import select
import struct
import threading
import time
import tty
import zlib
from collections import Counter
from dataclasses import replace
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self, TypeVar

from epf_gcs.codec.ahrs_test import BEGIN, QUIT, SYNCHRONISE, SYNCHRONISED
from epf_gcs.codec.description import FieldRow, GainRow, TopicRow, blocks_of, packed_rows
from epf_gcs.codec.encode import encode_telemetry, frame_bytes
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE, PARAMETERS, TELEMETRY_BY_NAME

T = TypeVar("T")

HEARTBEAT_PERIOD_S = 0.02
DESCRIBES_ITSELF = 64
_FLAGS = (
    "autopilot",
    "autotrim",
    "auto_switch",
    "servos",
    "gps",
    "statistics",
    "ahrs",
    "inertial",
    "analog",
    "fly_by_wire",
    "autopilot_hil",
    "autotrim_hil",
)
_STREAMS = {"servos_in": "servos"}
_ALL_STREAMS = ("servos", "gps", "statistics", "ahrs", "inertial", "analog", "fly_by_wire")


_OWN_GAIN: Final = GainRow(
    row=0,
    type=1,
    needs_restart=False,
    minimum=0.1,
    maximum=10.0,
    step=0.1,
    default=3.0,
    name="line_k_bank",
    unit="1/rad",
    group="line",
    choices="",
    help="Aileron for each radian of bank error.",
)


def own_row(row: int, name: str = "line_k_bank", **changed: Any) -> GainRow:
    """A row that describes a gain of 3 in 0.1..10, but for what is `changed`."""
    return replace(_OWN_GAIN, row=row, name=name, **changed)


def law_row(row: int, **changed: Any) -> GainRow:
    """The row that describes the choice of the law."""
    facts: dict[str, Any] = {"type": 5, "minimum": 0, "maximum": 1, "step": 1, "default": 0}
    texts = {"choices": "deployed|line", "unit": "1", "help": "Law that flies the leg."}
    return own_row(row, "guidance_law", **{**facts, **texts, **changed})


class FakeBoard:
    """Use it in a `with` block; a station opens `url`."""

    def __init__(self, path: Path, *, extended: bool = True) -> None:
        self.path = path
        self.extended = extended
        self.flags = dict.fromkeys(_FLAGS, 0)
        self.gains: dict[str, float] = {parameter.name: parameter.default for parameter in PARAMETERS}
        self.plans: dict[int, list[tuple[float, ...]]] = {0: [], 1: []}
        self._received: list[str] = []
        self._arguments: list[tuple[float, ...]] = []
        self._raw = b""
        # Faults by command: how often to ignore it before it works, and the result to acknowledge it with.
        self.ignore: Counter[str] = Counter()
        self.refuse: dict[str, int] = {}
        self.lose_acknowledgement: Counter[str] = Counter()
        self.lose_item: int | None = None
        # The table in which it describes itself, the values of its own gains, how often an answer about a gain's row
        # is lost, and how often a block of the table is.
        self.table = b""
        self.own_gains: dict[int, float] = {}
        self.lose_row: Counter[int] = Counter()
        self.lose_block: Counter[int] = Counter()
        self.lose_value = 0
        self.own_checksum: int | None = None
        self.silent = False
        # What it says that it can do, each a bit.
        self.features = 15
        self.in_binary_mode = False
        # The AHRS test: whether the board supports it, whether it is running, and what it sends.
        self.has_ahrs_test = True
        self.in_ahrs_test = False
        self.sends_attitude = True
        self.attitude_deg = (10.0, 5.0, -3.0)
        self._decoder = FrameDecoder(TO_BOARD)
        self._master = -1
        self._slave = -1
        self._building: list[tuple[float, ...]] = []
        self._stop = threading.Event()
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None

    @property
    def url(self) -> str:
        """The URL of its line for a station."""
        return f"pty://{self.path}"

    @property
    def received(self) -> list[str]:
        """Names of the commands that were sent to it before this is asked."""
        self._catch_up()
        return list(self._received)

    @property
    def arguments(self) -> list[tuple[float, ...]]:
        """The values of the commands in `received`."""
        self._catch_up()
        return list(self._arguments)

    @property
    def raw(self) -> bytes:
        """All bytes that were sent to it."""
        self._catch_up()
        return self._raw

    def forget_bytes(self) -> None:
        """Begin `raw` anew."""
        self._catch_up()
        self._raw = b""

    def __enter__(self) -> Self:
        self.plug_in()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.unplug()

    def plug_in(self) -> None:
        """Connect the cable and power on: text mode, all streams off."""
        self._master, slave = pty.openpty()
        tty.setraw(slave)
        self.path.symlink_to(os.ttyname(slave))
        # Keep the slave end open until a station opens it: without one the master reports a hang-up.
        self._slave = slave
        self._decoder = FrameDecoder(TO_BOARD)
        self.in_binary_mode = self.in_ahrs_test = False
        self.flags = dict.fromkeys(_FLAGS, 0)
        self._stop.clear()
        self._thread = threading.Thread(target=self._run, name="fake board", daemon=True)
        self._thread.start()

    def unplug(self) -> None:
        """Power off and disconnect the cable."""
        if self._thread is None:
            return
        self._stop.set()
        self._thread.join()
        self._thread = None
        self.path.unlink(missing_ok=True)
        os.close(self._slave)
        os.close(self._master)

    def restart(self) -> None:
        """Power off and on with the cable connected: text mode, all streams off."""
        with self._lock:
            self.in_binary_mode = self.in_ahrs_test = False
            self.flags = dict.fromkeys(_FLAGS, 0)

    def send(self, data: bytes) -> None:
        """Send bytes to the station."""
        with self._lock:
            self._write(data)

    def send_gps(self, latitude_deg: float, longitude_deg: float, altitude_m: float, *, valid: bool = True) -> None:
        """Send one position of the GPS receiver."""
        fix, status = (ord("3"), ord("A")) if valid else (ord("0"), ord("V"))
        self.send(encode_telemetry("gps", latitude_deg, longitude_deg, altitude_m, 55.0, 90.0, ord("8"), fix, status))

    def count(self, name: str) -> int:
        """How often this command was received."""
        return self.received.count(name)

    def _catch_up(self) -> None:
        """Take what lies on the line: on a busy machine its own thread comes later than who asks."""
        with self._lock:
            while self._thread is not None and self._read():
                pass

    def _run(self) -> None:
        next_s = time.monotonic()
        while not self._stop.is_set():
            ready, _, _ = select.select([self._master], [], [], max(0.0, next_s - time.monotonic()))
            with self._lock:
                if ready:
                    self._read()
                if time.monotonic() >= next_s:
                    next_s = time.monotonic() + HEARTBEAT_PERIOD_S
                    # A line that nobody reads is full after some seconds: a write would wait with the lock.
                    if select.select([], [self._master], [], 0.0)[1]:
                        self._tell()

    def _tell(self) -> None:
        if self.silent:
            return
        if self.in_ahrs_test and self.sends_attitude:
            self._write(b"\xaa" * 4 + struct.pack("<3f", *self.attitude_deg))
        if self.in_binary_mode:
            self._write(encode_telemetry("heartbeat", *self.flags.values()))
            if self.flags["ahrs"]:
                self._write(encode_telemetry("ahrs", 10.0, 5.0, -3.0))

    def _read(self) -> bool:
        """Take what lies on the line; False if nothing does."""
        # Whoever asks what it received takes it too: the read would wait for more.
        if not select.select([self._master], [], [], 0.0)[0]:
            return False
        try:
            data = os.read(self._master, 65536)
        except OSError:
            return False
        self._raw += data
        if not self.in_binary_mode:
            self._read_text(data)
        if OPEN_BINARY_MODE in data:
            self.in_binary_mode = True
            self.in_ahrs_test = False
        for found in self._decoder.feed(data):
            if isinstance(found, Frame):
                self._obey(found)
        return True

    def _read_text(self, data: bytes) -> None:
        if self.has_ahrs_test and SYNCHRONISE in data and BEGIN in self._raw:
            self._write(SYNCHRONISED)
            self.in_ahrs_test = True
        elif self.in_ahrs_test and QUIT in data:
            self.in_ahrs_test = False

    def _obey(self, frame: Frame) -> None:
        name = frame.message.name
        self._received.append(name)
        self._arguments.append(tuple(frame.values))
        if self.silent:
            return
        if self.ignore[name] > 0:
            self.ignore[name] -= 1
            return
        if frame.message.extension and not self.extended:
            return
        result = self.refuse.get(name, 0)
        if result == 0:
            self._act(frame)
        if self.extended and name not in ("do_nothing", "xplane_info") and not _loses(self.lose_acknowledgement, name):
            self._write(encode_telemetry("acknowledgement", frame.message.id, result))

    def _act(self, frame: Frame) -> None:  # noqa: C901 - a board does many things, one line each
        name, values = frame.message.name, frame.values
        stream, _, state = name.rpartition("_")
        if name in ("start", "stop"):
            self.flags.update(dict.fromkeys(_ALL_STREAMS, int(name == "start")))
        elif name in ("autopilot_on", "autopilot_off"):
            self.flags["autopilot_hil"] = self.flags["autopilot_hil"] & 2 | int(state == "on")
        elif name == "control_source":
            self.flags["autopilot_hil"] = self.flags["autopilot_hil"] & 1 | int(values[0]) << 1
        elif state in ("on", "off") and _STREAMS.get(stream, stream) in self.flags:
            self.flags[_STREAMS.get(stream, stream)] = int(state == "on")
        elif name == "exit_binary_mode":
            self.in_binary_mode = False
        elif name == "capabilities":
            self._write(encode_telemetry("capabilities", 1, self.features, b"fake", b"1.0", 5))
        elif name == "load_autopilot_parameters":
            self._write(encode_telemetry("autopilot_parameters", *self._gains_as_sent()))
        elif frame.message.parameter:
            self.gains[frame.message.parameter] = values[0]
        elif name == "xplane_info":
            self._write(encode_telemetry("hil_surfaces", 0.25, -0.5, 0.125, 0.75))
        elif name.startswith("mission_"):
            self._plan(name, values)
        elif name == "describe":
            checksum = zlib.crc32(self.table) if self.own_checksum is None else self.own_checksum
            self._write(encode_telemetry("description", len(self.table), checksum))
        elif name == "describe_blocks":
            self._send_blocks(values[0], values[1])
        elif name.startswith("own_gain_") and not _loses(self.lose_row, values[0]):
            self.own_gains[values[0]] = values[1] if name == "own_gain_set" else self.own_gains[values[0]]
            self.lose_value -= 1
            if self.lose_value < 0:
                self._write(encode_telemetry("own_gain", values[0], self.own_gains[values[0]]))

    def _plan(self, name: str, values: tuple[float, ...]) -> None:
        plan = int(values[0])
        if name == "mission_begin":
            self._building = []
        elif name == "mission_item":
            self._building.append(values)
        elif name == "mission_commit":
            self.plans[plan] = self._building
        else:
            items = self.plans[plan]
            self._write(encode_telemetry("mission_count", plan, len(items)))
            for index, item in enumerate(items):
                if index != self.lose_item:
                    self._write(encode_telemetry("mission_item", *item))

    def describe(self, *rows: GainRow | TopicRow | FieldRow) -> None:
        """Describe itself by these rows; each gain has its default."""
        self.features |= DESCRIBES_ITSELF
        self.table = packed_rows(rows)
        self.own_gains = {number: row.default for number, row in enumerate(rows) if isinstance(row, GainRow)}

    def _send_blocks(self, first: int, count: int) -> None:
        message = TELEMETRY_BY_NAME["description_block"]
        for block, data in list(enumerate(blocks_of(self.table)))[first : first + count]:
            if not _loses(self.lose_block, block):
                self._write(frame_bytes(FROM_BOARD, message, struct.pack("<i", block) + data))

    def _gains_as_sent(self) -> list[float]:
        return [
            int(self.gains[parameter.name]) if parameter.is_integer else self.gains[parameter.name]
            for parameter in PARAMETERS
        ]

    def _write(self, data: bytes) -> None:
        os.write(self._master, data)


def _loses(counts: Counter[T], key: T) -> bool:
    counts[key] -= 1
    return counts[key] >= 0
