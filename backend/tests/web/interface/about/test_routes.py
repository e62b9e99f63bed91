"""What the station says of itself."""

from __future__ import annotations

import platform

from epf_gcs import __version__
from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway


def test_versions_board_and_licences(gateway: Gateway, board: FakeBoard) -> None:
    about = gateway.http.get("/about").raise_for_status().json()
    assert (about["version"], about["python"]) == (__version__, platform.python_version())
    assert platform.system() in about["platform"]
    assert about["board"] is None
    licences = {package["name"]: package["licence"] for package in about["packages"]}
    assert licences["fastapi"] == "MIT"
    gateway.open_board(board.url)
    assert gateway.http.get("/about").json()["board"] == {"name": "fake", "version": "1.0", "mode": "extended"}


def test_a_legacy_board_has_no_name(gateway: Gateway, legacy_board: FakeBoard) -> None:
    gateway.open_board(legacy_board.url)
    assert gateway.http.get("/about").json()["board"] == {"name": None, "version": None, "mode": "legacy"}
