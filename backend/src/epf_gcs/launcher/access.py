"""Access for the launcher: which options go on to the programs, and the one-time key that is printed at the start."""

from __future__ import annotations

import secrets
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Final

import typer

from epf_gcs.data_folder.whereabouts import of_running
from epf_gcs.launcher.upkeep import FolderMeant

LAUNCHER_KEY: Final = "GCS_LAUNCHER_KEY"
"""The variable by which the gateway knows the program that started it. Others of this machine cannot read it."""


def new_launcher_key() -> str:
    """A key for one run."""
    return secrets.token_urlsafe(32)


def access_arguments(
    *, trust_this_computer: bool | None, allow_anyone_to_fly: bool, control_by_silence: bool = False
) -> list[str]:
    """The options for `epf-gcs` and `epf-web`."""
    trust = {None: [], True: ["--trust-this-computer"], False: ["--no-trust-this-computer"]}
    chosen = {"--allow-anyone-to-fly": allow_anyone_to_fly, "--control-by-silence": control_by_silence}
    return [*trust[trust_this_computer], *(option for option, is_chosen in chosen.items() if is_chosen)]


def invite_command(data: Path, host: str, port: int, *, tls: bool, more: Sequence[str] = ()) -> list[str]:
    """The program that makes a one-time key and prints it with its QR code."""
    return [
        *(sys.executable, "-m", "epf_gcs.web.invite"),
        *("--data-dir", str(data), "--host", host, "--port", str(port)),
        *(["--tls"] if tls else []),
        *more,
    ]


def print_invitation(command: Sequence[str]) -> None:
    """Run it, with our standard output. A station that cannot print a key runs all the same."""
    subprocess.run(command, check=False, stdin=subprocess.DEVNULL)


def invite(
    context: typer.Context,
    *,
    role: Annotated[
        str,
        typer.Option(help="viewer, operator or owner.", show_default="operator; owner for the first of a container"),
    ] = "",
    minutes: Annotated[float, typer.Option(help="How long the key can be used.")] = 60.0,
    first: Annotated[bool, typer.Option("--first", help="Only while nobody is owner yet; else nothing.")] = False,
    data_dir: FolderMeant,
    host: Annotated[
        str, typer.Option(show_envvar=False, envvar="GCS_HOST", help="What the station listens on.")
    ] = "0.0.0.0",  # noqa: S104 - nothing listens here
    port: Annotated[int, typer.Option(show_envvar=False, envvar="GCS_PORT", help="The station's port.")] = 8000,
    tls: Annotated[bool, typer.Option("--tls", show_envvar=False, envvar="GCS_TLS", help="It has TLS.")] = False,
) -> None:
    """Make a one-time key for a person, and print it with the address and its QR code.

    It is written into the data folder; the station, running or not, takes it once. One that runs tells by itself what
    it listens on, its port and whether it has TLS; what is given on the command line goes before that.
    """
    running = of_running(data_dir)
    if running is not None:
        host = host if _is_said(context, "host") else running.host
        port = port if _is_said(context, "port") else running.port
        tls = tls if _is_said(context, "tls") else running.tls
    more = ["--minutes", str(minutes), *(["--role", role] if role else []), *(["--first"] if first else [])]
    command = invite_command(data_dir, host, port, tls=tls, more=more)
    raise typer.Exit(subprocess.run(command, check=False).returncode)


def _is_said(context: typer.Context, name: str) -> bool:
    """Whether the option stands on the command line: a variable or the config file may be another station's."""
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"
