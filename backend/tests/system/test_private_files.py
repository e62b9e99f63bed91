"""Every program that may be started by itself closes its files to other users, whatever the habit of the shell."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

BACKEND = Path(__file__).parents[2]
PROGRAMS = tomllib.loads((BACKEND / "pyproject.toml").read_text())["project"]["scripts"]


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_program_begins_with_shutting_others_out_of_its_files(program: str) -> None:
    module = PROGRAMS[program].partition(":")[0]
    source = (BACKEND / "src" / f"{module.replace('.', '/')}.py").read_text()
    begins = re.search(r'^def main\(.*\n(?:    """(?:.|\n)*?"""\n)?(.*)\n', source, re.MULTILINE)
    assert begins is not None
    assert begins[1].strip() == "write_private_files()"
