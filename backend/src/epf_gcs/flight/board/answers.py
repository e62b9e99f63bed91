"""A question to the board that one frame answers, asked again when the answer is lost."""

from __future__ import annotations

import asyncio
from typing import Final

from epf_gcs.codec.frame import Frame
from epf_gcs.codec.values import Meaning
from epf_gcs.flight.board.commands import Commands
from epf_gcs.vehicle.board import Board

_TRIES: Final = 3
# As long as a command waits for its acknowledgement, which the board sends after the answer.
_ANSWER_S: Final = 0.6


async def answer_of(
    board: Board, commands: Commands, question: str, answer: str, row: int | None = None
) -> Frame | None:
    """The answering frame, of this `row` where given; None if the board refused or did not answer.

    One question is on the line at a time, so that many of them leave it to other traffic. Raises ConflictError and
    LinkError as `Commands.run` does.
    """
    for _ in range(_TRIES):
        found, is_refused = await _ask(board, commands, question, answer, row)
        if found is not None or is_refused:
            return found
    return None


async def _ask(
    board: Board, commands: Commands, question: str, answer: str, row: int | None
) -> tuple[Frame | None, bool]:
    heard: asyncio.Future[Frame] = asyncio.get_running_loop().create_future()

    def listen(frame: Frame, meant: Meaning) -> None:
        is_answer = frame.message.name == answer and (row is None or meant.values["row"] == row)
        if is_answer and not heard.done():
            heard.set_result(frame)

    with board.listening(listen):
        result = await commands.run(question, () if row is None else (row,), quiet=True)
        if result.state == "rejected":
            return None, True
        if result.done:
            await asyncio.wait((heard,), timeout=_ANSWER_S)
    return (heard.result() if heard.done() else None), False
