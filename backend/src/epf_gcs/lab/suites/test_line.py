"""The laws at the end of a line: each message, damage, pieces, plans and parameters, as the protocol's page says."""

from __future__ import annotations

import pytest

from epf_gcs.lab.conformance import conform
from epf_gcs.lab.peer import LawsWire
from epf_gcs.lab.plugin import Lab


def test_the_line_does_as_the_protocol_says(lab: Lab) -> None:
    wire = LawsWire(lab.library)
    lacks = [f"{one.name}: {one.lacks}" for one in conform(wire, is_program=False) if one.lacks is not None]
    wire.close()
    if lacks:
        pytest.fail("\n".join(["the board lacks:", *lacks]), pytrace=False)
