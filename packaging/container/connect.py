"""Tell a station in a container what it is connected to: the board, X-Plane or the simulator, and whether it flies.

Runs beside the gateway, with its data folder: it makes a one-time key for itself and comes in like any person. Waits
until each link is open. Ends with 1 and a sentence where one cannot be opened.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import time
import urllib.error
import urllib.request
from typing import Any, Final

_KEY: Final = re.compile(r"[0-9A-Z]{4}(?:-[0-9A-Z]{4}){3}")
_PATIENCE_S: Final = 60.0
_COMMANDS: Final = ("start", "hil_load_gando", "autotrim_on", "autopilot_on")


class Station:
    """A session at the gateway of this container's loopback."""

    def __init__(self) -> None:
        self._base = f"http://127.0.0.1:{os.environ.get('GCS_PORT', '8000')}/api/v1"
        self._headers = {"Content-Type": "application/json"}
        self._opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))

    def enter(self) -> None:
        """Come in as an operator."""
        invited = subprocess.run(
            ["epf-gcs", "invite", "--role", "operator", "--minutes", "5"], check=True, capture_output=True, text=True
        )
        found = _KEY.search(invited.stdout)
        if found is None:
            sys.exit(f"No key in what epf-gcs invite printed:\n{invited.stdout}")
        body = {"key": found[0], "name": "compose", "place": "container"}
        cookie = self._answer("POST", "access/enter", body).headers["Set-Cookie"]
        self._headers["Cookie"] = cookie.partition(";")[0]

    def ask(self, method: str, path: str, body: object = None) -> dict[str, Any]:
        """One request; ends the program with the gateway's own sentence where it refuses."""
        answer: dict[str, Any] = json.loads(self._answer(method, path, body).read() or b"{}")
        return answer

    def wait(self, what: str, link: str, key: str, value: str | None) -> None:
        """Until a part of the status has a value (None: any)."""
        give_up_s = time.monotonic() + _PATIENCE_S
        status: dict[str, Any] = {}
        while time.monotonic() < give_up_s:
            status = self.ask("GET", "status")[link]
            found: Any = status
            for name in key.split("."):
                found = found[name]
            if found == value if value is not None else found is not None:
                return
            time.sleep(0.1)
        failure = status.get("failure") or {}
        sys.exit(f"Waited {_PATIENCE_S:.0f} s in vain until {what}. {failure.get('detail', '')}")

    def _answer(self, method: str, path: str, body: object) -> Any:
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f"{self._base}/{path}", data, self._headers, method=method)  # noqa: S310
        try:
            return self._opener.open(request, timeout=15)
        except urllib.error.HTTPError as error:
            sys.exit(f"{method} {path}: {json.loads(error.read()).get('detail', error)}")


def main() -> None:
    """Connect what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", help="tcp://HOST:PORT or serial:///dev/board?baud=115200")
    parser.add_argument("--simulator", help="The host of X-Plane or epf-sim; it receives on UDP 49000.")
    parser.add_argument("--generation", default="xp10", choices=("xp10", "xp12"))
    parser.add_argument("--circuit", action="store_true", help="Load the Gando circuit and have the autopilot fly it.")
    options = parser.parse_args()
    if options.simulator == "":
        sys.exit("Name the computer of X-Plane: GCS_XPLANE=192.168.1.20")
    station = Station()
    station.enter()
    if options.board is not None:
        station.ask("PUT", "links/board", {"url": options.board})
        station.wait("the board answers", "board", "state", "open")
    if options.simulator is not None:
        link = {
            "receive_port": 49003,
            "send_host": options.simulator,
            "send_port": 49000,
            "profile": options.generation,
        }
        station.ask("PUT", "links/simulator", link)
    if options.circuit:
        station.ask("PUT", "hil", {"source": "joystick", "path": "assisted"})
        for name in _COMMANDS:
            state = station.ask("POST", f"commands/{name}", {})["state"]
            if state not in {"confirmed", "sent"}:
                sys.exit(f"The board did not take the command {name} ({state}).")
        station.wait("the board's surfaces reach the simulator", "simulator", "hil_round_trip_ms.newest", None)
        print("The autopilot flies the Gando circuit.")
    station.ask("POST", "access/leave", {})


if __name__ == "__main__":
    main()
