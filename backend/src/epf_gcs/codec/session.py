"""The life of one connection to a board: text mode, binary mode, what the board can do, and the end.

States and what moves them:

    closed  --open-->  opening  --first heartbeat-->  asking  --capabilities-->  extended
                          ^                              |
                          |                              +--500 ms without answer-->  legacy --late answer--> extended
                          +--heartbeat silent for 3 s (the board restarted in text mode)--+

A deployed board is asked once, and sends no extension frame. A board that sends one without having answered is asked
again, `MOST_QUESTIONS` times in all.

In `opening` the line that opens binary mode is repeated each second. In every state `close` gives the bytes
that stop the board's streams and put it into text mode. The time is an argument of each call.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any, Final

from epf_gcs.codec.encode import EMPTY_COMMANDS
from epf_gcs.codec.frame import Frame
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE
from epf_gcs.codec.values import Json, meaning

CAPABILITIES_TIMEOUT_S: Final = 0.5
MOST_QUESTIONS: Final = 3
"""How many times one opening asks for the capabilities, at the most."""
OPEN_REPEAT_S: Final = 1.0
HEARTBEAT_SILENCE_S: Final = 3.0
"""Silence after which the board is taken to be in text mode again. A heartbeat may be rarer when the
parameter task was made slower than this: see `expect_heartbeat_every`."""


class SessionState(StrEnum):
    """Where the dialogue stands; `legacy` and `extended` are the open states."""

    CLOSED = "closed"
    OPENING = "opening"
    ASKING = "asking"
    LEGACY = "legacy"
    EXTENDED = "extended"


class Session:
    """Opening, watching and closing the dialogue with one board."""

    def __init__(self) -> None:
        self.state = SessionState.CLOSED
        self.capabilities: dict[str, Json] | None = None
        self.heartbeat_s: float | None = None
        self._silence_s = HEARTBEAT_SILENCE_S
        self._next_s: float | None = None
        self._questions = 0
        self._asked_s = 0.0
        # A frame came that no deployed board sends.
        self._has_extensions = False

    @property
    def is_open(self) -> bool:
        """The board is in binary mode and it is known which extensions it has."""
        return self.state in (SessionState.LEGACY, SessionState.EXTENDED)

    @property
    def is_extended(self) -> bool:
        """Extension frames may be sent."""
        return self.state is SessionState.EXTENDED

    @property
    def deadline_s(self) -> float | None:
        """When `tick` has something to do next; None when never."""
        return self._next_s

    def heartbeat_age_s(self, now_s: float) -> float | None:
        """Time since the last heartbeat, None before the first of this connection."""
        return None if self.heartbeat_s is None else now_s - self.heartbeat_s

    def expect_heartbeat_every(self, period_s: float) -> None:
        """The parameter task's period was changed: three missed heartbeats count as silence, 3 s at the least."""
        self._silence_s = max(HEARTBEAT_SILENCE_S, 3 * period_s)

    def open(self, now_s: float) -> bytes:
        """Start the dialogue; returns the bytes to send."""
        self.heartbeat_s = None
        self._silence_s = HEARTBEAT_SILENCE_S
        return self._reopen(now_s)

    def on_frame(self, frame: Frame, now_s: float) -> bytes:
        """Take a frame from the board; returns the bytes to send."""
        if self.state is SessionState.CLOSED:
            return b""
        if frame.message.name == "heartbeat":
            return self._on_heartbeat(now_s)
        if frame.message.name == "capabilities" and self.state is not SessionState.OPENING:
            self.capabilities = meaning(frame).values
            self.state = SessionState.EXTENDED
            self._watch_heartbeat(now_s)
        elif frame.message.extension:
            self._has_extensions = True
            if self.state is SessionState.LEGACY and now_s - self._asked_s >= CAPABILITIES_TIMEOUT_S:
                return self._ask_again(now_s)
        return b""

    def tick(self, now_s: float) -> bytes:
        """Do what is due at `now_s`; returns the bytes to send."""
        if self._next_s is None or now_s < self._next_s:
            return b""
        if self.state is SessionState.ASKING:
            question = self._ask_again(now_s)
            if question:
                self._next_s = now_s + CAPABILITIES_TIMEOUT_S
                return question
            self.state = SessionState.LEGACY
            self._watch_heartbeat(now_s)
            return b""
        return self._reopen(now_s)

    def close(self) -> bytes:
        """End the dialogue; returns the bytes that stop all streams and leave binary mode."""
        was_closed = self.state is SessionState.CLOSED
        self.state = SessionState.CLOSED
        self._next_s = None
        return b"" if was_closed else EMPTY_COMMANDS["stop"] + EMPTY_COMMANDS["exit_binary_mode"]

    def kept(self) -> list[Any]:
        """Where the dialogue stands, as plain values for `restore`."""
        return [str(self.state), self.capabilities, self.heartbeat_s, self._silence_s, self._next_s]

    def restore(self, kept: list[Any]) -> None:
        """Go on from a state that `kept` gave."""
        state, self.capabilities, self.heartbeat_s, self._silence_s, self._next_s = kept
        self.state = SessionState(state)

    def _reopen(self, now_s: float) -> bytes:
        self.state = SessionState.OPENING
        self.capabilities = None
        self._questions = 0
        self._has_extensions = False
        self._next_s = now_s + OPEN_REPEAT_S
        return OPEN_BINARY_MODE

    def _on_heartbeat(self, now_s: float) -> bytes:
        self.heartbeat_s = now_s
        if self.state is SessionState.OPENING:
            self.state = SessionState.ASKING
            self._next_s = now_s + CAPABILITIES_TIMEOUT_S
            return self._ask(now_s)
        if self.is_open:
            self._watch_heartbeat(now_s)
        return b""

    def _ask_again(self, now_s: float) -> bytes:
        return self._ask(now_s) if self._has_extensions and self._questions < MOST_QUESTIONS else b""

    def _ask(self, now_s: float) -> bytes:
        self._questions += 1
        self._asked_s = now_s
        return EMPTY_COMMANDS["capabilities"]

    def _watch_heartbeat(self, now_s: float) -> None:
        heard_s = now_s if self.heartbeat_s is None else self.heartbeat_s
        self._next_s = heard_s + self._silence_s
