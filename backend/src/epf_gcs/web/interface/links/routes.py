"""The two links and the serial ports to choose from."""

from __future__ import annotations

from fastapi import APIRouter, status

from epf_gcs.web.interface.deps import OperatorDep, VehicleDep
from epf_gcs.web.interface.links.schemas import BoardLink, LinkResult, Ports, SimulatorLink
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(tags=["links"])


@router.get("/ports", responses=reading_problems(409))
async def get_ports(vehicle: VehicleDep) -> Ports:
    """The serial ports of the machine that the gateway runs on."""
    return Ports.model_validate({"ports": await vehicle.request("lines.ports")})


@router.put("/links/board", responses=problems(409))
async def put_board(body: BoardLink, vehicle: VehicleDep, operator: OperatorDep) -> LinkResult:
    """Open the board's link; it is reopened by itself until it is closed here."""
    return LinkResult.model_validate(await vehicle.request("lines.open_board", operator, url=body.url))


@router.delete("/links/board", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_board(vehicle: VehicleDep, operator: OperatorDep) -> None:
    """Leave the board quiet and close its link."""
    await vehicle.request("lines.close_board", operator)


@router.put("/links/simulator", responses=problems(409))
async def put_simulator(body: SimulatorLink, vehicle: VehicleDep, operator: OperatorDep) -> LinkResult:
    """Listen to the simulator."""
    return LinkResult.model_validate(await vehicle.request("lines.open_simulator", operator, **body.model_dump()))


@router.delete("/links/simulator", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_simulator(vehicle: VehicleDep, operator: OperatorDep) -> None:
    """Hand the simulator its controls back and close the port."""
    await vehicle.request("lines.close_simulator", operator)
