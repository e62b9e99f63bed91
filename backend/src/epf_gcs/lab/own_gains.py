"""A board's own gains, by the names that it describes them with over its line: the choice of its law among them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from epf_gcs.codec.description import BLOCK_SIZE, GainRow, block_count, block_questions, rows_of
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import Frame, FrameDecoder
from epf_gcs.codec.values import single
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.laws import LAWS

_LAW: Final = "guidance_law"


class OwnGains:
    """Of one board, as it was started. `feed`: gives it bytes of the line and returns what it answers."""

    def __init__(self, feed: Callable[[bytes], bytes]) -> None:
        self._feed = feed
        self._rows: dict[str, int] = {}

    def select(self, law: str) -> None:
        """Let the board fly plans by one of `LAWS`. Raises LabError if it has not this one."""
        if law == LAWS[0] and not self._rows:  # a board starts with it
            return
        try:
            self.set(_LAW, LAWS.index(law))
        except LabError as error:
            raise LabError(f"the board has no law {law}") from error

    def set(self, name: str, value: float) -> None:
        """Set one in its unit. Raises LabError for one that the board has not, or refuses."""
        if not self._rows:
            self._rows = self._described()
        row = self._rows.get(name)
        told = () if row is None else self._ask("own_gain_set", "own_gain", row, value)
        if told != (row, single(value)):
            raise LabError(f"the board takes no gain {name} of {value}")

    def _described(self) -> dict[str, int]:
        """Row by name; empty where the board does not describe itself."""
        size = int(next(iter(self._ask("describe", "description")), 0))
        blocks: dict[int, bytes] = {}
        for question in block_questions(size):
            for frame in self._answers("describe_blocks", "description_block", *question):
                blocks[frame.values[0]] = frame.payload[-BLOCK_SIZE:]
        table = b"".join(blocks.get(number, b"") for number in range(block_count(size)))[:size]
        return {row.name: row.row for row in rows_of(table) if isinstance(row, GainRow)}

    def _ask(self, command: str, answer: str, *values: float) -> tuple[float, ...]:
        return next((tuple(frame.values) for frame in self._answers(command, answer, *values)), ())

    def _answers(self, command: str, answer: str, *values: float) -> list[Frame]:
        try:
            said = self._feed(encode_command(command, *values))
        except ValueError:
            return []
        frames = (found for found in FrameDecoder().feed(said) if isinstance(found, Frame))
        return [frame for frame in frames if frame.message.name == answer]
