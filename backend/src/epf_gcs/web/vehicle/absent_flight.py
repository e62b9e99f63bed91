"""The status while the flight process is missing: nothing in it appears live."""

from __future__ import annotations

from dataclasses import replace
from typing import Final, TypeVar

from epf_gcs.contract.status import AlarmState, BoardStatus, Failure, SimulatorStatus, Status

_AWAY: Final = (
    "The flight process is gone or hangs, and is started again: what is shown is old, and nothing can be commanded."
)
LinkT = TypeVar("LinkT", BoardStatus, SimulatorStatus)


def status_without_flight(last: Status, now_s: float, lost_s: float) -> Status:
    """The last status, with everything that depends on the flight process marked as lost, and an alarm saying so."""
    gone_s = now_s - last.server_time_s

    def older(age_s: float | None) -> float | None:
        return None if age_s is None else age_s + gone_s

    return replace(
        last,
        server_time_s=now_s,
        board=replace(
            _lost(last.board),
            mode=None,
            heartbeat_age_s=older(last.board.heartbeat_age_s),
            rx_percent=0.0,
            tx_percent=0.0,
        ),
        simulator=replace(_lost(last.simulator), rows=[], missing_rows=[], unusable=[], paused=False, percent=0.0),
        hil=replace(last.hil, stick=replace(last.hil.stick, state=None)),
        recording=replace(last.recording, active=False, failure=_AWAY),
        alarms=[AlarmState("flight_lost", "critical", lost_s, None, _AWAY, {}, acknowledged=False)],
        topics={topic: replace(health, age_s=older(health.age_s)) for topic, health in last.topics.items()},
    )


def _lost(link: LinkT) -> LinkT:
    return link if link.state == "closed" else replace(link, state="lost", failure=Failure("flight_away", _AWAY, {}))
