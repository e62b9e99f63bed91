"""The documentation works without a network, and says what is true."""

from __future__ import annotations

import re
from typing import Any, cast

import httpx
import orjson
import pytest

from tests.support.gateway import Gateway, running_gateway


def root(gateway: Gateway, path: str) -> httpx.Response:
    return gateway.http.get(f"{gateway.base}{path}")


def test_the_page_asks_nobody_else(gateway: Gateway) -> None:
    page = root(gateway, "/api/docs").raise_for_status()
    assert "unsafe-inline" not in page.headers["content-security-policy"].split("style-src")[0]
    assets = re.findall(r'(?:src|href)="([^"]+)"', page.text)
    assert "/api/docs/swagger-ui-bundle.js" in assets
    for asset in assets:
        if not asset.startswith("data:"):
            assert asset.startswith("/api/docs/"), asset
            assert root(gateway, asset).raise_for_status().content
    assert "<script>" not in page.text
    assert root(gateway, "/api/docs/other.js").status_code == 404


def test_the_page_shows_this_interface(gateway: Gateway) -> None:
    start = root(gateway, "/api/docs/start.js").raise_for_status().text
    assert "/api/v1/openapi.json" in start
    document = root(gateway, "/api/v1/openapi.json").raise_for_status().json()
    assert document["info"]["title"] == "EPF GCS gateway"


@pytest.fixture(scope="module")
def document(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """What a station says of itself."""
    with running_gateway(tmp_path_factory.mktemp("docs")) as gateway:
        return cast(dict[str, Any], root(gateway, "/api/v1/openapi.json").raise_for_status().json())


@pytest.mark.parametrize(
    ("method", "path"),
    [
        ("get", "/status"),
        ("get", "/telemetry"),
        ("get", "/ports"),
        ("put", "/links/board"),
        ("delete", "/links/board"),
        ("put", "/links/simulator"),
        ("delete", "/links/simulator"),
        ("get", "/commands"),
        ("post", "/commands/{name}"),
        ("get", "/parameters"),
        ("post", "/parameters/load"),
        ("patch", "/parameters"),
        ("post", "/parameters/store"),
        ("get", "/missions/{plan}"),
        ("put", "/missions/{plan}"),
        ("get", "/hil"),
        ("put", "/hil"),
        ("post", "/console"),
        ("get", "/recordings"),
        ("get", "/recordings/{recording_id}"),
        ("get", "/recordings/{recording_id}/export"),
        ("get", "/control"),
        ("post", "/control"),
    ],
)
def test_every_route_of_the_contract_is_described_with_its_problems(
    document: dict[str, Any], method: str, path: str
) -> None:
    operation: dict[str, Any] = document["paths"][f"/api/v1{path}"][method]
    assert operation["description"]
    for status, response in operation["responses"].items():
        if status.startswith("4"):
            assert list(response["content"]) == ["application/problem+json"]
    assert "HTTPValidationError" not in document["components"]["schemas"]


def test_nothing_in_the_status_is_left_undescribed(document: dict[str, Any]) -> None:
    schemas = document["components"]["schemas"]
    for name in ("Status", "BoardStatus", "SimulatorStatus", "AlarmState", "TopicHealth"):
        schema = schemas[name]
        assert set(schema["required"]) == set(schema["properties"]), name
        assert schema["additionalProperties"] is False


def test_shapes_that_no_answer_has_are_described_with_all_their_parts(document: dict[str, Any]) -> None:
    assert document["x-shapes"]["Playback"] == {"$ref": "#/components/schemas/Playback"}
    assert document["x-events"]["stick"] == {"$ref": "#/components/schemas/StickEvent"}
    assert document["x-events"]["job"] == {"$ref": "#/components/schemas/Job"}
    named = set(re.findall(r'"#/components/schemas/(\w+)"', orjson.dumps(document).decode()))
    assert named <= set(document["components"]["schemas"])
    assert "Playback" in document["components"]["schemas"]
