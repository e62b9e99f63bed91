"""Requests to the board: commands, the console and the AHRS test."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from epf_gcs.bus.definition import Asker
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.errors import ConflictError
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.flight.requests.client_names import Table
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Outlet


def command_requests(
    board: Board,
    commands: Commands,
    parameters: Parameters,
    ahrs_test: AhrsTestRun,
    outlet: Outlet,
    hil: Hil,
) -> Table:
    """command {name, arguments}, console {text}, ahrs_test.start, ahrs_test.stop. Arguments are checked already."""

    async def command(by: Asker, arguments: dict[str, Any]) -> dict[str, Any]:
        wanted = COMMANDS[arguments["name"]]
        values = tuple(arguments["arguments"])
        if wanted.name == "autopilot_on":
            hil.check_profile()
        if wanted.parameter:
            return asdict(await parameters.set_by_command(wanted, values[0], by.client))
        return asdict(await commands.run(wanted.name, values, client=by.client))

    async def console(by: Asker, arguments: dict[str, Any]) -> None:
        text = str(arguments["text"])
        board.check_commandable()
        if not board.write(text.encode("ascii") + b"\n"):
            raise ConflictError(
                "board_not_open", "The line was not sent because no board is connected: open the board's link first."
            )
        outlet.event("console", {"direction": "sent", "text": text, "client": by.client})

    async def start_test(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return asdict(await ahrs_test.start())

    async def stop_test(_: Asker, __: dict[str, Any]) -> dict[str, Any]:
        return asdict(await ahrs_test.stop())

    return {"command": command, "console": console, "ahrs_test.start": start_test, "ahrs_test.stop": stop_test}
