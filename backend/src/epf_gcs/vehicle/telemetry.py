"""Where all samples pass: keeps the newest of each topic, measures how well it arrives, sends it to the viewers.

Frames come some 280 times a second, and a few decoded together cost less than as many decoded one at a time. So they
wait until the outlet wants them, or until anybody looks here: what is read is always the newest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Final, NamedTuple

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.values import Meaning, meaning
from epf_gcs.contract import answers, status
from epf_gcs.contract.base import Values
from epf_gcs.vehicle.health import ANSWERS, TASK_OF_TOPIC, KeptHealth, TopicHealth
from epf_gcs.vehicle.outside import Clock, Outlet

_TASK_TOPICS: Final = frozenset(TASK_OF_TOPIC)


class Sample(NamedTuple):
    """The newest values of a topic and their Unix time."""

    t_s: float
    values: Values


class TelemetryState(NamedTuple):
    """The newest sample of each topic, and how well it arrives (as `TopicHealth.kept` gives it)."""

    newest: dict[str, Sample]
    health: dict[str, KeptHealth]


class Telemetry:
    """Every topic of one vehicle. `commanded_period_s` gives the period of a task of the board by its rate command.

    `on_decoded` is called with each decoded frame and its Unix time, after its sample was taken.
    """

    def __init__(self, outlet: Outlet, clock: Clock, commanded_period_s: Callable[[str], float]) -> None:
        self._outlet = outlet
        self._send = outlet.sample
        self._clock = clock
        self._commanded_period_s = commanded_period_s
        self._newest: dict[str, Sample] = {}
        self._health: dict[str, TopicHealth] = {}
        self._waiting: list[tuple[Frame, float]] = []
        self._is_gathering = False
        self.on_decoded: Callable[[Frame, Meaning, float], None] = _nobody
        self.flush = outlet.flush

    def hear(self, frames: list[Frame], t_s: float, *, at_once: bool) -> None:
        """Take frames that came at Unix time `t_s`. `at_once`: somebody waits for their values."""
        for frame in frames:
            self._waiting.append((frame, t_s))
        if at_once or not (self._is_gathering or self._outlet.later(self.catch_up)):
            self.catch_up()

    @contextmanager
    def together(self) -> Iterator[None]:
        """Frames that are heard inside wait for its end, unless somebody waits for their values."""
        self._is_gathering = True
        try:
            yield
        finally:
            self._is_gathering = False
            if self._waiting and not self._outlet.later(self.catch_up):
                self.catch_up()

    def catch_up(self) -> None:
        """Decode the frames that wait, in the order of the line."""
        if not self._waiting:
            return
        waiting, self._waiting = self._waiting, []
        decoded = [(frame, meaning(frame), t_s) for frame, t_s in waiting]
        for frame, meant, t_s in decoded:
            if frame.message.topic:
                self._take(frame.message.name, t_s, meant.values, meant.implausible)
        self.flush()
        for frame, meant, t_s in decoded:
            self.on_decoded(frame, meant, t_s)

    def take(self, topic: str, t_s: float, values: Values, implausible: Iterable[str] = ()) -> None:
        """Take a sample, heard at Unix time `t_s`. Call `flush` after all samples that came together."""
        self.catch_up()
        self._take(topic, t_s, values, implausible)

    def _take(self, topic: str, t_s: float, values: Values, implausible: Iterable[str]) -> None:
        self._newest[topic] = Sample(t_s, values)
        self._send(topic, t_s, values)
        health = self._health.get(topic)
        if health is None:
            health = self._health[topic] = TopicHealth()
        health.heard(t_s, implausible)

    @property
    def health(self) -> Mapping[str, TopicHealth]:
        """How well each topic arrives that was heard so far."""
        self.catch_up()
        return self._health

    def rate_changed(self, rate_command: str) -> None:
        """The period of a task of the board was changed: measure the rates of its topics anew."""
        health = self.health
        for topic, command in TASK_OF_TOPIC.items():
            if command == rate_command and topic in health:
                health[topic].forget_rate()

    def blank(self) -> None:
        """The emulation has ended: replace its values by "no data" until a topic is heard again."""
        self.catch_up()
        now_s = self._clock.now_s()
        for topic, sample in list(self._newest.items()):
            values: Values = {name: {} if isinstance(value, dict) else None for name, value in sample.values.items()}
            self._newest[topic] = Sample(now_s, values)
            self._send(topic, now_s, values)
        self._health.clear()
        self.flush()

    def samples(self) -> Mapping[str, Sample]:
        """The newest sample of every topic heard so far."""
        self.catch_up()
        return self._newest

    def newest(self, topic: str) -> Values | None:
        """The newest values of a topic, however old."""
        self.catch_up()
        return self.peek(topic)

    def peek(self, topic: str) -> Values | None:
        """The same, but other topics that wait go on waiting: for the HIL path."""
        for frame, _ in reversed(self._waiting):
            if frame.message.name == topic:
                return meaning(frame).values
        sample = self._newest.get(topic)
        return None if sample is None else sample.values

    def is_live(self, topic: str) -> bool:
        """Whether the topic was heard and is not stale."""
        health = self.health.get(topic)
        return health is not None and not self._is_stale(topic, health, self._clock.now_s())

    def age_s(self, topic: str) -> float | None:
        """Time since the last sample; None when there was none."""
        health = self.health.get(topic)
        return None if health is None or health.last_s is None else self._clock.now_s() - health.last_s

    def stale_after_s(self, topic: str) -> float | None:
        """Age above which this topic is stale; None if it cannot become stale, or if its rate is unknown."""
        health = self.health.get(topic)
        if topic in ANSWERS or health is None:
            return None
        return health.stale_after_s(self.commanded_s(topic))

    def commanded_s(self, topic: str) -> float | None:
        """Commanded period of this topic; None if no task of the board sends it."""
        return self._commanded_period_s(TASK_OF_TOPIC[topic]) if topic in _TASK_TOPICS else None

    def snapshot(self, frozen: frozenset[str] = frozenset()) -> dict[str, answers.Sample]:
        """The newest sample of every topic with its age, for a single request (viewers get a stream). The `frozen`
        topics arrive, but their values stand still: none of them is live."""
        now_s = self._clock.now_s()
        return {
            topic: answers.Sample(
                t_s=sample.t_s,
                age_s=now_s - sample.t_s,
                stale=topic in frozen or self._is_stale(topic, self._health[topic], now_s),
                values=sample.values,
            )
            for topic, sample in self.samples().items()
            if topic in self._health
        }

    def summary(self) -> dict[str, status.TopicHealth]:
        """How well each topic arrives."""
        now_s = self._clock.now_s()
        return {topic: self._summary(topic, health, now_s) for topic, health in self.health.items()}

    def kept(self) -> TelemetryState:
        """For `restore`."""
        self.catch_up()
        return TelemetryState(dict(self._newest), {topic: health.kept() for topic, health in self._health.items()})

    def restore(self, kept: TelemetryState) -> None:
        """Go on from a state that `kept` gave; nothing is sent."""
        self._waiting.clear()
        self._newest = dict(kept.newest)
        self._health = {topic: TopicHealth.restored(*health) for topic, health in kept.health.items()}

    def _summary(self, topic: str, health: TopicHealth, now_s: float) -> status.TopicHealth:
        return status.TopicHealth(
            count=health.count,
            rate_hz=round(health.rate_hz(now_s), 2),
            age_s=None if health.last_s is None else round(now_s - health.last_s, 3),
            stale_after_s=self.stale_after_s(topic),
            implausible=health.implausible,
        )

    def _is_stale(self, topic: str, health: TopicHealth, now_s: float) -> bool:
        limit_s = self.stale_after_s(topic)
        return limit_s is not None and health.last_s is not None and now_s - health.last_s > limit_s


def _nobody(frame: Frame, meant: Meaning, t_s: float) -> None:
    """The callback before a board sets its own: ignore."""
