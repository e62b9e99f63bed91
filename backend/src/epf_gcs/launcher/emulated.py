"""The board's image for its own processor, run by QEMU in the place of the demonstration's board."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.ports import LOOPBACK, free_tcp_port

if TYPE_CHECKING:
    from pathlib import Path

QEMU: Final = "qemu-system-arm"
_MACHINES: Final = {"qemu": ("stm32f405", "netduinoplus2"), "qemu-an386": ("mps2_an386", "mps2-an386")}
"""What a person writes -> folder of the image, QEMU's name of the machine."""
_BUFFERED: Final = "stm32f405"
"""Whose serial port asks QEMU's multiplexer for the next byte; the other one would never see what that holds."""


@dataclass(frozen=True, slots=True)
class EmulatedBoard:
    """One image under QEMU, its serial line on a TCP port of the loopback."""

    folder: str
    machine: str
    port: int

    @classmethod
    def named(cls, board: str | None) -> Self | None:
        """The one that `board` names, on a free port; None for everything else a board can be."""
        if board not in _MACHINES:
            return None
        return cls(*_MACHINES[board], free_tcp_port())

    @property
    def url(self) -> str:
        """What the gateway opens."""
        return f"tcp://{LOOPBACK}:{self.port}"

    def command(self, firmware: Path, card: Path) -> list[str]:
        """Start QEMU with the image of `firmware`, and the folder `card` as its memory card.

        Raises LaunchError, with what to do, where QEMU or the image is missing.
        """
        program = shutil.which(QEMU)
        if program is None:
            raise LaunchError(f"{QEMU} is not on this computer: on Debian or Ubuntu, apt install qemu-system-arm.")
        image = firmware / "build" / self.folder / "epf-board-qemu.elf"
        if not image.exists():
            raise LaunchError(f"The board's image {image} is missing: build it with `make images`.")
        card.mkdir(parents=True, exist_ok=True)
        return [
            *(program, "-M", self.machine, "-kernel", str(image), "-display", "none", "-monitor", "none"),
            *self._line(),
            # A comma ends a value there, two are one.
            *("-semihosting-config", f"enable=on,target=native,arg=--card,arg={str(card).replace(',', ',,')}"),
        ]

    def _line(self) -> tuple[str, ...]:
        """Its serial port as a TCP port, each byte sent at once."""
        socket = f"socket,id=line,host={LOOPBACK},port={self.port},server=on,wait=off,nodelay=on"
        words = ("-chardev", socket, "-serial", "chardev:line")
        if self.folder != _BUFFERED:
            return words
        # QEMU's serial port takes one byte, and its main loop brings the next one only after the processor's program
        # has taken that: two threads that wake each other for every byte were five sixths of a frame's way. The
        # multiplexer holds 32 bytes between them. It would take a byte for its own commands, in the middle of a frame:
        # this one does not exist.
        return ("-chardev", f"{socket},mux=on", *words[2:], "-echr", "256")
