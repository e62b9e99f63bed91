"""What the launcher was asked to run, and with which programs."""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from launcher.errors import LaunchError
from launcher.ports import LOOPBACK

# backend/src/launcher/options.py: the tree's root is three folders above the package.
ROOT: Final = Path(__file__).resolve().parents[3]
BOARD_PROGRAM: Final = ROOT / "firmware" / "build" / "posix" / "epf-board"
PAGE: Final = ROOT / "frontend" / "dist" / "index.html"

STATION_PORT: Final = 49003
SIMULATOR_PORT: Final = 49000
_LINK_KINDS: Final = ("serial", "tcp", "pty")
EVERY_INTERFACE: Final = "0.0.0.0"  # noqa: S104 (only with --lan, which asks for it)


@dataclass(frozen=True, slots=True)
class Options:
    """One run. `board` and `xplane` are the real ones that take a demonstration part's place."""

    board: str | None
    xplane: str | None
    port: int
    lan: bool
    data: Path

    @property
    def host(self) -> str:
        """The address the page is served on."""
        return EVERY_INTERFACE if self.lan else LOOPBACK

    @property
    def url(self) -> str:
        """Where the page is."""
        return f"http://{LOOPBACK}:{self.port}"

    @property
    def board_line(self) -> Path:
        """The demonstration board's pseudo-terminal."""
        return self.data / "board.pty"

    def board_url(self) -> str:
        """What the gateway is to open: the demonstration's line, or the real board's device or address.

        Raises LaunchError for what can be neither.
        """
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
        """Raises LaunchError where the firmware has not been built."""
        if not BOARD_PROGRAM.exists():
            raise LaunchError(f"The board's program {BOARD_PROGRAM} is missing: build it with `make board`.")
        return [str(BOARD_PROGRAM), "--pty", str(self.board_line), "--card", str(self.data / "card")]

    def simulator_command(self, listen_port: int, send_port: int) -> list[str]:
        """The embedded simulator, which listens where the gateway sends and the other way round."""
        return [
            *(sys.executable, "-m", "simulator"),
            *("--listen", f"{LOOPBACK}:{listen_port}", "--send-to", f"{LOOPBACK}:{send_port}"),
        ]

    def gateway_command(self, *, first: bool) -> list[str]:
        """The gateway, which serves the page too.

        It remembers its links. Only its first start is told the board, lest it opens for a moment the one of
        another day; started again, it opens what was open when it died.
        """
        return [
            *(sys.executable, "-m", "gateway"),
            *("--host", self.host, "--port", str(self.port), "--data-dir", str(self.data)),
            *(("--board", self.board_url()) if first else ()),
        ]
