"""Requests about the gains and the plans that the board holds."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handler, Handlers
from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.answers import CommandOutcome, ParameterJournal
from epf_gcs.contract.own_gains import AllGains
from epf_gcs.contract.requests import (
    LoadParameters,
    ReadJournal,
    ReadParameters,
    ReadPlan,
    RedoParameters,
    Request,
    SetParameters,
    StoreParameters,
    UndoParameters,
    WritePlan,
)
from epf_gcs.flight.board.missions import Missions
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.vehicle.parameters import gain_state


def parameter_requests(parameters: Parameters) -> Handlers:
    """All that change gains answer with what is known of them then."""

    def held() -> AllGains:
        return AllGains({name: gain_state(name, one) for name, one in parameters.held.items()}, parameters.own.known)

    def then_held(do: Callable[[str | None], Awaitable[None]]) -> Handler:
        async def answer(_: Request[Any], by: Asker) -> AllGains:
            await do(by.client)
            return held()

        return answer

    async def read(_: ReadParameters, __: Asker) -> AllGains:
        return held()

    async def write(request: SetParameters, by: Asker) -> AllGains:
        await parameters.set(dict(request.values), by.client)
        return held()

    async def store(_: StoreParameters, by: Asker) -> CommandOutcome:
        return await parameters.store(by.client)

    async def read_journal(_: ReadJournal, __: Asker) -> ParameterJournal:
        kept = parameters.journal
        return ParameterJournal(list(kept.entries), kept.steps.undo, kept.steps.redo)

    return {
        ReadParameters: read,
        LoadParameters: then_held(parameters.load),
        SetParameters: write,
        UndoParameters: then_held(parameters.undo),
        RedoParameters: then_held(parameters.redo),
        StoreParameters: store,
        ReadJournal: read_journal,
    }


def mission_requests(missions: Missions) -> Handlers:
    """Both answer with the waypoints that the board has."""

    async def read(request: ReadPlan, _: Asker) -> list[Waypoint]:
        return list(await missions.read(request.plan))

    async def write(request: WritePlan, by: Asker) -> list[Waypoint]:
        return list(await missions.write(request.plan, request.waypoints, by.client))

    return {ReadPlan: read, WritePlan: write}
