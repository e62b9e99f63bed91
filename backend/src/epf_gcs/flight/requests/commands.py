"""Requests to the board: commands, the console and the AHRS test."""

from __future__ import annotations

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handlers
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.contract.events import ConsoleEvent
from epf_gcs.contract.requests import RunCommand, SendLine, StartAhrsTest, StopAhrsTest
from epf_gcs.errors import ConflictError
from epf_gcs.flight.board.ahrs_test import AhrsTestRun
from epf_gcs.flight.board.commands import Commands
from epf_gcs.flight.board.parameters import Parameters
from epf_gcs.flight.hil.hil import Hil
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Outlet


def command_requests(
    board: Board,
    commands: Commands,
    parameters: Parameters,
    ahrs_test: AhrsTestRun,
    outlet: Outlet,
    hil: Hil,
) -> Handlers:
    """The arguments of a command are checked already."""

    async def run(request: RunCommand, by: Asker) -> CommandOutcome:
        command = COMMANDS[request.name]
        values = tuple(request.arguments)
        if command.name == "autopilot_on":
            hil.check_profile()
        if command.parameter:
            return await parameters.set_by_command(command, values[0], by.client)
        return await commands.run(command.name, values, client=by.client)

    async def send_line(request: SendLine, by: Asker) -> None:
        board.check_commandable()
        if not board.write(request.text.encode("ascii") + b"\n"):
            raise ConflictError(
                "board_not_open", "The line was not sent because no board is connected: open the board's link first."
            )
        outlet.event(ConsoleEvent("sent", request.text, by.client))

    async def start_test(_: StartAhrsTest, __: Asker) -> CommandOutcome:
        return await ahrs_test.start()

    async def stop_test(_: StopAhrsTest, __: Asker) -> CommandOutcome:
        return await ahrs_test.stop()

    return {RunCommand: run, SendLine: send_line, StartAhrsTest: start_test, StopAhrsTest: stop_test}
