"""Chains of timers: one turn that raises is counted and the next comes; no timer is armed from its own callback."""

from __future__ import annotations

import ast
import asyncio
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, cast

import pytest

from epf_gcs.repeating import Repeating, repeat
from tests.support.held_loop import HeldLoop

SOURCES = Path(__file__).parents[1] / "src" / "epf_gcs"
ARMS = frozenset({"call_later", "call_at", "call_soon"})


@pytest.fixture
def loop() -> HeldLoop:
    return HeldLoop()


def repeating(loop: HeldLoop, turn: Callable[[], float | None], after_failure_s: float | None = None) -> Repeating:
    return Repeating(cast(asyncio.AbstractEventLoop, loop), "a test", turn, after_failure_s)


def test_each_turn_says_when_the_next_one_is(loop: HeldLoop) -> None:
    waits: Iterator[float | None] = iter([0.0, 2.0, 0.5, None])
    at_s: list[float] = []

    def turn() -> float | None:
        at_s.append(loop.now_s)
        return next(waits)

    chain = repeating(loop, turn)
    chain.arm(1.0)
    loop.run_until(10.0)
    assert at_s == [1.0, 1.0, 3.0, 3.5]
    assert not chain.is_armed
    chain.arm()
    assert chain.is_armed


def test_what_a_turn_raises_is_told_to_the_loop_and_the_next_turn_comes(loop: HeldLoop) -> None:
    turns: list[float] = []

    def turn() -> float | None:
        turns.append(loop.now_s)
        if len(turns) == 2:
            raise ZeroDivisionError
        return 1.0

    repeating(loop, turn, after_failure_s=3.0).arm()
    loop.run_until(6.0)
    assert turns == [0.0, 1.0, 4.0, 5.0, 6.0]
    ((what, error),) = loop.failures
    assert what == "a test"
    assert isinstance(error, ZeroDivisionError)


def test_a_chain_that_waits_to_be_armed_can_be_armed_after_a_turn_that_raised(loop: HeldLoop) -> None:
    turns: list[float] = []

    def turn() -> None:
        turns.append(loop.now_s)
        raise ZeroDivisionError

    chain = repeating(loop, turn)
    chain.arm()
    loop.run_until(1.0)
    chain.arm()
    loop.run_until(2.0)
    assert turns == [0.0, 1.0]


def test_no_turn_comes_after_stop_also_when_its_own_turn_stops_it(loop: HeldLoop) -> None:
    turns: list[float] = []

    def turn() -> float | None:
        turns.append(loop.now_s)
        if len(turns) == 3:
            chain.stop()
        return 1.0

    chain = repeating(loop, turn)
    chain.arm()
    loop.run_until(9.0)
    assert turns == [0.0, 1.0, 2.0]
    chain.arm()
    chain.hurry()
    loop.run_until(20.0)
    assert len(turns) == 3


def test_a_turn_that_raises_after_it_was_stopped_is_the_last(loop: HeldLoop) -> None:
    turns: list[float] = []

    def turn() -> float | None:
        turns.append(loop.now_s)
        chain.stop()
        raise ZeroDivisionError

    chain = repeating(loop, turn, after_failure_s=0.5)
    chain.arm()
    loop.run_until(9.0)
    assert turns == [0.0]
    assert len(loop.failures) == 1


def test_a_hurried_turn_comes_at_once_and_once(loop: HeldLoop) -> None:
    at_s: list[float] = []
    chain = repeating(loop, lambda: at_s.append(loop.now_s))
    chain.arm(5.0)
    loop.run_until(1.0)
    chain.arm(1.0)  # one is due already
    chain.hurry()
    loop.run_until(9.0)
    assert at_s == [1.0]


def test_a_turn_now_takes_the_place_of_the_one_that_was_due(loop: HeldLoop) -> None:
    at_s: list[float] = []
    chain = repeating(loop, lambda: at_s.append(loop.now_s))
    chain.arm(5.0)
    loop.run_until(2.0)
    chain.run_now()
    assert at_s == [2.0]
    loop.run_until(9.0)
    assert at_s == [2.0]


def test_a_task_s_turn_that_raises_is_told_to_the_loop_and_the_next_turn_comes() -> None:
    async def scenario() -> list[str]:
        told: list[str] = []
        asyncio.get_running_loop().set_exception_handler(lambda _, context: told.append(context["message"]))
        enough = asyncio.Event()
        turns: list[int] = []

        def turn() -> None:
            turns.append(len(turns))
            if len(turns) == 3:
                enough.set()
            raise ZeroDivisionError

        task = asyncio.create_task(repeat(0.0, "a test", turn))
        await enough.wait()
        task.cancel()
        return told

    assert asyncio.run(scenario()) == ["a test"] * 3


def self_arming(source: str) -> list[str]:
    """Functions of a module that a timer calls and that arm the same timer again, directly or through others."""
    uses: dict[str, set[str]] = {}
    armed: dict[str, set[str]] = {}
    for function in ast.walk(ast.parse(source)):
        if not isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
            continue
        mentioned = uses.setdefault(function.name, set())
        for node in ast.walk(function):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ARMS:
                callback = node.args[0 if node.func.attr == "call_soon" else 1]
                armed.setdefault(function.name, set()).update(names_in(callback))
            else:
                mentioned |= names_of(node)
    return sorted({one for begun in armed.values() for one in begun if one in chain_of(one, uses, armed)})


def chain_of(name: str, uses: dict[str, set[str]], armed: dict[str, set[str]]) -> set[str]:
    """All callbacks that are armed by `name` or by anything that it mentions."""
    seen, waiting, found = set[str](), [name], set[str]()
    while waiting:
        one = waiting.pop()
        if one not in seen:
            seen.add(one)
            found |= armed.get(one, set())
            waiting += uses.get(one, ())
    return found


def names_in(node: ast.AST) -> set[str]:
    return set().union(*(names_of(one) for one in ast.walk(node)))


def names_of(node: ast.AST) -> set[str]:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return {name}
        case _:
            return set()


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ("def a(self): self.loop.call_later(1, self.a)", ["a"]),
        ("def a(self): self.loop.call_at(1, self.b)\ndef b(self): self.c()\ndef c(self): self.a()", ["b"]),
        ("def a(self): self.loop.call_later(1, partial(self.a, 1))", ["a"]),
        ("def a(self): self.loop.call_soon(lambda: self.a())", ["a"]),
        ("def a(self): asyncio.get_running_loop().call_later(1, self.b)\ndef b(self): f.add_reader(1, self.a)", ["b"]),
        ("def a(self): self.loop.call_later(1, self.b)\ndef b(self): self.transport.abort()", []),
        ("def a(self): self.loop.call_soon(self.b)\ndef b(self): self.c()\ndef c(self): pass", []),
    ],
)
def test_the_check_finds_a_chain_made_by_hand(body: str, found: list[str]) -> None:
    assert self_arming(body) == found


def test_no_part_arms_a_timer_from_its_own_callback() -> None:
    files = [file for file in sorted(SOURCES.rglob("*.py")) if file.name != "repeating.py"]
    assert len(files) > 400, "the sources were not found"
    found: dict[str, Any] = {str(file.relative_to(SOURCES)): self_arming(file.read_text()) for file in files}
    assert {name: chains for name, chains in found.items() if chains} == {}
    assert self_arming((SOURCES / "repeating.py").read_text()), "the one chain that there is"
