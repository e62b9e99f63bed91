"""What the launcher was asked to run, and with which programs."""

import os
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Self

from epf_gcs.data_folder.place import data_folder
from epf_gcs.extras import SIM
from epf_gcs.launcher.access import access_arguments
from epf_gcs.launcher.emulated import EmulatedBoard
from epf_gcs.launcher.encryption import tls_arguments
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.ports import LOOPBACK
from epf_gcs.product import BOARD

BOARD_PROGRAM: Final = "posix/epf-board"
STATION_PORT: Final = 49003
SIMULATOR_PORT: Final = 49000
_LINK_KINDS: Final = ("serial", "tcp", "pty")
EVERY_INTERFACE: Final = "0.0.0.0"  # noqa: S104 (only with --lan, which asks for it)


@dataclass(frozen=True, slots=True)
class XPlane:
    """An X-Plane: the host and port that it receives on, the port that we receive on, and its generation."""

    host: str
    port: int = SIMULATOR_PORT
    receive_port: int = STATION_PORT
    profile: str = "xp10"

    @classmethod
    def at(cls, address: str, receive_port: int, profile: str) -> Self:
        """From `HOST` or `HOST:PORT`; raises LaunchError for anything else."""
        host, colon, port = address.partition(":")
        if not host or (colon and not (port.isdecimal() and 0 < int(port) < 65536)):
            raise LaunchError(f"{address} is not the address of X-Plane: give HOST or HOST:PORT, as in 192.168.1.20.")
        return cls(host, int(port) if colon else SIMULATOR_PORT, receive_port, profile)


@dataclass(frozen=True, slots=True)
class Options:
    """One run. `board` and `xplane` are the real ones that replace the demonstration's board and simulator.

    `emulated`: the demonstration's board runs as the image for its own processor, under QEMU.
    """

    board: str | None = None
    emulated: EmulatedBoard | None = None
    xplane: XPlane | None = None
    port: int = 8000
    lan: bool = False
    data: Path = field(default_factory=data_folder)
    tls: bool = False
    tls_cert: Path | None = None
    tls_key: Path | None = None
    trust_this_computer: bool | None = None
    allow_anyone_to_fly: bool = False

    @property
    def host(self) -> str:
        """The address the page is served on."""
        return EVERY_INTERFACE if self.lan else LOOPBACK

    @property
    def url(self) -> str:
        """Where the page is."""
        return f"{self.scheme}://{LOOPBACK}:{self.port}"

    @property
    def scheme(self) -> str:
        """How the page is asked for."""
        return "https" if self.tls or self.tls_cert else "http"

    @property
    def trusted(self) -> Path | None:
        """The certificate that the gateway is known by, None without TLS."""
        return self.tls_cert or (self.data / "tls" / "authority.crt" if self.tls else None)

    @property
    def board_line(self) -> Path:
        """The demonstration board's pseudo-terminal."""
        return self.data / "board.pty"

    def board_url(self) -> str:
        """The address that the gateway opens: the demonstration's line, or the real board's device or address.

        Raises LaunchError for what can be neither.
        """
        if self.emulated is not None:
            return self.emulated.url
        if self.board is None:
            return f"pty://{self.board_line}"
        kind, separator, _ = self.board.partition("://")
        if not separator:
            return f"serial://{self.board}"
        if kind not in _LINK_KINDS:
            raise LaunchError(
                f"{self.board} is not the address of a board: give a device like /dev/ttyUSB0, or an address like "
                "serial:///dev/ttyUSB0?baud=115200, tcp://192.168.1.5:4000 or pty:///run/board."
            )
        return self.board

    def board_command(self) -> list[str]:
        """The demonstration's board. Raises LaunchError if the firmware has not been built, or cannot be run."""
        card = self.data / "card"
        if self.emulated is not None:
            return self.emulated.command(BOARD.folder, card)
        try:
            program = BOARD.file(BOARD_PROGRAM)
        except FileNotFoundError as error:
            raise LaunchError(str(error)) from error
        return [str(program), "--pty", str(self.board_line), "--card", str(card)]

    def simulator_command(self, simulator: XPlane) -> list[str]:
        """The embedded simulator, which listens where the gateway sends and the other way round.

        Raises LaunchError if its flight dynamics are not installed.
        """
        if not SIM.is_here:
            raise LaunchError(f"{SIM.sentence()}\nOr fly with X-Plane by --xplane, or connect a board by epf-gcs.")
        return [
            *(sys.executable, "-m", "epf_gcs.simulator", "--profile", simulator.profile),
            *("--listen", f"{LOOPBACK}:{simulator.port}", "--send-to", f"{LOOPBACK}:{simulator.receive_port}"),
        ]

    def gateway_command(self, *, first: bool) -> list[str]:
        """The gateway, which serves the page too.

        It remembers its links. Its first start gets the board's address, or it would briefly open the board of an
        earlier run; a restart does not, because it opens what was open when it died.
        """
        return [
            *(sys.executable, "-m", "epf_gcs.launcher.gateway"),
            *("--host", self.host, "--port", str(self.port), "--data-dir", str(self.data)),
            # The demonstration takes nothing from the user's config file.
            *("--config", os.devnull),
            *tls_arguments(self.tls_cert, self.tls_key, tls=self.tls),
            *access_arguments(
                trust_this_computer=self.trust_this_computer, allow_anyone_to_fly=self.allow_anyone_to_fly
            ),
            # Its output goes to a file: no key is printed there.
            "--no-print-key",
            *(("--board", self.board_url()) if first else ()),
        ]
