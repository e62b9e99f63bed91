"""What a worker program tells of its work: JSON objects, a line each, on its standard output.

{"done": {...}} is the last one of a work that succeeded, {"fault": {"code", "detail", "params"}} of one that failed;
the others say how far it is.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, TypeVar

import msgspec
import orjson

from epf_gcs.errors import ErrorCode, GatewayError

if TYPE_CHECKING:
    import asyncio


class ToldFault(msgspec.Struct):
    """Why a work failed, as `GatewayError.as_dict` has it."""

    code: ErrorCode
    detail: str
    params: dict[str, str | int | float | bool | None]

    @staticmethod
    def of(error: GatewayError) -> ToldFault:
        """Of an error."""
        return ToldFault(error.code, error.detail, dict(error.params))


class WorkerLine(msgspec.Struct):
    """What every line may be; each kind of work adds what it tells."""

    fault: ToldFault | None = None


L = TypeVar("L", bound=WorkerLine)


def tell(message: Mapping[str, object]) -> None:
    """Write one line of this program's."""
    sys.stdout.buffer.write(orjson.dumps(message, option=orjson.OPT_SERIALIZE_NUMPY) + b"\n")
    sys.stdout.buffer.flush()


def tell_fault(fault: GatewayError) -> None:
    """Write the line of a work that failed."""
    tell({"fault": fault.as_dict()})


async def hear_lines(
    process: asyncio.subprocess.Process,
    line: type[L],
    hear: Callable[[L], None],
    error: type[GatewayError] = GatewayError,
) -> GatewayError | None:
    """Give each line to `hear` until the program closes its output; the fault that it told, if it told one."""
    fault = None
    if process.stdout is not None:
        async for text in process.stdout:
            message = msgspec.json.decode(text, type=line)
            if message.fault is None:
                hear(message)
            else:
                fault = error(message.fault.code, message.fault.detail, **message.fault.params)
    return fault
