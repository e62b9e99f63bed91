"""Commands with proof: each one sent ends as confirmed, rejected or timed out."""

from __future__ import annotations

import asyncio
from collections import defaultdict
from collections.abc import Callable
from dataclasses import replace
from itertools import count
from typing import Final, Literal, NamedTuple, cast

from epf_gcs.clock import Clock
from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Message
from epf_gcs.codec.values import Meaning
from epf_gcs.contract.answers import CommandOutcome, CommandProof, CommandReason, CommandState
from epf_gcs.contract.events import CommandEvent
from epf_gcs.error_log import ErrorLog
from epf_gcs.errors import ConflictError, GatewayError, LinkError
from epf_gcs.flight.board.acknowledgements import FENCE, AcknowledgementJudge, OutstandingAcknowledgements
from epf_gcs.vehicle.board import Board
from epf_gcs.vehicle.outside import Line, Outlet
from epf_gcs.vehicle.parameters import differing
from epf_gcs.vehicle.proof import NOT_REPEATABLE, heartbeat_proves, plan_proves
from epf_gcs.vehicle.telemetry import Telemetry

# How a command is proved. "frame" (a frame that shows the effect) is reported to clients as "read_back".
_Proof = Literal["acknowledgement", "heartbeat", "frame", "read_back", "none"]

_ATTEMPTS: Final = 2
# Far above a round trip on a busy 115200 baud line (some 20 ms), and short enough for someone who waits.
_ANSWER_S: Final = 0.6
_SLOW_LINE_BAUD: Final = 57600
_SLOW_LINE_FACTOR: Final = 5
_HEARTBEATS: Final = 3

Verdict = tuple[CommandState, CommandReason | None]
Judge = Callable[[Frame, Meaning], Verdict | None]


class _PendingCommand(NamedTuple):
    """One command on its way, and how it is proved."""

    command: Message
    frame: bytes
    link: Line | None
    proof: _Proof
    judge: Judge
    acknowledgement: AcknowledgementJudge | None


class Commands:
    """Sends one command of each type at a time, for an acknowledgement names only the type."""

    def __init__(self, board: Board, telemetry: Telemetry, outlet: Outlet, clock: Clock, errors: ErrorLog) -> None:
        self._loop = asyncio.get_running_loop()
        self._board = board
        self._telemetry = telemetry
        self._outlet = outlet
        self._clock = clock
        self._errors = errors
        self._locks: defaultdict[str, asyncio.Lock] = defaultdict(asyncio.Lock)
        self._ids = count(1)
        # The newest command for each switch, by the heartbeat's flag.
        self._newest: dict[str, object] = {}
        self._owed = OutstandingAcknowledgements(clock.steady_s)
        # Each command that waits for its proof, with the link it was sent on.
        self._waiting: dict[asyncio.Future[Verdict], Line | None] = {}
        # Set by the composition root; called after every command that was done.
        self.on_done: Callable[[str, tuple[float, ...]], None] | None = None
        board.listen("acknowledgement", self._owed.on_frame)

    def link_changed(self) -> None:
        """The board's link was replaced or closed: stop waiting for proofs on the old one."""
        for decided, link in self._waiting.items():
            if link is not self._board.link and not decided.done():
                decided.cancel()

    async def run(
        self,
        name: str,
        arguments: tuple[float, ...] = (),
        *,
        client: str | None = None,
        quiet: bool = False,
        is_read_back: bool = False,
    ) -> CommandOutcome:
        """Send and wait for the proof. `quiet`: the caller reports the overall result.

        `is_read_back`: the caller reads the value back itself, so it is not read back here as well when the board
        sends no acknowledgements. `arguments` are checked already. Raises ConflictError if the command cannot be
        sent now, and LinkError if the link was lost before the proof.
        """
        command = COMMANDS[name]
        asking = object()
        self._newest.update(dict.fromkeys(command.confirm.flags, asking))
        async with self._locks[name]:
            self.check_ready(command)
            story = self._story(name, arguments, client)
            if not quiet:
                self._outlet.event(story)
            try:
                result = await self._prove(command, arguments, asking, is_read_back=is_read_back)
            except BaseException as error:
                if not quiet:
                    self._outlet.event(_end_of(story, error))
                raise
        if result.done and self.on_done is not None:
            self.on_done(name, arguments)
        if not result.done:
            self._errors.count(f"command_{result.state}")
        if not quiet:
            self._tell(story, result)
        return result

    def tell_outcome(self, name: str, arguments: tuple[float, ...], client: str | None, result: CommandOutcome) -> None:
        """Report the outcome of a `quiet` command to the viewers, once the caller knows it."""
        self._tell(self._story(name, arguments, client), result)

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

    async def _prove(
        self, command: Message, arguments: tuple[float, ...], asking: object, *, is_read_back: bool
    ) -> CommandOutcome:
        sending = self._sending(command, arguments, is_read_back=is_read_back)
        started_s = self._clock.steady_s()
        if sending is None:
            self._send(command, encode_command(command.name, *arguments))
            return CommandOutcome("sent", "none", 0.0)
        attempts = 1 if command.name in NOT_REPEATABLE else _ATTEMPTS
        verdict: Verdict | None = None
        for attempt in range(attempts):
            verdict = await self._attempt(sending, is_first=attempt == 0)
            # Sent again after a newer one for the same switch, it would undo that.
            if verdict is not None or any(self._newest[flag] is not asking for flag in command.confirm.flags):
                break
        ms = round((self._clock.steady_s() - started_s) * 1000.0, 1)
        by: CommandProof = "read_back" if sending.proof == "frame" else sending.proof
        if verdict is None:
            return CommandOutcome("timed_out", by, ms)
        return CommandOutcome(verdict[0], by, ms, verdict[1])

    async def _attempt(self, sending: _PendingCommand, *, is_first: bool) -> Verdict | None:
        """Send once and wait. None if nothing proved it in time. Raises LinkError if the link is gone."""
        decided: asyncio.Future[Verdict] = self._loop.create_future()

        def listen(frame: Frame, meant: Meaning) -> None:
            verdict = sending.judge(frame, meant)
            if verdict is not None and not decided.done():
                decided.set_result(verdict)

        with self._board.listening(listen):
            self._send_again(sending, is_first=is_first)
            self._waiting[decided] = sending.link
            try:
                await asyncio.wait((decided,), timeout=self._patience_s(sending.proof))
            finally:
                del self._waiting[decided]
        if decided.done() and not decided.cancelled():
            return decided.result()
        self._check_link(sending)
        return None

    def _send_again(self, sending: _PendingCommand, *, is_first: bool) -> None:
        self._check_link(sending)
        acknowledgement = sending.acknowledgement
        if acknowledgement is not None and acknowledgement.is_fenced:
            self._board.write(encode_command(FENCE.name))
        try:
            self._send(sending.command, sending.frame)
        except ConflictError:
            # The first sending may have arrived, so a full line at the second one does not mean failure.
            if is_first:
                raise
            return
        if acknowledgement is not None:
            acknowledgement.sent()
        if sending.proof == "read_back":
            self._board.write(encode_command("load_autopilot_parameters"))

    def _check_link(self, sending: _PendingCommand) -> None:
        if self._board.link is not sending.link:
            raise LinkError(
                "command_link_lost",
                f"The line to the board was lost while '{sending.command.name}' was on its way: "
                "nobody knows whether the board has it; see what it does and send it again.",
                command=sending.command.name,
            )

    def _send(self, command: Message, frame: bytes) -> None:
        if not self._board.write(frame):
            raise ConflictError(
                "board_line_full",
                f"'{command.name}' was not sent because the line to the board takes no more bytes: "
                "check the board, or lower the rates.",
                command=command.name,
            )

    def _sending(self, command: Message, arguments: tuple[float, ...], *, is_read_back: bool) -> _PendingCommand | None:
        """What will prove this command on this board; None if nothing can, or if the caller proves it."""
        frame, link = encode_command(command.name, *arguments), self._board.link
        if self._board.session.is_extended and self._board.capabilities().get("has_acknowledgements"):
            judge = AcknowledgementJudge(command.id, self._owed)
            return _PendingCommand(command, frame, link, "acknowledgement", _by_acknowledgement(judge), judge)
        proof, seen = self._effect(command, arguments)
        if seen is None or (is_read_back and proof == "read_back"):
            return None
        return _PendingCommand(command, frame, link, proof, seen, None)

    def _effect(self, command: Message, arguments: tuple[float, ...]) -> tuple[_Proof, Judge | None]:
        """How telemetry shows the effect of this command, for boards without acknowledgements."""
        confirm = command.confirm
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

    def _story(self, name: str, arguments: tuple[float, ...], client: str | None) -> CommandEvent:
        return CommandEvent(next(self._ids), name, list(arguments), client, "pending")

    def _tell(self, story: CommandEvent, result: CommandOutcome) -> None:
        self._outlet.event(replace(story, state=result.state, by=result.by, ms=result.ms, reason=result.reason))


def _by_acknowledgement(judge: AcknowledgementJudge) -> Judge:
    def seen(frame: Frame, meant: Meaning) -> Verdict | None:
        found = judge(frame, meant)
        if found is None:
            return None
        is_done, result = found
        return ("confirmed", None) if is_done else ("rejected", cast(CommandReason, result))

    return seen


def _end_of(story: CommandEvent, error: BaseException) -> CommandEvent:
    """Outcome of an aborted command: "rejected" only if it was never sent, for otherwise nobody knows."""
    if isinstance(error, GatewayError) and error.code == "board_line_full":
        return replace(story, state="rejected", reason="not_sent")
    return replace(story, state="timed_out")


def _reads_back(parameter: str, wanted: float) -> Judge:
    def judge(frame: Frame, meant: Meaning) -> Verdict | None:
        if frame.message.name != "autopilot_parameters":
            return None
        return ("confirmed", None) if not differing({parameter: wanted}, meant.values) else ("rejected", "not_taken")

    return judge
