"""The two links and the serial ports to choose from."""

from __future__ import annotations

import asyncio

from fastapi import APIRouter, status

from epf_gcs.flight.hil.simulator import SimulatorAddress
from epf_gcs.link.address import LinkAddress, parse_address
from epf_gcs.link.ports import list_serial_ports
from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.schemas import BoardLink, LinkResult, Ports, PortState, SimulatorLink

router = APIRouter(tags=["links"])


@router.get("/ports", responses=reading_problems())
async def get_ports() -> Ports:
    """The serial ports of the machine that the gateway runs on."""
    found = await asyncio.to_thread(list_serial_ports)
    return Ports(
        ports=[
            PortState(
                path=port.path,
                url=LinkAddress("serial", port.path).url,
                description=port.description,
                identity=port.identity,
            )
            for port in found
        ]
    )


@router.put("/links/board", responses=problems(409))
async def put_board(body: BoardLink, station: StationDep, _: OperatorDep) -> LinkResult:
    """Open the board's link; it is reopened by itself until it is closed here."""
    address = parse_address(body.url)
    await station.open_board(address)
    return LinkResult(state=station.supervisor.state, url=address.url)


@router.delete("/links/board", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_board(station: StationDep, _: OperatorDep) -> None:
    """Leave the board quiet and close its link."""
    await station.close_board()


@router.put("/links/simulator", responses=problems(409))
async def put_simulator(body: SimulatorLink, station: StationDep, _: OperatorDep) -> LinkResult:
    """Listen to the simulator."""
    await station.open_simulator(SimulatorAddress(body.receive_port, body.send_host, body.send_port, body.profile))
    return LinkResult(state=station.simulator.state, url=f"udp://{body.send_host}:{body.send_port}")


@router.delete("/links/simulator", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_simulator(station: StationDep, _: OperatorDep) -> None:
    """Hand the simulator its controls back and close the port."""
    await station.close_simulator()
