"""What happens when the disk fills, as the person chose it. The flight process keeps the choice, for it records."""

from __future__ import annotations

from collections.abc import Awaitable
from typing import Protocol

from epf_gcs.contract.answers import DiskPolicy
from epf_gcs.contract.requests import AnswerT_co, ChooseDiskPolicy, Request
from epf_gcs.errors import GatewayError


class Ask(Protocol):
    """Asks the flight process. Raises GatewayError."""

    def __call__(self, request: Request[AnswerT_co], /) -> Awaitable[AnswerT_co]:
        """The request's answer."""


class PolicyChoice:
    """The choice, asked for once; until the flight process has answered it is the default, which deletes nothing."""

    def __init__(self, ask: Ask) -> None:
        self._ask = ask
        self._known: DiskPolicy | None = None

    async def now(self) -> DiskPolicy:
        """The choice."""
        if self._known is None:
            try:
                self._known = await self._ask(ChooseDiskPolicy())
            except GatewayError:
                return DiskPolicy()
        return self._known

    async def choose(self, policy: DiskPolicy) -> None:
        """Change it. Raises GatewayError while the flight process is away."""
        self._known = await self._ask(ChooseDiskPolicy(policy.delete_oldest, policy.keep_free_bytes))
