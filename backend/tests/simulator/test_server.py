"""The simulator's socket, in this process: a station on the loopback, a clock that is the real one."""

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from epf_gcs.contract.simulator_faults import MAGIC
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.server import Pace, Server
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from epf_gcs.xplane.datagram import Surfaces, parse, surfaces_datagram
from tests.support.waiting import DEADLINE_S

LOOPBACK = "127.0.0.1"
COMMAND = surfaces_datagram(Surfaces(-0.16, 0.03, 0.0, 0.71))


class Station:
    """The other end, and the thread the simulator runs in."""

    def __init__(self, options: SimulationOptions, pace: Pace) -> None:
        self.socket = udp_socket()
        self.socket.settimeout(DEADLINE_S)
        self._simulator = udp_socket()
        self._simulator.setblocking(False)
        self.simulation = Simulation(options, print)
        self._stop = False
        self.server = Server(self.simulation, self._simulator, self.socket.getsockname(), pace, lambda: self._stop)
        self._thread = threading.Thread(target=self.server.run)
        self._thread.start()

    def receive(self) -> bytes:
        """The next rows; what it says of its faults is left out."""
        while (datagram := self.socket.recv(4096)).startswith(MAGIC):
            pass
        return datagram

    def send(self, datagram: bytes) -> None:
        self.socket.sendto(datagram, self._simulator.getsockname())

    def answer(self) -> bytes:
        """Take a frame and command something."""
        datagram = self.receive()
        assert COMMAND is not None
        self.send(COMMAND)
        return datagram

    def wait_for_the_end(self) -> None:
        self._thread.join(DEADLINE_S)
        assert not self._thread.is_alive()

    def stop(self) -> None:
        self._stop = True
        self.wait_for_the_end()
        self.socket.close()
        self._simulator.close()


def udp_socket() -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind((LOOPBACK, 0))
    return sock


@contextmanager
def station(options: SimulationOptions | None = None, **pace: float | bool | None) -> Iterator[Station]:
    options = options or SimulationOptions()
    one = Station(options, Pace(1.0 / options.rate_hz, **pace))  # type: ignore[arg-type]
    try:
        yield one
    finally:
        one.stop()


def in_lockstep(frames: int) -> list[bytes]:
    with station(lockstep=True) as there:
        return [there.answer() for _ in range(frames)]


def test_in_lockstep_the_same_answers_give_the_same_bytes() -> None:
    assert in_lockstep(200) == in_lockstep(200)


def test_in_lockstep_nothing_moves_until_a_command_comes() -> None:
    with station(lockstep=True) as there:
        first = there.receive()
        there.send(b"X")
        there.send(b"DATA\0" + bytes(36))
        # Neither damage nor a row that commands nothing is an answer: the same rows come again.
        assert there.receive() == first
        assert there.simulation.time_s == pytest.approx(0.02)
        assert COMMAND is not None
        there.send(COMMAND)
        assert there.receive() != first


def test_in_lockstep_delay_and_loss_do_not_stop_the_flight() -> None:
    bad = SimulationOptions(link=LinkQuality(delay_ms=100.0, jitter_ms=20.0, loss=0.2))
    with station(bad, lockstep=True, duration_s=10.0) as there:
        there.socket.settimeout(0.2)
        answered = 0
        while there.simulation.time_s < 10.0:
            try:
                there.answer()
                answered += 1
            except TimeoutError:
                continue
        there.wait_for_the_end()
        assert 300 < answered < 500


def test_in_real_time_frames_come_without_being_asked_for_and_commands_move_the_aircraft() -> None:
    with station(speed_up=10.0, duration_s=20.0) as there:
        rows = [there.receive() for _ in range(20)]
        assert len(set(rows)) == 20
        full = surfaces_datagram(Surfaces(0.5, 0.0, 0.0, 1.0))
        assert full is not None
        there.send(full)
        shown = 0.0
        while shown < 0.45:
            records = {record.row: record.values for record in parse(there.receive()) or []}
            shown = records[11][0]
        there.wait_for_the_end()
        assert there.simulation.time_s == pytest.approx(20.0, abs=0.03)
        assert there.server.datagrams_sent == pytest.approx(1000, abs=2)


class EndlessFlood(socket.socket):
    """However much is taken from it, there is always more."""

    taken = 0

    def recv(self, *_: int) -> bytes:
        self.taken += 1
        return b"DATA rubbish"


def test_a_flood_of_datagrams_does_not_stop_the_flight() -> None:
    simulation = Simulation(SimulationOptions(), print)
    with EndlessFlood(socket.AF_INET, socket.SOCK_DGRAM) as flooded, udp_socket() as there:
        flooded.bind((LOOPBACK, 0))
        there.sendto(b"the first drop", flooded.getsockname())
        pace = Pace(0.02, speed_up=50.0, duration_s=5.0)
        server = Server(simulation, flooded, there.getsockname(), pace, lambda: False)
        flight = threading.Thread(target=server.run, daemon=True)
        flight.start()
        flight.join(DEADLINE_S)
        assert not flight.is_alive()
        assert simulation.time_s == pytest.approx(5.0)
        assert simulation.inputs.counts.bad_datagrams == flooded.taken > 1000
