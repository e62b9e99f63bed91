"""Commands to the board, the HIL switches and the console."""

from __future__ import annotations

from dataclasses import asdict
from typing import Final

from fastapi import APIRouter

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Message
from epf_gcs.errors import BoardError, ConflictError, InvalidInputError, NotFoundError
from epf_gcs.flight.station import Station
from epf_gcs.flight.status import hil_state
from epf_gcs.vehicle.arguments import ArgumentFault, read_arguments
from epf_gcs.web.deps import OperatorDep, StationDep
from epf_gcs.web.problems import problems, reading_problems
from epf_gcs.web.schemas import (
    Argument,
    CommandInfo,
    CommandList,
    CommandOutcome,
    CommandValue,
    ConsoleLine,
    HilInput,
    HilState,
)

router = APIRouter(tags=["commands"])

# These are steps of something that has a place of its own: the link's dialogue, the HIL loop, the plans.
_INTERNAL: Final = frozenset(
    {
        "xplane_info",
        "capabilities",
        "exit_binary_mode",
        "mission_begin",
        "mission_item",
        "mission_commit",
        "mission_read",
    }
)
OFFERED: Final = {name: command for name, command in COMMANDS.items() if name not in _INTERNAL}


@router.get("/commands", responses=reading_problems())
async def get_commands(station: StationDep) -> CommandList:
    """All commands with their arguments and ranges."""
    return CommandList(commands=[_info(command, station) for command in OFFERED.values()])


@router.post("/commands/{name}", responses=problems(404, 409))
async def post_command(
    name: str, station: StationDep, operator: OperatorDep, body: CommandValue | None = None
) -> CommandOutcome:
    """Send a command and answer what became of it."""
    command = OFFERED.get(name)
    if command is None:
        raise NotFoundError(
            "command_unknown", f"There is no command '{name}': GET /api/v1/commands lists all of them.", command=name
        )
    try:
        arguments = read_arguments(command, body.value if body is not None else None)
    except ArgumentFault as fault:
        raise InvalidInputError("value_not_allowed", fault.sentence, command=name, field=fault.field) from fault
    if command.parameter:
        result = await station.parameters.set_by_command(command, arguments[0], operator)
    else:
        result = await station.commands.run(name, arguments, client=operator)
    return CommandOutcome.model_validate(asdict(result))


@router.get("/hil", responses=reading_problems())
async def get_hil(station: StationDep) -> HilState:
    """The two switches, and where the stick comes from."""
    return HilState.model_validate(hil_state(station))


@router.put("/hil", responses=problems(409, 502))
async def put_hil(body: HilInput, station: StationDep, operator: OperatorDep) -> HilState:
    """Set any of the switches; the source is the board's and is confirmed by it.

    A gamepad is that of the caller, who needs control and sends its samples on the stream before it is taken.
    """
    if body.stick != "simulator" or body.source is not None or body.path is not None:
        station.board.check_commandable()
    if body.source is not None and body.source != station.hil.source:
        result = await station.commands.run("control_source", (int(body.source == "joystick"),), client=operator)
        if not result.done:
            raise BoardError(
                "source_not_taken",
                f"The control source is still {station.hil.source}: the board did not take the change "
                f"({result.reason or result.state}); try again.",
                reason=result.reason or result.state,
            )
    if body.path is not None:
        station.set_path(body.path)
    if body.stick is not None:
        await station.set_stick(body.stick, operator, body.gamepad)
    return HilState.model_validate(hil_state(station) | ({"source": body.source} if body.source else {}))


@router.post("/console", responses=problems(409))
async def post_console(body: ConsoleLine, station: StationDep, operator: OperatorDep) -> ConsoleLine:
    """Send a line of text to the board; what comes back is on the stream as `console` events."""
    station.board.check_commandable()
    if not station.board.write(body.text.encode("ascii") + b"\n"):
        raise ConflictError(
            "board_not_open", "The line was not sent because no board is connected: open the board's link first."
        )
    station.hub.event("console", {"direction": "sent", "text": body.text, "client": operator})
    return body


def _info(command: Message, station: Station) -> CommandInfo:
    session = station.board.session
    return CommandInfo(
        name=command.name,
        id=command.id,
        doc=command.doc,
        extension=command.extension,
        supported=None if not station.board.is_open else session.is_extended or not command.extension,
        arguments=[
            Argument(
                name=value.name,
                unit=value.unit,
                minimum=value.minimum,
                maximum=value.maximum,
                default=value.default,
                is_integer=value.kind == "integer",
                names=dict(value.names),
                doc=value.doc,
            )
            for value in command.values
        ],
    )
