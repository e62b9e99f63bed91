"""What an image needs of its processor: memory, stack and time, measured on the image itself under QEMU.

Usage: report.py BUILD SIZE_PROGRAM [SECONDS]

Meanwhile the image flies in the loop: 50 frames a second with every stream on. The times depend on what else this
computer has to do: measure on an idle one.
"""

from __future__ import annotations

import socket
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from station import OPEN_BINARY_MODE, Listener, command_bytes

PERIOD_S = 0.02
LEVEL_FLIGHT = (0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 28.0, 3.0, 0.0, 1000.0, 0.0, 55.0, 27.95, -15.38)
STARTED_S = 20.0
QEMU = "qemu-system-arm"
MACHINE = "stm32f405"


def free_port() -> int:
    """Return a TCP port of the loopback that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def emulator(build: Path, card: Path, port: int) -> list[str]:
    """Return the command that runs an image, its serial line on a TCP port and `card` as its card."""
    line = f"socket,id=line,host=127.0.0.1,port={port},server=on,wait=off,nodelay=on"
    words = [QEMU, "-M", "netduinoplus2", "-kernel", str(build / MACHINE / "epf-board-qemu.elf")]
    words += ["-display", "none", "-monitor", "none", "-serial", "chardev:line", "-chardev"]
    words += [f"{line},mux=on", "-echr", "256"]
    return [*words, "-semihosting-config", f"enable=on,target=native,arg=--card,arg={str(card).replace(',', ',,')}"]


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
        self._listener = Listener()

    def send(self, data: bytes) -> None:
        """Send all of it."""
        self._socket.sendall(data)

    def read(self, timeout_s: float) -> bytes:
        """Return what came in, or nothing after this time."""
        self._socket.settimeout(max(timeout_s, 0.0001))
        try:
            return self._socket.recv(65536)
        except TimeoutError:
            return b""

    def names(self, timeout_s: float) -> list[str]:
        """Return the names of the frames that came in."""
        return self._listener.feed(self.read(timeout_s))


def round_trips_ms(line: Line, seconds: float) -> tuple[list[float], int]:
    """Return the milliseconds from each command 50 to its answer, and how many had no answer in a second."""
    times: list[float] = []
    lost = 0
    due_s = time.monotonic()
    for _ in range(round(seconds / PERIOD_S)):
        due_s += PERIOD_S
        while (rest_s := due_s - time.monotonic()) > 0:
            line.names(rest_s)
        begun_s = time.monotonic()
        line.send(command_bytes("xplane_info", *LEVEL_FLIGHT))
        while "hil_surfaces" not in line.names(begun_s + 1.0 - time.monotonic()):
            if time.monotonic() - begun_s >= 1.0:
                lost += 1
                break
        else:
            times.append((time.monotonic() - begun_s) * 1000.0)
    return times, lost


def ask(line: Line, words: str) -> str:
    """Return the shell's answer."""
    while line.read(0.3):
        pass
    line.send(f"{words}\n".encode())
    answer = b""
    while chunk := line.read(0.5):
        answer += chunk
    return answer.decode("ascii", "replace").replace("\r", "")


def fly(build: Path, card: Path, seconds: float) -> None:
    """Fly one image and print what it needed."""
    port = free_port()
    with subprocess.Popen(emulator(build, card, port)) as qemu:
        try:
            line = Line(port)
            deadline_s = time.monotonic() + STARTED_S
            while "heartbeat" not in line.names(0.5):
                line.send(OPEN_BINARY_MODE)
                if time.monotonic() > deadline_s:
                    sys.exit("report: the image does not answer")
            line.send(command_bytes("capabilities") + command_bytes("start") + command_bytes("hil_load_gando"))
            line.send(command_bytes("control_source", 1) + command_bytes("autopilot_on"))
            line.send(command_bytes("store_parameters"))
            times, lost = round_trips_ms(line, seconds)
            line.send(command_bytes("stop") + command_bytes("exit_binary_mode"))
            ask(line, "help")  # the longest way through the shell
            tasks = ask(line, "tasks")
        finally:
            qemu.terminate()
    if not times:
        sys.exit("report: no frame was answered")
    cuts = statistics.quantiles(times, n=100)
    print(f"\n{MACHINE} under QEMU, {seconds:.0f} s at 50 Hz with every stream on")
    print(f"HIL round trip: p50 {cuts[49]:.1f} ms, p99 {cuts[98]:.1f} ms; {len(times)} answered, {lost} not")
    print(tasks, end="")


def main(build: Path, size: str, seconds: float) -> None:
    """Print the whole report."""
    for program, image in (
        (size, f"{MACHINE}/epf-board.elf"),
        ("size", "posix/epf-board"),
    ):
        subprocess.run([program, build / image], check=True)
    with tempfile.TemporaryDirectory() as card:
        fly(build, Path(card), seconds)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], float(sys.argv[3]) if len(sys.argv) > 3 else 20.0)
