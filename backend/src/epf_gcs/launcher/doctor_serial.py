"""The doctor's look at serial ports: whether this user may open them, and who else writes to them."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from epf_gcs.launcher.findings import Finding, found

# The rule of packaging/linux keeps ModemManager away from them.
_RULES: Final = ("/etc/udev/rules.d", "/usr/lib/udev/rules.d", "/lib/udev/rules.d")
_RULE: Final = "70-epf-gcs.rules"


def serial_ports() -> Iterator[Finding]:
    """Each port that is there, and the group that is missing."""
    from serial.tools.list_ports import comports  # noqa: PLC0415 - slow on some systems

    paths = sorted(port.device for port in comports() if port.hwid != "n/a")
    if not paths:
        yield found("note", "No serial port is here.", "Plug the board in; a PTY or TCP address needs none.")
    for path in paths:
        if sys.platform == "win32" or os.access(path, os.R_OK | os.W_OK):
            yield found("ok", "Serial port {path} can be opened", path=path)
        else:
            yield _may_not(path)


def takers_of_ports() -> Iterator[Finding]:
    """Programs that write to each new serial port by themselves."""
    running = set(_process_names())
    has_rule = any(Path(folder, _RULE).exists() for folder in _RULES)
    if "ModemManager" in running and not has_rule:
        yield found(
            "note",
            "ModemManager runs: it writes to each new serial port for some seconds, and the board hears it.",
            "sudo systemctl disable --now ModemManager   (or, with a mobile modem: packaging/linux/70-epf-gcs.rules)",
        )
    if "brltty" in running:
        yield found(
            "note",
            "brltty runs: it takes some USB adapters for a Braille display, and their port goes away.",
            "sudo systemctl disable --now brltty brltty-udev   (if nobody reads this computer by Braille)",
        )


def _may_not(path: str) -> Finding:
    group = _group_of(path)
    if group in _groups_on_paper():
        return found(
            "fault",
            "Serial port {path} may not be opened by this user, who is in its group {group} only after the next login.",
            "Log out and in again.",
            path=path,
            group=group,
        )
    return found(
        "fault",
        "Serial port {path} may not be opened by this user.",
        'sudo usermod -a -G {group} "$USER"   (then log out and in again)',
        path=path,
        group=group,
    )


def _group_of(path: str) -> str:
    if sys.platform == "win32":
        return ""
    try:
        return Path(path).group()
    except (KeyError, OSError):
        return "dialout"


def _groups_on_paper() -> set[str]:
    """The groups that this user has from the next login on."""
    if sys.platform == "win32":
        return set()
    import grp  # noqa: PLC0415 - not on every system
    import pwd  # noqa: PLC0415

    try:
        name = pwd.getpwuid(os.getuid()).pw_name
    except KeyError:
        return set()
    return {group.gr_name for group in grp.getgrall() if name in group.gr_mem}


def _process_names() -> Iterator[str]:
    for path in Path("/proc").glob("[0-9]*/comm"):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            yield path.read_text().strip()
