"""Whether a data folder was ever set up, by what is in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.errors import NotKeptError
from epf_gcs.web.setup.first_start import FirstStart


def test_a_folder_that_has_only_what_a_start_makes_was_not_set_up(tmp_path: Path) -> None:
    assert FirstStart(tmp_path / "none").is_due()
    for name in ("format.json", "flight.json", "listening.json", ".lock", "access.sqlite"):
        (tmp_path / name).touch()
    (tmp_path / "state.json").write_text(
        '{"board_url": null, "simulator": null, "recording": {"delete_oldest": false}}'
    )
    (tmp_path / "recordings").mkdir()
    assert FirstStart(tmp_path).is_due()


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("state.json", '{"board_url": "tcp://board:5760", "simulator": null}'),
        ("state.json", '{"board_url": null, "simulator": {"send_port": 49000}}'),
        ("state.json", "cut o"),
        ("recordings/20260131T120000Z.mcap", ""),
    ],
)
def test_one_with_a_link_or_a_flight_was_and_one_that_cannot_be_read(tmp_path: Path, path: str, text: str) -> None:
    (tmp_path / path).parent.mkdir(exist_ok=True)
    (tmp_path / path).write_text(text)
    assert not FirstStart(tmp_path).is_due()


def test_that_it_is_over_is_remembered(tmp_path: Path) -> None:
    FirstStart(tmp_path).end()
    assert not FirstStart(tmp_path).is_due()


def test_a_disk_that_does_not_take_it_is_said(tmp_path: Path) -> None:
    with pytest.raises(NotKeptError, match="cannot be kept"):
        FirstStart(tmp_path / "gone").end()
