"""Undo, redo and the journal over REST."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway, running_gateway


def journal(gateway: Gateway) -> dict[str, Any]:
    answer: dict[str, Any] = gateway.http.get("/parameters/journal").raise_for_status().json()
    return answer


def gain(answer: Any, name: str) -> dict[str, Any]:
    return next(one for one in answer.raise_for_status().json()["parameters"] if one["name"] == name)


def test_an_undo_and_a_redo_answer_like_a_write(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    written = gain(gateway.http.patch("/parameters", json={"k_pitch": 2.5}), "k_pitch")
    assert (written["value"], written["loaded"], written["state"]) == (2.5, 2.0, "confirmed")
    assert journal(gateway)["undo"] == [{"name": "k_pitch", "before": 2.5, "after": 2.0}]
    undone = gain(gateway.http.post("/parameters/undo"), "k_pitch")
    assert (undone["value"], undone["state"]) == (2.0, "confirmed")
    assert journal(gateway)["redo"] == [{"name": "k_pitch", "before": 2.0, "after": 2.5}]
    redone = gain(gateway.http.post("/parameters/redo"), "k_pitch")
    assert (redone["value"], redone["state"]) == (2.5, "confirmed")
    assert board.gains["k_pitch"] == 2.5
    assert [entry["kind"] for entry in journal(gateway)["entries"]] == ["redo", "undo", "write"]


def test_with_nothing_to_undo_or_redo_it_says_so(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    for action in ("undo", "redo"):
        answer = gateway.http.post(f"/parameters/{action}")
        assert (answer.status_code, answer.json()["code"]) == (409, f"nothing_to_{action}")
    assert journal(gateway) == {"entries": [], "undo": None, "redo": None}


def test_an_undo_without_a_board_says_that_there_is_none(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.patch("/parameters", json={"k_pitch": 2.5}).raise_for_status()
    gateway.http.delete("/links/board").raise_for_status()
    assert gateway.http.post("/parameters/undo").json()["code"] == "nothing_to_undo"
    assert journal(gateway)["undo"] is None
    assert len(journal(gateway)["entries"]) == 1


def test_the_journal_says_who_wrote_and_the_viewers_hear_of_it(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    with gateway.stream("?name=tablet") as operator, gateway.stream() as viewer:
        client = operator.hello["client"]
        refused = gateway.http.post("/parameters/undo", headers={"X-Client": viewer.hello["client"]})
        assert (refused.status_code, refused.json()["code"]) == (409, "control_held")
        gateway.http.patch("/parameters", json={"k_pitch": 2.5}, headers={"X-Client": client}).raise_for_status()
        entry = journal(gateway)["entries"][0]
        assert (entry["client"], entry["name"]) == (client, "tablet")
        undo = [{"name": "k_pitch", "before": 2.5, "after": 2.0}]
        for stream in (operator, viewer):
            assert stream.event("journal") == {"entry": entry, "undo": undo, "redo": None}
        gateway.http.delete("/links/board", headers={"X-Client": client}).raise_for_status()
        assert viewer.event("journal") == {"entry": None, "undo": None, "redo": None}


def test_the_journal_is_there_after_a_restart_and_the_steps_are_not(tmp_path: Path, board: FakeBoard) -> None:
    with running_gateway(tmp_path / "data") as gateway:
        gateway.open_board(board.url)
        gateway.http.patch("/parameters", json={"k_pitch": 2.5}).raise_for_status()
        before = journal(gateway)
    with running_gateway(tmp_path / "data") as gateway:
        assert journal(gateway) == {"entries": before["entries"], "undo": None, "redo": None}


def test_a_set_command_by_itself_is_a_step_too(gateway: Gateway, board: FakeBoard) -> None:
    gateway.open_board(board.url)
    gateway.http.post("/parameters/load").raise_for_status()
    sent = len(board.received)
    outcome = gateway.http.post("/commands/set_k_pitch", json={"value": 2.5}).json()
    assert (outcome["state"], outcome["by"]) == ("confirmed", "acknowledgement")
    assert board.received[sent:] == ["set_k_pitch"], "no more than the command goes out"
    assert gain(gateway.http.get("/parameters"), "k_pitch")["value"] == 2.5
    assert journal(gateway)["undo"] == [{"name": "k_pitch", "before": 2.5, "after": 2.0}]
