"""The streams of each session, live and of the past, so that all of them can be closed when it ends."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from epf_gcs.access.control import Control
from epf_gcs.web.stream.socket import SocketConnection


class OpenStreams:
    """Owned by the event loop."""

    def __init__(self, control: Control) -> None:
        self._control = control
        self._of: dict[str, set[SocketConnection]] = {}

    def add(self, session: str, connection: SocketConnection) -> Callable[[], None]:
        """Keep it until the result is called."""
        streams = self._of.setdefault(session, set())
        streams.add(connection)

        def leave() -> None:
            streams.discard(connection)
            if not streams and self._of.get(session) is streams:
                del self._of[session]

        return leave

    def close_sessions(self, sessions: Iterable[str]) -> None:
        """These sessions or keys are no longer good: their control ends at once, and their streams."""
        for session in sessions:
            self._control.end_session(session)
            for connection in tuple(self._of.get(session, ())):
                connection.dismiss("ended")
