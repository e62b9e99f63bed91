"""Names of the clients that made requests, for the journal."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any, Final

from epf_gcs.bus.definition import Asker
from epf_gcs.bus.vehicle_end import Handler, Handlers
from epf_gcs.contract.requests import Request

_KEPT: Final = 200


class ClientNames:
    """Remembers the names of the latest clients."""

    def __init__(self) -> None:
        self._names: OrderedDict[str, str] = OrderedDict()

    def name_of(self, client: str) -> str | None:
        """The client's name as others see it; None if it never gave one."""
        return self._names.get(client)

    def remembering(self, handlers: Handlers) -> Handlers:
        """Wrap these handlers so that each request's client name is remembered."""
        return {kind: self._remember(handler) for kind, handler in handlers.items()}

    def _remember(self, handler: Handler) -> Handler:
        async def remember(request: Request[Any], by: Asker) -> Any:
            if by.client is not None and by.name is not None:
                self._names[by.client] = by.name
                self._names.move_to_end(by.client)
                if len(self._names) > _KEPT:
                    self._names.popitem(last=False)
            return await handler(request, by)

        return remember
