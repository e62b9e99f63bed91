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

from epf_gcs.errors import GatewayError
from epf_gcs.launcher.access import access_arguments, invite, invite_command, print_invitation
from epf_gcs.launcher.encryption import tls_arguments
from epf_gcs.launcher.folder import data_folder
from epf_gcs.launcher.ports import is_loopback
from epf_gcs.launcher.service import Service
from epf_gcs.launcher.upkeep import add_commands
from epf_gcs.listening import listen
from epf_gcs.watchdog import REFUSED, SILENT_S, wait_for_end

# The first restart is immediate, because the aircraft may be in flight; repeated ones wait longer, up to this.
_LONGEST_WAIT_S: Final = 5.0
_LIVED_S: Final = 10.0
_STOP_S: Final = 8.0
# A process that was being started when the signal came gets another signal after this time.
_SIGNAL_AGAIN_S: Final = 2.0

_DATA: Final = data_folder()

app = typer.Typer(add_completion=False, context_settings={"help_option_names": ["-h", "--help"]})


class Part:
    """One of the two processes. `again` is the command of every restart; `silent_s` is told in `watchdog.py`."""

    def __init__(
        self,
        name: str,
        command: Sequence[str],
        again: Sequence[str],
        stdin: int,
        files: Sequence[int] = (),
        silent_s: float = SILENT_S,
    ) -> None:
        self.name = name
        self._command = tuple(command)
        self._again = tuple(again)
        self._stdin = stdin
        self._files = tuple(files)
        self._silent_s = silent_s
        self._quick_deaths = 0
        self.process: subprocess.Popen[bytes] | None = None

    def keep_running(self, stopping: threading.Event) -> int | None:
        """Start it again whenever it dies or hangs, until `stopping`. Returns its exit status if it refused."""
        is_first = True
        while not stopping.is_set():
            began_s = time.monotonic()
            code = self._run(self._command if is_first else self._again)
            if stopping.is_set():
                return None
            has_lived = time.monotonic() - began_s > _LIVED_S
            if is_first and (code == REFUSED or (code > 0 and not has_lived)):
                return code
            is_first = False
            how = f"by signal {-code}" if code < 0 else f"with status {code}"
            print(f"epf-gcs: the {self.name} process ended {how} and is started again.", file=sys.stderr, flush=True)
            stopping.wait(self._wait_s(has_lived=has_lived))
        return None

    def signal(self, number: int) -> None:
        """Send a signal if it runs."""
        if self.process is not None and self.process.poll() is None:
            self.process.send_signal(number)

    def _run(self, command: Sequence[str]) -> int:
        # Only we hold the write end of its standard input, so it notices when we die, and ends. A process group of its
        # own: a terminal's Ctrl-C reaches only us, and we end both in order.
        watched, fed = os.pipe()
        try:
            self.process = subprocess.Popen(
                [*command, "--watchdog", str(fed)],
                stdin=self._stdin,
                pass_fds=(*self._files, fed),
                process_group=0,
            )
        finally:
            os.close(fed)
        try:
            return wait_for_end(self.process, watched, self._silent_s, self._report_hung)
        finally:
            os.close(watched)

    def _report_hung(self) -> None:
        print(f"epf-gcs: the {self.name} process hangs and is killed.", file=sys.stderr, flush=True)

    def _wait_s(self, *, has_lived: bool) -> float:
        self._quick_deaths = 1 if has_lived else self._quick_deaths + 1
        return 0.0 if self._quick_deaths <= 1 else min(_LONGEST_WAIT_S, 0.1 * 2.0**self._quick_deaths)


class Gateway:
    """Both processes. Each is watched by a thread of its own, so that neither waits for the other's restart."""

    def __init__(self, flight: Part, web: Part) -> None:
        self._parts = (flight, web)
        self._stopping = threading.Event()
        self._refusal: int | None = None

    def run(self) -> int:
        """Run until a signal, or until one of the two refuses to start; returns the exit code."""
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, self._stop)
        watchers = [threading.Thread(target=self._watch, args=(part,), name=part.name) for part in self._parts]
        for watcher in watchers:
            watcher.start()
        service = Service()
        service.ready()
        while not self._stopping.wait(service.every_s):
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
        number: int = signal.SIGTERM
        while any(watcher.is_alive() for watcher in watchers):
            for part in self._parts:
                part.signal(number)
            for watcher in watchers:
                watcher.join(_SIGNAL_AGAIN_S)
            if time.monotonic() > give_up_s:
                number = signal.SIGKILL


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
    print_key: Annotated[
        bool,
        typer.Option(help="Print a one-time key with its QR code, where it listens beyond this computer."),
    ] = True,
    verbose: Annotated[bool, typer.Option(help="Log more.")] = False,
    print_openapi: Annotated[bool, typer.Option(help="Print the OpenAPI document and end.")] = False,
) -> None:
    """The gateway of EPF GCS: connects a board and a flight simulator with browsers.

    Without --board it opens the links of its last run. Every option is also a variable: GCS_HOST, GCS_PORT,
    GCS_BOARD, GCS_DATA_DIR, GCS_PAGE_DIR, GCS_RECORDING, GCS_TLS, GCS_TLS_CERT, GCS_TLS_KEY;
    GCS_REACHED_AT (http://HOST:PORT) is where others reach it, if it cannot know (in a container, behind a proxy);
    GCS_ALLOWED_HOSTS and GCS_ALLOWED_ORIGINS (JSON lists) let more names and pages in; GCS_LOCAL_MAPS (a JSON list of
    host:port) names servers of map tiles in the own network.

    It runs as two processes: `epf-flight` owns the lines and flies on when `epf-web`, which serves the page, does not.
    """
    if context.invoked_subcommand is not None:
        return
    if print_openapi:
        raise typer.Exit(
            subprocess.run([sys.executable, "-m", "epf_gcs.web", "--print-openapi"], check=False).returncode
        )
    try:
        listener = listen(host, port)
    except GatewayError as error:
        print(f"epf-gcs: {error.detail}", file=sys.stderr)
        raise typer.Exit(1) from error
    encryption = tls_arguments(tls_cert, tls_key, tls=tls)
    access = access_arguments(trust_this_computer=trust_this_computer, allow_anyone_to_fly=allow_anyone_to_fly)
    more = [*encryption, *access]
    gateway = _gateway(listener, host, data_dir, page_dir, board, more, recording=recording, verbose=verbose)
    if print_key and not is_loopback(host):
        command = invite_command(data_dir, host, listener.getsockname()[1], tls=bool(encryption))
        threading.Thread(target=print_invitation, args=(command,), name="invitation", daemon=True).start()
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
    web = [
        *(sys.executable, "-m", "epf_gcs.web", *common, "--host", host, "--fd", str(listener.fileno())),
        *more,
        *([] if page_dir is None else ["--page-dir", str(page_dir)]),
    ]
    # After a restart the flight process opens what was open when it died, so only its first start gets --board.
    first = [*flight, *([] if board is None else ["--board", board])]
    # We keep the listening socket open, so that browsers wait during a restart of the web process, and are not refused.
    parts = Part("flight", first, flight, alive), Part("web", web, [*web, "--again"], alive, [listener.fileno()])
    return Gateway(*parts)


app.command()(invite)
add_commands(app)


def main() -> None:
    """Entry point of `epf-gcs`."""
    app()


if __name__ == "__main__":
    main()
