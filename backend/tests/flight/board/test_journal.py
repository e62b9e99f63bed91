"""The journal of what was written: kept, told, and whole whatever the file holds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import orjson
import pytest

from epf_gcs.clock import Clock
from epf_gcs.contract.answers import ParameterChange
from epf_gcs.contract.events import Event
from epf_gcs.errors import GatewayError
from epf_gcs.flight.board.journal import Journal
from epf_gcs.vehicle.journal import Steps
from tests.support.contract import as_told
from tests.support.files import the_one_like
from tests.support.outlet import KeptOutlet

pytestmark = pytest.mark.anyio

CHANGE = ParameterChange("k_pitch", 2.0, 2.5, "confirmed")


class Told(KeptOutlet):
    """An outlet that remembers its events."""

    def __init__(self) -> None:
        super().__init__()
        self.events: list[dict[str, Any]] = []

    def event(self, event: Event, /) -> None:
        kind, data = as_told(event)
        assert kind == "journal"
        self.events.append(data)


def a_journal(path: Path) -> tuple[Journal, Told, list[GatewayError]]:
    outlet, reported = Told(), list[GatewayError]()
    names = {"c1": "tablet"}
    return Journal(path, clock=Clock(), outlet=outlet, report=reported.append, name_of=names.get), outlet, reported


async def test_an_entry_says_who_when_and_what_and_is_there_after_a_restart(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    journal, _, reported = a_journal(path)
    journal.note("write", [CHANGE], "c1", undoable=True)
    journal.note("write", [ParameterChange("k_roll", None, 3.0, "rejected")], None, undoable=True)
    journal.close()
    again, _, _ = a_journal(path)
    newest, first = again.entries
    assert (first.id, first.client, first.name, first.state) == (1, "c1", "tablet", "confirmed")
    assert abs(first.t_s - Clock().now_s()) < 60
    assert (newest.id, newest.client, newest.name, newest.state) == (2, None, None, "rejected")
    assert again.steps == Steps(), "another board may be there by now"
    again.note("write", [CHANGE], None, undoable=True)
    assert again.entries[0].id == 3
    again.close()
    assert reported == []


async def test_viewers_hear_of_each_entry_and_of_what_can_be_undone(tmp_path: Path) -> None:
    journal, outlet, _ = a_journal(tmp_path / "journal.jsonl")
    journal.note("write", [CHANGE], "c1", undoable=True)
    (event,) = outlet.events
    assert event["entry"] == orjson.loads(orjson.dumps(journal.entries[0]))
    assert event["undo"] == [{"name": "k_pitch", "before": 2.5, "after": 2.0}]
    assert event["redo"] is None
    journal.forget_steps()
    assert outlet.events[1:] == [{"entry": None, "undo": None, "redo": None}]
    journal.forget_steps()
    assert len(outlet.events) == 2, "nothing changed, nothing is told"
    journal.close()


async def test_a_write_to_a_board_that_is_gone_is_told_but_cannot_be_undone(tmp_path: Path) -> None:
    journal, _, _ = a_journal(tmp_path / "journal.jsonl")
    journal.note("write", [ParameterChange("k_pitch", 2.0, 2.5, "timed_out")], None, undoable=False)
    assert [entry.state for entry in journal.entries] == ["timed_out"]
    assert journal.steps.undo is None
    journal.close()


async def test_only_the_newest_thousand_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "journal.jsonl"
    journal, _, _ = a_journal(path)
    for _ in range(1100):
        journal.note("write", [CHANGE], None, undoable=True)
    assert [entry.id for entry in journal.entries] == list(range(1100, 100, -1))
    journal.close()
    again, _, _ = a_journal(path)
    assert [entry.id for entry in again.entries] == list(range(1100, 100, -1))
    again.close()
    assert len(path.read_bytes().splitlines()) == 1000


@pytest.mark.parametrize(
    "rubbish", [b"\xff\xfe", b"[]", b"{}", b"7", b'{"id": 1, "t_s"', b'{"id":1,"t_s":1,"kind":"wish","changes":[]}']
)
async def test_lines_that_make_no_sense_are_told_and_kept_aside_and_the_rest_counts(
    tmp_path: Path, rubbish: bytes
) -> None:
    path = tmp_path / "journal.jsonl"
    journal, _, _ = a_journal(path)
    journal.note("write", [CHANGE], None, undoable=True)
    journal.close()
    path.write_bytes(rubbish + b"\n" + path.read_bytes())
    again, _, reported = a_journal(path)
    assert [entry.id for entry in again.entries] == [1]
    assert [error.code for error in reported] == ["journal_unreadable"]
    assert reported[0].params["reason"] == "1 of 2 lines make no sense"
    again.note("write", [CHANGE], None, undoable=True)
    again.close()
    third, _, silent = a_journal(path)
    assert [entry.id for entry in third.entries] == [2, 1]
    assert silent == []
    third.close()
    assert rubbish in the_one_like(tmp_path, "journal.jsonl.damaged-*").read_bytes()


async def test_a_file_that_cannot_be_read_is_told_and_the_journal_goes_on(tmp_path: Path) -> None:
    (tmp_path / "journal.jsonl").mkdir()
    journal, outlet, reported = a_journal(tmp_path / "journal.jsonl")
    assert [(error.code, error.params["reason"]) for error in reported] == [("journal_unreadable", "Is a directory")]
    journal.note("write", [CHANGE], None, undoable=True)
    assert [entry.id for entry in journal.entries] == [1]
    assert len(outlet.events) == 1
    journal.close()
