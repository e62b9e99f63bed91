"""The real board as a child process, and a station at the other end of its line."""

from __future__ import annotations

import fcntl
import os
import re
import select
import signal
import socket
import subprocess
import sys
import termios
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from struct import Struct
from typing import Any, Final, TypeVar

from epf_gcs.codec.encode import encode_command, frame_bytes
from epf_gcs.codec.frame import TO_BOARD, Damage, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS, OPEN_BINARY_MODE, TELEMETRY_BY_NAME
from tests.support.firmware import FIRMWARE
from tests.support.waiting import DEADLINE_S

VERSION: Final = "epf-board 1.0.0"

T = TypeVar("T")


class Board:
    """One run of `epf-board`."""

    def __init__(self, flavour: str, *arguments: str) -> None:
        program = FIRMWARE / "build" / flavour / "epf-board"
        self._process = subprocess.Popen(
            [program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, bufsize=1
        )
        assert self._process.stdout is not None
        self.greeting = self._process.stdout.readline()
        self._ending: tuple[int, str] | None = None

    @property
    def pid(self) -> int:
        return self._process.pid

    @property
    def tcp_port(self) -> int:
        """The port that it listens on."""
        return int(self.greeting.split()[3].rstrip(",").rpartition(":")[2])

    def null_devices(self) -> int:
        """How many of its descriptors lead to the null device: one more while nobody is at the line's other end."""
        return sum(os.path.realpath(descriptor) == os.devnull for descriptor in Path(f"/proc/{self.pid}/fd").iterdir())

    def wait(self, condition: Callable[[], bool]) -> None:
        """Until `condition` holds; fails when it does not by the deadline."""
        deadline_s = time.monotonic() + DEADLINE_S
        while not condition():
            assert time.monotonic() < deadline_s, "waited in vain"
            time.sleep(0.005)

    @property
    def has_ended(self) -> bool:
        """A test has seen it end."""
        return self._ending is not None

    def stop(self, with_signal: signal.Signals = signal.SIGTERM) -> tuple[int, str]:
        """End it; its exit code and what it had to complain about."""
        if self._ending is None:
            self._process.send_signal(with_signal)
        return self.ended()

    def ended(self) -> tuple[int, str]:
        """Wait until it has ended by itself; exit code and complaints."""
        if self._ending is None:
            _, complaints = self._process.communicate(timeout=DEADLINE_S)
            self._ending = (self._process.returncode, complaints)
        return self._ending


ASK_AGAIN_S: Final = 1.0


class Station:
    """The other end of the line: everything that came in, in order, as frames and as text."""

    def __init__(self, link: int | socket.socket) -> None:
        self._link = link
        self._fd = link if isinstance(link, int) else link.fileno()
        os.set_blocking(self._fd, False)
        self._decoder = FrameDecoder()
        self.received = bytearray()
        self.frames: list[Frame] = []
        self.failed = 0
        self.is_closed = False
        self._text = bytearray()

    @classmethod
    def on_pty(cls, path: Path) -> Station:
        return cls(os.open(path, os.O_RDWR | os.O_NOCTTY))

    @classmethod
    def on_tcp(cls, port: int) -> Station:
        link = socket.socket()
        # What one end does not read shall not fill a large buffer first.
        for size in (socket.SO_RCVBUF, socket.SO_SNDBUF):
            link.setsockopt(socket.SOL_SOCKET, size, 16384)
        link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            link.connect(("127.0.0.1", port))
        except OSError:
            link.close()
            raise
        return cls(link)

    def close(self) -> None:
        if isinstance(self._link, int):
            with suppress(OSError):
                os.close(self._link)
        else:
            self._link.close()

    def send(self, data: bytes) -> None:
        """Everything, however little the line takes at a time.

        Taking in is left alone while the line takes what is given: an answer is never seen before `next` looks for it.
        """
        while data:
            _, writable, _ = select.select([], [self._fd], [], 0.01)
            if writable:
                data = data[os.write(self._fd, data) :]
            else:
                self.pump(0.0)

    def write_without_reading(self, data: bytes) -> None:
        """Everything, waiting for the line as long as it takes, and not taking in a byte."""
        while data:
            select.select([], [self._fd], [], DEADLINE_S)
            data = data[os.write(self._fd, data) :]

    def unread(self) -> int:
        """Bytes that wait to be read."""
        return int.from_bytes(fcntl.ioctl(self._fd, termios.FIONREAD, bytes(4)), sys.byteorder)

    def pump(self, timeout_s: float, most: int = 65536) -> int:
        """Take in what there is, at most so many bytes, waiting for it at most so long; how many came."""
        readable, _, _ = select.select([self._fd], [], [], timeout_s)
        if not readable:
            return 0
        try:
            chunk = os.read(self._fd, most)
        except BlockingIOError:
            return 0
        except ConnectionResetError:
            chunk = b""
        self.is_closed = chunk == b""
        self.take(chunk)
        return len(chunk)

    def take(self, chunk: bytes) -> None:
        self.received += chunk
        for found in self._decoder.feed(chunk):
            if isinstance(found, Damage):
                self.failed += found.is_failed_frame
                self._text += found.data
            else:
                self.frames.append(found)

    def wait(self, condition: Callable[[], T | None]) -> T:
        """The first true value of `condition`; fails when there is none by the deadline."""
        deadline_s = time.monotonic() + DEADLINE_S
        while not (value := condition()):
            assert time.monotonic() < deadline_s, f"waited in vain; text {self.text!r}, {len(self.frames)} frames"
            self.pump(0.02)
        return value

    def ask_until(self, ask: Callable[[], None], condition: Callable[[], bool]) -> None:
        """Ask now, and again now and then, until `condition`; fails when it does not come by the deadline."""
        asked_s = -ASK_AGAIN_S

        def is_answered() -> bool:
            nonlocal asked_s
            if time.monotonic() - asked_s > ASK_AGAIN_S:
                asked_s = time.monotonic()
                ask()
            return condition()

        self.wait(is_answered)

    # ---- binary mode

    def open_binary(self) -> None:
        """Open binary mode and wait until it is open; asked again now and then, as a board may still be starting."""
        self.frames.clear()
        self.ask_until(lambda: self.send(OPEN_BINARY_MODE), lambda: self.count("heartbeat") > 0)

    def leave_binary(self) -> None:
        """Leave binary mode and wait until the shell answers; asked again now and then, as a busy computer may cut a
        command with a pause, which the board has to take for its end.
        """
        self.forget_text()

        def ask() -> None:
            self.command("exit_binary_mode")
            self.send(b"version\n")

        self.ask_until(ask, lambda: self._pending_text().endswith(f"\r{VERSION}\n"))
        self.settle()

    def settle(self) -> None:
        """Wait for the answers of the shell to what was asked more than once: they come before this one's."""
        self.send(b"\nsettled\n")
        self.wait(lambda: self._pending_text().endswith("unknown: settled (try `help`)\n"))

    def command(self, name: str, *values: float) -> None:
        self.send(encode_command(name, *values))

    @staticmethod
    def raw_command(name: str, payload: bytes) -> bytes:
        """The frame of a command with any payload, also one that a station would not send."""
        return frame_bytes(TO_BOARD, COMMANDS[name], payload)

    @staticmethod
    def command_struct(name: str) -> Struct:
        """The payload's layout."""
        return COMMANDS[name].struct

    def extend(self) -> Frame:
        """Ask for the capabilities; every command is acknowledged from then on."""
        self.command("capabilities")
        return self.next("capabilities")

    def next(self, name: str) -> Frame:
        """The next frame of that name; those before are forgotten."""
        self.frames.clear()
        return self.wait(lambda: self.newest(name))

    def newest(self, name: str) -> Frame | None:
        return next((frame for frame in reversed(self.frames) if frame.message.name == name), None)

    def count(self, name: str) -> int:
        return sum(frame.message.name == name for frame in self.frames)

    def acknowledgements(self, command: str) -> int:
        """How often that command was acknowledged."""
        return sum(
            frame.message.name == "acknowledgement" and frame.values[0] == COMMANDS[command].id for frame in self.frames
        )

    def names(self) -> set[str]:
        return {frame.message.name for frame in self.frames}

    def ask(self, name: str, *values: float) -> int:
        """Send a command and return the result in its acknowledgement."""
        return self.ask_bytes(COMMANDS[name].id, encode_command(name, *values))

    def ask_bytes(self, type_id: int, frame: bytes) -> int:
        self.frames.clear()
        self.send(frame)
        return self.wait(lambda: self._result_of(type_id)) - 1

    def _result_of(self, type_id: int) -> int | None:
        for frame in self.frames:
            if frame.message.name == "acknowledgement" and frame.values[0] == type_id:
                return int(frame.values[1]) + 1
        return None

    def heartbeat(self) -> dict[str, Any]:
        """The flags of the second heartbeat from now: the first may have been on its way already."""
        self.next("heartbeat")
        return dict(zip(HEARTBEAT, self.next("heartbeat").values, strict=True))

    def heartbeats(self, number: int) -> None:
        """Forget what came in and wait for so many heartbeats, the board's own measure of time."""
        self.frames.clear()
        self.wait(lambda: self.count("heartbeat") >= number)

    # ---- text mode

    @property
    def text(self) -> str:
        return self._text.decode("ascii", "replace")

    def lines(self, line: str) -> list[str]:
        """Send a line to the shell; the lines of its answer."""
        self.forget_text()
        # The version behind it says when the answer is complete.
        self.send(f"{line}\nversion\n".encode())
        self.wait(lambda: self._pending_text().endswith(f"\r{VERSION}\n"))
        answer = self._pending_text().removesuffix(f"\r{VERSION}\n")
        assert all(part.startswith("\r") for part in answer.split("\n")[:-1])
        return [part for part in answer.replace("\r", "").split("\n") if part]

    def line(self, line: str) -> str:
        """The only line of the answer."""
        (answer,) = self.lines(line)
        return answer

    def table(self, line: str) -> dict[str, str]:
        """The answer's lines as name and value."""
        pairs = [re.split(" {2,}", part, maxsplit=1) for part in self.lines(line)]
        return {pair[0]: pair[1] for pair in pairs if len(pair) == 2}

    def forget_text(self) -> None:
        self._flush()
        self._text.clear()

    def _pending_text(self) -> str:
        self._flush()
        return self.text

    def _flush(self) -> None:
        for found in self._decoder.flush():
            if isinstance(found, Damage):
                self._text += found.data


HEARTBEAT: Final = (
    "autopilot", "autotrim", "auto_switch", "servos", "gps", "statistics", "ahrs", "inertial", "analog", "fly_by_wire",
    "autopilot_hil", "autotrim_hil",
)  # fmt: skip
"""The twelve bytes of the heartbeat, in the order of the wire."""

LEVEL_FLIGHT: Final = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 28.0, 3.0, 0.0, 1000.0, 0.0, 55.0, 27.95, -15.38)
"""A plausible command 50: level at 1000 ft and 55 kt near the airport, stick in the middle, half throttle."""

EXTENSIONS: Final = frozenset(message.name for message in TELEMETRY_BY_NAME.values() if message.extension)
