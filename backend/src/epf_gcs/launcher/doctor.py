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
from dataclasses import replace
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
from epf_gcs.launcher.findings import Finding, Language, found
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
_NOTHING_WRONG: Final = "Nothing keeps the station from working."


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
            yield found(
                "fault", "A check failed: {error}.", "Tell this to whoever looks after the computer.", error=error
            )


def report(findings: list[Finding], language: Language = "en") -> str:
    """The findings as text, one a line, what to do below each."""
    marks = {"ok": "ok   ", "note": "note ", "fault": "FAULT"}
    lines = []
    for one in findings:
        lines.append(f"{marks[one.state]}  {one.what}")
        if one.mend:
            lines.append(f"       -> {one.mend}")
    faults = sum(one.state == "fault" for one in findings)
    end = found("fault", "{count} to mend.", count=faults) if faults else found("ok", _NOTHING_WRONG)
    lines.append(replace(end, language=language).what)
    return "\n".join(lines)


def _versions() -> Iterator[Finding]:
    system = f"{platform.system()} {platform.machine()}"
    yield found(
        "ok",
        "epf-gcs {version}, Python {python}, {system}; packages in {folder}",
        version=__version__,
        python=platform.python_version(),
        system=system,
        folder=sys.prefix,
    )
    wrong = list(_wrong_packages())
    if wrong:
        more = [f"+ {len(wrong) - _SHOWN}"] if len(wrong) > _SHOWN else []
        yield found(
            "fault",
            "Python's packages are not those that epf-gcs was tried with: {packages}.",
            "Install epf-gcs again in an environment of its own: pipx install --force FILE.whl",
            packages="; ".join([*wrong[:_SHOWN], *more]),
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
    if _is_read_only(place):
        yield found(
            "fault",
            "The disk of the data folder {data} is mounted read-only.",
            "sudo mount -o remount,rw $(df --output=target {place} | tail -1)   "
            "(or choose another folder with --data-dir)",
            data=data,
            place=place,
        )
        return
    not_ours = next((path for path in (place, *_files_of(data)) if not os.access(path, os.W_OK)), None)
    if not_ours is not None:
        yield found(
            "fault",
            "The data folder {data} may not be written by this user."
            if not_ours == place
            else "{path} in the data folder {data} may not be written by this user.",
            'sudo chown -R "$USER" {whose}   (or choose another folder with --data-dir)',
            path=not_ours,
            data=data,
            whose=place if not_ours == place else data,
        )
        return
    has = read_format(data) if data.exists() else None
    if has is not None and has.number > FORMAT:
        yield found(
            "fault",
            "{sentence}",
            "Install epf-gcs {version}" if has.written_by else "Install the newest epf-gcs",
            sentence=newer(data, has),
            version=has.written_by,
        )
    elif has is not None and has.number < FORMAT:
        yield found(
            "note",
            "{data} is of format {number}: the next start brings it to {to}.",
            data=data,
            number=has.number,
            to=FORMAT,
        )
    else:
        yield found("ok", "Data folder {data}", data=data)


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
        yield found(
            "fault",
            "The disk of {data} has {free} GB free: recordings stop when it is full.",
            "Delete old flights in the tab Vuelos, or choose another disk with --data-dir.",
            data=data,
            free=f"{free / 1e9:.1f}",
        )
    else:
        yield found("ok", "{free} GB free on its disk", free=f"{free / 1e9:.0f}")


def _ports(data: Path, port: int) -> Iterator[Finding]:
    if is_in_use(data):
        yield found("ok", "A station runs with this data folder: its ports are its own")
        return
    try:
        listen("127.0.0.1", port).close()
    except GatewayError as error:
        who = listener_of(port)
        other = 8001 if port != 8001 else 8002
        yield found(
            "fault",
            "TCP port {port} is taken by {who}." if who else "{sentence}",
            "End that program, or: epf-gcs --port {other}" if who else "epf-gcs --port {other}",
            port=port,
            who=who,
            sentence=error.detail,
            other=other,
        )
    else:
        yield found("ok", "TCP port {port} for the page is free", port=port)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("", _SIMULATOR_PORT))
        except OSError:
            yield found(
                "fault",
                "UDP port {port}, where X-Plane sends to, is taken by another program.",
                "sudo ss -ulpn 'sport = :{port}'   (shows which; end it, or choose another port in Setup)",
                port=_SIMULATOR_PORT,
            )
        else:
            yield found("ok", "UDP port {port} for X-Plane is free", port=_SIMULATOR_PORT)


def _clock() -> Iterator[Finding]:
    now = time.gmtime()
    said = time.strftime("%Y-%m-%d %H:%M:%S UTC", now)
    if now.tm_year < _FIRST_YEAR:
        yield found(
            "fault",
            "The clock says {time}: recordings would be filed under that day.",
            'sudo date -u -s "2026-01-31 12:00"   (with the right time)',
            time=said,
        )
    elif is_synchronised() is False:
        yield found(
            "note",
            "The clock says {time}, and no time server vouches for it: recordings say so.",
            "sudo timedatectl set-ntp true   (with a network; else compare it with your watch)",
            time=said,
        )
    else:
        yield found("ok", "The clock says {time}", time=said)


def _product() -> Iterator[Finding]:
    try:
        PAGE.file("index.html")
    except FileNotFoundError as error:
        yield found("fault", "{sentence}", sentence=error)
    else:
        yield found("ok", "The page is in {folder}", folder=PAGE.folder)
    try:
        program = BOARD.file("posix/epf-board")
        subprocess.run([program, "--help"], capture_output=True, check=True, timeout=_PROGRAM_S)
    except FileNotFoundError as error:
        yield found("note", "{sentence}", "Only the demonstration needs it.", sentence=error)
    except (OSError, subprocess.SubprocessError) as error:
        yield found(
            "fault", "The demonstration's board does not run here: {error}.", "Connect a real board.", error=error
        )
    else:
        yield found("ok", "The demonstration's board runs")


def _extras() -> Iterator[Finding]:
    for extra in ALL:
        has = {"what": extra.what, "modules": ", ".join(extra.modules), "command": extra.command()}
        if not extra.is_here:
            yield found("note", "{what}: {modules} not installed.", "{command}", **has)
            continue
        try:
            for module in extra.modules:
                import_module(module)
        except ImportError as error:
            # What a package needs of the system is found only when it is loaded.
            needs_expat = "libexpat" in str(error)
            again = " --force-reinstall" if " -m pip " in has["command"] else ""
            yield found(
                "fault",
                "{what} fails: {error}.",
                "sudo apt install libexpat1   (on Debian and Ubuntu)" if needs_expat else "{command}",
                **{**has, "command": has["command"] + again, "error": str(error)},
            )
        else:
            yield found("ok", "{what}: {modules}", **has)


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
        yield found("ok", "The flight process may go before all other programs")
    else:
        yield found(
            "note",
            "The flight process has no right to go before other programs; on a busy computer the loop may be late.",
            'echo "@dialout - rtprio 10" | sudo tee /etc/security/limits.d/epf-gcs.conf   (then log in again)',
        )
