"""What goes wrong in the embedded simulator by order. With X-Plane, or with a real aircraft, all of it is refused."""

from __future__ import annotations

from fastapi import APIRouter, status

from epf_gcs.contract.requests import BeginFault, EndFault, SetWind
from epf_gcs.contract.simulator_faults import FaultState, SimulatedFaults
from epf_gcs.web.interface.deps import AskerDep, StatusDep, VehicleDep
from epf_gcs.web.interface.faults.schemas import CHOICES, FaultInput, FaultTable, WindInput
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/faults", tags=["faults"])


@router.get("", responses=reading_problems())
async def get_faults(state: StatusDep) -> FaultTable:
    """The faults that can be asked for, and those that are flown."""
    return FaultTable(choices=CHOICES, flown=state.build().simulator.faults)


@router.post("", status_code=status.HTTP_201_CREATED, responses=problems(409))
async def post_fault(body: FaultInput, vehicle: VehicleDep, asker: AskerDep) -> FaultState:
    """Let something go wrong. Everybody sees that it was asked for."""
    return await vehicle.ask(BeginFault(**body.model_dump()), asker)


@router.delete("", responses=problems(409))
async def delete_faults(vehicle: VehicleDep, asker: AskerDep) -> SimulatedFaults:
    """End all faults; the wind stays."""
    return await vehicle.ask(EndFault(), asker)


@router.delete("/{fault_id}", responses=problems(404, 409))
async def delete_fault(fault_id: str, vehicle: VehicleDep, asker: AskerDep) -> SimulatedFaults:
    """End a fault, or let one not begin that waits."""
    return await vehicle.ask(EndFault(fault_id), asker)


@router.put("/wind", responses=problems(409))
async def put_wind(body: WindInput, vehicle: VehicleDep, asker: AskerDep) -> SimulatedFaults:
    """Steady wind and turbulence from now on."""
    return await vehicle.ask(SetWind(**body.model_dump()), asker)
