"""systemd hears that the station is ready, lives and ends; and nobody else does."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs.launcher.service import Service
from tests.support.waiting import DEADLINE_S

UNITS = sorted((Path(__file__).parents[3] / "packaging" / "linux").glob("*.service"))


def test_without_systemd_it_is_silent() -> None:
    service = Service({})
    service.ready()
    assert service.every_s is None


def test_half_of_the_time_that_systemd_waits_is_how_often_it_hears() -> None:
    assert Service({"NOTIFY_SOCKET": "@x", "WATCHDOG_USEC": "20000000"}).every_s == 10.0


def test_a_systemd_that_is_gone_stops_nothing(tmp_path: Path) -> None:
    Service({"NOTIFY_SOCKET": str(tmp_path / "gone")}).alive()


def test_the_gateway_says_when_it_is_ready_that_it_lives_and_when_it_ends(tmp_path: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as systemd:
        systemd.bind(str(tmp_path / "notify"))
        systemd.settimeout(DEADLINE_S)
        environment = {**os.environ, "NOTIFY_SOCKET": str(tmp_path / "notify"), "WATCHDOG_USEC": "200000"}
        command = [
            sys.executable,
            "-m",
            "epf_gcs.launcher.gateway",
            "--port",
            "0",
            "--data-dir",
            str(tmp_path / "data"),
        ]
        gateway = subprocess.Popen(command, env=environment)
        try:
            heard = [systemd.recv(100) for _ in range(3)]
            gateway.send_signal(signal.SIGTERM)
            while heard[-1] != b"STOPPING=1":
                heard.append(systemd.recv(100))
            assert gateway.wait(30) == 0
        finally:
            gateway.kill()
            gateway.wait()
    assert heard[0] == b"READY=1"
    assert set(heard[1:-1]) == {b"WATCHDOG=1"}


@pytest.mark.parametrize("unit", UNITS, ids=lambda path: path.name)
@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="systemd-analyze is not on this machine")
def test_systemd_finds_the_services_little_exposed(unit: Path) -> None:
    # Its measure from 0 to 10, in tenths; below 3 it has a friendly word for it.
    command = ["systemd-analyze", "security", "--offline=yes", "--threshold=29", "--no-pager", str(unit)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=DEADLINE_S, check=False)
    assert "Overall exposure level" in done.stdout
    assert done.returncode == 0, done.stdout[-500:]
