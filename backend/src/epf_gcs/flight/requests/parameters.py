"""Requests about the gains and the plans that the board holds."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from dataclasses import asdict
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handler
from epf_gcs.codec.tables import Waypoint
from epf_gcs.flight.board.missions import Missions
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.vehicle.journal import moves_as_dicts
from epf_gcs.vehicle.parameters import as_values


def parameter_requests(parameters: Parameters) -> Table:
    """parameters.read, .load, .set {name: value}, .undo and .redo answer {name: {value, loaded, state}}.

    Beside them parameters.store and parameters.journal.
    """

    def held() -> dict[str, dict[str, Any]]:
        return {name: as_values(name, one) for name, one in parameters.held.items()}

    async def read(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return held()

    def then_held(do: Callable[[str | None], Awaitable[None]]) -> Handler:
        async def answer(by: Asker, _: dict[str, Any]) -> dict[str, Any]:
            await do(by.client)
            return held()

        return answer

    async def write(by: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        await parameters.set(arguments, by.client)
        return held()

    async def store(by: Asker, _: dict[str, Any]) -> dict[str, Any]:
        return asdict(await parameters.store(by.client))

    async def journal(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        kept = parameters.journal
        return {
            "entries": [entry.as_dict() for entry in kept.entries],
            "undo": moves_as_dicts(kept.steps.undo),
            "redo": moves_as_dicts(kept.steps.redo),
        }

    return {
        "parameters.read": read,
        "parameters.load": then_held(parameters.load),
        "parameters.set": write,
        "parameters.undo": then_held(parameters.undo),
        "parameters.redo": then_held(parameters.redo),
        "parameters.store": store,
        "parameters.journal": journal,
    }


def mission_requests(missions: Missions) -> Table:
    """missions.read {plan}, missions.write {plan, waypoints}: both answer with the waypoints that the board has."""

    async def read(_: Asker, arguments: dict[str, Any]) -> list[dict[str, Any]]:
        return [asdict(waypoint) for waypoint in await missions.read(arguments["plan"])]

    async def write(by: Asker, arguments: dict[str, Any]) -> list[dict[str, Any]]:
        waypoints = [Waypoint(**waypoint) for waypoint in arguments["waypoints"]]
        return [asdict(waypoint) for waypoint in await missions.write(arguments["plan"], waypoints, by.client)]

    return {"missions.read": read, "missions.write": write}
