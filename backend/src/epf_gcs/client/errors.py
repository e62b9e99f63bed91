"""What a program is told when a station does not do what it asked."""

from __future__ import annotations

from collections.abc import Mapping

from epf_gcs.contract.base import ParamValue


class StationError(Exception):
    """The station refused, or could not do it: `code` is stable, the text says why and what to do in one sentence."""

    def __init__(self, code: str, detail: str, params: Mapping[str, ParamValue]) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail
        self.params = params


class ControlError(StationError):
    """Another page has control: nothing was sent to the board."""


class StationLostError(Exception):
    """The stream has ended or cannot be opened: nothing that was known is live any more. The text says why."""
