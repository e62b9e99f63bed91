"""The names of clients that made requests."""

from __future__ import annotations

from typing import Any

import pytest

from epf_gcs.bus.definition import Asker
from epf_gcs.flight.requests.client_names import ClientNames


async def answer(_by: Asker, _arguments: dict[str, Any]) -> None:
    """A request that does nothing."""


@pytest.mark.anyio
async def test_of_very_many_clients_the_latest_are_known_by_name() -> None:
    names = ClientNames()
    handler = names.remembering({"start": answer})["start"]
    for number in range(250):
        await handler(Asker(f"client {number}", f"Ana {number}"), {})
    await handler(Asker("nameless", None), {})
    await handler(Asker("client 249", None), {})
    await handler(Asker("client 60", "Bo"), {})
    await handler(Asker("one more", "Eve"), {})
    assert names.name_of("client 249") == "Ana 249", "who gives none keeps the one that is known"
    assert names.name_of("client 60") == "Bo", "who asks again is among the latest"
    assert names.name_of("one more") == "Eve"
    assert names.name_of("client 0") is names.name_of("client 50") is names.name_of("nameless") is None
