"""What can go wrong on purpose. Each error is one sentence for a person and one stable code for a program."""

from __future__ import annotations

Params = dict[str, str | int | float | bool | None]


class GatewayError(Exception):
    """Base of all expected failures.

    `code` is a stable key which the page translates; `detail` says in one English sentence which
    thing failed, why, and what to do; `params` are the values in that sentence.
    """

    def __init__(self, code: str, detail: str, **params: str | float | bool | None) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail
        self.params: Params = params


class InvalidInputError(GatewayError):
    """What was asked for can never be done as asked: out of range, misspelt, of the wrong shape."""


class NotFoundError(GatewayError):
    """The named thing does not exist."""


class ConflictError(GatewayError):
    """It cannot be done now: no link, no control, not supported by this board."""


class LinkError(GatewayError):
    """A device or socket could not be opened, or was lost."""


class BoardError(GatewayError):
    """The board was asked and did not do it: refused, or no answer in time."""
