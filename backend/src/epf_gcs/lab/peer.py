"""A station at the other end of a board's line, for judging the board: bytes out, frames in, waits that end."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Final, Protocol

from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS, OPEN_BINARY_MODE, TELEMETRY_BY_NAME
from epf_gcs.codec.tables import Message
from epf_gcs.errors import GatewayError
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.laws import Laws
from epf_gcs.link.address import parse_address

_CHUNK: Final = 65536
_LOOK_S: Final = 0.05
_TICK_MS: Final = 20
_STREAM_TICKS: Final = 5
_TASKS: Final = 3

LEVEL: Final = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 28.0, 3.0, 0.0, 1000.0, 0.0, 55.0, 27.95, -15.38)
"""A command 50 that may be: level at 1000 ft and 55 kt, stick in the middle, half throttle."""


class Lack(Exception):  # noqa: N818 - what a board lacks is no error of ours
    """What a board does not do, in words for the person who will make it do so."""


def must_be(told: object, wanted: object, what: str) -> None:
    """Raises Lack where what the board told is not what it must be."""
    if told != wanted:
        raise Lack(f"{what}: must be {wanted}, is {told}")


class Wire(Protocol):
    """The board's line."""

    def send(self, data: bytes) -> None:
        """Give the board bytes."""

    def receive(self, wait_s: float) -> bytes:
        """What has come, waiting for it at most so long."""

    def now_s(self) -> float:
        """A steady clock's."""

    def close(self) -> None:
        """Let the line go."""


class TcpWire:
    """A board that listens on a TCP port."""

    def __init__(self, host: str, port: int) -> None:
        self._socket = socket.create_connection((host, port), timeout=10.0)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def send(self, data: bytes) -> None:
        """All of it."""
        self._socket.sendall(data)

    def receive(self, wait_s: float) -> bytes:
        """Empty where nothing came."""
        self._socket.settimeout(wait_s)
        try:
            data = self._socket.recv(_CHUNK)
        except TimeoutError:
            return b""
        if not data:
            raise Lack("it closed the line")
        return data

    def now_s(self) -> float:
        """This computer's."""
        return time.monotonic()

    def close(self) -> None:
        """Hang up."""
        self._socket.close()


class SerialWire:
    """A board on a serial port, or a pseudo-terminal."""

    def __init__(self, device: str, baud: int) -> None:
        import serial  # noqa: PLC0415 - only where a port is asked for

        self._port = serial.Serial(device, baud, timeout=0.0, write_timeout=10.0)

    def send(self, data: bytes) -> None:
        """All of it."""
        self._port.write(data)
        self._port.flush()

    def receive(self, wait_s: float) -> bytes:
        """Empty where nothing came."""
        self._port.timeout = wait_s
        first: bytes = self._port.read(1)
        return first + self._port.read(self._port.in_waiting) if first else b""

    def now_s(self) -> float:
        """This computer's."""
        return time.monotonic()

    def close(self) -> None:
        """Let the port go."""
        self._port.close()


class LawsWire:
    """The board's laws in this process, whose time is counted here: no second of it takes a second."""

    def __init__(self, library: Path | None = None) -> None:
        self._laws = Laws(0.0, library)
        self._ticks = 0
        self._waiting = b""

    def send(self, data: bytes) -> None:
        """Answered at once, and heard with the next call of `receive`."""
        self._waiting += self._laws.feed(data)

    def receive(self, wait_s: float) -> bytes:
        """Time passes, a tick at least, unless something waits."""
        for _ in range(max(1, round(wait_s * 1000.0 / _TICK_MS))):
            if self._waiting:
                break
            self._tick()
        data, self._waiting = self._waiting, b""
        return data

    def now_s(self) -> float:
        """The board's."""
        return self._ticks * _TICK_MS / 1000.0

    def close(self) -> None:
        """Free the board."""
        self._laws.close()

    def _tick(self) -> None:
        self._ticks += 1
        self._laws.advance(_TICK_MS)
        if self._ticks % _STREAM_TICKS == 0:
            for task in range(_TASKS):
                self._waiting += self._laws.send_streams(task)


def wire(url: str) -> Wire:
    """A line by its address, as `tcp://host:port`, `serial:///dev/ttyUSB0`, `pty:///path`. Raises LabError."""
    try:
        address = parse_address(url)
        match address.scheme:
            case "tcp":
                return TcpWire(address.target, address.port)
            case "serial" | "pty":
                return SerialWire(address.target, address.baud)
            case _:
                raise LabError(f"{url} is no board's line: tcp://host:port, serial:///dev/ttyUSB0 or pty:///path")
    except GatewayError as error:
        raise LabError(error.detail) from error
    except OSError as error:
        raise LabError(f"{url} cannot be opened: {error}") from error


class Peer:
    """Sends commands, and knows the frames that came since it last forgot them. `patience_s`: how long an answer may
    take."""

    def __init__(self, line: Wire, patience_s: float = 2.0) -> None:
        self.line = line
        self.patience_s = patience_s
        self.frames: list[Frame] = []
        self._decoder = FrameDecoder()

    def know(self, messages: Iterable[Message]) -> None:
        """Take in these messages of the board's own too, from now on."""
        self._decoder.learn(messages)

    def send(self, data: bytes) -> None:
        """Any bytes."""
        self.line.send(data)

    def command(self, name: str, *values: float) -> None:
        """A whole frame."""
        self.send(encode_command(name, *values))

    def look(self, seconds: float) -> None:
        """Take in what comes in so long."""
        until_s = self.line.now_s() + seconds
        while (left_s := until_s - self.line.now_s()) > 0.0:
            self._take(min(left_s, _LOOK_S))

    def wait(self, is_there: Callable[[], bool], what: str) -> None:
        """Until it is there. Raises Lack with `what` where it does not come."""
        until_s = self.line.now_s() + self.patience_s
        while not is_there():
            if self.line.now_s() > until_s:
                raise Lack(what)
            self._take(_LOOK_S)

    def next(self, name: str, why: str) -> Frame:
        """The next such frame from now on. Raises Lack: it did not come, `why` it should."""
        self.frames.clear()
        return self.awaited(name, why)

    def awaited(self, name: str, why: str) -> Frame:
        """The first such frame since they were forgotten."""
        self.wait(lambda: self.count(name) > 0, f"no {_named(name)} came {why}")
        return next(frame for frame in self.frames if frame.message.name == name)

    def count(self, name: str) -> int:
        """How many such frames came."""
        return sum(frame.message.name == name for frame in self.frames)

    def open(self) -> None:
        """Open the binary mode; asked again meanwhile, as a board may still be starting."""
        until_s = self.line.now_s() + 3.0 * self.patience_s
        self.frames.clear()
        while not self.count("heartbeat"):
            if self.line.now_s() > until_s:
                raise Lack("no heartbeat came after #QT and a line feed")
            self.send(OPEN_BINARY_MODE)
            self.look(0.5)

    def flags(self) -> dict[str, int]:
        """Of the second heartbeat from now: the first may have been on its way before the last command."""
        self.next("heartbeat", "of itself")
        values = self.next("heartbeat", "of itself").values
        return dict(zip(FLAGS, values, strict=True))

    def result(self, name: str, *values: float) -> int:
        """What the board acknowledges a command with. Raises Lack where it does not."""
        return self.result_of(COMMANDS[name].id, encode_command(name, *values))

    def result_of(self, type_id: int, frame: bytes) -> int:
        """The same, of any frame."""
        self.frames.clear()
        self.send(frame)
        self.wait(lambda: bool(self._results(type_id)), f"command {type_id} was not acknowledged")
        return self._results(type_id)[0]

    def _results(self, type_id: int) -> list[int]:
        acknowledged = [frame.values for frame in self.frames if frame.message.name == "acknowledgement"]
        return [result for kind, result in acknowledged if kind == type_id]

    def _take(self, wait_s: float) -> None:
        self.frames += [found for found in self._decoder.feed(self.line.receive(wait_s)) if isinstance(found, Frame)]


FLAGS: Final = (
    *("autopilot", "autotrim", "auto_switch", "servos", "gps", "statistics", "ahrs", "inertial", "analog"),
    *("fly_by_wire", "autopilot_hil", "autotrim_hil"),
)
"""The twelve bytes of the heartbeat, in their order."""


def _named(name: str) -> str:
    return f"{name} (type {TELEMETRY_BY_NAME[name].id:#x})"


Check = Callable[[Peer], None]
"""Raises Lack where a board does not do what it must."""
