"""The two links and the serial ports to choose from."""

from __future__ import annotations

from fastapi import APIRouter, status

from epf_gcs.contract.answers import LinkResult
from epf_gcs.contract.requests import CloseBoard, CloseSimulator, OpenBoard, OpenSimulator, ReadPorts
from epf_gcs.web.interface.deps import BeaconsDep, OperatorDep, VehicleDep
from epf_gcs.web.interface.links.schemas import BoardLink, NearbySimulator, NearbySimulators, Ports, SimulatorLink
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(tags=["links"])


@router.get("/ports", responses=reading_problems(409))
async def get_ports(vehicle: VehicleDep) -> Ports:
    """The serial ports of the machine that the gateway runs on."""
    return Ports(ports=await vehicle.ask(ReadPorts()))


@router.get("/simulators", responses=reading_problems())
async def get_simulators(beacons: BeaconsDep) -> NearbySimulators:
    """The X-Planes that say on the network that they are there; listened to while somebody asks every few seconds."""
    return NearbySimulators(
        simulators=[
            NearbySimulator(
                name=found.beacon.name,
                host=found.host,
                port=found.beacon.port,
                version=found.beacon.version_text,
                profile=found.beacon.profile,
            )
            for found in beacons.look()
        ]
    )


@router.put("/links/board", responses=problems(409))
async def put_board(body: BoardLink, vehicle: VehicleDep, operator: OperatorDep) -> LinkResult:
    """Open the board's link; it is reopened by itself until it is closed here."""
    return await vehicle.ask(OpenBoard(body.url), operator)


@router.delete("/links/board", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_board(vehicle: VehicleDep, operator: OperatorDep) -> None:
    """Leave the board quiet and close its link."""
    await vehicle.ask(CloseBoard(), operator)


@router.put("/links/simulator", responses=problems(409))
async def put_simulator(body: SimulatorLink, vehicle: VehicleDep, operator: OperatorDep) -> LinkResult:
    """Listen to the simulator."""
    return await vehicle.ask(OpenSimulator(**body.model_dump()), operator)


@router.delete("/links/simulator", status_code=status.HTTP_204_NO_CONTENT, responses=problems(409))
async def delete_simulator(vehicle: VehicleDep, operator: OperatorDep) -> None:
    """Hand the simulator its controls back and close the port."""
    await vehicle.ask(CloseSimulator(), operator)
