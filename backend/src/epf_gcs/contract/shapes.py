"""What all shapes of the REST interface share. They stop here: inside the gateway are plain values."""

from __future__ import annotations

from typing import Annotated, Any, Final, Literal

from pydantic import BaseModel, ConfigDict, Field

from epf_gcs.errors import ErrorCode

LinkState = Literal["closed", "opening", "open", "lost"]
ParamValue = str | float | bool | None
Port = Annotated[int, Field(ge=1, le=65535)]
PlanName = Literal["flight", "hil"]

Description = dict[str, Any]
"""A piece of the interface's description, as OpenAPI has it."""
Answers = dict[int | str, Description]
"""How a route can answer, by HTTP status."""

FILE: Final[Description] = {"schema": {"type": "string", "format": "binary"}}
"""How the interface's description says that an answer is a file."""


def file_body(**limits: int) -> Description:
    """The same of a request whose body is a file. `limits` as JSON Schema has them, such as maxLength in bytes."""
    schema = {**FILE["schema"], **limits}
    return {"requestBody": {"required": True, "content": {"application/octet-stream": {"schema": schema}}}}


class Output(BaseModel):
    """What we send: every field is always there."""

    model_config = ConfigDict(extra="forbid", json_schema_serialization_defaults_required=True)


class Input(BaseModel):
    """What others send: a misspelt field is an error, not a wish that gets lost."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class Problem(BaseModel):
    """RFC 9457. `code` is stable and translated by the page; `detail` says which, why and what to do."""

    type: str
    title: str
    status: int
    detail: str
    code: ErrorCode
    params: dict[str, ParamValue]
