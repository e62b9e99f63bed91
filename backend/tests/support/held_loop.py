"""An event loop whose time the test says: timers come when it runs, and what they tell of failures is kept."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class HeldTimer:
    """One call that is due."""

    def __init__(self, due_s: float, call: Callable[[], Any]) -> None:
        self.due_s = due_s
        self.call = call
        self.is_off = False

    def cancel(self) -> None:
        self.is_off = True


class HeldLoop:
    """Stands in for the event loop where only its clock and its timers are used."""

    def __init__(self, now_s: float = 0.0) -> None:
        self.now_s = now_s
        self.timers: list[HeldTimer] = []
        self.failures: list[tuple[str, BaseException]] = []

    def time(self) -> float:
        return self.now_s

    def call_at(self, due_s: float, call: Callable[..., Any], *arguments: Any) -> HeldTimer:
        timer = HeldTimer(due_s, lambda: call(*arguments))
        self.timers.append(timer)
        return timer

    def call_later(self, in_s: float, call: Callable[..., Any], *arguments: Any) -> HeldTimer:
        return self.call_at(self.now_s + in_s, call, *arguments)

    def call_soon(self, call: Callable[..., Any], *arguments: Any) -> HeldTimer:
        return self.call_at(self.now_s, call, *arguments)

    def call_exception_handler(self, context: dict[str, Any]) -> None:
        self.failures.append((context["message"], context["exception"]))

    @property
    def due(self) -> list[HeldTimer]:
        """What is still to come, the next first."""
        return sorted((one for one in self.timers if not one.is_off), key=lambda one: one.due_s)

    def step(self, late_s: float = 0.0) -> float:
        """Let the next timer come, that much late; returns when it was due."""
        timer = self.due[0]
        self.timers.remove(timer)
        self.now_s = max(self.now_s, timer.due_s + late_s)
        timer.call()
        return timer.due_s

    def run_until(self, until_s: float) -> None:
        """Let all timers come that are due until then."""
        while self.due and self.due[0].due_s <= until_s:
            self.step()
        self.now_s = until_s
