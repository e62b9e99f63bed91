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
from importlib import import_module
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path
from typing import Final

from packaging.requirements import InvalidRequirement, Requirement

from epf_gcs import __version__
from epf_gcs.data_folder.lock import is_in_use
from epf_gcs.data_folder.version import FORMAT, newer, read_format
from epf_gcs.errors import GatewayError
from epf_gcs.extras import ALL
from epf_gcs.launcher.doctor_serial import serial_ports, takers_of_ports
from epf_gcs.launcher.findings import Finding
from epf_gcs.launcher.ports import listener_of
from epf_gcs.listening import listen
from epf_gcs.product import BOARD, PAGE
from epf_gcs.system.time_source import is_synchronised

# An hour of a full line takes 150 MB before it is packed.
_LEAST_FREE_BYTES: Final = 2_000_000_000
# The station is younger than this: a clock before it has not been set.
_FIRST_YEAR: Final = 2026
_SIMULATOR_PORT: Final = 49003
_PROGRAM_S: Final = 10.0
_SHOWN: Final = 3


def findings(data: Path, port: int) -> Iterator[Finding]:
    """Look at everything; a check that itself fails is a finding, too."""
    checks: tuple[Callable[[], Iterator[Finding]], ...] = (
        _versions,
        lambda: _data_folder(data),
        lambda: _room(data),
        lambda: _ports(data, port),
        serial_ports,
        takers_of_ports,
        _clock,
        _product,
        _extras,
        _priority,
    )
    for check in checks:
        try:
            yield from check()
        except (OSError, GatewayError, subprocess.SubprocessError) as error:
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
    yield Finding(
        "ok", f"epf-gcs {__version__}, Python {platform.python_version()}, {system}; packages in {sys.prefix}"
    )
    wrong = list(_wrong_packages())
    if wrong:
        yield Finding(
            "fault",
            f"Python's packages are not those that epf-gcs was tried with: {'; '.join(wrong[:_SHOWN])}"
            + (f"; and {len(wrong) - _SHOWN} more." if len(wrong) > _SHOWN else "."),
            "Install epf-gcs again in an environment of its own: pipx install --force FILE.whl",
        )


def _wrong_packages() -> Iterator[str]:
    """What is missing or of another version than our package asks for, extras left aside."""
    for line in requires("epf-gcs") or ():
        try:
            wanted = Requirement(line)
        except InvalidRequirement:
            continue
        if wanted.marker is not None and not wanted.marker.evaluate({"extra": ""}):
            continue
        try:
            there = version(wanted.name)
        except PackageNotFoundError:
            yield f"{wanted.name} is missing"
        else:
            if there not in wanted.specifier:
                yield f"{wanted.name} is {there}, not {str(wanted.specifier).removeprefix('==')}"


def _data_folder(data: Path) -> Iterator[Finding]:
    place = next(folder for folder in (data, *data.parents) if folder.exists())
    choose = "or choose another folder with --data-dir"
    if _is_read_only(place):
        yield Finding(
            "fault",
            f"The disk of the data folder {data} is mounted read-only.",
            f"sudo mount -o remount,rw $(df --output=target {place} | tail -1)   ({choose})",
        )
        return
    not_ours = next((path for path in (place, *_files_of(data)) if not os.access(path, os.W_OK)), None)
    if not_ours is not None:
        whose = place if not_ours == place else data
        yield Finding(
            "fault",
            f"{not_ours} in the data folder {data} may not be written by this user."
            if not_ours != place
            else f"The data folder {data} may not be written by this user.",
            f'sudo chown -R "$USER" {whose}   ({choose})',
        )
        return
    found = read_format(data) if data.exists() else None
    if found is not None and found.number > FORMAT:
        yield Finding("fault", newer(data, found), f"Install epf-gcs {found.written_by or 'of the newest version'}")
    elif found is not None and found.number < FORMAT:
        yield Finding("note", f"{data} is of format {found.number}: the next start brings it to {FORMAT}.")
    else:
        yield Finding("ok", f"Data folder {data}")


def _files_of(data: Path) -> Iterator[Path]:
    if data.is_dir() and os.access(data, os.R_OK | os.X_OK):
        yield from (path for path in data.iterdir() if not path.is_symlink() and not path.is_socket())


def _is_read_only(place: Path) -> bool:
    if sys.platform == "win32":
        return False
    return bool(os.statvfs(place).f_flag & os.ST_RDONLY)


def _room(data: Path) -> Iterator[Finding]:
    place = next(folder for folder in (data, *data.parents) if folder.exists())
    free = shutil.disk_usage(place).free
    if free < _LEAST_FREE_BYTES:
        yield Finding(
            "fault",
            f"The disk of {data} has {free / 1e9:.1f} GB free: recordings stop when it is full.",
            "Delete old flights in the tab Vuelos, or choose another disk with --data-dir.",
        )
    else:
        yield Finding("ok", f"{free / 1e9:.0f} GB free on its disk")


def _ports(data: Path, port: int) -> Iterator[Finding]:
    if is_in_use(data):
        yield Finding("ok", "A station runs with this data folder: its ports are its own")
        return
    try:
        listen("127.0.0.1", port).close()
    except GatewayError as error:
        who = listener_of(port)
        other = 8001 if port != 8001 else 8002
        yield Finding(
            "fault",
            f"TCP port {port} is taken by {who}." if who else error.detail,
            f"End that program, or: epf-gcs --port {other}" if who else f"epf-gcs --port {other}",
        )
    else:
        yield Finding("ok", f"TCP port {port} for the page is free")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("", _SIMULATOR_PORT))
        except OSError:
            yield Finding(
                "fault",
                f"UDP port {_SIMULATOR_PORT}, where X-Plane sends to, is taken by another program.",
                f"sudo ss -ulpn 'sport = :{_SIMULATOR_PORT}'   (shows which; end it, or choose another port in Setup)",
            )
        else:
            yield Finding("ok", f"UDP port {_SIMULATOR_PORT} for X-Plane is free")


def _clock() -> Iterator[Finding]:
    now = time.gmtime()
    said = time.strftime("%Y-%m-%d %H:%M:%S UTC", now)
    if now.tm_year < _FIRST_YEAR:
        yield Finding(
            "fault",
            f"The clock says {said}: recordings would be filed under that day.",
            'sudo date -u -s "2026-01-31 12:00"   (with the right time)',
        )
    elif is_synchronised() is False:
        yield Finding(
            "note",
            f"The clock says {said}, and no time server vouches for it: recordings say so.",
            "sudo timedatectl set-ntp true   (with a network; else compare it with your watch)",
        )
    else:
        yield Finding("ok", f"The clock says {said}")


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


def _extras() -> Iterator[Finding]:
    for extra in ALL:
        if not extra.is_here:
            yield Finding("note", f"{extra.what}: {' and '.join(extra.modules)} not installed.", extra.command())
            continue
        try:
            for module in extra.modules:
                import_module(module)
        except ImportError as error:
            # What a package needs of the system is found only when it is loaded.
            yield Finding("fault", f"{extra.what} fails: {error}.", _mend_library(str(error), extra.command()))
        else:
            yield Finding("ok", f"{extra.what}: {' and '.join(extra.modules)}")


def _mend_library(said: str, again: str) -> str:
    if "libexpat" in said:
        return "sudo apt install libexpat1   (on Debian and Ubuntu)"
    return f"{again} --force-reinstall" if " -m pip " in again else again


def _priority() -> Iterator[Finding]:
    if sys.platform != "linux":
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
