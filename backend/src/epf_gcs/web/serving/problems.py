"""One table from error types to problem documents (RFC 9457)."""

from __future__ import annotations

import re
from http import HTTPStatus
from typing import Final

import orjson
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response
from starlette.exceptions import HTTPException

from epf_gcs.contract.shapes import Answers, Problem
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import (
    BoardError,
    ConflictError,
    ErrorCode,
    GatewayError,
    InvalidInputError,
    LinkError,
    NotAdmittedError,
    NotFoundError,
    NotKeptError,
    NotYoursError,
    Params,
    RoleError,
    TooManyError,
    UnavailableError,
)

MEDIA_TYPE: Final = "application/problem+json"

_HTTP_CODES: Final[dict[int, ErrorCode]] = {
    404: "no_such_address",
    405: "method_not_allowed",
    400: "bad_json",
}
# Parts of a validation error's location that are pydantic's own and not names of the request's fields.
_NO_FIELD: Final = re.compile(r"body|query|path|header|float|str|int|list\[.*|dict\[.*")

_STATUS: Final[dict[type[GatewayError], HTTPStatus]] = {
    InvalidInputError: HTTPStatus.UNPROCESSABLE_ENTITY,
    NotFoundError: HTTPStatus.NOT_FOUND,
    ConflictError: HTTPStatus.CONFLICT,
    LinkError: HTTPStatus.CONFLICT,
    BoardError: HTTPStatus.BAD_GATEWAY,
    NotAdmittedError: HTTPStatus.UNAUTHORIZED,
    RoleError: HTTPStatus.FORBIDDEN,
    NotYoursError: HTTPStatus.FORBIDDEN,
    TooManyError: HTTPStatus.TOO_MANY_REQUESTS,
    NotKeptError: HTTPStatus.INSUFFICIENT_STORAGE,
    UnavailableError: HTTPStatus.SERVICE_UNAVAILABLE,
    GatewayError: HTTPStatus.INTERNAL_SERVER_ERROR,
}

_DESCRIPTIONS: Final = {
    400: "The body is not JSON.",
    401: "It needs a key: none, a wrong one or an ended one was shown.",
    403: "The request came from a page or under a name that may not command, or the caller's role is too low.",
    404: "There is no such thing.",
    409: "It cannot be done now: another has control, no link, not supported, or the device cannot be opened.",
    413: "The body is too large.",
    429: "Too much was asked: `Retry-After` says when to come back.",
    422: "A value is missing, misspelt or out of range.",
    503: "The flight process does not answer: whether anything was done is not known.",
    507: "The disk of the station does not take it.",
    502: "The board was asked and refused, or did not answer.",
}


def problems(*statuses: int) -> Answers:
    """Documentation of the problems that a route can answer with."""
    return _described(400, 401, 403, 413, 422, 429, 503, *statuses)


def reading_problems(*statuses: int) -> Answers:
    """The same for a route that only reads."""
    return _described(401, 403, 422, 429, 503, *statuses)


def _described(*statuses: int) -> Answers:
    # By name: FastAPI would make a serializer for each of 900 models, a tenth of what the station's start costs.
    content = {MEDIA_TYPE: {"schema": {"$ref": f"#/components/schemas/{Problem.__name__}"}}}
    return {status: {"description": _DESCRIPTIONS[status], "content": content} for status in statuses}


def problem_response(
    status: int, code: ErrorCode, detail: str, params: Params | None = None, headers: dict[str, str] | None = None
) -> Response:
    """A problem document."""
    body = {
        "type": f"urn:epf-gcs:problem:{code}",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "detail": detail,
        "code": code,
        "params": params or {},
    }
    return Response(orjson.dumps(body), status, headers=headers, media_type=MEDIA_TYPE)


def problem_of(error: GatewayError) -> Response:
    """The problem document of an error, with the headers that its status asks for."""
    status = next(status for kind, status in _STATUS.items() if isinstance(error, kind))
    headers = {}
    if status == HTTPStatus.TOO_MANY_REQUESTS:
        headers["Retry-After"] = str(error.params["retry_after_s"])
    elif status == HTTPStatus.UNAUTHORIZED:
        headers["WWW-Authenticate"] = 'Bearer realm="EPF GCS"'
    return problem_response(status, error.code, error.detail, error.params, headers)


def install_error_handlers(app: FastAPI, errors: ErrorLog) -> None:
    """Every failure becomes a problem document, and is counted by its code."""

    async def expected(_: Request, error: Exception) -> Response:
        known = error if isinstance(error, GatewayError) else GatewayError("internal", str(error))
        errors.count(known.code)
        return problem_of(known)

    async def invalid(_: Request, error: Exception) -> Response:
        first = error.errors()[0] if isinstance(error, RequestValidationError) else {"type": "", "msg": str(error)}
        place = ".".join(str(part) for part in first.get("loc", ()) if _NO_FIELD.fullmatch(str(part)) is None)
        if first["type"] == "json_invalid":
            errors.count("bad_json")
            detail = "The body is not JSON: send an object such as {}, with the content type application/json."
            return problem_response(HTTPStatus.BAD_REQUEST, "bad_json", detail)
        errors.count("invalid_request")
        named = f"'{place}'" if place else "The request"
        detail = f"{named} cannot be taken: {first['msg']}. The allowed values are in /api/docs."
        return problem_response(HTTPStatus.UNPROCESSABLE_ENTITY, "invalid_request", detail, {"field": place})

    async def http_error(request: Request, error: Exception) -> Response:
        status = error.status_code if isinstance(error, HTTPException) else 500
        headers = dict(error.headers or {}) if isinstance(error, HTTPException) else {}
        code = _HTTP_CODES.get(status, "http_error")
        errors.count(code)
        detail = f"{request.method} {request.url.path} is no address of this interface: /api/docs lists all of them."
        if status == HTTPStatus.BAD_REQUEST:
            detail = "The body is not JSON: send an object such as {}, with the content type application/json."
        return problem_response(status, code, detail, {}, headers)

    app.add_exception_handler(GatewayError, expected)
    app.add_exception_handler(RequestValidationError, invalid)
    app.add_exception_handler(HTTPException, http_error)
