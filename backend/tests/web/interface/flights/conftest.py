"""A station with a flight that is indexed: for a test alone, or for all of a file that leave it as it is."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.flights.flown_flights import recording
from tests.support.gateway import Gateway, running_gateway
from tests.support.waiting import eventually
from tests.web.interface.flights.test_routes import upload


def indexed(gateway: Gateway, content: bytes) -> str:
    flight = str(upload(gateway, content)["flight"])
    eventually(lambda: gateway.http.get(f"/flights/{flight}").json()["state"] == "indexed", "it is indexed")
    return flight


@pytest.fixture
def flight(gateway: Gateway) -> str:
    """An imported flight that is indexed."""
    return indexed(gateway, recording(20))


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """One gateway for a file."""
    with running_gateway(tmp_path_factory.mktemp("station") / "data") as running:
        yield running


@pytest.fixture(scope="module")
def kept(station: Gateway) -> str:
    """Its flight."""
    return indexed(station, recording(20))
