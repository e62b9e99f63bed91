"""The shapes of the gains and of the journal of what was written to them."""

from __future__ import annotations

from epf_gcs.contract.answers import ParameterState
from epf_gcs.contract.shapes import Output


class ParameterList(Output):
    """The 17 gains."""

    parameters: list[ParameterState]
