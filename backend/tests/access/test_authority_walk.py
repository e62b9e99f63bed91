"""A random walk through the rules of control; `python -m bench control` walks a million steps."""

from __future__ import annotations

from typing import get_args

import pytest

from epf_gcs.contract.events import ControlReason, RequestResult
from tests.support.control_walk import Walk

STEPS = 60_000


@pytest.mark.uncounted
def test_random_steps_meet_no_second_holder_no_stick_without_one_and_always_a_way_back() -> None:
    walk = Walk(seed=20261122)
    walk.go(STEPS)
    assert walk.ways_back == STEPS // 500
    seen = walk.flight.reasons.keys()
    assert seen >= set(get_args(ControlReason)) | set(get_args(RequestResult)), "every rule was walked through"
    assert walk.flight.kept_over > 0
    assert walk.refusals.keys() >= {
        "control_held",
        "control_not_held",
        "control_refused",
        "control_not_asked",
        "control_unconfirmed",
        "client_unknown",
        "client_silent",
        "client_may_not_command",
        "role_too_low",
    }
