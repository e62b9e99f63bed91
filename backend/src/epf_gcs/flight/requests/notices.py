"""What a station says without waiting for an answer."""

from __future__ import annotations

from collections.abc import Callable

from epf_gcs.contract.notices import Notice, SurroundingsReport
from epf_gcs.flight.hil.stick import Stick
from epf_gcs.flight.requests.hil import take_stick_notice
from epf_gcs.vehicle.surroundings import ToldSurroundings


def notices(stick: Stick, surroundings: ToldSurroundings, steady_s: Callable[[], float]) -> Callable[[Notice], None]:
    """Ground and fence as seen now, and the stick."""

    def take(notice: Notice) -> None:
        if isinstance(notice, SurroundingsReport):
            surroundings.take(notice.findings, steady_s(), notice.watched, notice.blind)
        else:
            take_stick_notice(stick, notice)

    return take
