"""`epf-run`: the real board, simulator and gateway, started and stopped as a person does it."""

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any, Self

import httpx
import pytest
from websockets.sync.client import connect

from epf_gcs.launcher.options import BOARD_PROGRAM
from epf_gcs.launcher.ports import LOOPBACK, free_tcp_port, listener_of
from epf_gcs.product import BOARD
from tests.support.ports import free_udp_port
from tests.support.programs import sockets_of, words_of
from tests.support.waiting import DEADLINE_S

GANDO_WAYPOINTS = 8

Status = dict[str, Any]


class Run:
    """One `epf-run` in a folder of its own."""

    def __init__(self, data: Path, *arguments: str, port: int | None = None) -> None:
        self.port = port or free_tcp_port()
        self.url = f"http://{LOOPBACK}:{self.port}"
        self.data = data
        self.process = subprocess.Popen(
            [sys.executable, "-m", "epf_gcs.launcher", "--port", str(self.port), "--data-dir", str(data), *arguments],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self._said: list[str] = []
        assert self.process.stderr is not None
        self._listener = threading.Thread(target=self._listen, args=(self.process.stderr,))
        self._listener.start()

    def _listen(self, stream: Any) -> None:
        self._said.extend(stream)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(DEADLINE_S)
        self._listener.join(DEADLINE_S)
        for stream in (self.process.stdout, self.process.stderr):
            assert stream is not None
            stream.close()

    def first_line(self) -> str:
        """What it prints once everything flies; empty where it has ended without."""
        assert self.process.stdout is not None
        return self.process.stdout.readline()

    def said(self) -> str:
        """Everything on its standard error; it has to have ended."""
        self.process.wait(DEADLINE_S)
        self._listener.join(DEADLINE_S)
        return "".join(self._said)

    def status(self) -> Status:
        status: Status = httpx.get(f"{self.url}/api/v1/status", timeout=DEADLINE_S).json()
        return status

    def telemetry(self) -> dict[str, Any]:
        telemetry: dict[str, Any] = httpx.get(f"{self.url}/api/v1/telemetry", timeout=DEADLINE_S).json()
        return telemetry

    def autopilot_is_on(self) -> bool:
        """As the newest heartbeat says, if it is new."""
        heartbeat = self.telemetry().get("heartbeat")
        return heartbeat is not None and not heartbeat["stale"] and heartbeat["values"]["autopilot_hil"] is True

    def eventually(self, condition: Callable[[Status], bool]) -> Status:
        """Wait until the gateway's status is so."""
        deadline_s = time.monotonic() + DEADLINE_S
        status: Status | None = None
        while time.monotonic() < deadline_s:
            try:
                status = self.status()
            except httpx.TransportError:
                status = None
            if status is not None and condition(status):
                return status
            time.sleep(0.05)
        raise AssertionError(f"waited in vain; status {status}")

    def children(self) -> dict[str, int]:
        """Name of the program -> process number, of the launcher's programs and of the gateway's two."""
        names = self._children_of(self.process.pid)
        if "gateway" in names:
            names |= self._children_of(names["gateway"])
        return names

    def _children_of(self, parent: int) -> dict[str, int]:
        names = {}
        for entry in Path("/proc").iterdir():
            if entry.name.isdigit() and parent_of(entry) == parent:
                words = words_of(int(entry.name))
                # One that has just died, or has not become its program yet, has no words of its own.
                if words[:1] == [str(BOARD.folder / BOARD_PROGRAM)]:
                    names["board"] = int(entry.name)
                elif "-m" in words and (name := words[words.index("-m") + 1]) != "epf_gcs.launcher":
                    names[name.rpartition(".")[2]] = int(entry.name)
        return names


def parent_of(process: Path) -> int | None:
    try:
        return int((process / "stat").read_text().rpartition(")")[2].split()[1])
    except OSError:
        return None


def exists(pid: int) -> bool:
    return Path(f"/proc/{pid}").exists()


def flies(status: Status) -> bool:
    """Surfaces of the board go to the simulator."""
    return (
        status["simulator"]["frames_to_simulator"] > 0
        and status["simulator"]["hil_round_trip_ms"]["newest"] is not None
    )


@pytest.fixture(scope="module")
def demonstration(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    with Run(tmp_path_factory.mktemp("demonstration")) as run:
        assert run.first_line() == f"{run.url}\n", run.said()
        yield run


def test_it_prints_its_address_when_gando_is_flown(demonstration: Run) -> None:
    # The status and the heartbeat that it is made of are asked for one after the other: wait for both.
    in_automatic_flight = {"source": "joystick", "path": "assisted"}
    status = demonstration.eventually(
        lambda status: (
            flies(status) and status["hil"].items() >= in_automatic_flight.items() and demonstration.autopilot_is_on()
        )
    )
    assert status["board"]["state"] == "open"
    assert status["simulator"]["state"] == "open"
    assert demonstration.telemetry()["fms_hil_plan"]["values"]["waypoint"] in range(GANDO_WAYPOINTS)


def test_no_port_is_open_beyond_the_loopback(demonstration: Run) -> None:
    addresses = [
        address
        for pid in (demonstration.process.pid, *demonstration.children().values())
        for address in local_addresses(pid)
    ]
    assert len(addresses) >= 3
    assert all(address.startswith("127.") for address in addresses), addresses


def test_a_gateway_that_is_killed_is_started_again_and_carries_on(demonstration: Run) -> None:
    before = demonstration.children()
    os.kill(before["gateway"], signal.SIGKILL)
    demonstration.eventually(
        lambda status: demonstration.children().get("gateway") != before["gateway"] and flies(status)
    )
    after = demonstration.children()
    assert (after["board"], after["simulator"]) == (before["board"], before["simulator"])
    demonstration.eventually(lambda _: demonstration.autopilot_is_on())


def test_a_board_that_is_killed_is_started_again_and_flies_again(demonstration: Run) -> None:
    before = demonstration.children()
    # A page that is open has the controls, and does not keep the launcher from closing the loop again.
    with connect(f"ws://{LOOPBACK}:{demonstration.port}/api/v1/stream"):
        demonstration.eventually(lambda status: status["control"]["client"] is not None)
        os.kill(before["board"], signal.SIGKILL)
        demonstration.eventually(lambda _: demonstration.children().get("board", before["board"]) != before["board"])
        demonstration.eventually(lambda status: flies(status) and demonstration.autopilot_is_on())
    assert demonstration.children()["gateway"] == before["gateway"]


def test_a_second_one_in_the_same_folder_is_refused(demonstration: Run) -> None:
    with Run(demonstration.data) as second:
        assert second.first_line() == ""
        assert "Another epf-run is using the folder" in second.said()
        assert second.process.returncode == 1


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_stops_everything(tmp_path: Path, number: signal.Signals) -> None:
    with Run(tmp_path) as run:
        assert run.first_line() == f"{run.url}\n", run.said()
        children = run.children()
        assert set(children) == {"board", "simulator", "gateway", "flight", "web"}
        run.process.send_signal(number)
        assert run.process.wait(DEADLINE_S) == 0
        assert not any(exists(pid) for pid in children.values())
        assert "was killed" not in run.said()
        # The next start finds nothing in its way.
        assert "Flown" in (tmp_path / "logs" / "simulator.log").read_text()
        assert not (tmp_path / "board.pty").exists()


def test_a_signal_while_it_starts_stops_everything(tmp_path: Path) -> None:
    with Run(tmp_path) as run:
        deadline_s = time.monotonic() + DEADLINE_S
        while not run.children():
            assert time.monotonic() < deadline_s
            time.sleep(0.01)
        run.process.send_signal(signal.SIGINT)
        run.process.wait(DEADLINE_S)
        assert run.first_line() == ""
        assert run.children() == {}


def test_a_taken_port_is_told_and_nothing_is_started(tmp_path: Path) -> None:
    with closing(socket.create_server((LOOPBACK, 0))) as server:
        taken = server.getsockname()[1]
        with Run(tmp_path, port=taken) as run:
            said = run.said()
    assert run.process.returncode == 1
    assert said.startswith(f"Port {taken} is taken by another program (")
    assert "--port" in said
    assert not (tmp_path / "logs").exists()


def test_a_board_that_is_real_is_opened_and_left_as_it_is(tmp_path: Path) -> None:
    line = tmp_path / "other.pty"
    with board_of_somebody(line), Run(tmp_path / "data", "--board", f"pty://{line}") as run:
        assert run.first_line() == f"{run.url}\n", run.said()
        status = run.eventually(lambda status: status["board"]["state"] == "open" and has_heartbeat(status))
        assert status["board"]["url"] == f"pty://{line}"
        assert "board" not in run.children()
        assert not run.autopilot_is_on()
    assert "left as they are" in run.said()


def test_the_processor_s_image_takes_the_demonstration_board_s_place(built_images: None, tmp_path: Path) -> None:
    with Run(tmp_path, "--board", "qemu") as run:
        assert run.first_line() == f"{run.url}\n", run.said()
        status = run.eventually(lambda status: flies(status) and run.autopilot_is_on())
        port = int(status["board"]["url"].rpartition(":")[2])
        assert status["board"]["url"] == f"tcp://{LOOPBACK}:{port}"
        assert listener_of(port) is not None
    assert run.process.returncode == 0
    assert listener_of(port) is None


def test_an_x_plane_takes_the_embedded_simulators_place_whenever_it_comes(tmp_path: Path) -> None:
    listens_on, sends_to = free_udp_port(), free_udp_port()
    with Run(tmp_path, "--xplane", f"{LOOPBACK}:{listens_on}", "--receive-port", str(sends_to)) as run:
        assert run.first_line() == f"{run.url}\n", run.said()
        assert set(run.children()) == {"board", "gateway", "flight", "web"}
        assert not flies(run.status())
        with x_plane_of_somebody(listens_on, sends_to):
            run.eventually(flies)
    assert f"sends its data to UDP port {sends_to} here" in run.said()


def test_a_board_that_cannot_be_opened_is_told(tmp_path: Path) -> None:
    with Run(tmp_path, "--board", str(tmp_path / "nothing")) as run:
        assert run.first_line() == ""
        said = run.said()
    assert run.process.returncode == 1
    assert str(tmp_path / "nothing") in said
    assert "Traceback" not in said


def has_heartbeat(status: Status) -> bool:
    return status["board"]["heartbeat_age_s"] is not None


@contextmanager
def x_plane_of_somebody(listens_on: int, sends_to: int) -> Iterator[None]:
    command = [
        sys.executable,
        "-m",
        "epf_gcs.simulator",
        "--listen",
        str(listens_on),
        "--send-to",
        f"{LOOPBACK}:{sends_to}",
    ]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as simulator:
        try:
            yield
        finally:
            simulator.terminate()


@contextmanager
def board_of_somebody(line: Path) -> Iterator[None]:
    with subprocess.Popen([BOARD.file(BOARD_PROGRAM), "--pty", line], stdout=subprocess.DEVNULL) as board:
        deadline_s = time.monotonic() + DEADLINE_S
        while not line.exists():
            assert time.monotonic() < deadline_s
            time.sleep(0.01)
        try:
            yield
        finally:
            board.terminate()


def local_addresses(pid: int) -> list[str]:
    """Addresses of the IPv4 and IPv6 sockets that a process listens or is bound on."""
    sockets = sockets_of(pid)
    addresses = []
    for table in ("tcp", "tcp6", "udp", "udp6"):
        for line in Path(f"/proc/net/{table}").read_text().splitlines()[1:]:
            fields = line.split()
            if f"socket:[{fields[9]}]" in sockets:
                host = bytes.fromhex(fields[1].partition(":")[0])
                addresses.append(socket.inet_ntoa(host[::-1]) if len(host) == 4 else f"IPv6 {host.hex()}")
    return addresses
