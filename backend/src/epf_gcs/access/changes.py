"""What can change about control: a page that has it, who asks for it, what became of that."""

from __future__ import annotations

from dataclasses import dataclass

from epf_gcs.access.caller import LOCAL_SESSION, CallerKind
from epf_gcs.access.roles import Role
from epf_gcs.contract.events import ControlReason, RequestResult


@dataclass(frozen=True, slots=True)
class Page:
    """A stream, as others see it. `name` is ready to show; `number` tells pages of one name apart, from 1 on."""

    client: str
    session: str
    kind: CallerKind
    name: str
    number: int
    role: Role

    @property
    def is_local(self) -> bool:
        """Whether it is one of this computer."""
        return self.session == LOCAL_SESSION

    @property
    def may_command(self) -> bool:
        """Whether its role allows control."""
        return self.role >= Role.operator

    @property
    def refused_as(self) -> str:
        """Whom a refusal means: a person on all pages of a session; at this computer each page, for all share one."""
        return self.client if self.is_local else self.session


@dataclass(frozen=True, slots=True)
class HolderChange:
    """`page` has control now, None: nobody. `before` had it."""

    page: Page | None
    reason: ControlReason
    before: Page | None


@dataclass(frozen=True, slots=True)
class KeptOver:
    """Control is kept for `page` no longer."""

    page: Page


@dataclass(frozen=True, slots=True)
class RequestStart:
    """`page` asks the holder for control."""

    page: Page


@dataclass(frozen=True, slots=True)
class RequestEnd:
    """What became of it."""

    page: Page
    result: RequestResult


@dataclass(frozen=True, slots=True)
class StickLoss:
    """This page's hand is no longer on the stick."""

    client: str


Effect = HolderChange | KeptOver | RequestStart | RequestEnd | StickLoss
