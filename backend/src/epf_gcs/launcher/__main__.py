"""`epf-run`: the whole demonstration with one command, and the station for a real board or X-Plane."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from types import FrameType
from typing import Annotated

import typer

from epf_gcs.data_folder.place import DEFAULT, DEMONSTRATION, data_folder, demonstration_folder
from epf_gcs.launcher.access import invite_command, print_invitation
from epf_gcs.launcher.demonstration import Demonstration, StopRequest
from epf_gcs.launcher.emulated import EmulatedBoard
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.options import STATION_PORT, Options, XPlane
from epf_gcs.launcher.upkeep import print_version
from epf_gcs.system.locks import lock
from epf_gcs.system.private_files import write_private_files
from epf_gcs.system.signals import POLITE

app = typer.Typer(
    pretty_exceptions_enable=False, rich_markup_mode=None, context_settings={"help_option_names": ["-h", "--help"]}
)


class Profile(StrEnum):
    """Generations of X-Plane that order the rows differently."""

    XP10 = "xp10"
    XP12 = "xp12"


@app.command()
def run(
    *,
    board: Annotated[
        str | None,
        typer.Option(
            metavar="URL",
            help="A real board in the demonstration board's place: a device (/dev/ttyUSB0), "
            "serial:///dev/ttyUSB0?baud=115200, or tcp://host:port. Its modes are left as they are. `qemu` is the "
            "demonstration's board as the image of its processor (an STM32F405).",
            show_default="the board on this computer",
        ),
    ] = None,
    xplane: Annotated[
        str | None,
        typer.Option(
            metavar="HOST[:PORT]",
            help="The computer X-Plane runs on, in the embedded simulator's place, and the UDP port it receives on "
            "where that is not 49000. X-Plane has to send its data output to this computer.",
            show_default="the embedded simulator",
        ),
    ] = None,
    receive_port: Annotated[
        int, typer.Option(min=1, max=65535, help="UDP port X-Plane sends to. Only with --xplane.")
    ] = STATION_PORT,
    profile: Annotated[
        Profile, typer.Option(help="xp10: X-Plane 10 and 11. xp12: X-Plane 12. Only with --xplane.")
    ] = Profile.XP10,
    port: Annotated[int, typer.Option(min=1, max=65535, help="Port of the page and the interface.")] = 8000,
    lan: Annotated[
        bool,
        typer.Option(
            "--lan", help="Let other computers of the network in, with a key that is printed; else only this one can."
        ),
    ] = False,
    trust_this_computer: Annotated[
        bool | None,
        typer.Option(
            show_default="yes, but not in a container with --lan",
            help="Whether programs and browsers of this user on this computer need no key.",
        ),
    ] = None,
    allow_anyone_to_fly: Annotated[
        bool,
        typer.Option(
            "--allow-anyone-to-fly",
            help="With --lan: everybody on the network commands the aircraft without a key. The page says so in red.",
        ),
    ] = False,
    tls: Annotated[
        bool,
        typer.Option("--tls", help="HTTPS, with an authority and a certificate that are made in DATA/tls and renewed."),
    ] = False,
    tls_cert: Annotated[
        Path | None, typer.Option(help="HTTPS with this certificate and its chain (PEM).", show_default=False)
    ] = None,
    tls_key: Annotated[
        Path | None, typer.Option(help="The certificate's key (PEM), if not beside it.", show_default=False)
    ] = None,
    data: Annotated[
        Path | None,
        typer.Option(
            "--data-dir",
            help="Folder for recordings, settings, the board's card and the programs' logs.",
            show_default=f"{DEMONSTRATION}; with --board a real one, {DEFAULT}",
        ),
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version and end.")
    ] = False,
) -> None:
    """Start the board, the simulator and the gateway, and fly the Gando route.

    The page's address is printed once everything flies. Ctrl-C stops it all.
    A program that dies is started again, and the flight goes on. The programs'
    logs are in DATA/logs; those of the run before end in .1.log.

    \b
    Examples:
      epf-run
      epf-run --port 8001 --lan
      epf-run --board qemu
      epf-run --board /dev/ttyUSB0 --xplane 192.168.1.20
    """
    asked = _StopRequest()
    try:
        real = None if xplane is None else XPlane.at(xplane, receive_port, profile.value)
        emulated = EmulatedBoard.named(board)
        if data is None:
            data = demonstration_folder() if board is None or emulated else data_folder()
        options = Options(
            board=None if emulated else board,
            emulated=emulated,
            xplane=real,
            port=port,
            lan=lan,
            data=data.resolve(),
            tls=tls,
            tls_cert=None if tls_cert is None else tls_cert.resolve(),
            tls_key=None if tls_key is None else tls_key.resolve(),
            trust_this_computer=trust_this_computer,
            allow_anyone_to_fly=allow_anyone_to_fly,
        )
        demonstration = Demonstration(options, _say, lambda: asked.heard)
        with _alone(options.data):
            try:
                demonstration.start()
                print(options.url, flush=True)
                if lan:
                    print_invitation(invite_command(options.data, options.host, port, tls=options.scheme == "https"))
                demonstration.watch()
            except StopRequest:
                pass
            finally:
                if asked.heard:
                    _say("Stopping ...")
                demonstration.stop()
    except LaunchError as error:
        _say(str(error))
        raise typer.Exit(1) from None


class _StopRequest:
    """Remembers that Ctrl-C or SIGTERM came; polled while waiting."""

    def __init__(self) -> None:
        self.heard = False
        for number in POLITE:
            signal.signal(number, self._hear)

    def _hear(self, _number: int, _frame: FrameType | None) -> None:
        self.heard = True


@contextmanager
def _alone(data: Path) -> Iterator[None]:
    """Lock the data folder for this run: two boards on one line, or two recorders, would disturb each other."""
    try:
        data.mkdir(parents=True, exist_ok=True)
        opened = (data / "run.lock").open("w")
    except OSError as error:
        raise LaunchError(
            f"The folder {data} cannot be written to ({error.strerror}): choose another with --data-dir."
        ) from None
    with opened as file:
        if not lock(file):
            raise LaunchError(
                f"Another epf-run is using the folder {data}: stop that one, or choose another with --data-dir."
            )
        yield


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def main() -> None:
    """Entry point of `epf-run`."""
    write_private_files()
    app()


if __name__ == "__main__":
    main()
