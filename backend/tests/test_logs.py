"""The log: a few lines of each kind in a minute with a count of the others, however many a stranger causes."""

from __future__ import annotations

import logging
from collections.abc import Iterator

import pytest
import structlog

from epf_gcs.logs import LINES_PER_WINDOW, WINDOW_S, Quota, set_up_logging
from tests.support.gateway import Gateway


@pytest.fixture(autouse=True)
def _as_before() -> Iterator[None]:
    yield
    for handler in logging.getLogger().handlers:
        for one in tuple(handler.filters):
            handler.removeFilter(one)


def test_a_kind_has_its_lines_in_each_window_and_then_a_count() -> None:
    now_s = 100.0
    quota = Quota(lambda: now_s, lines=3)
    assert [quota.take("a") for _ in range(5)] == [0, 0, 0, None, None]
    assert quota.take("b") == 0, "another kind has its own"
    now_s += WINDOW_S
    assert quota.take("a") == 2
    assert [quota.take("a") for _ in range(3)] == [0, 0, None]
    now_s += 10 * WINDOW_S
    assert quota.take("a") == 1


def test_kinds_without_number_take_no_memory_without_bound() -> None:
    now_s = 0.0
    quota = Quota(lambda: now_s)
    said = sum(quota.take(str(kind)) is not None for kind in range(10_000))
    assert said < 1000
    now_s += WINDOW_S
    assert quota.take("new") == 0


def test_a_flood_of_one_kind_is_a_few_lines(capsys: pytest.CaptureFixture[str]) -> None:
    set_up_logging(verbose=False)
    log = structlog.get_logger("gateway")
    for number in range(1000):
        log.error("a request failed", path=f"/{number}" + "x" * 10_000)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == LINES_PER_WINDOW
    assert sum(map(len, lines)) < 60_000


def test_what_libraries_say_is_bounded_too(capsys: pytest.CaptureFixture[str]) -> None:
    root = logging.getLogger()
    kept, root.handlers[:] = list(root.handlers), []
    try:
        set_up_logging(verbose=False)
        for _ in range(1000):
            logging.getLogger("uvicorn.error").warning("Invalid HTTP request received.")
        assert capsys.readouterr().err.count("Invalid HTTP") == LINES_PER_WINDOW
    finally:
        root.handlers[:] = kept


def test_bad_requests_do_not_fill_the_log(gateway: Gateway, capsys: pytest.CaptureFixture[str]) -> None:
    for number in range(100):
        assert gateway.http.get(f"{gateway.base}/%00{number}").status_code == 404
        assert gateway.http.get("/status", headers={"Host": "[::1"}).status_code == 400
    assert len(capsys.readouterr().err) < 2000
