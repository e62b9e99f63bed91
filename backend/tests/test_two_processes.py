"""Flight and web die alone: what one does while the other is gone, and how both find each other again."""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
import time
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx
import orjson
import pytest
from mcap.records import Message
from mcap.stream_reader import StreamReader
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from epf_gcs.bus.station_end import StationEnd
from epf_gcs.contract.requests import RunCommand
from epf_gcs.xplane.datagram import release_datagram
from tests.bus.test_ends import Heard, connected
from tests.support.fake_board import FakeBoard
from tests.support.page import Page, page
from tests.support.ports import free_udp_port
from tests.support.programs import Program, children_of, gateway_process, words_of
from tests.support.simulator import WHOLE, Simulator
from tests.support.waiting import DEADLINE_S, eventually, eventually_async

WINDOWS = Path(__file__).parent / "support" / "windows"
TURN = (-0.5, 0.25, -0.125, 0.5)
LET_GO = (0.0, 0.0, 0.0, 0.5)


class Flying:
    """A gateway in a closed loop: the fake board answers each frame of the simulator with surfaces."""

    def __init__(self, program: Program, board: FakeBoard, simulator: Simulator) -> None:
        self.program = program
        self.board = board
        self.simulator = simulator
        self.url = program.wait_for_words(r"url=(http://\S+)")
        self.http = httpx.Client(base_url=f"{self.url}/api/v1", timeout=DEADLINE_S)

    def pid(self, name: str) -> int:
        """Process number of `flight` or `web`."""
        return self.pids()[name]

    def pids(self) -> dict[str, int]:
        found = {}
        pid = self.program.process.pid
        for child in children_of(pid):
            words = words_of(child)
            if "-m" in words:
                found[words[words.index("-m") + 1].rpartition(".")[2]] = int(child)
        return found

    def status(self) -> dict[str, Any] | None:
        try:
            answer: dict[str, Any] = self.http.get("/status").raise_for_status().json()
        except httpx.HTTPError:
            return None
        return answer

    def fly_a_frame(self) -> None:
        """One frame of the simulator reaches the board, and the board's surfaces reach the simulator."""
        before = self.board.count("xplane_info")
        got = len(self.simulator.got)
        self.simulator.send(WHOLE)
        eventually(lambda: self.board.count("xplane_info") == before + 1, "the frame reaches the board")
        eventually(lambda: self._moved(got), "the surfaces reach the simulator")

    def flies(self) -> bool:
        """Whether the flight process has the board, and a frame of the simulator moves its surfaces."""
        if ((self.status() or {}).get("board") or {}).get("state") != "open":
            return False
        self.fly_a_frame()
        return True

    def states_of_flights(self) -> list[str]:
        """What the library says of each flight."""
        return [one["state"] for one in self.http.get("/flights").raise_for_status().json()["flights"]]

    def stick(self) -> tuple[float, ...]:
        """Elevator, aileron, rudder and throttle that the board is told with one more frame."""
        self.fly_a_frame()
        told = [
            values
            for name, values in zip(self.board.received, self.board.arguments, strict=False)
            if name == "xplane_info" and len(values) == 15
        ]
        return tuple(told[-1][:4])

    def _moved(self, got: int) -> bool:
        self.simulator.heard(b"")
        return len(self.simulator.got) > got


@contextmanager
def hand_on(pilot: Page) -> Iterator[None]:
    """A gamepad that is held in one position, as a page sends it for as long as it has a line."""
    stop = threading.Event()

    def hold() -> None:
        with suppress(ConnectionClosed):
            while not stop.wait(0.02):
                position = dict(zip(("elevator", "aileron", "rudder", "throttle"), TURN, strict=True))
                pilot.send({"type": "stick", **position, "t_ms": time.monotonic() * 1000.0})

    thread = threading.Thread(target=hold)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


@pytest.fixture
def flying(tmp_path: Path, board: FakeBoard) -> Iterator[Flying]:
    with flight(tmp_path, board) as made:
        yield made


@contextmanager
def flight(tmp_path: Path, board: FakeBoard, url: str = "") -> Iterator[Flying]:
    with Simulator() as simulator, gateway_process(tmp_path / "data") as program:
        made = Flying(program, board, simulator)
        simulator.port = free_udp_port()
        made.http.put("/links/board", json={"url": url or board.url}).raise_for_status()
        address = {"receive_port": simulator.port, "send_port": simulator.own_port}
        made.http.put("/links/simulator", json=address).raise_for_status()
        eventually(lambda: (made.status() or {})["board"]["state"] == "open", "the board opens")
        made.http.put("/hil", json={"path": "assisted"}).raise_for_status()
        made.fly_a_frame()
        state = tmp_path / "data" / "state.json"
        eventually(lambda: state.exists() and b'"assisted"' in state.read_bytes(), "the links are remembered")
        yield made
        made.http.close()


def test_on_windows_both_processes_start_fly_come_back_after_a_kill_and_end(
    tmp_path: Path, board: FakeBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    # As far as Linux can be Windows: its sockets, its serial ports, its ways to start and end programs.
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, (str(WINDOWS), os.environ.get("PYTHONPATH")))))
    with flight(tmp_path, board, f"serial://{board.path}") as flying:
        assert "tcp" in orjson.loads((tmp_path / "data" / "flight.json").read_bytes())
        web = flying.pid("web")
        os.kill(web, signal.SIGKILL)
        flying.fly_a_frame()
        eventually(lambda: (flying.status() or {}).get("board", {}).get("state") == "open", "the web process is back")
        assert flying.pid("web") != web
        os.kill(flying.pid("flight"), signal.SIGKILL)
        eventually(flying.flies, "the flight process is back")
        # A program of the web process has looked into what the first one recorded.
        eventually(lambda: flying.states_of_flights().count("indexed") == 1, "the killed flight can be looked at")
        assert flying.program.end(signal.SIGINT) == 0
    assert board.received[-1:] == ["exit_binary_mode"]


def test_the_loop_and_the_recording_go_on_while_the_web_process_is_dead(flying: Flying, tmp_path: Path) -> None:
    with connect(f"{flying.url.replace('http', 'ws')}/api/v1/stream?rate=0") as viewer:
        viewer.recv(DEADLINE_S)
        web = flying.pid("web")
        os.kill(flying.pid("flight"), 0)
        os.kill(web, signal.SIGSTOP)
        for _ in range(20):
            flying.fly_a_frame()
        os.kill(web, signal.SIGKILL)
        for _ in range(20):
            flying.fly_a_frame()
    eventually(lambda: flying.pids().get("web") not in (None, web), "another web process starts")
    eventually(lambda: flying.status() is not None, "it answers at the same address")
    status = flying.status()
    assert status is not None
    assert status["simulator"]["frames_to_board"] == 41
    assert status["simulator"]["frames_skipped"] == {}
    assert status["board"]["reopened"] == 0
    flying.program.end()
    (file,) = (tmp_path / "data" / "recordings").glob("*.mcap")
    with file.open("rb") as stream:
        messages = [record for record in StreamReader(stream).records if isinstance(record, Message)]
    assert b"".join(message.data for message in messages if message.channel_id == 2) == flying.board.raw


def test_a_page_that_had_control_has_it_again_after_the_web_process_died(flying: Flying) -> None:
    stream = f"{flying.url.replace('http', 'ws')}/api/v1/stream"
    with connect(stream) as page:
        client = orjson.loads(page.recv(DEADLINE_S))["client"]
        eventually(lambda: (flying.status() or {})["control"]["client"] == client, "it has control")
        os.kill(flying.pid("web"), signal.SIGKILL)
    eventually(lambda: flying.status() is not None, "the web process is back")
    with connect(stream) as stranger, connect(f"{stream}?client={client}") as page:
        assert not orjson.loads(stranger.recv(DEADLINE_S))["has_control"]
        hello = orjson.loads(page.recv(DEADLINE_S))
        assert (hello["client"], hello["has_control"]) == (client, True)


def test_a_gamepad_is_let_go_when_the_web_process_is_killed_and_flies_on_when_its_page_is_back(flying: Flying) -> None:
    with page(flying.url) as pilot, hand_on(pilot):
        chosen = pilot.http.put("/hil", json={"stick": "gamepad", "gamepad": "Test Pad"})
        assert chosen.json()["stick"]["state"] == "live"
        eventually(lambda: flying.stick() == TURN, "the gamepad flies")
        os.kill(flying.pid("web"), signal.SIGSTOP)
        eventually(lambda: flying.stick() == LET_GO, "a hung web process holds no stick")
        os.kill(flying.pid("web"), signal.SIGCONT)
        eventually(lambda: flying.stick() == TURN, "it goes on")
        os.kill(flying.pid("web"), signal.SIGKILL)
        eventually(lambda: flying.stick()[:3] == LET_GO[:3], "nor does a dead one")
    eventually(lambda: flying.status() is not None, "the web process is back")
    with page(flying.url, f"/api/v1/stream?client={pilot.client}") as pilot, hand_on(pilot):
        assert pilot.hello["has_control"]
        eventually(lambda: flying.stick() == TURN, "its gamepad flies on, without being chosen again")


def test_the_loss_of_the_flight_process_is_said_at_once_and_it_flies_again(flying: Flying) -> None:
    with connect(f"{flying.url.replace('http', 'ws')}/api/v1/stream?rate=0", max_size=None) as viewer:
        flight = flying.pid("flight")
        os.kill(flight, signal.SIGKILL)
        status = _until(viewer, lambda one: one["type"] == "status" and one["data"]["board"]["state"] == "lost")["data"]
        assert [alarm["id"] for alarm in status["alarms"]] == ["flight_lost"]
        assert status["board"]["failure"]["code"] == "flight_away"
        assert not status["recording"]["active"]
        _until(viewer, lambda one: one["type"] == "status" and one["data"]["board"]["state"] == "open")
    assert flying.pid("flight") != flight
    flying.fly_a_frame()
    status = flying.status() or {}
    assert status["hil"]["path"] == "assisted"
    assert status["alarms"] == []


def test_a_flight_process_that_hangs_is_not_said_to_be_well_and_is_heard_again(flying: Flying) -> None:
    pid = flying.pid("flight")

    def health() -> str:
        return str(httpx.get(f"{flying.url}/health", timeout=DEADLINE_S).json()["status"])

    assert health() == "ok"
    os.kill(pid, signal.SIGSTOP)
    try:
        eventually(lambda: health() == "failed", "its silence is noticed")
        status = flying.status()
        assert status is not None, "what is known is told"
        assert [alarm["id"] for alarm in status["alarms"]] == ["flight_lost"]
        assert status["board"]["state"] == "lost", "nothing looks live"
        answer = flying.http.get("/telemetry")
        assert (answer.status_code, answer.json()["code"]) == (503, "flight_silent")
        assert "epf_flight_up 0" in httpx.get(f"{flying.url}/metrics", timeout=DEADLINE_S).text
    finally:
        # Or the launcher has killed it by now, and another one flies.
        with suppress(ProcessLookupError):
            os.kill(pid, signal.SIGCONT)
    eventually(flying.flies, "it flies again")
    eventually(lambda: health() == "ok", "it is well again")


def test_nothing_is_reported_as_done_while_the_flight_process_is_away(flying: Flying) -> None:
    os.kill(flying.program.process.pid, signal.SIGSTOP)
    os.kill(flying.pid("flight"), signal.SIGKILL)
    try:
        eventually(lambda: flying.http.post("/commands/ahrs_on").status_code == 409, "commands are refused")
        answer = flying.http.post("/commands/autopilot_on").json()
        assert answer["code"] == "flight_away"
        status = flying.status() or {}
        assert status["board"]["state"] == "lost"
    finally:
        os.kill(flying.program.process.pid, signal.SIGCONT)
    eventually(lambda: (flying.status() or {})["board"]["state"] == "open", "it is back")


def test_when_the_gateway_itself_is_killed_both_processes_end_and_let_everything_go(flying: Flying) -> None:
    pids = flying.pids()
    flying.program.end(signal.SIGKILL)
    eventually(lambda: not any(runs(pid) for pid in pids.values()), "both end")
    eventually(lambda: flying.simulator.heard(release_datagram()), "the simulator has its controls back")
    eventually(lambda: flying.board.received[-1:] == ["exit_binary_mode"], "the board is let go")


def runs(pid: int) -> bool:
    """Whether a process has not ended; in a container without an init nobody buries one that has."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


@contextmanager
def headless_flight(data: Path, *arguments: str) -> Iterator[Program]:
    """`epf-flight` alone."""
    program = Program([sys.executable, "-m", "epf_gcs.flight", "--data-dir", str(data), *arguments])
    try:
        program.wait_for_words("flying")
        yield program
    finally:
        program.end(signal.SIGKILL)


@asynccontextmanager
async def asked(data: Path) -> AsyncIterator[tuple[StationEnd, Heard]]:
    """A station without any web."""
    heard = Heard()
    async with connected(data, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        yield station, heard


@pytest.mark.anyio
async def test_a_flight_process_alone_opens_its_board_and_takes_commands_from_its_stream(
    tmp_path: Path, board: FakeBoard
) -> None:
    with headless_flight(tmp_path / "data", "--board", board.url) as program:
        async with asked(tmp_path / "data") as (station, heard):
            await eventually_async(lambda: any(s.board.state == "open" for s in heard.statuses), "it opens")
            answer = await station.ask(RunCommand("ahrs_on", []))
            assert answer.state == "confirmed"
            await eventually_async(lambda: any(one.name == "ahrs" for one in heard.samples), "the stream comes")
        assert program.end(signal.SIGTERM) == 0
        assert heard.losses in ([False], [True])
    assert board.received[-1:] == ["exit_binary_mode"]


def test_two_gateways_do_not_share_a_data_folder(flying: Flying, tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data") as second:
        assert second.process.wait(DEADLINE_S) == 1
    assert re.search(r"in use by another epf-gcs", second.said), second.said
    flying.fly_a_frame()


def _until(viewer: Any, condition: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    give_up_s = time.monotonic() + DEADLINE_S
    while time.monotonic() < give_up_s:
        message: dict[str, Any] = orjson.loads(viewer.recv(DEADLINE_S))
        if message["type"] == "batch":
            viewer.send(orjson.dumps({"type": "ack", "seq": message["seq"]}).decode())
        if condition(message):
            return message
    raise AssertionError("never came")
