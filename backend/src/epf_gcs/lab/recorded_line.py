"""What a recording holds of the board's line, as frames: what the board was told, and what it answered."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from epf_gcs.codec.encode import encode_command, frame_bytes
from epf_gcs.codec.frame import FROM_BOARD, TO_BOARD, Damage, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import OPEN_BINARY_MODE, ROUTES
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import meaning
from epf_gcs.contract.own_topics import OWN_TYPE_WORDS
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.routes import Route
from epf_gcs.recordings import notes
from epf_gcs.recordings.notes import Note
from epf_gcs.recordings.reading import Message, RecordingError, walk
from epf_gcs.recordings.topics import BOARD_RECEIVED, BOARD_SENT
from epf_gcs.vehicle.noted import noted_messages

SURFACES: Final = "hil_surfaces"
STEP: Final = "hil_step"


@dataclass(frozen=True, slots=True)
class Told:
    """A command, or the greeting that opens the line, `name` of which is empty; `t_s` since the recording began."""

    t_s: float
    name: str
    data: bytes


@dataclass(slots=True)
class Answered:
    """A frame of the board. `step`: when the board took what this answers (ms of its clock), and how much it integrated
    (s); None where it does not tell."""

    t_s: float
    frame: Frame
    step: tuple[int, float] | None = None


@dataclass(slots=True)
class RecordedLine:
    """Both ways of the line, each in its order. `before`: commands that give a board the gains, modes and plan that the
    recorded one had already. `damaged_at_s`: where the first frame of the board is damaged; what follows is left out,
    because nobody knows any more which answer belongs to which command. `has_receiver`: the stick came from the board's
    receiver for a while, which is in no recording."""

    told: list[Told] = field(default_factory=list)
    answered: list[Answered] = field(default_factory=list)
    before: list[bytes] = field(default_factory=list)
    damaged_at_s: float | None = None
    has_receiver: bool = False

    @property
    def has_steps(self) -> bool:
        """Whether the board told the times of all its steps; that of the last one may be cut off."""
        steps = [one.step for one in self.answered if one.frame.message.name == SURFACES]
        return None not in (steps[:-1] or steps)

    def period_s(self) -> float:
        """Time of every step, where all are equal; else 0: the board measures it."""
        taken = [one.step[1] for one in self.answered if one.step is not None]
        whole = {step_s for step_s in taken if step_s > 0.0}
        return whole.pop() if len(whole) == 1 and taken[0] > 0.0 else 0.0


def read_line(path: Path) -> RecordedLine:
    """Read a recording. Raises LabError for another kind of file, or one without a HIL flight."""
    line, reader = RecordedLine(), _Reader()
    try:
        for item in walk(path):
            reader.take(line, item)
            if line.damaged_at_s is not None:
                break
    except (OSError, RecordingError, KeyError, TypeError, ValueError) as error:
        raise LabError(f"{path} cannot be read as a recording: {error}") from error
    if not any(one.frame.message.name == SURFACES for one in line.answered):
        raise LabError(f"{path} holds no answer of a board to a simulator: nothing can be flown again")
    line.before = reader.known.commands()
    return line


class _Reader:
    def __init__(self) -> None:
        self._sent, self._received = FrameDecoder(TO_BOARD), FrameDecoder(FROM_BOARD)
        self._start_ns: int | None = None
        self._has_flown = False
        self.known = _Known()

    def take(self, line: RecordedLine, item: Message | Note) -> None:
        if isinstance(item, Note):
            self._note(item)
            return
        if self._start_ns is None:
            self._start_ns = item.t_ns
        t_s = (item.t_ns - self._start_ns) / 1e9
        if item.channel == BOARD_SENT:
            for told in self._told(t_s, item.data):
                self.known.told(told.name)
                line.told.append(told)
        elif item.channel == BOARD_RECEIVED:
            for found in self._received.feed(item.data):
                if isinstance(found, Frame):
                    self._answer(line, t_s, found)
                elif found.is_failed_frame:
                    line.damaged_at_s = t_s
                    return

    def _note(self, note: Note) -> None:
        self.known.note(note)
        own = noted_messages(note)
        if own is not None:
            self._received.learn(own)

    def _told(self, t_s: float, data: bytes) -> Iterator[Told]:
        for found in self._sent.feed(data):
            match found:
                case Frame(message=message, payload=payload):
                    yield Told(t_s, message.name, frame_bytes(TO_BOARD, message, payload))
                case Damage(data=text) if OPEN_BINARY_MODE in text:
                    yield Told(t_s, "", OPEN_BINARY_MODE)

    def _answer(self, line: RecordedLine, t_s: float, frame: Frame) -> None:
        if frame.message.name == STEP:
            newest = next((one for one in reversed(line.answered) if one.frame.message.name == SURFACES), None)
            if newest is not None and newest.step is None:
                newest.step = frame.values
            return
        if frame.type_id in OWN_TYPE_WORDS:
            return  # told by the clock, and no answer
        self.known.answered(frame)
        line.answered.append(Answered(t_s, frame))
        self._has_flown = self._has_flown or frame.message.name == SURFACES
        if self._has_flown and frame.message.name == "heartbeat":
            line.has_receiver = line.has_receiver or meaning(frame).values["source_joystick"] is False


class _Known:
    """What the board had before it was told anything else that is recorded."""

    def __init__(self) -> None:
        self._told: set[str] = set()
        self._commands: dict[str, list[bytes]] = {}

    def told(self, name: str) -> None:
        """A command was sent: what the board says from now on may come of it."""
        self._told.add(name)

    def answered(self, frame: Frame) -> None:
        """A frame came."""
        name = frame.message.name
        if name in self._commands:
            return
        values = meaning(frame).values
        if name == "autopilot_parameters" and not any(one.startswith("set_k_") for one in self._told):
            self._commands[name] = [
                encode_command(f"set_{gain}", number)
                for gain, number in values.items()
                if isinstance(number, int | float)
            ]
        elif name == "heartbeat" and not self._told & _SWITCHES:
            source = int(values["source_joystick"] is True)
            on = [command for flag, command in _MODES.items() if values[flag] is True]
            self._commands[name] = [encode_command("control_source", source), *map(encode_command, on)]

    def note(self, note: Note) -> None:
        """A note came."""
        said: Any = note.content
        is_first = notes.PLAN not in self._commands and not self._told & _PLANS
        if note.name == notes.PLAN and is_first and said["plan"] == "hil" and said["waypoints"]:
            plan = Route("recorded", tuple(Waypoint(**one) for one in said["waypoints"]))
            self._commands[notes.PLAN] = [encode_command(name, *values) for name, values in plan.commands()]

    def commands(self) -> list[bytes]:
        """What gives it to another board."""
        return [command for commands in self._commands.values() for command in commands]


_MODES: Final = {"autopilot_hil": "autopilot_on", "autotrim_hil": "autotrim_on"}
_SWITCHES: Final = frozenset({"control_source", "autopilot_on", "autopilot_off", "autotrim_on", "autotrim_off"})
_PLANS: Final = frozenset({"mission_commit", *(f"hil_load_{name}" for name in ROUTES)})
