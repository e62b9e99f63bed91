"""Run the demonstration: start the programs, close the HIL loop, keep them running, stop them all."""

import time
from collections import deque
from collections.abc import Callable
from typing import Final

from epf_gcs.launcher.access import LAUNCHER_KEY, new_launcher_key
from epf_gcs.launcher.child import Child
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.gateway_client import GatewayClient, Status
from epf_gcs.launcher.options import SIMULATOR_PORT, STATION_PORT, Options, XPlane
from epf_gcs.launcher.ports import LOOPBACK, free_udp_port, require_tcp_port
from epf_gcs.product import PAGE

_START_TIMEOUT_S: Final = 60.0
_WATCH_S: Final = 0.1
_DEATHS_ALLOWED: Final = 5
_DEATHS_WINDOW_S: Final = 60.0

Say = Callable[[str], None]


class StopRequest(Exception):  # noqa: N818 (no error: somebody asked for it)
    """The person asked to stop."""


class Demonstration:
    """Board, simulator and gateway of one run. `say` shows progress; `asked_to_stop` is polled."""

    def __init__(self, options: Options, say: Say, asked_to_stop: Callable[[], bool]) -> None:
        self._options = options
        self._say = say
        self._asked_to_stop = asked_to_stop
        self._key = new_launcher_key()
        self._gateway = GatewayClient(options.url, self._key, options.trusted)
        self._children: list[Child] = []
        self._deaths: deque[float] = deque()

    def start(self) -> None:
        """Start everything and close the loop; raises LaunchError with what failed, Stopped when asked to."""
        require_tcp_port(self._options.host, self._options.port)
        try:
            PAGE.file("index.html")
        except FileNotFoundError as error:
            self._say(f"{error} The interface works without it.")
        if self._options.xplane is not None:
            self._start_with(self._options.xplane)
            return
        simulator = self._embedded()
        try:
            self._start_with(simulator)
        except LaunchError:
            self.stop()
            # Two demonstrations started at the same moment find the same ports free, and one fails to bind them: if
            # they are taken now, try once more with others.
            if all(free_udp_port(port) == port for port in (simulator.port, simulator.receive_port)):
                raise
            self._start_with(self._embedded())

    def _start_with(self, simulator: XPlane) -> None:
        options = self._options
        logs = options.data / "logs"
        logs.mkdir(parents=True, exist_ok=True)
        # In the order of starting. They are stopped in reverse order, the gateway first, because on its way out it
        # hands the controls back to the simulator and closes the board's binary mode.
        if options.board is None:
            self._children.append(Child("board", options.board_command(), logs))
        if options.xplane is None:
            self._children.append(Child("simulator", options.simulator_command(simulator), logs))
        gateway = [options.gateway_command(first=first) for first in (True, False)]
        # A board of the environment would be opened at a restart in flight.
        variables = {LAUNCHER_KEY: self._key, "GCS_BOARD": ""}
        self._children.append(Child("gateway", gateway[0], logs, gateway[1], variables))
        self._say("Starting " + ", ".join(f"the {child.name}" for child in self._children) + " ...")
        for child in self._children:
            child.start()
        self._wait("the gateway answers", lambda _: True)
        self._gateway.end_first_start()
        self._gateway.open_board(options.board_url())
        self._gateway.open_simulator(simulator)
        if options.board is None:
            self._close_loop()
        else:
            self._say("The board is a real one: its streams, plans and autopilot are left as they are.")

    def watch(self) -> None:
        """Keep everything running until asked to stop; raises LaunchError if a program ends again and again."""
        while not self._asked_to_stop():
            for child in self._children:
                if (status := child.ended) is not None:
                    self._revive(child, status)
                child.turn_log_over()
            time.sleep(_WATCH_S)

    def stop(self) -> None:
        """Stop every child, the gateway first; a child that hangs is killed."""
        for child in reversed(self._children):
            if not child.stop():
                self._say(f"The {child.name} did not stop within 5 s and was killed.")
        self._children.clear()

    def _embedded(self) -> XPlane:
        """The embedded simulator on the usual ports, or on free ones if those are taken: we start both ends."""
        ports = free_udp_port(SIMULATOR_PORT), free_udp_port(STATION_PORT)
        for wanted, chosen in zip((SIMULATOR_PORT, STATION_PORT), ports, strict=True):
            if chosen != wanted:
                self._say(f"UDP port {wanted} is taken (by X-Plane?): the demonstration uses {chosen} in its place.")
        return XPlane(LOOPBACK, *ports)

    def _close_loop(self) -> None:
        """Switch the streams on, load the Gando route, and have the board's autopilot fly the simulator."""
        gateway = self._gateway
        self._wait("the board answers", lambda status: status["board"]["state"] == "open" and _has_heartbeat(status))
        self._say("Loading the Gando route and closing the loop ...")
        gateway.select_hil("joystick", "assisted")
        gateway.command("start")
        gateway.command("hil_load_gando")
        gateway.command("autotrim_on")
        gateway.command("autopilot_on")
        xplane = self._options.xplane
        if xplane is None:
            self._wait("the board's surfaces reach the simulator", _loop_is_closed)
        else:
            port = xplane.receive_port
            self._say(f"The loop closes as soon as X-Plane on {xplane.host} sends its data to UDP port {port} here.")

    def _wait(self, what: str, condition: Callable[[Status], bool]) -> None:
        self._gateway.wait(what, condition, _START_TIMEOUT_S, self._check)

    def _check(self) -> None:
        """Called during every wait: raises Stopped if asked to stop, LaunchError if a program has ended."""
        if self._asked_to_stop():
            raise StopRequest
        for child in self._children:
            if (status := child.ended) is not None:
                raise LaunchError(f"The {child.name} ended at once {_how(status)}; its log says:\n{child.last_lines()}")

    def _revive(self, child: Child, status: int) -> None:
        now_s = time.monotonic()
        self._deaths.append(now_s)
        while now_s - self._deaths[0] > _DEATHS_WINDOW_S:
            self._deaths.popleft()
        if len(self._deaths) > _DEATHS_ALLOWED:
            raise LaunchError(
                f"The {child.name} ends again and again {_how(status)}; its log says:\n{child.last_lines()}"
            )
        self._say(f"The {child.name} ended {_how(status)}: starting it again.")
        child.start()
        if child.name == "board":
            # A restarted board has no plan and its autopilot is off. The gateway reopens the line by itself, unless it
            # was closed in the page: then the commands fail, which is shown but does not end the run.
            try:
                self._close_loop()
            except LaunchError as error:
                self._say(str(error))


def _has_heartbeat(status: Status) -> bool:
    return status["board"]["heartbeat_age_s"] is not None


def _loop_is_closed(status: Status) -> bool:
    return status["simulator"]["hil_round_trip_ms"]["newest"] is not None


def _how(status: int) -> str:
    return f"by signal {-status}" if status < 0 else f"with status {status}"
