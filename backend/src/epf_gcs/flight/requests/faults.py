"""Requests about what goes wrong in the embedded simulator, and its wind."""

from __future__ import annotations

from dataclasses import asdict

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.contract.requests import BeginFault, EndFault, SetWind
from epf_gcs.contract.simulator_faults import KINDS, Fault, FaultError, FaultState, SimulatedFaults, WindState
from epf_gcs.errors import InvalidInputError
from epf_gcs.flight.hil.simulator_faults import SimulatorFaultControl


def fault_requests(faults: SimulatorFaultControl) -> Handlers:
    """Begin and end faults, and set the wind."""

    async def begin(request: BeginFault, _: Asker) -> FaultState:
        return await faults.begin(_fault(request))

    async def end(request: EndFault, _: Asker) -> SimulatedFaults:
        return await faults.end(request.id)

    async def blow(request: SetWind, _: Asker) -> SimulatedFaults:
        return await faults.blow(WindState(**asdict(request)))

    return {BeginFault: begin, EndFault: end, SetWind: blow}


def _fault(request: BeginFault) -> Fault:
    try:
        return Fault(**asdict(request))
    except FaultError as error:
        about = KINDS[request.place].get(request.kind)
        raise InvalidInputError(
            "fault_out_of_range",
            f"This fault cannot be as it is asked: {error}.",
            fault=f"{request.place}.{request.kind}",
            lowest=0.0 if about is None else about.lowest,
            highest=0.0 if about is None else about.highest,
            unit="" if about is None else about.unit,
        ) from error
