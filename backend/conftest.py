"""Fixtures of the gateway's tests."""

from __future__ import annotations

import os
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

# Before numpy is loaded: beside other tests its threads only wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# An HTTP client reads the world's authorities when it is made, for longer than a gateway takes to start; who meets TLS
# here names its own. Of a folder nothing is read before it is looked for.
os.environ.pop("SSL_CERT_FILE", None)
os.environ["SSL_CERT_DIR"] = os.devnull

import pytest
from coverage import Coverage
from hypothesis import HealthCheck, settings

from tests.support.equal_priority import sitecustomize as equal_priority
from tests.support.fake_board import FakeBoard
from tests.support.firmware import lacking_for_images, make
from tests.support.gateway import Gateway, running_gateway

pytest_plugins = ("pytester",)

# For the programs that tests start; this one has loaded it.
EQUAL_PRIORITY = str(Path(equal_priority.__file__).parent)
# A worker of the run inherits the path from its parent, which has done the same.
FOLDERS = [one for one in os.environ.get("PYTHONPATH", "").split(os.pathsep) if one not in ("", EQUAL_PRIORITY)]
os.environ["PYTHONPATH"] = os.pathsep.join((EQUAL_PRIORITY, *FOLDERS))

# A busy machine is slow: how long an example takes says nothing about whether it is right. Half of the usual examples
# find the same faults in half of the time: each run has others.
settings.register_profile("gateway", deadline=None, max_examples=50, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("gateway")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What tries the board's C counts no lines of the gateway."""
    for item in items:
        if Path(__file__).parent / "board_tests" in item.path.parents:
            item.add_marker(pytest.mark.uncounted)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, object, object]:
    """Lines are not counted while an `uncounted` test runs: counting makes long calculations twice as long."""
    stopped: list[Coverage] = []
    if item.get_closest_marker("uncounted"):
        # In a worker there are two, one under the other: the plugin's for a whole run, and the worker's own.
        while (counting := Coverage.current()) is not None:
            counting.stop()
            stopped.append(counting)
    try:
        return (yield)
    finally:
        for counting in reversed(stopped):
            counting.start()


@pytest.fixture
def anyio_backend() -> tuple[str, dict[str, Any]]:
    """Asynchronous tests run on the loop that the gateway runs on."""
    return "asyncio", {"use_uvloop": True}


@pytest.fixture(scope="session")
def built_images() -> None:
    """The images of the board's processors, where this computer can build and run them."""
    if reason := lacking_for_images():
        pytest.skip(reason)
    make("images")


@pytest.fixture
def true_priority(monkeypatch: pytest.MonkeyPatch) -> None:
    """Programs that the test starts lower their priority as they do for a user."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(FOLDERS))


@pytest.fixture
def gateway(tmp_path: Path) -> Iterator[Gateway]:
    """A gateway without any link."""
    with running_gateway(tmp_path / "data") as running:
        yield running


@pytest.fixture
def board(tmp_path: Path) -> Iterator[FakeBoard]:
    """An extended board that is plugged in."""
    with FakeBoard(tmp_path / "board") as plugged:
        yield plugged


@pytest.fixture
def legacy_board(tmp_path: Path) -> Iterator[FakeBoard]:
    """A deployed board that is plugged in."""
    with FakeBoard(tmp_path / "board", extended=False) as plugged:
        yield plugged
