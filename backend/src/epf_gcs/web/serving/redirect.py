"""The answer to HTTP in plain text on a port of TLS: the same address under https."""

from __future__ import annotations

from http import HTTPStatus
from urllib.parse import urlsplit

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from epf_gcs.errors import GatewayError, InvalidInputError
from epf_gcs.web.serving.origins import Access
from epf_gcs.web.serving.problems import problem_response


class Redirect:
    """ASGI application. It tells nothing of the vehicle, so it asks for no key."""

    def __init__(self, access: Access) -> None:
        self._access = access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send the browser on, but only to a name of this station."""
        headers = Headers(scope=scope)
        host = headers.get("host")
        try:
            self._access.check(headers.getlist, reads=True)
        except GatewayError as error:
            is_none = isinstance(error, InvalidInputError)
            status = HTTPStatus.BAD_REQUEST if is_none else HTTPStatus.FORBIDDEN
            await problem_response(status, error.code, error.detail, error.params)(scope, receive, send)
            return
        answer = Response(
            status_code=HTTPStatus.PERMANENT_REDIRECT,
            # Browsers would remember it beyond the day when the station runs without TLS again.
            headers={"Location": _secure(host or "", scope), "Cache-Control": "no-store", "Connection": "close"},
        )
        await answer(scope, receive, send)


def _secure(host: str, scope: Scope) -> str:
    """The address, put together anew from checked parts: of `user@host:port` only host and port are taken."""
    parts = urlsplit(f"//{host}")
    name, port = parts.hostname or "", parts.port
    place = (f"[{name}]" if ":" in name else name) + ("" if port is None else f":{port}")
    path = bytes(scope["raw_path"]).decode("latin-1")
    query = bytes(scope["query_string"]).decode("latin-1")
    return f"https://{place}{path}" + (f"?{query}" if query else "")
