"""What the aircraft is called, as a person said it. The flight process keeps the name: it notes it in recordings."""

from __future__ import annotations

from epf_gcs.contract.requests import NameAircraft
from epf_gcs.errors import GatewayError
from epf_gcs.library.policy import Ask


class AircraftNameChoice:
    """The name, asked for once; empty where nobody gave one, and until the flight process has answered."""

    def __init__(self, ask: Ask) -> None:
        self._ask = ask
        self._known: str | None = None

    async def now(self) -> str:
        """The name."""
        if self._known is None:
            try:
                self._known = (await self._ask(NameAircraft())).name
            except GatewayError:
                return ""
        return self._known

    async def choose(self, name: str) -> str:
        """Change it, and return it as it is kept. Raises GatewayError while the flight process is away."""
        self._known = (await self._ask(NameAircraft(name))).name
        return self._known
