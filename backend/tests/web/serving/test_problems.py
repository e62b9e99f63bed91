"""Failures that nobody planned."""

from __future__ import annotations

import pytest

from tests.support.gateway import Gateway
from tests.support.waiting import eventually


def test_a_fault_of_ours_is_a_problem_too_and_is_counted(gateway: Gateway, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail() -> None:
        raise RuntimeError("a fault of ours")

    monkeypatch.setattr(gateway.flight.telemetry, "snapshot", fail)
    answer = gateway.http.get("/telemetry")
    assert (answer.status_code, answer.json()["code"]) == (500, "internal")
    assert "a fault of ours" not in answer.text
    assert gateway.status()["errors"] == {"internal": 1}


def test_a_part_that_fails_begins_again(gateway: Gateway, monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[int] = []

    def fail_once(_t_s: float) -> bool:
        calls.append(1)
        if len(calls) == 1:
            raise RuntimeError("a fault of ours")
        return False

    monkeypatch.setattr(gateway.flight.alarms, "look", fail_once)
    with gateway.stream() as stream:
        while len(calls) < 3:
            stream.next("status")
    eventually(lambda: gateway.status()["errors"] == {"internal": 1}, "it is counted")
