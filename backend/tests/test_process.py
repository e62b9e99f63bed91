"""The gateway as a program: how it starts, how it ends, and what survives a kill."""

from __future__ import annotations

import os
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import httpx
import orjson
import pytest
from mcap.exceptions import EndOfFile
from mcap.records import Message
from mcap.stream_reader import StreamReader

from epf_gcs.xplane.datagram import Record, build, release_datagram
from tests.support.fake_board import FakeBoard
from tests.support.programs import Program, children_of, gateway_process, sockets_of, words_of
from tests.support.waiting import DEADLINE_S, eventually

WHOLE = build(Record(row, (0.1,) * 8) for row in (3, 4, 6, 8, 11, 16, 17, 18, 20, 25))


def client_of(program: Program) -> httpx.Client:
    url = program.wait_for_words(r"url=(http://\S+)")
    return httpx.Client(base_url=f"{url}/api/v1", timeout=DEADLINE_S)


def open_board(client: httpx.Client, board: FakeBoard) -> None:
    client.put("/links/board", json={"url": board.url}).raise_for_status()
    wait_until_open(client)


def wait_until_open(client: httpx.Client) -> None:
    eventually(lambda: client.get("/status").json()["board"]["state"] == "open", "the board opens")


class Simulator:
    """X-Plane's side: sends frames, keeps what it is told."""

    def __init__(self) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(DEADLINE_S)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            self.station_port = probe.getsockname()[1]

    def connect(self, client: httpx.Client) -> None:
        body = {"receive_port": self.station_port, "send_port": self.socket.getsockname()[1]}
        client.put("/links/simulator", json=body).raise_for_status()

    def send(self) -> None:
        self.socket.sendto(WHOLE, ("127.0.0.1", self.station_port))

    def last_word(self) -> bytes:
        """The last datagram that was sent here."""
        last = self.socket.recv(2048)
        self.socket.setblocking(False)
        with suppress(BlockingIOError):
            while True:
                last = self.socket.recv(2048)
        return last


def test_the_web_process_keeps_off_the_core_of_the_flight(tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data") as program, client_of(program) as client:
        client.get("/status").raise_for_status()
        cores = {}
        for pid in children_of(program.process.pid):
            words = words_of(pid)
            cores[words[words.index("-m") + 1]] = os.sched_getaffinity(pid)
        flight, web = cores["epf_gcs.flight"], cores["epf_gcs.web"]
        real_time = "priority=real-time" in program.said
        assert flight | web == os.sched_getaffinity(0)
        assert max(flight) not in web or len(web) == 1
        assert len(flight) == 1 or not real_time


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
def test_every_polite_end_leaves_board_and_simulator_free(
    tmp_path: Path, board: FakeBoard, how: signal.Signals
) -> None:
    simulator = Simulator()
    with gateway_process(tmp_path / "data") as program, simulator.socket:
        with client_of(program) as client:
            open_board(client, board)
            simulator.connect(client)
            simulator.send()
            eventually(lambda: board.count("xplane_info") == 1, "the loop runs")
        program.end(how)
        assert simulator.last_word() == release_datagram()
        eventually(lambda: board.received[-2:] == ["stop", "exit_binary_mode"], "the farewell arrives")
        # The simulator has sent one frame only, which the station calls a lost loop if the end takes half a second.
        others = [line for line in program.said.splitlines() if "alarm=hil_lost" not in line]
        assert "rror" not in "".join(others), program.said


def test_after_a_kill_the_next_gateway_carries_on_by_itself(tmp_path: Path, board: FakeBoard) -> None:
    simulator = Simulator()
    with simulator.socket:
        with gateway_process(tmp_path / "data") as program, client_of(program) as client:
            open_board(client, board)
            simulator.connect(client)
            client.post("/commands/ahrs_on").raise_for_status()
            client.put("/hil", json={"source": "joystick", "path": "assisted"}).raise_for_status()
            program.end(signal.SIGKILL)
        board.restart()
        with gateway_process(tmp_path / "data") as program, client_of(program) as client:
            wait_until_open(client)
            eventually(lambda: board.flags["ahrs"] == 1, "the stream is on again")
            expected = {"source": "joystick", "path": "assisted"}
            eventually(lambda: client.get("/hil").json().items() >= expected.items(), "the switches are as they were")
            simulator.send()
            assert simulator.socket.recv(2048).startswith(b"DATA\0")


def test_after_a_kill_at_most_a_second_of_bytes_is_missing(tmp_path: Path, board: FakeBoard) -> None:
    with gateway_process(tmp_path / "data") as program, client_of(program) as client:
        open_board(client, board)
        eventually(lambda: client.get("/status").json()["recording"]["bytes"] > 2000, "some seconds are recorded")
        known = client.get("/status").json()["recording"]["bytes"]
        program.end(signal.SIGKILL)
    (file,) = (tmp_path / "data" / "recordings").glob("*.mcap")
    assert file.stat().st_size >= known
    with file.open("rb") as stream, suppress(EndOfFile, struct.error):
        received = [r.data for r in StreamReader(stream).records if isinstance(r, Message) and r.channel_id == 1]
        assert sum(map(len, received)) > 0


def test_after_a_polite_end_every_byte_that_was_sent_is_in_the_file(tmp_path: Path, board: FakeBoard) -> None:
    with gateway_process(tmp_path / "data") as program, client_of(program) as client:
        open_board(client, board)
        client.post("/commands/start").raise_for_status()
        program.end()
    eventually(lambda: board.received[-1:] == ["exit_binary_mode"], "the farewell arrives")
    (file,) = (tmp_path / "data" / "recordings").glob("*.mcap")
    with file.open("rb") as stream:
        messages = [record for record in StreamReader(stream).records if isinstance(record, Message)]
    assert b"".join(message.data for message in messages if message.channel_id == 2) == board.raw


def test_a_port_that_no_browser_opens_is_told_and_serves_those_who_come_through_a_proxy(tmp_path: Path) -> None:
    program = Program([sys.executable, "-m", "epf_gcs.launcher.gateway", "--port", "6697", "--data-dir", str(tmp_path)])
    try:
        url = program.wait_for_words(r"url=(http://\S+)")
        assert httpx.get(f"{url}/api/v1/status", timeout=DEADLINE_S).status_code == 200
    finally:
        program.end()
    assert "Browsers refuse to open port 6697: choose another with --port" in program.said


def test_a_port_that_is_taken_ends_it_with_one_sentence(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = str(other.getsockname()[1])
        program = Program(
            [sys.executable, "-m", "epf_gcs.launcher.gateway", "--port", port, "--data-dir", str(tmp_path)]
        )
        assert program.process.wait(DEADLINE_S) != 0
        program.end()
    assert f"TCP port {port} of 127.0.0.1 is taken by another program" in program.said
    assert "--port" in program.said
    assert "Traceback" not in program.said


def test_a_second_station_on_the_same_folder_says_who_has_it_and_touches_nothing(tmp_path: Path) -> None:
    whereabouts = tmp_path / "listening.json"
    with gateway_process(tmp_path) as first:
        first.wait_for_words(r"url=(http://\S+)")
        before = whereabouts.read_bytes()
        with gateway_process(tmp_path) as second:
            assert second.process.wait(DEADLINE_S) == 1
            assert "is in use by another epf-gcs (process" in second.said
            assert "url=" not in second.said, "it never served anything of the folder"
        assert whereabouts.read_bytes() == before
        first.end()
    assert not whereabouts.exists(), "who ends takes its address back"


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "epf_gcs.launcher.gateway", *arguments],
        capture_output=True,
        text=True,
        timeout=DEADLINE_S,
        check=False,
    )


def test_help_says_everything_that_one_needs() -> None:
    answer = run("--help")
    assert answer.returncode == 0
    for word in ("--board", "serial:///dev", "--data-dir", "GCS_"):
        assert word in answer.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--board", "pigeon"], "is not the address of a board link"),
        (["--port", "70000"], "port"),
        (["--port", "many"], "port"),
        (["--wings", "2"], "wings"),
    ],
)
def test_a_wrong_command_line_is_said_to_be_wrong(arguments: list[str], words: str) -> None:
    answer = run(*arguments)
    assert answer.returncode == 2
    assert words in " ".join(answer.stderr.replace("│", " ").split())
    assert "Traceback" not in answer.stderr


def test_the_description_of_the_interface_is_printed() -> None:
    document = orjson.loads(run("--print-openapi").stdout)
    assert document["openapi"].startswith("3.")
    assert "/api/v1/status" in document["paths"]
    assert run("--print-openapi").stdout == run("--print-openapi").stdout


def test_a_board_of_the_command_line_is_opened(tmp_path: Path, board: FakeBoard) -> None:
    with gateway_process(tmp_path / "data", "--board", board.url) as program, client_of(program) as client:
        wait_until_open(client)


def test_nothing_is_open_to_other_machines(tmp_path: Path, board: FakeBoard) -> None:
    simulator = Simulator()
    with gateway_process(tmp_path / "data") as program, client_of(program) as client, simulator.socket:
        open_board(client, board)
        simulator.connect(client)
        assert _open_beyond_loopback(program.process.pid) == []


def _open_beyond_loopback(pid: int) -> list[str]:
    """Local addresses of the process's listening and datagram sockets that are not on the loopback."""
    sockets = sockets_of(pid)
    is_open: dict[str, Callable[[str], bool]] = {"tcp": lambda state: state == "0A", "udp": lambda _: True}
    found: list[str] = []
    for family in ("", "6"):
        for kind, open_state in is_open.items():
            for line in Path(f"/proc/net/{kind}{family}").read_text().splitlines()[1:]:
                fields = line.split()
                if (
                    f"socket:[{fields[9]}]" in sockets
                    and open_state(fields[3])
                    and not fields[1].startswith("0100007F:")
                ):
                    found.append(fields[1])
    return found
