"""Errors are counted all, and told now and then."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from epf_gcs.contract.events import ErrorEvent
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import LinkError

GARBAGE = LinkError("line_garbage", "The line brought rubbish: check it.", kind="noise")


class Listener:
    def __init__(self) -> None:
        self.now_s = 100.0
        self.told: list[dict[str, Any]] = []
        self.errors = ErrorLog()
        self.errors.tell_viewers(lambda: self.now_s, lambda *told: self.told.append(asdict(ErrorEvent.of(*told))))


def test_each_kind_is_told_once_in_ten_seconds_and_counted_always() -> None:
    listener = Listener()
    for _ in range(500):
        listener.errors.report(GARBAGE)
    assert listener.errors.counts["line_garbage"] == 500
    assert len(listener.told) == 1
    assert listener.told[0]["detail"] == "The line brought rubbish: check it."
    listener.now_s += 10.0
    listener.errors.report(GARBAGE)
    assert [data["count"] for data in listener.told] == [1, 501]


def test_another_kind_is_told_at_once() -> None:
    listener = Listener()
    listener.errors.report(GARBAGE)
    listener.errors.report(LinkError("link_lost", "Gone."))
    assert [data["code"] for data in listener.told] == ["line_garbage", "link_lost"]


def test_what_was_answered_already_is_only_counted() -> None:
    listener = Listener()
    listener.errors.count("bad_json")
    assert listener.errors.counts == {"bad_json": 1}
    assert listener.told == []
