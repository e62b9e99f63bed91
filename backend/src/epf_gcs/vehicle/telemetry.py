"""What was heard: every sample to the hub, and how well each topic arrives."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from epf_gcs.clock import Clock
from epf_gcs.vehicle.health import ANSWERS, TASK_OF_TOPIC, TopicHealth
from epf_gcs.web.stream.hub import Hub
from epf_gcs.web.stream.hub_state import Values

_TASK_TOPICS: Final = frozenset(TASK_OF_TOPIC)


class Telemetry:
    """The books on all topics. `commanded_period_s` tells the period of a task of the board."""

    def __init__(self, hub: Hub, clock: Clock, commanded_period_s: Callable[[str], float]) -> None:
        self._state = hub.state
        self._clock = clock
        self._commanded_period_s = commanded_period_s
        self._listeners: dict[str, Callable[[float, Values], None]] = {}
        self.health: dict[str, TopicHealth] = {}

    def listen(self, topic: str, listener: Callable[[float, Values], None]) -> None:
        """From now on each sample of this topic is handed to `listener` too, with its Unix time."""
        self._listeners[topic] = listener

    def heard(self, topic: str, t_s: float, values: Values, implausible: Iterable[str] = ()) -> None:
        """A sample of this topic came at `t_s` and was put into the hub."""
        health = self.health.get(topic)
        if health is None:
            health = self.health[topic] = TopicHealth()
        health.heard(t_s, implausible)
        listener = self._listeners.get(topic)
        if listener is not None:
            listener(t_s, values)

    def show(self, topic: str, t_s: float, values: Values, implausible: Iterable[str] = ()) -> None:
        """Put a sample into the hub and keep the books on it."""
        self._state.put(topic, t_s, values)
        self.heard(topic, t_s, values, implausible)

    def rate_changed(self, rate_command: str) -> None:
        """A task of the board has another period now."""
        for topic, command in TASK_OF_TOPIC.items():
            if command == rate_command and topic in self.health:
                self.health[topic].forget_rate()

    def blank(self) -> None:
        """What was heard was an example and is over: every topic has no data until it is heard again."""
        now_s = self._clock.now_s()
        for topic, sample in list(self._state.samples().items()):
            values: Values = {name: {} if isinstance(value, dict) else None for name, value in sample.values.items()}
            self._state.put(topic, now_s, values)
        self.health.clear()

    def newest(self, topic: str) -> Values | None:
        """The newest values of a topic, however old."""
        sample = self._state.samples().get(topic)
        return None if sample is None else sample.values

    def is_live(self, topic: str) -> bool:
        """The topic was heard within its time."""
        health = self.health.get(topic)
        return health is not None and not self._is_stale(topic, health, self._clock.now_s())

    def age_s(self, topic: str) -> float | None:
        """Time since the last sample; None when there was none."""
        health = self.health.get(topic)
        return None if health is None or health.last_s is None else self._clock.now_s() - health.last_s

    def stale_after_s(self, topic: str) -> float | None:
        """Age from which this topic is not live; None where it cannot grow stale, or where its rate is unknown."""
        health = self.health.get(topic)
        if topic in ANSWERS or health is None:
            return None
        return health.stale_after_s(self.commanded_s(topic))

    def commanded_s(self, topic: str) -> float | None:
        """Period with which the board was told to send this topic; None where it has none."""
        return self._commanded_period_s(TASK_OF_TOPIC[topic]) if topic in _TASK_TOPICS else None

    def snapshot(self) -> dict[str, dict[str, Any]]:
        """The newest sample of every topic with its age, for those who ask once."""
        now_s = self._clock.now_s()
        return {
            topic: {
                "t_s": sample.t_s,
                "age_s": now_s - sample.t_s,
                "stale": self._is_stale(topic, self.health[topic], now_s),
                "values": sample.values,
            }
            for topic, sample in self._state.samples().items()
            if topic in self.health
        }

    def summary(self) -> dict[str, dict[str, Any]]:
        """How well each topic arrives."""
        now_s = self._clock.now_s()
        return {topic: self._summary(topic, health, now_s) for topic, health in self.health.items()}

    def _summary(self, topic: str, health: TopicHealth, now_s: float) -> dict[str, Any]:
        implausible: Mapping[str, int] = health.implausible
        return {
            "count": health.count,
            "rate_hz": round(health.rate_hz(now_s), 2),
            "age_s": None if health.last_s is None else round(now_s - health.last_s, 3),
            "stale_after_s": self.stale_after_s(topic),
            "implausible": implausible,
        }

    def _is_stale(self, topic: str, health: TopicHealth, now_s: float) -> bool:
        limit_s = self.stale_after_s(topic)
        return limit_s is not None and health.last_s is not None and now_s - health.last_s > limit_s
