"""Commands to the board, the HIL switches and the console."""

from __future__ import annotations

from typing import Final

from fastapi import APIRouter

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Message
from epf_gcs.contract.answers import CommandOutcome
from epf_gcs.contract.requests import ReadHil, RunCommand, SendLine, SetHil
from epf_gcs.contract.status import HilState
from epf_gcs.errors import InvalidInputError, NotFoundError
from epf_gcs.web.interface.commands.arguments import ArgumentFault, read_arguments
from epf_gcs.web.interface.commands.schemas import (
    Argument,
    CommandInfo,
    CommandList,
    CommandValue,
    ConsoleLine,
    HilInput,
)
from epf_gcs.web.interface.deps import MirrorDep, OperatorDep, VehicleDep
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(tags=["commands"])

# These are steps of something that has a place of its own: the link's dialogue, the HIL loop, the plans, the
# board's own gains.
_INTERNAL: Final = frozenset(
    {
        "xplane_info",
        "capabilities",
        "exit_binary_mode",
        "mission_begin",
        "mission_item",
        "mission_commit",
        "mission_read",
        "hil_steps_on",
        "describe",
        "describe_blocks",
        "own_gain_get",
        "own_gain_set",
    }
)
OFFERED: Final = {name: command for name, command in COMMANDS.items() if name not in _INTERNAL}


@router.get("/commands", responses=reading_problems())
async def get_commands(mirror: MirrorDep) -> CommandList:
    """All commands with their arguments and ranges."""
    board = mirror.status.board
    mode = board.mode if board.state == "open" else None
    return CommandList(commands=[_info(command, mode) for command in OFFERED.values()])


@router.post("/commands/{name}", responses=problems(404, 409))
async def post_command(
    name: str, vehicle: VehicleDep, operator: OperatorDep, body: CommandValue | None = None
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
    return await vehicle.ask(RunCommand(name, list(arguments)), operator)


@router.get("/hil", responses=reading_problems(409))
async def get_hil(vehicle: VehicleDep) -> HilState:
    """The two switches, and where the stick comes from."""
    return await vehicle.ask(ReadHil())


@router.put("/hil", responses=problems(409, 502))
async def put_hil(body: HilInput, vehicle: VehicleDep, operator: OperatorDep) -> HilState:
    """Set any of the switches; the source is the board's and is confirmed by it.

    A gamepad is that of the caller, who needs control and sends its samples on the stream before it is taken.
    """
    return await vehicle.ask(SetHil(**body.model_dump()), operator)


@router.post("/console", responses=problems(409))
async def post_console(body: ConsoleLine, vehicle: VehicleDep, operator: OperatorDep) -> ConsoleLine:
    """Send a line of text to the board; what comes back is on the stream as `console` events."""
    await vehicle.ask(SendLine(body.text), operator)
    return body


def _info(command: Message, mode: str | None) -> CommandInfo:
    return CommandInfo(
        name=command.name,
        id=command.id,
        doc=command.doc,
        extension=command.extension,
        supported=None if mode is None else mode == "extended" or not command.extension,
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
