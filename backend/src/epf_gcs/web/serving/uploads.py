"""Limits on simultaneous uploads: for each host and in total, with a share reserved for this computer."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

from epf_gcs.errors import ConflictError
from epf_gcs.shares.holder import host_of

PER_HOST: Final = 3
FROM_ELSEWHERE: Final = 4


class Uploads:
    """Owned by the event loop."""

    def __init__(self) -> None:
        self._of: Counter[str] = Counter()

    @contextmanager
    def one_more(self, host: str) -> Iterator[None]:
        """Count an upload while inside. Raises ConflictError if the limit is reached."""
        key = host_of(host)
        elsewhere = self._of.total() - self._of[""]
        if self._of[key] >= PER_HOST or (key and elsewhere >= FROM_ELSEWHERE):
            raise ConflictError(
                "map_imports_busy",
                f"{PER_HOST} files are being received already: wait for one of them, or cancel it.",
                limit=PER_HOST,
            )
        self._of[key] += 1
        try:
            yield
        finally:
            self._of[key] -= 1
            if not self._of[key]:
                del self._of[key]
