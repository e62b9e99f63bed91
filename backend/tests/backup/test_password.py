"""A password of a backup is not too short, wherever it comes from."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.backup.errors import BackupError
from epf_gcs.backup.password import LONGEST, SHORTEST, check_password, password_in


@pytest.mark.parametrize("length", [0, SHORTEST - 1, LONGEST + 1])
def test_a_password_that_is_too_short_or_too_long_is_refused(length: int) -> None:
    with pytest.raises(BackupError, match="10 to 200 characters"):
        check_password("x" * length)


@pytest.mark.parametrize("text", ["contraseña larga\n", "contraseña larga", "contraseña larga\r\nmore\n"])
def test_the_first_line_of_a_file_is_the_password(tmp_path: Path, text: str) -> None:
    (tmp_path / "password").write_bytes(text.encode())
    assert password_in(tmp_path / "password") == "contraseña larga"


def test_a_file_that_is_no_text_is_said_to_be_none(tmp_path: Path) -> None:
    (tmp_path / "password").write_bytes(b"\xff" * 20)
    with pytest.raises(BackupError, match="no text in UTF-8"):
        password_in(tmp_path / "password")
