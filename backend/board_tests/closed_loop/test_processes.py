"""The three real programs in lock-step: they fly the very flight that the pure parts fly in one process."""

import select
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from epf_gcs.contract.simulator_faults import MAGIC
from epf_gcs.lab.closed_loop import ClosedLoop
from epf_gcs.lab.laws import library
from epf_gcs.simulator.simulation import SimulationOptions
from tests.support.ports import free_port
from tests.support.waiting import DEADLINE_S

BOARD = library().with_name("epf-board")
LOOPBACK = "127.0.0.1"
FRAMES = 5000  # 100 simulated seconds: past the first waypoint


class Wire:
    """Stands between simulator and gateway, and keeps the simulator's rows.

    It hands on what the flight is made of. That the simulator takes orders for faults is kept from the station, which
    would ask for them by the clock.
    """

    def __init__(self) -> None:
        self.from_simulator = udp_socket()
        self.from_gateway = udp_socket()
        self.rows: list[bytes] = []
        self.answers = 0

    def carry(self, gateway: tuple[str, int], simulator: tuple[str, int], frames: int) -> None:
        """Until the gateway has answered so many frames."""
        while self.answers < frames:
            ready, _, _ = select.select([self.from_simulator, self.from_gateway], [], [], DEADLINE_S)
            assert ready, f"nothing comes any more after {self.answers} frames"
            if self.from_simulator in ready:
                datagram = self.from_simulator.recv(4096)
                # Lock-step sends the same rows again when a busy machine takes long to answer: once is enough.
                if not datagram.startswith(MAGIC) and (not self.rows or datagram != self.rows[-1]):
                    self.rows.append(datagram)
                    self.from_gateway.sendto(datagram, gateway)
            if self.from_gateway in ready:
                self.from_simulator.sendto(self.from_gateway.recv(4096), simulator)
                self.answers += 1

    def close(self) -> None:
        self.from_simulator.close()
        self.from_gateway.close()


def udp_socket() -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind((LOOPBACK, 0))
    return sock


@contextmanager
def program(*command: str | Path) -> Iterator[None]:
    """A program that is stopped at the end."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        try:
            yield
        finally:
            process.terminate()
            try:
                process.wait(DEADLINE_S)
            finally:
                process.kill()


def eventually(condition: Callable[[], bool]) -> None:
    deadline_s = time.monotonic() + DEADLINE_S
    while not condition():
        assert time.monotonic() < deadline_s, "waited in vain"
        time.sleep(0.05)


class Gateway:
    """The gateway's interface."""

    def __init__(self, port: int) -> None:
        self._http = httpx.Client(base_url=f"http://{LOOPBACK}:{port}/api/v1", timeout=DEADLINE_S)

    def close(self) -> None:
        self._http.close()

    def answers(self) -> bool:
        try:
            return self._http.get("/status").is_success
        except httpx.TransportError:
            return False

    def status(self) -> dict[str, Any]:
        status: dict[str, Any] = self._http.get("/status").raise_for_status().json()
        return status

    def put(self, path: str, /, **body: str | int) -> None:
        self._http.put(path, json=body).raise_for_status()

    def command(self, name: str) -> None:
        answer = self._http.post(f"/commands/{name}", json={}).raise_for_status().json()
        assert answer["state"] == "confirmed", answer


@pytest.fixture
def wire() -> Iterator[Wire]:
    with closing(Wire()) as wire:
        yield wire


def test_board_gateway_and_simulator_fly_the_same_bytes_as_the_pure_parts(tmp_path: Path, wire: Wire) -> None:
    http_port, gateway_port = free_port(socket.SOCK_STREAM), free_port(socket.SOCK_DGRAM)
    simulator_port = free_port(socket.SOCK_DGRAM)
    line = tmp_path / "board"
    with ExitStack() as stack:
        stack.enter_context(program(BOARD, "--pty", line, "--card", tmp_path / "card", "--hil-period-ms", "20"))
        stack.enter_context(
            program(
                *(sys.executable, "-m", "epf_gcs.launcher.gateway", "--port", str(http_port)),
                *("--data-dir", tmp_path / "data", "--board", f"pty://{line}"),
            )
        )
        gateway = stack.enter_context(closing(Gateway(http_port)))
        eventually(gateway.answers)
        eventually(lambda: gateway.status()["board"]["state"] == "open")
        gateway.put(
            "/links/simulator",
            receive_port=gateway_port,
            send_host=LOOPBACK,
            send_port=wire.from_gateway.getsockname()[1],
            profile="xp10",
        )
        gateway.put("/hil", source="joystick", path="assisted")
        for command in ("hil_load_gando", "autotrim_on", "autopilot_on"):
            gateway.command(command)
        # Everything is as it shall be before the first frame, so that the flight depends on nothing but the frames.
        stack.enter_context(
            program(
                *(sys.executable, "-m", "epf_gcs.simulator", "--lockstep", "--listen", str(simulator_port)),
                *("--send-to", f"{LOOPBACK}:{wire.from_simulator.getsockname()[1]}"),
            )
        )
        wire.carry((LOOPBACK, gateway_port), (LOOPBACK, simulator_port), FRAMES)
        status = gateway.status()
    assert status["board"]["frames_damaged"] == 0
    assert status["simulator"]["datagrams_dropped"] == 0
    assert status["simulator"]["frames_to_board"] == status["simulator"]["frames_to_simulator"] == FRAMES

    with ClosedLoop(SimulationOptions()) as loop:
        loop.command("hil_load_gando")
        loop.command("autopilot_on")
        loop.fly(FRAMES / 50.0)
    assert loop.samples[-1].waypoint == 1
    assert wire.rows[:FRAMES] == loop.bytes_to_station
