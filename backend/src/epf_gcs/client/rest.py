"""Questions and orders over REST, with the types of the contract as their answers."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from typing import Any, Final, Literal, TypeVar

import httpx
import msgspec

from epf_gcs.client.errors import ControlError, StationError, StationLostError

AnswerT = TypeVar("AnswerT")
Method = Literal["GET", "PUT", "POST", "PATCH", "DELETE"]
# A board that does not answer is given up by the station after 15 s; its sentence is better than a time-out here.
_PATIENCE_S: Final = 60.0
_CONTROL: Final = "/control"
_CONTROL_CODES: Final = frozenset({"control_held", "control_not_held", "control_unconfirmed"})


class Rest:
    """The interface under `/api/v1` of one station. Raises StationError where it refuses.

    `asks_for_control`: what is refused because another has control asks that one for it.
    """

    def __init__(self, url: str, key: str | None, *, asks_for_control: bool) -> None:
        self._asks_for_control = asks_for_control
        headers = {} if key is None else {"Authorization": f"Bearer {key}"}
        self._http = httpx.AsyncClient(base_url=f"{url}/api/v1", headers=headers, timeout=_PATIENCE_S)

    def act_as(self, client: str) -> None:
        """Ask in the name of the program's own stream from now on: control belongs to a stream."""
        self._http.headers["X-Client"] = client

    async def ask(
        self, method: Method, path: str, answer: type[AnswerT], body: Mapping[str, object] | None = None
    ) -> AnswerT:
        """What the station answers, as this type."""
        return msgspec.convert(await self.json(method, path, body), answer)

    async def json(self, method: Method, path: str, body: Mapping[str, object] | None = None) -> Any:
        """The same without a type; None for an empty answer."""
        response = await self.fetch(method, path, body)
        return response.json() if response.content else None

    async def fetch(self, method: Method, path: str, body: Mapping[str, object] | None = None) -> httpx.Response:
        """The whole answer, such as a file."""
        try:
            response = await self._http.request(method, path, json=body)
        except httpx.TransportError as error:
            raise StationLostError(f"The station at {self._http.base_url} does not answer: {error}.") from error
        if response.is_success:
            return response
        refusal = _refusal(response)
        if self._asks_for_control and isinstance(refusal, ControlError) and path != _CONTROL:
            with contextlib.suppress(StationError):  # it has asked already
                await self.json("POST", _CONTROL, {"client": self._http.headers["X-Client"], "action": "ask"})
        raise refusal

    async def close(self) -> None:
        """Close its connections."""
        await self._http.aclose()


def _refusal(response: httpx.Response) -> StationError:
    """The error that a problem document (RFC 9457) tells of."""
    try:
        problem = response.json()
        code, detail, params = str(problem["code"]), str(problem["detail"]), dict(problem["params"])
    except (ValueError, KeyError, TypeError):
        return StationError("no_problem_document", f"The station answered {response.status_code} without a reason.", {})
    return (ControlError if code in _CONTROL_CODES else StationError)(code, detail, params)
