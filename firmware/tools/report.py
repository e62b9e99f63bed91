"""What an image needs of its processor: memory, stack and time, measured on the image itself under QEMU.

Usage: report.py BUILD SIZE_PROGRAM [SECONDS], by a Python that has the gateway's packages.

The image flies in the loop meanwhile: 50 frames a second with every stream on. Times are the computer's, so they mean
something on one that has little else to do.
"""

from __future__ import annotations

import socket
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from gateway.codec.encode import encode_command
from gateway.codec.frame import Frame, FrameDecoder
from gateway.codec.messages_gen import OPEN_BINARY_MODE
from launcher.emulated import EmulatedBoard

PERIOD_S = 0.02
LEVEL_FLIGHT = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 28.0, 3.0, 0.0, 1000.0, 0.0, 55.0, 27.95, -15.38)
STARTED_S = 20.0


class Line:
    """The image's serial line."""

    def __init__(self, port: int) -> None:
        deadline_s = time.monotonic() + STARTED_S
        while True:
            try:
                self._socket = socket.create_connection(("127.0.0.1", port))
                break
            except ConnectionRefusedError:
                if time.monotonic() > deadline_s:
                    sys.exit("report: nobody listens on the image's line")
                time.sleep(0.05)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._decoder = FrameDecoder()

    def send(self, data: bytes) -> None:
        """All of it."""
        self._socket.sendall(data)

    def read(self, timeout_s: float) -> bytes:
        """What comes in; empty when nothing does in this time."""
        self._socket.settimeout(max(timeout_s, 0.0001))
        try:
            return self._socket.recv(65536)
        except TimeoutError:
            return b""

    def names(self, timeout_s: float) -> list[str]:
        """Names of the frames that came in."""
        return [found.message.name for found in self._decoder.feed(self.read(timeout_s)) if isinstance(found, Frame)]


def round_trips_ms(line: Line, seconds: float) -> tuple[list[float], int]:
    """Milliseconds from each command 50 to the surfaces that answer it, and how many had no answer in a second."""
    times: list[float] = []
    lost = 0
    due_s = time.monotonic()
    for _ in range(round(seconds / PERIOD_S)):
        due_s += PERIOD_S
        while (rest_s := due_s - time.monotonic()) > 0:
            line.names(rest_s)
        begun_s = time.monotonic()
        line.send(encode_command("xplane_info", *LEVEL_FLIGHT))
        while "hil_surfaces" not in line.names(begun_s + 1.0 - time.monotonic()):
            if time.monotonic() - begun_s >= 1.0:
                lost += 1
                break
        else:
            times.append((time.monotonic() - begun_s) * 1000.0)
    return times, lost


def ask(line: Line, words: str) -> str:
    """The shell's answer."""
    while line.read(0.3):
        pass
    line.send(f"{words}\n".encode())
    answer = b""
    while chunk := line.read(0.5):
        answer += chunk
    return answer.decode("ascii", "replace").replace("\r", "")


def fly(name: str, build: Path, card: Path, seconds: float) -> None:
    """Fly one image and say what it needed."""
    emulated = EmulatedBoard.named(name)
    if emulated is None:
        raise ValueError(name)
    with subprocess.Popen(emulated.command(build.resolve().parent, card)) as qemu:
        try:
            line = Line(emulated.port)
            deadline_s = time.monotonic() + STARTED_S
            while "heartbeat" not in line.names(0.5):
                line.send(OPEN_BINARY_MODE)
                if time.monotonic() > deadline_s:
                    sys.exit("report: the image does not answer")
            line.send(encode_command("capabilities") + encode_command("start") + encode_command("hil_load_gando"))
            line.send(encode_command("control_source", 1) + encode_command("autopilot_on"))
            line.send(encode_command("store_parameters"))
            times, lost = round_trips_ms(line, seconds)
            line.send(encode_command("stop") + encode_command("exit_binary_mode"))
            ask(line, "help")  # the longest way through the shell
            tasks = ask(line, "tasks")
        finally:
            qemu.terminate()
    if not times:
        sys.exit("report: no frame was answered")
    cuts = statistics.quantiles(times, n=100)
    print(f"\n{emulated.folder} under QEMU, {seconds:.0f} s at 50 Hz with every stream on")
    print(f"HIL round trip: p50 {cuts[49]:.1f} ms, p99 {cuts[98]:.1f} ms; {len(times)} answered, {lost} not")
    print(tasks, end="")


def main(build: Path, size: str, seconds: float) -> None:
    """Print the whole report."""
    for program, image in (
        (size, "stm32f405/epf-board.elf"),
        (size, "mps2_an386/epf-board.elf"),
        ("size", "posix/epf-board"),
    ):
        subprocess.run([program, build / image], check=True)
    with tempfile.TemporaryDirectory() as card:
        for name in ("qemu", "qemu-an386"):
            fly(name, build, Path(card), seconds)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], float(sys.argv[3]) if len(sys.argv) > 3 else 20.0)
