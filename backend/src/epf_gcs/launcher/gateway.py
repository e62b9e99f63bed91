"""`epf-gcs`: the gateway as two processes, flight and web. Starts both, and restarts either if it dies or hangs."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from types import FrameType
from typing import Annotated, Final

import typer

from epf_gcs.data_folder.place import data_folder
from epf_gcs.data_folder.upgrade import bring_up_to_date
from epf_gcs.data_folder.version import FormatError
from epf_gcs.data_folder.whereabouts import held_by_launcher
from epf_gcs.errors import GatewayError
from epf_gcs.launcher.access import access_arguments, invite, invite_command, print_invitation
from epf_gcs.launcher.config import NAME, entries_of, load_config
from epf_gcs.launcher.encryption import tls_arguments
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.part import Part
from epf_gcs.launcher.ports import is_loopback
from epf_gcs.launcher.service import Service
from epf_gcs.launcher.upkeep import add_commands, print_version
from epf_gcs.listening import is_refused_by_browsers, listen
from epf_gcs.system.private_files import write_private_files
from epf_gcs.system.processes import HANDS_DOWN
from epf_gcs.system.signals import HEARD_WITHIN_S, POLITE

_STOP_S: Final = 8.0
# A process that was being started when the signal came gets another signal after this time.
_SIGNAL_AGAIN_S: Final = 2.0

_DATA: Final = data_folder()

app = typer.Typer(
    pretty_exceptions_enable=False, rich_markup_mode=None, context_settings={"help_option_names": ["-h", "--help"]}
)


class Gateway:
    """Both processes. Each is watched by a thread of its own, so that neither waits for the other's restart."""

    def __init__(self, flight: Part, web: Part) -> None:
        self._parts = (flight, web)
        self._stopping = threading.Event()
        self._refusal: int | None = None

    def run(self) -> int:
        """Run until a signal, or until one of the two refuses to start; returns the exit code."""
        for number in POLITE:
            signal.signal(number, self._stop)
        watchers = [threading.Thread(target=self._watch, args=(part,), name=part.name) for part in self._parts]
        for watcher in watchers:
            watcher.start()
        service = Service()
        service.ready()
        while not self._stopping.wait(service.every_s or HEARD_WITHIN_S):
            if all(watcher.is_alive() for watcher in watchers):
                service.alive()
        service.stopping()
        self._end(watchers)
        return self._refusal or 0

    def _watch(self, part: Part) -> None:
        refusal = part.keep_running(self._stopping)
        if refusal is not None:
            self._refusal = refusal
            self._stopping.set()

    def _stop(self, _number: int, _frame: FrameType | None) -> None:
        self._stopping.set()

    def _end(self, watchers: Sequence[threading.Thread]) -> None:
        """End both; one that hangs is killed."""
        give_up_s = time.monotonic() + _STOP_S
        while any(watcher.is_alive() for watcher in watchers):
            for part in self._parts:
                part.end(by_force=time.monotonic() > give_up_s)
            for watcher in watchers:
                watcher.join(_SIGNAL_AGAIN_S)


def _configure(context: typer.Context, path: Path | None) -> Path | None:
    if context.resilient_parsing:  # a shell asks for completions
        return path
    try:
        return load_config(context, path, entries_of(run))
    except LaunchError as error:
        _say(str(error))
        raise typer.Exit(2) from error


@app.callback(invoke_without_command=True)
def run(
    context: typer.Context,
    *,
    host: Annotated[
        str,
        typer.Option(
            show_envvar=False,
            envvar="GCS_HOST",
            help="Address to listen on. Beyond 127.0.0.1 everybody needs a key, which is printed.",
        ),
    ] = "127.0.0.1",
    port: Annotated[
        int,
        typer.Option(
            show_envvar=False,
            envvar="GCS_PORT",
            min=0,
            max=65535,
            help="TCP port of page and interface; 0 takes any free one.",
        ),
    ] = 8000,
    board: Annotated[
        str | None,
        typer.Option(
            show_envvar=False,
            envvar="GCS_BOARD",
            help="Board to connect to: serial:///dev/ttyUSB0?baud=115200, tcp://host:port or pty:///path; "
            "emulation: plays example values without one.",
        ),
    ] = None,
    data_dir: Annotated[
        Path,
        typer.Option(
            show_envvar=False, envvar="GCS_DATA_DIR", help="Folder of the recordings and the remembered links."
        ),
    ] = _DATA,
    page_dir: Annotated[
        Path | None, typer.Option(show_envvar=False, envvar="GCS_PAGE_DIR", help="Folder of the built page.")
    ] = None,
    recording: Annotated[
        bool, typer.Option(show_envvar=False, envvar="GCS_RECORDING", help="Record every byte of the lines.")
    ] = True,
    tls: Annotated[
        bool,
        typer.Option(
            "--tls",
            show_envvar=False,
            envvar="GCS_TLS",
            help="HTTPS, with an authority and a certificate that are made here and renewed by themselves.",
        ),
    ] = False,
    tls_cert: Annotated[
        Path | None,
        typer.Option(show_envvar=False, envvar="GCS_TLS_CERT", help="HTTPS with this certificate and its chain (PEM)."),
    ] = None,
    tls_key: Annotated[
        Path | None,
        typer.Option(show_envvar=False, envvar="GCS_TLS_KEY", help="The certificate's key (PEM), if not beside it."),
    ] = None,
    trust_this_computer: Annotated[
        bool | None,
        typer.Option(
            show_envvar=False,
            envvar="GCS_TRUST_THIS_COMPUTER",
            show_default="yes, but not in a container that others reach",
            help="Whether programs and browsers of this user on this computer need no key.",
        ),
    ] = None,
    allow_anyone_to_fly: Annotated[
        bool,
        typer.Option(
            "--allow-anyone-to-fly",
            show_envvar=False,
            envvar="GCS_ALLOW_ANYONE_TO_FLY",
            help="Everybody on the network commands the aircraft without a key. The page says so in red.",
        ),
    ] = False,
    control_by_silence: Annotated[
        bool,
        typer.Option(
            "--control-by-silence",
            show_envvar=False,
            envvar="GCS_CONTROL_BY_SILENCE",
            help="Gives control to a page that asks for it when the one that has it does not answer for 10 s.",
        ),
    ] = False,
    print_key: Annotated[
        bool,
        typer.Option(
            show_envvar=False,
            envvar="GCS_PRINT_KEY",
            help="Print a one-time key with its QR code, where it listens beyond this computer.",
        ),
    ] = True,
    verbose: Annotated[bool, typer.Option(show_envvar=False, envvar="GCS_VERBOSE", help="Log more.")] = False,
    print_openapi: Annotated[bool, typer.Option(help="Print the OpenAPI document and end.")] = False,
    config: Annotated[
        Path | None,
        typer.Option(
            callback=_configure,
            is_eager=True,
            show_envvar=False,
            envvar="GCS_CONFIG",
            show_default=f"{NAME} in the user's folder for settings, if it is there",
            help="File with entries like port = 8080 (TOML).",
        ),
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version and end.")
    ] = False,
) -> None:
    """The gateway of EPF GCS: connects a board and a flight simulator with browsers.

    Without --board it opens the links of its last run. Every option is also a variable (--data-dir: GCS_DATA_DIR) and
    an entry of the config file (data_dir = "/srv/flights"); an option goes before a variable, a variable before the
    file. GCS_REACHED_AT (http://HOST:PORT) is where others reach it, if it cannot know (container, proxy);
    GCS_ALLOWED_HOSTS and GCS_ALLOWED_ORIGINS (JSON lists; in the file allowed_hosts and allowed_origins) let more
    names and pages in; GCS_LOCAL_MAPS (host:port) names servers of map tiles in the own network.

    It runs as two processes: `epf-flight` owns the lines and flies on when `epf-web`, which serves the page, does not.

    \b
    Examples:
      epf-gcs
      epf-gcs --board serial:///dev/ttyUSB0?baud=57600
      epf-gcs --host 0.0.0.0 --tls
      epf-gcs doctor
    """
    if context.invoked_subcommand is not None:
        return
    if print_openapi:
        raise typer.Exit(
            subprocess.run([sys.executable, "-m", "epf_gcs.web", "--print-openapi"], check=False).returncode
        )
    try:
        folder = held_by_launcher(data_dir)
        bring_up_to_date(data_dir, _say)
        listener = listen(host, port)
    except GatewayError as error:
        _say(error.detail)
        raise typer.Exit(1) from error
    except FormatError as error:
        _say(str(error))
        raise typer.Exit(1) from error
    except OSError as error:
        _say(f"The data folder {data_dir} cannot be used ({error.strerror or error}): see to its disk and rights.")
        raise typer.Exit(1) from error
    if is_refused_by_browsers(port):
        _say(f"Browsers refuse to open port {port}: choose another with --port, unless they come through a proxy.")
    encryption = tls_arguments(tls_cert, tls_key, tls=tls)
    access = access_arguments(
        trust_this_computer=trust_this_computer,
        allow_anyone_to_fly=allow_anyone_to_fly,
        control_by_silence=control_by_silence,
    )
    more = [*encryption, *access]
    port = listener.getsockname()[1]  # which may have been 0
    gateway = _gateway(listener, host, data_dir, page_dir, board, more, recording=recording, verbose=verbose)
    if print_key and not is_loopback(host):
        command = invite_command(data_dir, host, port, tls=bool(encryption))
        threading.Thread(target=print_invitation, args=(command,), name="invitation", daemon=True).start()
    with folder:
        code = gateway.run()
    # Both processes have ended.
    raise typer.Exit(code)


def _gateway(
    listener: socket.socket,
    host: str,
    data_dir: Path,
    page_dir: Path | None,
    board: str | None,
    more: Sequence[str],
    *,
    recording: bool,
    verbose: bool,
) -> Gateway:
    alive, held = os.pipe()
    os.set_inheritable(held, False)
    common = ["--data-dir", str(data_dir), "--with-parent", *(["--verbose"] if verbose else [])]
    flight = [
        *(sys.executable, "-m", "epf_gcs.flight", *common),
        *([] if recording else ["--no-recording"]),
    ]
    if HANDS_DOWN:
        # We keep it open, so that browsers wait during a restart of the web process, and are not refused.
        files, where = [listener.fileno()], ["--fd", str(listener.fileno())]
    else:
        files, where = [], ["--port", str(listener.getsockname()[1])]
        listener.close()
    web = [
        *(sys.executable, "-m", "epf_gcs.web", *common, "--host", host, *where),
        *more,
        *([] if page_dir is None else ["--page-dir", str(page_dir)]),
    ]
    # After a restart the flight process opens what was open when it died, so only its first start gets --board.
    first = [*flight, *([] if board is None else ["--board", board])]
    return Gateway(Part("flight", first, flight, alive), Part("web", web, [*web, "--again"], alive, files=files))


def _say(text: str) -> None:
    print(f"epf-gcs: {text}", file=sys.stderr, flush=True)


app.command()(invite)
add_commands(app)


def main() -> None:
    """Entry point of `epf-gcs`."""
    write_private_files()
    app()


if __name__ == "__main__":
    main()
