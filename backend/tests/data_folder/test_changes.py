"""What each change of the data folder's format does to its files."""

from __future__ import annotations

import json

import pytest

from epf_gcs.data_folder.changes import CHANGES, Changed, Files

CHOICE = {"enabled": True, "limit_bytes": 5, "sources": []}


def to(number: int, files: Files) -> Changed:
    (change,) = (one for one in CHANGES if one.to == number)
    return change.make(files)


def test_the_online_maps_of_version_0_1_0_get_a_file_of_their_own() -> None:
    made = to(2, {"state.json": json.dumps({"board_url": None, "online": CHOICE}).encode()})
    assert {name: json.loads(text or b"") for name, text in made.items()} == {
        "state.json": {"board_url": None},
        "online-maps.json": CHOICE,
    }


def test_a_later_choice_of_online_maps_is_kept() -> None:
    made = to(2, {"state.json": json.dumps({"online": CHOICE}).encode(), "online-maps.json": b'{"enabled": false}'})
    assert set(made) == {"state.json"}


@pytest.mark.parametrize("content", [b"{", b"[]", b"{}", b"5", b"\xff"])
def test_settings_that_make_no_sense_are_left_to_their_reader(content: bytes) -> None:
    assert to(2, {"state.json": content}) == {}


def test_a_folder_without_settings_has_nothing_to_change() -> None:
    assert to(2, {}) == {}
