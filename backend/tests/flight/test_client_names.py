"""The names of clients that made requests."""

from __future__ import annotations

import pytest

from epf_gcs.bus.definition import Asker
from epf_gcs.contract.requests import CloseBoard
from epf_gcs.flight.requests.client_names import ClientNames


async def answer(_request: CloseBoard, _by: Asker) -> None:
    """A request that does nothing."""


@pytest.mark.anyio
async def test_of_very_many_clients_the_latest_are_known_by_name() -> None:
    names = ClientNames()
    handler = names.remembering({CloseBoard: answer})[CloseBoard]
    for number in range(250):
        await handler(CloseBoard(), Asker(f"client {number}", f"Ana {number}"))
    await handler(CloseBoard(), Asker("nameless", None))
    await handler(CloseBoard(), Asker("client 249", None))
    await handler(CloseBoard(), Asker("client 60", "Bo"))
    await handler(CloseBoard(), Asker("one more", "Eve"))
    assert names.name_of("client 249") == "Ana 249", "who gives none keeps the one that is known"
    assert names.name_of("client 60") == "Bo", "who asks again is among the latest"
    assert names.name_of("one more") == "Eve"
    assert names.name_of("client 0") is names.name_of("client 50") is names.name_of("nameless") is None
