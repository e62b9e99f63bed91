"""Commands with proof: sent, and then confirmed, rejected or timed out; never just hoped for."""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from typing import Any, Final, Literal

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS, TELEMETRY_BY_NAME
from epf_gcs.codec.tables import Message
from epf_gcs.codec.values import Meaning
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Outlet
from epf_gcs.vehicle.parameters import differing
from epf_gcs.vehicle.proof import NOT_REPEATABLE, heartbeat_proves, plan_proves
from epf_gcs.vehicle.telemetry import Telemetry

State = Literal["confirmed", "rejected", "timed_out", "sent"]
By = Literal["acknowledgement", "heartbeat", "read_back", "none"]
# How a proof is looked for; a frame that shows the effect is a read-back to the outside.
_Proof = Literal["acknowledgement", "heartbeat", "frame", "read_back", "none"]

_ATTEMPTS: Final = 2
# Far above a round trip on a busy 115200 line (some 20 ms), far below a person's patience.
_ANSWER_S: Final = 0.6
_SLOW_LINE_BAUD: Final = 57600
_SLOW_LINE_FACTOR: Final = 5
_HEARTBEATS: Final = 3

_RESULTS: Final = {
    number: name
    for value in TELEMETRY_BY_NAME["acknowledgement"].values
    if value.name == "result"
    for name, number in value.names.items()
}

Verdict = tuple[State, str | None]
Judge = Callable[[Frame, Meaning], Verdict | None]


@dataclass(frozen=True, slots=True)
class CommandResult:
    """What became of a command. `reason` is the board's, where it refused: bad_value, bad_state, unknown, ..."""

    state: State
    by: By
    ms: float
    reason: str | None = None

    @property
    def done(self) -> bool:
        """The board has it, or nothing says that it has not."""
        return self.state in ("confirmed", "sent")


class Commands:
    """Sends commands one at a time of each type, for an acknowledgement names nothing but the type."""

    def __init__(self, board: Board, telemetry: Telemetry, hub: Outlet, clock: Clock, errors: ErrorLog) -> None:
        self._loop = asyncio.get_running_loop()
        self._board = board
        self._telemetry = telemetry
        self._hub = hub
        self._clock = clock
        self._errors = errors
        self._locks: defaultdict[str, asyncio.Lock] = defaultdict(asyncio.Lock)
        self._ids = count(1)
        # Set by the composition: hears of every command that was done.
        self.on_done: Callable[[str, tuple[float, ...]], None] | None = None

    async def run(
        self, name: str, arguments: tuple[float, ...] = (), *, client: str | None = None, quiet: bool = False
    ) -> CommandResult:
        """Send and wait for the proof; `quiet` ones are part of something that is told as a whole.

        `arguments` are checked already. Raises ConflictError where it cannot be sent now.
        """
        command = COMMANDS[name]
        self.check_ready(command)
        async with self._locks[name]:
            self.check_ready(command)
            story: dict[str, Any] = {
                "id": next(self._ids),
                "name": name,
                "value": list(arguments),
                "client": client,
            }
            if not quiet:
                self._tell(story, "pending", "none", None, None)
            result = await self._prove(command, arguments)
        if result.done and self.on_done is not None:
            self.on_done(name, arguments)
        if not result.done:
            self._errors.count(f"command_{result.state}")
        if not quiet:
            self._tell(story, result.state, result.by, result.ms, result.reason)
        return result

    def check_ready(self, command: Message) -> None:
        """Raise ConflictError with the reason why the board cannot be asked this now."""
        self._board.check_commandable()
        if not self._board.is_open:
            raise ConflictError(
                "board_not_open",
                f"'{command.name}' was not sent because no board is connected: open the board's link first.",
                command=command.name,
            )
        if command.extension and not self._board.session.is_extended:
            raise ConflictError(
                "not_supported",
                f"'{command.name}' was not sent because this board does not support it: it needs newer firmware.",
                command=command.name,
            )

    async def _prove(self, command: Message, arguments: tuple[float, ...]) -> CommandResult:
        frame = encode_command(command.name, *arguments)
        proof, judge = self._judge(command, arguments)
        started_s = self._clock.steady_s()
        if judge is None:
            self._send(command, frame)
            return CommandResult("sent", "none", 0.0)
        attempts = 1 if command.name in NOT_REPEATABLE else _ATTEMPTS
        verdict: Verdict | None = None
        for _ in range(attempts):
            verdict = await self._attempt(command, frame, proof, judge)
            if verdict is not None:
                break
        ms = round((self._clock.steady_s() - started_s) * 1000.0, 1)
        by: By = "read_back" if proof == "frame" else proof
        if verdict is None:
            return CommandResult("timed_out", by, ms)
        return CommandResult(verdict[0], by, ms, verdict[1])

    async def _attempt(self, command: Message, frame: bytes, proof: _Proof, judge: Judge) -> Verdict | None:
        decided: asyncio.Future[Verdict] = self._loop.create_future()

        def listen(frame: Frame, meant: Meaning) -> None:
            verdict = judge(frame, meant)
            if verdict is not None and not decided.done():
                decided.set_result(verdict)

        with self._board.listening(listen):
            self._send(command, frame)
            if proof == "read_back":
                self._board.write(encode_command("load_autopilot_parameters"))
            try:
                async with asyncio.timeout(self._patience_s(proof)):
                    return await decided
            except TimeoutError:
                return None

    def _send(self, command: Message, frame: bytes) -> None:
        if not self._board.write(frame):
            raise ConflictError(
                "board_line_full",
                f"'{command.name}' was not sent because the line to the board takes no more bytes: "
                "check the board, or lower the rates.",
                command=command.name,
            )

    def _judge(self, command: Message, arguments: tuple[float, ...]) -> tuple[_Proof, Judge | None]:
        """What will prove this command on this board, and how to see it in a frame."""
        confirm = command.confirm
        if self._board.session.is_extended and self._board.capabilities().get("has_acknowledgements"):
            return "acknowledgement", _acknowledges(command.id)
        match confirm.by:
            case "heartbeat":
                return (
                    "heartbeat",
                    lambda frame, meant: (
                        ("confirmed", None)
                        if frame.message.name == "heartbeat" and heartbeat_proves(confirm, arguments, meant.values)
                        else None
                    ),
                )
            case "frame":
                return "frame", lambda frame, _: ("confirmed", None) if frame.message.name == confirm.message else None
            case "plan" if self._telemetry.is_live(confirm.message):
                before = (self._telemetry.newest(confirm.message) or {}).get("waypoint")
                return (
                    "frame",
                    lambda frame, meant: (
                        ("confirmed", None)
                        if frame.message.name == confirm.message
                        and plan_proves(confirm, before, meant.values.get("waypoint"))
                        else None
                    ),
                )
            case "read_back":
                return "read_back", _reads_back(command.parameter, arguments[0])
            case _:
                return "none", None

    def _patience_s(self, proof: _Proof) -> float:
        slow = self._board.baud < _SLOW_LINE_BAUD
        patience_s = _ANSWER_S * (_SLOW_LINE_FACTOR if slow else 1)
        if proof in ("heartbeat", "frame"):
            health = self._telemetry.health.get("heartbeat")
            period_s = health.period_s(None) if health is not None else None
            patience_s = max(patience_s, _HEARTBEATS * (period_s or 0.0))
        return patience_s

    def _tell(self, story: dict[str, Any], state: str, by: By, ms: float | None, reason: str | None) -> None:
        self._hub.event("command", {**story, "state": state, "by": by, "ms": ms, "reason": reason})


def _acknowledges(command_id: int) -> Judge:
    def judge(frame: Frame, meant: Meaning) -> Verdict | None:
        if frame.message.name != "acknowledgement" or meant.values["command_type"] != command_id:
            return None
        result = _RESULTS.get(frame.values[1], "unknown")
        return ("confirmed", None) if result == "done" else ("rejected", result)

    return judge


def _reads_back(parameter: str, wanted: float) -> Judge:
    def judge(frame: Frame, meant: Meaning) -> Verdict | None:
        if frame.message.name != "autopilot_parameters":
            return None
        return ("confirmed", None) if not differing({parameter: wanted}, meant.values) else ("rejected", "not_taken")

    return judge
