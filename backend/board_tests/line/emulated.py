"""The board's image for its own processor under QEMU, as a child process."""

from __future__ import annotations

import signal
import subprocess
import time
from pathlib import Path
from typing import Final

from board_tests.line.station import VERSION, Station
from epf_gcs.launcher.emulated import QEMU, EmulatedBoard
from epf_gcs.launcher.ports import LOOPBACK, free_tcp_port
from tests.support.firmware import FIRMWARE
from tests.support.waiting import DEADLINE_S

Machine = tuple[str, tuple[str, ...]]
"""Folder of an image, and QEMU's words for the machine."""
STM32F405: Final[Machine] = ("stm32f405", ("netduinoplus2",))
LM3S6965: Final[Machine] = ("lm3s6965evb", ("lm3s6965evb", "-cpu", "cortex-m4"))


class Emulator:
    """One run of QEMU, the board's line on this port. Its time is its own: never compare it with the wall's."""

    def __init__(self, port: int, command: list[str]) -> None:
        self.port = port
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def station(self) -> Station:
        """A station on its line, once the board answers: what is sent to one that is still starting is lost."""
        station = self._connected()
        station.ask_until(lambda: station.send(b"version\n"), lambda: f"{VERSION}\n" in station.text)
        station.settle()
        return station

    def _connected(self) -> Station:
        deadline_s = time.monotonic() + DEADLINE_S
        while True:
            try:
                return Station.on_tcp(self.port)
            except ConnectionRefusedError:
                assert self._process.poll() is None, self._process.communicate()[0]
                assert time.monotonic() < deadline_s, "nobody listens"
                time.sleep(0.02)

    def stop(self) -> str:
        """End it; what it had to complain about."""
        self._process.send_signal(signal.SIGTERM)
        complaints, _ = self._process.communicate(timeout=DEADLINE_S)
        return "\n".join(line for line in complaints.splitlines() if not _is_usual(line))

    def cut_power(self) -> None:
        """End it without a word to anybody."""
        self._process.kill()
        self._process.communicate(timeout=DEADLINE_S)


class Image(Emulator):
    """An image for QEMU, which lends it a folder as its card."""

    def __init__(self, machine: Machine, card: Path, *options: str) -> None:
        emulated = EmulatedBoard(free_tcp_port(), *machine)
        command = emulated.command(FIRMWARE / "build", card)
        # The board's own options stand before the card.
        command[-1] = command[-1].replace(
            "arg=--card", ",".join([*(f"arg={option}" for option in options), "arg=--card"])
        )
        super().__init__(emulated.port, command)


class Bare(Emulator):
    """An image for the processor itself, which QEMU lends nothing, and a card in its slot where it has one."""

    def __init__(self, machine: Machine, card: Path | None) -> None:
        folder, words = machine
        port = free_tcp_port()
        image = FIRMWARE / "build" / folder / "epf-board.elf"
        plugged = () if card is None else ("-drive", f"if=sd,format=raw,file={card}")
        super().__init__(
            port,
            [
                *(QEMU, "-M", *words, "-kernel", str(image), "-display", "none", "-monitor", "none"),
                *("-serial", f"tcp:{LOOPBACK}:{port},server=on,wait=off,nodelay=on", *plugged),
            ],
        )


def _is_usual(line: str) -> bool:
    """What QEMU always says: that it was ended, and that a timer of the machine was started before it was set."""
    return "terminating on signal" in line or line == "Timer with period zero, disabling"
