"""The API documentation in the browser, served from local files: it works without a network."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from typing import Any, Final, Literal

from fastapi import APIRouter, FastAPI
from fastapi.openapi.utils import get_openapi
from fastapi.responses import HTMLResponse, Response
from pydantic import TypeAdapter

from epf_gcs import __version__
from epf_gcs.access.roles import OPEN, Role
from epf_gcs.contract.shapes import Description, Output, Problem
from epf_gcs.web.interface.events import EVENTS
from epf_gcs.web.interface.flights import schemas as flights
from epf_gcs.web.serving.access_table import MESSAGES, ROUTES, STREAMS, Entry

OPENAPI_PATH: Final = "/api/v1/openapi.json"
_REFERENCE: Final = "#/components/schemas/{model}"
_ASSETS: Final = {"swagger-ui-bundle.js": "text/javascript", "swagger-ui.css": "text/css"}
_PAGE: Final = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>EPF GCS interface</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="/api/docs/swagger-ui.css">
</head>
<body>
<div id="docs"></div>
<script src="/api/docs/swagger-ui-bundle.js"></script>
<script src="/api/docs/start.js"></script>
</body>
</html>
"""
_START: Final = f'SwaggerUIBundle({{url: "{OPENAPI_PATH}", dom_id: "#docs", deepLinking: true, validatorUrl: null}});\n'
_DESCRIPTION: Final = """
The gateway of EPF GCS. Errors are problem documents (RFC 9457) whose `code` is stable.

**Who may**: on the computer itself nobody needs a key. From elsewhere everybody does: a browser enters with a one-time
key and gets a cookie, a program sends `Authorization: Bearer epf_...`. Each route says the least role that it needs
(`x-least-role`: `anyone`, `viewer`, `operator`, `owner`) and whether the caller must also have control, or nobody
(`x-needs-control`). Without a key the answer is 401, with a lower role 403, and 429 says in `Retry-After` when to come
back.

**Stream**: WebSocket `/api/v1/stream?rate=60` sends `hello`, then `batch`, `event` and `status` messages as JSON.
Answer each batch with `{"type": "ack", "seq": n}`: at most four are under way, and a viewer which stalled gets the
newest state at once. `rate=0` sends every sample; `{"type": "rate", "rate": n}` changes it. Commands go over REST with
the header `X-Client: <client of the hello>`.

**Stick**: the page that has control may send `{"type": "stick", "elevator": -1..1, "aileron": -1..1, "rudder": -1..1,
"throttle": 0..1, "t_ms": its own steady clock}` on its stream, up to 50 times a second: the positions of its gamepad
(elevator + nose up, aileron + right wing down, rudder + nose right). With `PUT /hil` `{"stick": "gamepad"}` they take
the place of the simulator's rows 8 and 25. A sample is used for 0.3 s; without a newer one the surfaces are centred
then, and the throttle is closed after 2 s. The choice ends with that page's control.

**Control**: one page at a time commands; `GET /control` says which. `POST /control` takes it while nobody has it, asks
for it (events `control_request` and `control_request_closed`), grants, refuses, hands over and gives it back. A
request waits until the holder answers it, unless the station was started with `--control-by-silence`: then 10 s in
which the holder does nothing grant it. A page that is closed or cut off loses
control within a second, one that hangs after two, and gets it back if it returns while nobody else has it.

**Recordings**: `/api/v1/stream?flight=ID&at_s=SECONDS` speaks the same of a recording, with `playback` messages beside;
send `play`, `pause`, `seek`, `step` or `loop`. While it is being opened, an `opening` comes each
second before the `hello`. `{"type": "ask", "about": "inspector"}` is answered with `{"type":
"answer", "about": "inspector", "data": as GET /inspector gives it}` of the moment that is shown; `known` as
`GET /flights/{id}/known`.

**Events**: `alarm` (an alarm that came, went or was acknowledged), `command` (pending, and what became of it),
`console`, `control` (who has it now, the `reason`, and who had it `before`), `control_request` and
`control_request_closed` (`result`: `given`, `refused`, `withdrawn`, `gone`), `error`, `fault` (one that was asked for
in the simulator has `begun` or `ended`), `flight` (the flight process: `state` is `lost` or `back`), `job` (as `GET
/jobs/{id}`, at most four a second), `journal` (a new entry, and what undo and redo would write now), `link`,
`map_field` (as one of `GET /map/fields`, at most four a second), `map_import` (as `GET /map/imports/{id}`, at most
four a second), `mission`, `own_gains` (the table in which the board describes gains and topics of its own, null where
it is as before, and the gains' values that changed; samples of such topics are sent like others), `parameter` (the
gains that changed, each with value, state and loaded value),
`recording`, `stick` (where the stick comes from, whether it is `live` or `lost`, and the `reason`: `chosen`,
`control_lost`, `lost`, `back`), `track` and `wind` (the embedded simulator's).
"""

# Shapes that no route answers with: of messages on the stream. They stand under `x-shapes`, from which
# the page's checks are generated as from the answers.
SHAPES: Final[tuple[type[Output], ...]] = (flights.Playback,)

_SECURITY: Final = {
    "session": {
        "type": "apiKey",
        "in": "cookie",
        "name": "epf_8000",
        "description": "Of a person that has entered by `POST /access/enter`; named after the port, `__Host-epf` with "
        "TLS.",
    },
    "key": {"type": "http", "scheme": "bearer", "description": "The key of a program."},
    "password": {"type": "http", "scheme": "basic", "description": "The same key as the password, with any name."},
}

router = APIRouter(include_in_schema=False)


@router.get("/api/docs")
async def docs_page() -> HTMLResponse:
    """The page."""
    return HTMLResponse(_PAGE)


@router.get("/api/docs/start.js")
async def docs_start() -> Response:
    """Starts the page; a file of its own because scripts inside the page are not allowed."""
    return Response(_START, media_type="text/javascript")


@router.get("/api/docs/{name}")
async def docs_asset(name: str) -> Response:
    """Swagger UI's own files."""
    if name not in _ASSETS:
        return Response(status_code=404)
    content = (files("fastapi_offline") / "static" / name).read_bytes()
    return Response(content, media_type=_ASSETS[name], headers={"Cache-Control": "max-age=3600"})


def describe(app: FastAPI) -> Description:
    """The OpenAPI document, with problems under their own media type."""
    if app.openapi_schema is None:
        schema = get_openapi(
            title="EPF GCS gateway", version=__version__, description=_DESCRIPTION.strip(), routes=app.routes
        )
        for path, operations in schema["paths"].items():
            for method, operation in operations.items():
                _say_who_may(operation, ROUTES[method.upper(), path])
        schema["components"]["securitySchemes"] = _SECURITY
        schema["x-stream"] = {"opening": _least(STREAMS), "messages": _least(MESSAGES)}
        schemas = schema["components"]["schemas"]
        schemas.pop("HTTPValidationError", None)
        schemas.pop("ValidationError", None)
        schemas.setdefault("Problem", Problem.model_json_schema())
        schema["x-shapes"] = _described({shape.__name__: shape for shape in SHAPES}, schemas)
        schema["x-events"] = _described(EVENTS, schemas)
        app.openapi_schema = schema
    return app.openapi_schema


def _described(shapes: Mapping[str, type[Any]], schemas: Description) -> Description:
    """A reference for each of these shapes; their schemas are added to `schemas`."""
    asked: list[tuple[str, Literal["serialization"], TypeAdapter[Any]]] = [
        (name, "serialization", TypeAdapter(shape)) for name, shape in shapes.items()
    ]
    references, parts = TypeAdapter.json_schemas(asked, ref_template=_REFERENCE)
    for name, part in parts.get("$defs", {}).items():
        schemas.setdefault(name, part)
    return {name: references[name, "serialization"] for name in shapes}


def _say_who_may(operation: Description, entry: Entry) -> None:
    operation["x-least-role"] = _name_of(entry)
    operation["x-needs-control"] = entry.control
    operation["security"] = [] if entry.least == OPEN else [{name: []} for name in _SECURITY]


def _least(entries: Mapping[str, Entry]) -> Description:
    return {
        name: {"x-least-role": _name_of(entry), "x-needs-control": entry.control} for name, entry in entries.items()
    }


def _name_of(entry: Entry) -> str:
    return "anyone" if entry.least == OPEN else Role(entry.least).name
