"""The embedded simulator in a thread of the test's process, in real time, sending to a station on the loopback."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from epf_gcs.simulator.server import Pace, Server
from epf_gcs.simulator.simulation import Simulation, SimulationOptions
from tests.support.waiting import DEADLINE_S

LOOPBACK = "127.0.0.1"


@contextmanager
def embedded_simulator(station_port: int) -> Iterator[int]:
    """The port at which it takes the surfaces."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind((LOOPBACK, 0))
        sock.setblocking(False)
        stop = threading.Event()
        server = Server(Simulation(SimulationOptions(), print), sock, (LOOPBACK, station_port), Pace(0.02), stop.is_set)
        thread = threading.Thread(target=server.run, daemon=True)
        thread.start()
        try:
            yield int(sock.getsockname()[1])
        finally:
            stop.set()
            thread.join(DEADLINE_S)
            assert not thread.is_alive()
