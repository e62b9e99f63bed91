"""The built page, served beside its interface."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from tests.support.gateway import Gateway, running_gateway


@pytest.fixture
def built(tmp_path: Path) -> Iterator[Gateway]:
    dist = tmp_path / "dist"
    (dist / "assets").mkdir(parents=True)
    (dist / "index.html").write_text("<!doctype html><title>EPF GCS</title>")
    (dist / "assets" / "index-abc123.js").write_text("export {};")
    (tmp_path / "secret").write_text("secret")
    with running_gateway(tmp_path / "data", page_dir=dist) as running:
        yield running


def get(gateway: Gateway, path: str) -> httpx.Response:
    return gateway.http.get(f"{gateway.base}{path}")


@pytest.mark.parametrize("path", ["/", "/index.html"])
def test_the_page_is_at_the_root(built: Gateway, path: str) -> None:
    answer = get(built, path)
    assert answer.status_code == 200
    assert "EPF GCS" in answer.text
    assert answer.headers["content-type"].startswith("text/html")
    assert answer.headers["cache-control"] == "no-cache"
    assert "default-src 'self'" in answer.headers["content-security-policy"]


def test_files_with_a_hash_are_kept_by_the_browser(built: Gateway) -> None:
    answer = get(built, "/assets/index-abc123.js")
    assert answer.headers["content-type"].startswith("text/javascript")
    assert "immutable" in answer.headers["cache-control"]
    assert get(built, "/assets/index-old.js").status_code == 404


@pytest.mark.parametrize("path", ["/../secret", "/..%2fsecret", "/assets/..%2f..%2fsecret", "/%2e%2e/secret"])
def test_nothing_outside_the_page_is_served(built: Gateway, path: str) -> None:
    answer = get(built, path)
    assert answer.status_code == 404
    assert answer.json()["code"] == "no_such_address"


@pytest.mark.parametrize(
    "path", ["/hil", "/setup/deep", "/no-such.txt", "/%00", "/a%00b", f"/{'x' * 300}", "/assets", "/" + "a/" * 3000]
)
def test_an_address_that_is_none_is_not_the_page(built: Gateway, path: str) -> None:
    answer = get(built, path)
    assert (answer.status_code, answer.json()["code"]) == (404, "no_such_address")
    assert len(answer.content) < 1000
    assert "internal" not in built.status()["errors"]


def test_an_address_of_the_interface_that_is_none_is_not_the_page(built: Gateway) -> None:
    answer = get(built, "/api/v1/no-such")
    assert (answer.status_code, answer.json()["code"]) == (404, "no_such_address")


def test_without_a_built_page_a_sentence_says_so(tmp_path: Path) -> None:
    with running_gateway(tmp_path / "data", page_dir=tmp_path / "nothing") as running:
        answer = get(running, "/")
        assert answer.status_code == 404
        assert "The page is not built" in answer.text
