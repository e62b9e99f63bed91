"""Fixtures of the closed loop's tests."""

from __future__ import annotations

import pytest

from board_tests.closed_loop.circuit import Circuit, flown_once


@pytest.fixture(scope="session")
def circuit(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Circuit:
    """The Gando circuit in calm air. pytest's workers have folders of their own in one that they share."""
    folder = tmp_path_factory.getbasetemp()
    return flown_once(folder if worker_id == "master" else folder.parent)
