"""The shapes of control, and of what may be asked of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from pydantic import Field

from epf_gcs.contract.base import PageKind, RoleName
from epf_gcs.contract.shapes import Input, Output
from epf_gcs.contract.status import ControlState


class StreamPage(Output):
    """A page on the live stream."""

    client: str
    name: str
    kind: PageKind
    number: int
    role: RoleName


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlDetails(ControlState):
    """The same, and all pages on the live stream, the longest first: control can be handed over to those that are no
    viewers."""

    pages: list[StreamPage]


class ControlInput(Input):
    """`client` is the id of the caller's own stream (`hello`).

    `take` is for all while nobody has control; an owner who sends `confirm` takes it from another page. `ask` opens a
    request, `withdraw` closes it. The page that has control can `grant` or `refuse` it `to` the one who asks,
    `hand_over` without being asked, and `release`.
    """

    client: str = Field(min_length=1, max_length=64)
    action: Literal["take", "release", "ask", "withdraw", "grant", "refuse", "hand_over"]
    to: str | None = Field(default=None, min_length=1, max_length=64)
    confirm: bool = False
