"""Access for the launcher: which options go on to the programs, and the one-time key that is printed at the start."""

from __future__ import annotations

import secrets
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Final

LAUNCHER_KEY: Final = "GCS_LAUNCHER_KEY"
"""The variable by which the gateway knows the program that started it. Others of this machine cannot read it."""


def new_launcher_key() -> str:
    """A key for one run."""
    return secrets.token_urlsafe(32)


def access_arguments(*, trust_this_computer: bool | None, allow_anyone_to_fly: bool) -> list[str]:
    """The options for `epf-gcs` and `epf-web`."""
    trust = {None: [], True: ["--trust-this-computer"], False: ["--no-trust-this-computer"]}
    return [*trust[trust_this_computer], *(["--allow-anyone-to-fly"] if allow_anyone_to_fly else [])]


def invite_command(data: Path, host: str, port: int, *, tls: bool, more: Sequence[str] = ()) -> list[str]:
    """The program that makes a one-time key and prints it with its QR code."""
    return [
        *(sys.executable, "-m", "epf_gcs.web.access.invite"),
        *("--data-dir", str(data), "--host", host, "--port", str(port)),
        *(["--tls"] if tls else []),
        *more,
    ]


def print_invitation(command: Sequence[str]) -> None:
    """Run it, with our standard output. A station that cannot print a key runs all the same."""
    subprocess.run(command, check=False, stdin=subprocess.DEVNULL)
