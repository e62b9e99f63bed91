"""Plans to write, and the reading of what somebody else wrote."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import strategies as st

from epf_gcs.codec.tables import Waypoint
from epf_gcs.errors import InvalidInputError
from epf_gcs.formats.mission_file import MissionFile
from epf_gcs.formats.recognise import read_plan_file, settle_plan
from epf_gcs.formats.wpl_plan import FirstItem

WAYPOINTS = st.builds(
    Waypoint,
    st.floats(-90, 90),
    st.floats(-180, 180),
    st.floats(-2000, 60000),
    st.floats(0, 500),
)
PLANS = st.lists(WAYPOINTS, min_size=1, max_size=100)
TWO = (Waypoint(27.93, -15.38, 1000.0, 60.0), Waypoint(27.95, -15.36, 1200.0, 55.0))


def read(
    text: str | bytes,
    name: str = "file",
    *,
    ground_ft: float | None = None,
    home_ft: float | None = None,
    thin: bool = False,
    first: FirstItem | None = None,
) -> MissionFile:
    """As the station reads it. `ground_ft`: the same below all waypoints; None: not known."""
    plan = read_plan_file(name, text.encode() if isinstance(text, str) else text, thin=thin, first=first)
    return settle_plan(name, plan, [ground_ft] * len(plan.points), home_ft)


def notes(found: MissionFile) -> dict[str, Any]:
    """The notes by their code."""
    assert len({note.code for note in found.notes}) == len(found.notes)
    return {note.code: note.params for note in found.notes}


def refusal(text: str | bytes, name: str = "file") -> InvalidInputError:
    """Why it is not taken; always one sentence that names the file."""
    with pytest.raises(InvalidInputError) as caught:
        read(text, name)
    error = caught.value
    assert error.detail.startswith(f"'{name}' cannot be read as a flight plan because ")
    assert error.detail.endswith(".")
    assert error.params["name"] == name
    return error
