"""The simulator's socket: X-Plane's UDP, in real time or in lock-step with the station."""

import select
import socket
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from epf_gcs.contract.simulator_faults import MAGIC, FaultOrder, read_datagram
from epf_gcs.contract.simulator_faults import datagram as fault_datagram
from epf_gcs.simulator.clock import Schedule
from epf_gcs.simulator.simulation import Simulation

Address = tuple[str, int]

# More than any valid datagram; a longer one is cut by the system and then refused as damaged.
_LONGEST_DATAGRAM: Final = 4096
# Most datagrams taken before checking whether the next frame is due, so that a flood does not stop the simulation.
_AT_ONCE: Final = 64
# Lock-step: without an answer for this long the rows are sent again, because rows or answer may have been lost.
_ANSWER_TIMEOUT_S: Final = 1.0
# How often the station hears what goes wrong here, and so that faults may be ordered. X-Plane says nothing of the kind,
# and is sent no orders.
_REPORT_EVERY_S: Final = 0.5
# Longest sleep of the loop between checks whether it is asked to stop.
_LONGEST_WAIT_S: Final = 0.2


@dataclass(frozen=True, slots=True)
class Pace:
    """How simulated time passes. `duration_s`: when to stop, None: never."""

    period_s: float  # of a frame, simulated
    speed_up: float = 1.0
    lockstep: bool = False
    duration_s: float | None = None


class Server:
    """Runs a simulation on an open UDP socket until its duration is over or `asked_to_stop` says so."""

    def __init__(
        self,
        simulation: Simulation,
        sock: socket.socket,
        station: Address,
        pace: Pace,
        asked_to_stop: Callable[[], bool],
    ) -> None:
        self._simulation = simulation
        self._socket = sock
        self._station = station
        self._pace = pace
        self._asked_to_stop = asked_to_stop
        self._marks: tuple[tuple[str, bool], ...] = ()
        self._report_due_s = 0.0
        self.datagrams_sent = 0
        self.send_failures = 0
        self.stalls = 0

    def run(self) -> None:
        """Run the simulation until its end."""
        if self._pace.lockstep:
            self._run_in_lockstep()
        else:
            self._run_in_real_time()

    def _over(self) -> bool:
        duration_s = self._pace.duration_s
        return self._asked_to_stop() or (duration_s is not None and self._simulation.time_s >= duration_s)

    def _run_in_real_time(self) -> None:
        simulation, speed_up = self._simulation, self._pace.speed_up
        frame_s = time.monotonic()
        schedule = Schedule(self._pace.period_s / speed_up, frame_s)
        while not self._over():
            now_s = time.monotonic()
            if now_s >= schedule.due_s:
                self._advance()
                frame_s = now_s
                schedule.done(time.monotonic())
                self.stalls = schedule.shifts
            # Delayed datagrams are sent when they are due, not only at the next frame.
            self._send(simulation.arrived(simulation.time_s + (now_s - frame_s) * speed_up))
            wake_s = schedule.due_s
            if (due_s := simulation.next_due_s) is not None:
                wake_s = min(wake_s, frame_s + (due_s - simulation.time_s) / speed_up)
            self._receive(wake_s - time.monotonic())

    def _run_in_lockstep(self) -> None:
        simulation = self._simulation
        while not self._over():
            self._advance()
            frame = simulation.arrived(simulation.time_s)
            self._send(frame)
            # If delay or loss let nothing through, the station has nothing to answer: do not wait.
            answered = not frame
            deadline_s = time.monotonic() + _ANSWER_TIMEOUT_S
            while not answered and not self._asked_to_stop():
                answered = self._receive(deadline_s - time.monotonic()) > 0
                if not answered and time.monotonic() >= deadline_s:
                    self._send(frame)
                    deadline_s = time.monotonic() + _ANSWER_TIMEOUT_S

    def _advance(self) -> None:
        """One frame; what begins or ends in it is reported."""
        simulation = self._simulation
        simulation.advance()
        simulation.send()
        if (marks := simulation.faults.marks(simulation.time_s)) != self._marks:
            self._marks = marks
            self._report()

    def _obey(self, datagram: bytes) -> None:
        order = read_datagram(datagram, FaultOrder)
        if order is None:
            self._simulation.inputs.counts.bad_datagrams += 1
            return
        self._simulation.obey(order)
        self._report()

    def _report(self) -> None:
        self._report_due_s = time.monotonic() + _REPORT_EVERY_S
        self._send_one(fault_datagram(self._simulation.faults.report(self._simulation.time_s)))

    def _send(self, datagrams: list[bytes]) -> None:
        for datagram in datagrams:
            self.datagrams_sent += self._send_one(datagram)

    def _send_one(self, datagram: bytes) -> bool:
        try:
            self._socket.sendto(datagram, self._station)
        except OSError:
            # Nobody listens yet, or there is no network: count it and go on, as X-Plane does.
            self.send_failures += 1
            return False
        return True

    def _receive(self, timeout_s: float) -> int:
        """Wait for datagrams up to `timeout_s`; returns how many commands were among those taken."""
        if time.monotonic() >= self._report_due_s:
            self._report()
        wait_s = min(max(timeout_s, 0.0), _LONGEST_WAIT_S)
        ready, _, _ = select.select([self._socket], [], [], wait_s)
        commands = 0
        for _ in range(_AT_ONCE if ready else 0):
            try:
                datagram = self._socket.recv(_LONGEST_DATAGRAM)
            except BlockingIOError:
                break
            except OSError:
                # An ICMP error for a datagram that we sent: the station does not listen.
                self.send_failures += 1
                continue
            if datagram.startswith(MAGIC):
                self._obey(datagram)
            else:
                commands += self._simulation.receive(datagram)
        return commands
