"""What a worker program tells of its work: JSON objects, a line each, on its standard output.

{"done": {...}} is the last one of a work that succeeded, {"fault": {"code", "detail", "params"}} of one that failed;
the others say how far it is.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import orjson

from epf_gcs.errors import GatewayError

if TYPE_CHECKING:
    import asyncio


def tell(message: Mapping[str, object]) -> None:
    """Write one line of this program's."""
    sys.stdout.buffer.write(orjson.dumps(message, option=orjson.OPT_SERIALIZE_NUMPY) + b"\n")
    sys.stdout.buffer.flush()


def tell_fault(fault: GatewayError) -> None:
    """Write the line of a work that failed."""
    tell({"fault": fault.as_dict()})


async def hear_lines(
    process: asyncio.subprocess.Process,
    hear: Callable[[dict[str, Any]], None],
    kind: type[GatewayError] = GatewayError,
) -> GatewayError | None:
    """Give each line to `hear` until the program closes its output; the fault that it told, if it told one."""
    fault = None
    if process.stdout is not None:
        async for line in process.stdout:
            message = orjson.loads(line)
            if "fault" in message:
                told = message["fault"]
                fault = kind(told["code"], told["detail"], **told["params"])
            else:
                hear(message)
    return fault
