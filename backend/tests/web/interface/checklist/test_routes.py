"""The checklist over REST, and its file."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.errors import ConflictError
from epf_gcs.web.checklist.checklist_store import FILE_NAME, KeptChecklist
from epf_gcs.web.checklist.schemas import ChecklistChange
from tests.support.gateway import Gateway

LINES = [{"text": "Hélice y tren", "watched": None}, {"text": "GPS", "watched": "gps"}]


def test_the_list_is_nobodys_until_somebody_changes_it(gateway: Gateway) -> None:
    assert gateway.http.get("/checklist").json() == {"lines": None}


def test_a_changed_list_is_kept_and_told_to_all_and_can_be_given_back(gateway: Gateway) -> None:
    with gateway.stream() as stream:
        assert gateway.http.put("/checklist", json={"lines": LINES}).raise_for_status().json() == {"lines": LINES}
        stream.event("checklist")
        assert gateway.http.get("/checklist").json() == {"lines": LINES}
        assert gateway.http.delete("/checklist").raise_for_status().json() == {"lines": None}
        stream.event("checklist")
    assert gateway.http.get("/checklist").json() == {"lines": None}


@pytest.mark.parametrize(
    "lines",
    [
        [{"text": "", "watched": None}],
        [{"text": "  ", "watched": None}],
        [{"text": "x" * 201, "watched": None}],
        [{"text": "x", "watched": "weather"}],
        [{"text": "x", "watched": None}] * 101,
        [{"text": "x", "watched": None, "done": True}],
        [{"text": "x"}],
    ],
)
def test_what_is_no_list_is_refused_and_the_kept_one_stays(gateway: Gateway, lines: list[object]) -> None:
    gateway.http.put("/checklist", json={"lines": LINES}).raise_for_status()
    assert gateway.http.put("/checklist", json={"lines": lines}).status_code == 422
    assert gateway.http.get("/checklist").json() == {"lines": LINES}
    gateway.http.delete("/checklist").raise_for_status()


def test_a_damaged_file_is_kept_aside(tmp_path: Path) -> None:
    (tmp_path / FILE_NAME).write_bytes(b"\xff{")
    assert KeptChecklist(tmp_path).read().lines is None
    aside = [path for path in tmp_path.iterdir() if ".damaged-" in path.name]
    assert [path.read_bytes() for path in aside] == [b"\xff{"]


def test_a_disk_that_does_not_take_it_is_said(tmp_path: Path) -> None:
    kept = KeptChecklist(tmp_path / "gone")
    with pytest.raises(ConflictError, match="cannot be kept"):
        kept.write(ChecklistChange(lines=[]))
