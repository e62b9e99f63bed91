"""The shapes of the gains and of the journal of what was written to them."""

from __future__ import annotations

from epf_gcs.contract.answers import ParameterState
from epf_gcs.contract.own_gains import OwnGains
from epf_gcs.contract.shapes import Output


class ParameterList(Output):
    """The 17 gains, and those that the board describes itself."""

    parameters: list[ParameterState]
    own: OwnGains
