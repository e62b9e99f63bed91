"""What a program tells systemd that runs it as a service: that it is ready, that it lives, that it ends."""

from __future__ import annotations

import contextlib
import os
import socket
from collections.abc import Mapping
from typing import Final

from epf_gcs.system.sockets import local_socket

_SOCKET: Final = "NOTIFY_SOCKET"
_WATCHDOG: Final = "WATCHDOG_USEC"


class Service:
    """Speaks sd_notify(3) to the socket that systemd names; silent where nobody listens."""

    def __init__(self, environment: Mapping[str, str] = os.environ) -> None:
        # An abstract socket's name begins with a zero byte, which systemd writes as @.
        address = environment.get(_SOCKET, "")
        self._address = "\0" + address[1:] if address.startswith("@") else address
        silent_us = environment.get(_WATCHDOG, "")
        self.every_s: float | None = int(silent_us) / 2e6 if self._address and silent_us.isdecimal() else None
        """How often it wants to hear that the program lives; None: never."""

    def ready(self) -> None:
        """The program has started."""
        self._say("READY=1")

    def alive(self) -> None:
        """The program and all that it runs live."""
        self._say("WATCHDOG=1")

    def stopping(self) -> None:
        """The program is ending on purpose."""
        self._say("STOPPING=1")

    def _say(self, text: str) -> None:
        if not self._address:
            return
        with contextlib.suppress(OSError), local_socket(socket.SOCK_DGRAM) as to:
            to.sendto(text.encode(), self._address)
