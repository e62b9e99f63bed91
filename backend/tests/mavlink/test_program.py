"""What the program takes on its command line, and what it refuses to open."""

from __future__ import annotations

from pathlib import Path

import pytest
from typer.testing import CliRunner

from epf_gcs.mavlink.__main__ import app


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--aircraft", "glider"], "no aircraft 'glider'"),
        (["--udp", "10.0.0.5:14550"], "--signing-key-file"),
        (["--tcp", "0.0.0.0:5760"], "--signing-key-file"),
        (["--udp", "nowhere"], "HOST:PORT"),
        (["--udp", "127.0.0.1:99999"], "HOST:PORT"),
        (["--home", "27.9,-15.4"], "LATITUDE,LONGITUDE,METRES"),
        (["--key-file", "/nowhere/key"], "cannot be read"),
    ],
)
def test_a_choice_that_cannot_be_is_refused_in_words(arguments: list[str], words: str) -> None:
    result = CliRunner().invoke(app, arguments)
    assert result.exit_code == 2
    assert words in result.output
    assert "Traceback" not in result.output


def test_a_signing_key_of_another_length_is_refused(tmp_path: Path) -> None:
    (tmp_path / "key").write_bytes(b"short")
    result = CliRunner().invoke(app, ["--signing-key-file", str(tmp_path / "key")])
    assert (result.exit_code, "32" in result.output) == (2, True)
