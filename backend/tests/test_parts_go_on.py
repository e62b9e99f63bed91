"""Each part of a running station raises once in its turn, and has its next turn: nothing that repeats ends by a bug."""

from __future__ import annotations

import importlib
import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.web.serving.visitors import Limits
from tests.support.gateway import running_gateway
from tests.support.waiting import eventually

SOURCES = Path(__file__).parents[1] / "src" / "epf_gcs"
SOON_S = 0.05
# Module, class and function of each turn that comes in a station with emulated data and a viewer; the constants that
# say how rarely it comes are made short.
TURNS: dict[str, tuple[str, str, dict[str, float]]] = {
    "access.admission": ("Admission", "_write_last_heard", {"_WRITTEN_EVERY_S": SOON_S}),
    "access.control": ("Control", "_look", {}),
    "bus.vehicle_end": ("Broadcast", "_send_due", {}),
    "flight.flight": ("Flight", "_send_status", {}),
    "flight.hil.emulation": ("EmulationLink", "_step", {}),
    "flight.hil.hil": ("Hil", "show", {}),
    "flight.hil.simulator_faults": ("SimulatorFaultControl", "_look", {"_LOOK_S": SOON_S}),
    "flight.state.advised": ("AdviceWatch", "_look", {"_EVERY_S": SOON_S}),
    "flight.state.housekeeping": ("Housekeeping", "_tick", {}),
    "library.queries": ("Queries", "_look", {"_LOOK_EVERY_S": SOON_S}),
    "surroundings.watch": ("Surroundings", "look", {"_TICK_S": SOON_S, "_LOOK_S": SOON_S}),
    "track.tracks": ("Tracks", "_save", {"_SAVE_S": SOON_S}),
    "web.serving.connection": ("Connection", "look", {}),
    "web.state.whole": ("WholeStatus", "_send", {}),
    "web.station": ("Station", "_tell_alone", {"_STATUS_S": SOON_S}),
    "web.stream.hub": ("Hub", "_turn", {}),
    "web.stream.socket": ("SocketConnection", "_check_alive", {"_KEEPALIVE_S": SOON_S}),
}
# Where a turn needs a line, a simulator, a flood, a file or a certificate, the part's own tests have it.
ELSEWHERE = {
    "beacons.listener",
    "fields.progress",
    "flight.hil.simulator",
    "link.descriptor",
    "link.udp",
    "replay.vehicle_process",
    "replay.viewing",
    "tls.keeper",
    "web.replays.replay_conversation",
    "web.serving.doorway",
}


def test_every_part_has_its_next_turn_after_one_that_raised(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    turns: Counter[str] = Counter()
    for module, (owner, name, constants) in TURNS.items():
        for constant, value in constants.items():
            monkeypatch.setattr(f"epf_gcs.{module}.{constant}", value)
        part = getattr(importlib.import_module(f"epf_gcs.{module}"), owner)
        monkeypatch.setattr(part, name, raising_once(module, getattr(part, name), turns))
    with (
        running_gateway(tmp_path, Limits(), recording=False, board="emulation:") as gateway,
        # Not in step with the emulated board's samples: each would come just when it may leave, and none would wait.
        gateway.stream("?rate=33") as stream,
        gateway.stream("?rate=33") as other,
    ):

        def goes_on(part: str) -> bool:
            stream.next("batch")
            other.next("batch")
            return turns[part] > 2

        for part in TURNS:
            eventually(lambda part=part: goes_on(part), f"{part} has turns after the one that raised")  # type: ignore[misc]
        errors = gateway.status()["errors"]
    assert errors["internal"] >= len(TURNS), "each is counted, so that somebody looks"


def raising_once(module: str, turn: Callable[..., Any], turns: Counter[str]) -> Callable[..., Any]:
    def faulty(*arguments: Any) -> Any:
        turns[module] += 1
        if turns[module] == 1:
            raise ZeroDivisionError
        if module == "web.stream.socket":
            # So short a keepalive would put out a viewer that a busy computer holds up for a moment.
            arguments[0]._answered = True
        return turn(*arguments)

    return faulty


def test_each_part_that_repeats_is_among_them() -> None:
    repeats = {
        str(file.relative_to(SOURCES).with_suffix("")).replace("/", ".")
        for file in SOURCES.rglob("*.py")
        if re.search(r"import .*\b(Repeating|repeat)\b", file.read_text()) and file.name != "repeating.py"
    }
    assert repeats == set(TURNS) | ELSEWHERE
