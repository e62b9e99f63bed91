"""`epf-gcs doctor`: what on this computer keeps the station from working, and the command that mends it."""

from __future__ import annotations

import os
import platform
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Final, Literal

from epf_gcs import __version__
from epf_gcs.errors import GatewayError
from epf_gcs.listening import listen
from epf_gcs.product import BOARD, PAGE

State = Literal["ok", "note", "fault"]

# An hour of a full line takes 150 MB before it is packed.
_LEAST_FREE_BYTES: Final = 2_000_000_000
# The station is younger than this: a clock before it has not been set.
_FIRST_YEAR: Final = 2026
_SIMULATOR_PORT: Final = 49003
_PROGRAM_S: Final = 10.0
# What a Python package needs of the system is found only when it is loaded.
_PACKAGES: Final = {
    "jsbsim": "The simulator and the demonstration need it: pip install 'epf-gcs[sim]'",
    "rasterio": "It imports heights; on Debian: sudo apt install libexpat1",
    "duckdb": "The flights' tab needs it: install epf-gcs again",
    "pyarrow": "The flights' tab needs it: install epf-gcs again",
}
_OPTIONAL: Final = frozenset({"jsbsim"})


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was looked at. `mend` is what to do about it, "" if nothing."""

    state: State
    what: str
    mend: str = ""


def findings(data: Path, port: int) -> Iterator[Finding]:
    """Look at everything; a check that itself fails is a finding, too."""
    checks: tuple[Callable[[], Iterator[Finding]], ...] = (
        _versions,
        lambda: _data_folder(data),
        lambda: _ports(port),
        _serial_ports,
        _modem_manager,
        _clock,
        _product,
        _packages,
        _priority,
    )
    for check in checks:
        try:
            yield from check()
        except (OSError, GatewayError) as error:
            yield Finding("fault", f"A check failed: {error}.", "Tell this to whoever looks after the computer.")


def report(found: list[Finding]) -> str:
    """The findings as text, one a line, what to do below each."""
    marks = {"ok": "ok   ", "note": "note ", "fault": "FAULT"}
    lines = []
    for one in found:
        lines.append(f"{marks[one.state]}  {one.what}")
        if one.mend:
            lines.append(f"       -> {one.mend}")
    faults = sum(one.state == "fault" for one in found)
    lines.append("Nothing keeps the station from working." if not faults else f"{faults} to mend.")
    return "\n".join(lines)


def _versions() -> Iterator[Finding]:
    system = f"{platform.system()} {platform.machine()}"
    yield Finding("ok", f"epf-gcs {__version__}, Python {platform.python_version()}, {system}")


def _data_folder(data: Path) -> Iterator[Finding]:
    place = next(folder for folder in (data, *data.parents) if folder.exists())
    if not os.access(place, os.W_OK):
        yield Finding(
            "fault",
            f"The data folder {data} cannot be written to.",
            f'Give it to yourself: sudo chown -R "$USER" {place}; or choose another with --data-dir.',
        )
        return
    free = shutil.disk_usage(place).free
    if free < _LEAST_FREE_BYTES:
        yield Finding(
            "fault",
            f"The disk of {data} has {free / 1e9:.1f} GB free: recordings stop when it is full.",
            "Delete old flights in the tab Vuelos, or choose another disk with --data-dir.",
        )
    else:
        yield Finding("ok", f"Data folder {data}, {free / 1e9:.0f} GB free")


def _ports(port: int) -> Iterator[Finding]:
    try:
        listen("127.0.0.1", port).close()
    except GatewayError as error:
        yield Finding("note", error.detail, "If that is the station itself, all is well; else choose with --port.")
    else:
        yield Finding("ok", f"TCP port {port} for the page is free")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("", _SIMULATOR_PORT))
        except OSError:
            yield Finding(
                "note",
                f"UDP port {_SIMULATOR_PORT}, where X-Plane sends to, is in use.",
                "If the station runs, that is the station; else end what uses it, or choose another in Setup.",
            )
        else:
            yield Finding("ok", f"UDP port {_SIMULATOR_PORT} for X-Plane is free")


def _serial_ports() -> Iterator[Finding]:
    from serial.tools.list_ports import comports  # noqa: PLC0415 - slow on some systems

    found = sorted(port.device for port in comports() if port.hwid != "n/a")
    if not found:
        yield Finding("note", "No serial port is here.", "Plug the board in; a PTY or TCP address needs none.")
    for path in found:
        if os.name == "nt" or os.access(path, os.R_OK | os.W_OK):
            yield Finding("ok", f"Serial port {path} can be opened")
        else:
            yield Finding(
                "fault",
                f"Serial port {path} may not be opened by this user.",
                f'sudo usermod -a -G {_group_of(path)} "$USER"   (then log out and in again)',
            )


def _group_of(path: str) -> str:
    try:
        return Path(path).group()
    except (KeyError, OSError, NotImplementedError):
        return "dialout"


def _modem_manager() -> Iterator[Finding]:
    if any(name == "ModemManager" for name in _process_names()):
        yield Finding(
            "note",
            "ModemManager runs: it writes to each new serial port for some seconds.",
            "sudo systemctl disable --now ModemManager   (if this computer has no mobile modem)",
        )


def _process_names() -> Iterator[str]:
    for path in Path("/proc").glob("[0-9]*/comm"):
        try:
            yield path.read_text().strip()
        except OSError:
            continue  # it has ended meanwhile


def _clock() -> Iterator[Finding]:
    year = time.gmtime().tm_year
    if year < _FIRST_YEAR:
        yield Finding(
            "fault",
            f"The clock says {year}: recordings would be filed under that day.",
            'sudo date -s "2026-01-31 12:00"   (with the right time)',
        )
    else:
        yield Finding("ok", f"The clock says {time.strftime('%Y-%m-%d %H:%M:%S UTC', time.gmtime())}")


def _product() -> Iterator[Finding]:
    try:
        PAGE.file("index.html")
    except FileNotFoundError as error:
        yield Finding("fault", str(error))
    else:
        yield Finding("ok", f"The page is in {PAGE.folder}")
    try:
        program = BOARD.file("posix/epf-board")
        subprocess.run([program, "--help"], capture_output=True, check=True, timeout=_PROGRAM_S)
    except FileNotFoundError as error:
        yield Finding("note", str(error), "Only the demonstration needs it.")
    except (OSError, subprocess.SubprocessError) as error:
        yield Finding("fault", f"The demonstration's board does not run here: {error}.", "Connect a real board.")
    else:
        yield Finding("ok", "The demonstration's board runs")


def _packages() -> Iterator[Finding]:
    for name, need in _PACKAGES.items():
        try:
            import_module(name)
        except ImportError as error:
            yield Finding("note" if name in _OPTIONAL else "fault", f"{name} cannot be loaded: {error}.", need)
    yield Finding("ok", f"Python's packages are in {sys.prefix}")


def _priority() -> Iterator[Finding]:
    if not hasattr(os, "sched_setscheduler"):
        return
    # Tried in a process of its own, which ends at once.
    tried = subprocess.run(
        [sys.executable, "-c", "import os; os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))"],
        capture_output=True,
        check=False,
        timeout=_PROGRAM_S,
    )
    if tried.returncode == 0:
        yield Finding("ok", "The flight process may go before all other programs")
    else:
        yield Finding(
            "note",
            "The flight process has no right to go before other programs; on a busy computer the loop may be late.",
            'echo "@dialout - rtprio 10" | sudo tee /etc/security/limits.d/epf-gcs.conf   (then log in again)',
        )
