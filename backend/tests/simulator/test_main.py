"""`epf-sim` as a person starts it."""

import os
import signal
import socket
import subprocess
import sys
from contextlib import closing

import pytest

from tests.support.waiting import DEADLINE_S

LOOPBACK = "127.0.0.1"


def epf_sim(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "epf_gcs.simulator", *arguments],
        capture_output=True,
        text=True,
        timeout=DEADLINE_S,
        check=False,
        env=os.environ | {"COLUMNS": "120", "NO_COLOR": "1"},
    )


def udp_socket() -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind((LOOPBACK, 0))
    sock.settimeout(DEADLINE_S)
    return sock


def free_port() -> int:
    with closing(udp_socket()) as sock:
        port: int = sock.getsockname()[1]
        return port


def test_help_names_every_option() -> None:
    text = epf_sim("--help").stdout
    for option in (
        *("--aircraft", "--start", "--lat", "--lon", "--heading", "--throttle", "--wind", "--turbulence", "--seed"),
        *("--send-to", "--listen", "--profile", "--one-row-per-datagram", "--delay-ms", "--jitter-ms", "--loss"),
        *("--rate", "--speed-up", "--lockstep", "--duration"),
    ):
        assert option in text
    assert "epf-sim --start runway" in text


@pytest.mark.parametrize("aircraft", ["rc", "c172p"])
@pytest.mark.parametrize("start", ["air", "runway", "final"])
def test_every_aircraft_flies_from_every_start_and_says_what_it_did(aircraft: str, start: str) -> None:
    with closing(udp_socket()) as there:
        port = there.getsockname()[1]
        done = epf_sim(
            *("--aircraft", aircraft, "--start", start, "--speed-up", "50", "--duration", "5"),
            *("--send-to", f"{LOOPBACK}:{port}", "--listen", str(free_port())),
        )
        assert done.returncode == 0, done.stderr
        assert done.stdout.startswith(f"{aircraft} ")
        assert "Flown 5.0 s, 0 crashes" in done.stdout
        assert done.stderr == ""
        assert len(there.recv(4096)) == 365


def test_a_taken_port_is_told_with_what_to_do() -> None:
    with closing(udp_socket()) as there:
        taken = there.getsockname()[1]
        done = epf_sim("--listen", str(taken))
    assert done.returncode == 1
    assert f"UDP {LOOPBACK}:{taken} cannot be opened" in done.stderr
    assert "--listen" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (("--wind", "north"), "as in 330/20"),
        (("--send-to", "nowhere"), "is not HOST:PORT"),
        (("--listen", "70000"), "is not HOST:PORT"),
        (("--rate", "500"), "less than or equal to 100"),
        (("--aircraft", "zeppelin"), "c172p"),
        (("--loss", "2"), "less than or equal to 1"),
    ],
)
def test_a_wrong_option_is_told_with_what_is_right(arguments: tuple[str, ...], complaint: str) -> None:
    done = epf_sim(*arguments)
    assert done.returncode == 2
    assert complaint in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_with_its_summary(number: signal.Signals) -> None:
    with closing(udp_socket()) as there:
        port = there.getsockname()[1]
        process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "epf_gcs.simulator",
                "--send-to",
                f"{LOOPBACK}:{port}",
                "--listen",
                str(free_port()),
            ],
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            there.recv(4096)
            process.send_signal(number)
            out, _ = process.communicate(timeout=DEADLINE_S)
        finally:
            process.kill()
            process.wait()
    assert process.returncode == 0
    assert "Flown " in out
