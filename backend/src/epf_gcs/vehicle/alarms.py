"""The alarms, which every tab of the page shows at once: raised, acknowledged, and kept in a history."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any, Final, Literal

from epf_gcs.contract.alarm_ids import AlarmId
from epf_gcs.contract.answers import PastAlarm
from epf_gcs.contract.events import AlarmEvent
from epf_gcs.contract.status import AlarmState
from epf_gcs.errors import InvalidInputError, NotFoundError
from epf_gcs.vehicle.judges import Finding
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.thresholds import BY_NAME, chosen, threshold_fault

KEPT: Final = 200

News = Literal["came", "went", "acknowledged"]


@dataclass(frozen=True, slots=True)
class Alarm:
    """One thing that is or was wrong. Unix times; `until_s` is None while it lasts.

    An alarm that ended without being acknowledged is "recovered": it stays listed until somebody acknowledges it.
    """

    finding: Finding
    since_s: float
    acknowledged: bool = False
    until_s: float | None = None
    count: int = 1
    """How often it came since somebody last acknowledged it."""

    @property
    def state(self) -> AlarmState:
        """As the contract has it."""
        finding = self.finding
        return AlarmState(
            finding.id,
            finding.level,
            self.since_s,
            self.until_s,
            finding.text,
            finding.params,
            self.acknowledged,
            self.count,
        )

    @property
    def past_state(self) -> PastAlarm:
        """As the contract has one that has ended."""
        finding = self.finding
        return PastAlarm(
            finding.id,
            finding.level,
            finding.text,
            finding.params,
            self.since_s,
            self.since_s if self.until_s is None else self.until_s,
            self.acknowledged,
        )

    @staticmethod
    def from_state(state: AlarmState) -> Alarm:
        """The alarm that `state` gave."""
        finding = Finding(state.id, state.level, state.text, dict(state.params))
        return Alarm(finding, state.since_s, state.acknowledged, state.until_s, state.count)


class Alarms:
    """Asks `watch` at each `look`, and announces each alarm that comes, goes or is acknowledged.

    `thresholds` are the operator's choices; `on_thresholds` stores new ones. `past` are the alarms of earlier runs,
    oldest first; `on_past` stores each alarm when it ends, and once more if it is acknowledged after its end. `on_news`
    hears of every alarm that comes, goes or is acknowledged.
    """

    def __init__(
        self,
        watch: Callable[[Mapping[str, float]], Iterable[Finding]],
        outlet: Outlet,
        thresholds: Mapping[str, Any],
        on_thresholds: Callable[[dict[str, float]], None],
        *,
        past: Iterable[Alarm] = (),
        on_past: Callable[[Alarm], None] | None = None,
        on_news: Callable[[News, Alarm], None] | None = None,
    ) -> None:
        self._watch = watch
        self._outlet = outlet
        self._on_thresholds = on_thresholds
        self._active: dict[AlarmId, Alarm] = {}
        # Ended, and not acknowledged yet.
        self._recovered: dict[AlarmId, Alarm] = {}
        self._past: deque[Alarm] = deque(past, maxlen=KEPT)
        self._on_past = on_past
        self.thresholds = chosen(thresholds)
        self._on_news = on_news

    @property
    def active(self) -> list[Alarm]:
        """All that is wrong now, and what recovered without being acknowledged; oldest first."""
        return sorted([*self._active.values(), *self._recovered.values()], key=lambda alarm: alarm.since_s)

    @property
    def past(self) -> list[Alarm]:
        """The alarms that have ended, the latest to end first."""
        return list(reversed(self._past))

    def look(self, t_s: float) -> bool:
        """Update the alarms at Unix time `t_s`. True if an alarm came, went or became worse."""
        before = self._active
        self._active = {
            finding.id: _follow(before.get(finding.id), finding, t_s, self._recovered.get(finding.id))
            for finding in self._watch(self.thresholds)
        }
        gone = [replace(alarm, until_s=t_s) for alarm in before.values() if alarm.finding.id not in self._active]
        news = [alarm for alarm in self._active.values() if _is_news(before.get(alarm.finding.id), alarm)]
        self._past.extend(gone)
        for alarm in news:
            # The new alarm replaces the recovered one of the same id, which stays in the history.
            self._recovered.pop(alarm.finding.id, None)
            self._tell(alarm, "came")
        for alarm in gone:
            if not alarm.acknowledged:
                self._recovered[alarm.finding.id] = alarm
            self._keep(alarm)
            self._tell(alarm, "went")
        return bool(news or gone)

    def restore(self, listed: Iterable[AlarmState]) -> None:
        """Go on with these alarms (as `Alarm.state` gives them) in place of all others; nothing is announced."""
        alarms = [Alarm.from_state(one) for one in listed]
        self._active = {alarm.finding.id: alarm for alarm in alarms if alarm.until_s is None}
        self._recovered = {alarm.finding.id: alarm for alarm in alarms if alarm.until_s is not None}

    def acknowledge(self, name: str) -> Alarm:
        """The operator has seen it: an active alarm is shown quietly until it ends, a recovered one is removed.

        The second of two presses finds it acknowledged, and is answered alike. Raises NotFoundError if it is neither
        active nor recovered nor of the acknowledged past.
        """
        alarm = next((alarm for alarm in self.active if alarm.finding.id == name), None)
        if alarm is None:
            known_before = next((one for one in self.past if one.finding.id == name and one.acknowledged), None)
            if known_before is not None:
                return known_before
            raise NotFoundError(
                "alarm_not_active",
                f"There is no active alarm '{name}': it went, or there is none of this name. "
                "GET /api/v1/alarms lists them.",
                alarm=name,
            )
        known = replace(alarm, acknowledged=True)
        if alarm.until_s is None:
            self._active[alarm.finding.id] = known
        else:
            del self._recovered[alarm.finding.id]
            self._past = deque((known if one == alarm else one for one in self._past), maxlen=KEPT)
            self._keep(known)
        if not alarm.acknowledged:
            self._tell(known, "acknowledged")
        return known

    def choose(self, thresholds: Mapping[str, float]) -> None:
        """Set some limits. Raises NotFoundError or InvalidInputError; then none is changed."""
        for name, value in thresholds.items():
            if name not in BY_NAME:
                raise NotFoundError(
                    "threshold_unknown",
                    f"There is no alarm threshold '{name}': GET /api/v1/alarms/thresholds lists them.",
                    field=name,
                )
            threshold = BY_NAME[name]
            fault = threshold_fault(threshold, value)
            if fault is not None:
                raise InvalidInputError(
                    "threshold_out_of_range",
                    fault,
                    field=name,
                    value=value,
                    minimum=threshold.minimum,
                    maximum=threshold.maximum,
                )
        self.thresholds = {**self.thresholds, **thresholds}
        self._on_thresholds(self.thresholds)

    def _keep(self, alarm: Alarm) -> None:
        if self._on_past is not None:
            self._on_past(alarm)

    def _tell(self, alarm: Alarm, news: News) -> None:
        self._outlet.event(AlarmEvent(**asdict(alarm.state), active=alarm.until_s is None))
        if self._on_news is not None:
            self._on_news(news, alarm)


def _follow(before: Alarm | None, finding: Finding, t_s: float, recovered: Alarm | None) -> Alarm:
    """The alarm of a finding. If it became worse it must be acknowledged again; if it came back before anybody
    acknowledged that it was there, it is counted with those before."""
    if before is None:
        return Alarm(finding, t_s, count=1 if recovered is None else recovered.count + 1)
    return replace(before, finding=finding, acknowledged=before.acknowledged and not _is_worse(before, finding))


def _is_worse(before: Alarm, finding: Finding) -> bool:
    return (before.finding.level, finding.level) == ("warning", "critical")


def _is_news(before: Alarm | None, now: Alarm) -> bool:
    return before is None or _is_worse(before, now.finding)
