"""The firmware image for the board's own processor, run by QEMU in place of the demonstration's board."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.ports import LOOPBACK, free_tcp_port

if TYPE_CHECKING:
    from pathlib import Path

QEMU: Final = "qemu-system-arm"
_OPTION: Final = "qemu"
"""Value of --board."""


@dataclass(frozen=True, slots=True)
class EmulatedBoard:
    """One image under QEMU, its serial line on a TCP port of the loopback."""

    port: int
    folder: str = "stm32f405"
    machine: tuple[str, ...] = ("netduinoplus2",)

    @classmethod
    def named(cls, board: str | None) -> Self | None:
        """The emulated board that `board` names, on a free port; None if it names another kind of board."""
        return cls(free_tcp_port()) if board == _OPTION else None

    @property
    def url(self) -> str:
        """The address that the gateway opens."""
        return f"tcp://{LOOPBACK}:{self.port}"

    def command(self, built: Path, card: Path) -> list[str]:
        """Start QEMU with the image in the folder `built`, and the folder `card` as its memory card.

        Raises LaunchError, with what to do, where QEMU or the image is missing.
        """
        program = shutil.which(QEMU)
        if program is None:
            raise LaunchError(f"{QEMU} is not on this computer: on Debian or Ubuntu, apt install qemu-system-arm.")
        image = built / self.folder / "epf-board-qemu.elf"
        if not image.exists():
            raise LaunchError(f"The board's image {image} is missing: build it with `make images`.")
        card.mkdir(parents=True, exist_ok=True)
        return [
            *(program, "-M", *self.machine, "-kernel", str(image), "-display", "none", "-monitor", "none"),
            *self._line(),
            # QEMU ends a value at a comma; a doubled comma stands for one.
            *("-semihosting-config", f"enable=on,target=native,arg=--card,arg={str(card).replace(',', ',,')}"),
        ]

    def _line(self) -> tuple[str, ...]:
        """Its serial port as a TCP port, each byte sent at once."""
        socket = f"socket,id=line,host={LOOPBACK},port={self.port},server=on,wait=off,nodelay=on"
        # QEMU's serial port holds one byte, and its main loop passes the next one only after the firmware has read it:
        # two threads that wake each other for every byte took five sixths of a frame's time. The multiplexer buffers
        # 32 bytes between them. But it reads an escape byte as a command, even inside a frame: 256 is a value that no
        # byte has.
        return ("-chardev", f"{socket},mux=on", "-serial", "chardev:line", "-echr", "256")
