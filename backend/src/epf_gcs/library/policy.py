"""What happens when the disk fills, as the person chose it. The flight process keeps the choice, for it records."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from dataclasses import asdict, dataclass
from typing import Any, Final

from epf_gcs.errors import GatewayError

_KEEP_FREE_BYTES: Final = 1_000_000_000

Ask = Callable[..., Awaitable[Any]]
"""Asks the flight process: a request's name and its arguments. Raises GatewayError."""


@dataclass(frozen=True, slots=True)
class Policy:
    """With `delete_oldest`, the bin and then the oldest flights that are not pinned are deleted for good until
    `keep_free_bytes` are free; without, recording stops there."""

    delete_oldest: bool = False
    keep_free_bytes: int = _KEEP_FREE_BYTES


class PolicyChoice:
    """The choice, asked for once; until the flight process has answered it is the default, which deletes nothing."""

    def __init__(self, ask: Ask) -> None:
        self._ask = ask
        self._known: Policy | None = None

    async def now(self) -> Policy:
        """The choice."""
        if self._known is None:
            try:
                self._known = _policy(await self._ask("recording.policy", None))
            except GatewayError:
                return Policy()
        return self._known

    async def choose(self, policy: Policy) -> None:
        """Change it. Raises GatewayError while the flight process is away."""
        self._known = _policy(await self._ask("recording.policy", None, **asdict(policy)))


def _policy(answer: Any) -> Policy:
    return Policy(answer["delete_oldest"], answer["keep_free_bytes"])
