"""X-Plane is told to send its rows: the loop closes without a click in it."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

from epf_gcs.flight.flight import Flight
from epf_gcs.flight.hil import simulator
from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.xplane.datagram import parse
from epf_gcs.xplane.output import output_datagrams
from tests.support.ports import free_udp_port
from tests.support.waiting import eventually_async
from tests.support.x_plane import XPlane

pytestmark = pytest.mark.anyio


@pytest.mark.parametrize(("version", "profile"), [(104103, "xp10"), (115502, "xp10"), (120012, "xp12")])
async def test_an_x_plane_in_which_nothing_is_ticked_sends_all_that_the_station_reads(
    tmp_path: Path, version: int, profile: str
) -> None:
    station = Flight(tmp_path / "data", record=False)
    with XPlane(version) as x_plane:
        async with station.running():
            port = free_udp_port()
            await station.lines.open_simulator(
                SimulatorAddress(port, "127.0.0.1", x_plane.port, profile, tells_rows=True)  # type: ignore[arg-type]
            )

            def is_open() -> bool:
                x_plane.turn()
                return station.simulator.state == "open" and not station.hil.missing_rows

            await eventually_async(is_open, "its rows")
            assert x_plane.target == ("127.0.0.1", port)
            assert x_plane.rows == [3, 4, 6, 8, 11, 16, 17, 18, 20, 25]
            assert x_plane.values == {"sim/network/dataout/network_data_rate": 50.0}

            x_plane.target, x_plane.rows = None, []
            await eventually_async(lambda: station.simulator.state == "lost", "it was started anew")
            await eventually_async(is_open, "its rows again")
            await station.lines.close_simulator()
        x_plane.turn()
        assert parse(x_plane.datagrams[-1]) is not None, "the last word gives the controls back"


async def test_it_is_told_again_after_a_turn_that_failed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    faults = [ZeroDivisionError]

    def faulty(host: str, port: int, rows: Iterable[int]) -> list[bytes]:
        if faults:
            raise faults.pop()
        return output_datagrams(host, port, rows)

    monkeypatch.setattr(simulator, "output_datagrams", faulty)
    station = Flight(tmp_path / "data", record=False)
    with XPlane(120012) as x_plane:
        async with station.running():
            address = SimulatorAddress(free_udp_port(), "127.0.0.1", x_plane.port, "xp12", tells_rows=True)
            await station.lines.open_simulator(address)

            def is_told() -> bool:
                x_plane.turn()
                return bool(x_plane.rows)

            await eventually_async(is_told, "its rows")
    assert not faults


async def test_an_x_plane_that_its_user_has_set_up_is_told_nothing(tmp_path: Path) -> None:
    station = Flight(tmp_path / "data", record=False)
    with XPlane(120012) as x_plane:
        async with station.running():
            await station.lines.open_simulator(SimulatorAddress(free_udp_port(), "127.0.0.1", x_plane.port, "xp12"))
            await station.lines.close_simulator()
        x_plane.turn()
        assert [parse(datagram) is None for datagram in x_plane.datagrams] == [False]
