"""Print the notes of a release: its part of CHANGELOG.md.

Usage: notes.py ROOT [TAG]. With a tag (v1.2.3) it has to be the version that backend/pyproject.toml says, its part has
to be the newest, and nothing may stand under Unreleased: that would ship and be told nowhere.
"""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path
from typing import Final

_HEADING: Final = re.compile(r"^## (.+)$", re.MULTILINE)
_UNRELEASED: Final = "Unreleased"


class NotesError(Exception):
    """A sentence that says why there are none."""


def parts(changelog: str) -> dict[str, str]:
    """The text of each part, by the first word of its heading, the newest first."""
    pieces = _HEADING.split(changelog)[1:]
    return {heading.split()[0]: text.strip() for heading, text in zip(pieces[::2], pieces[1::2], strict=True)}


def notes(changelog: str, version: str, tag: str | None = None) -> str:
    """The part of this version. Raises NotesError."""
    found = parts(changelog)
    if ".dev" in version:
        raise NotesError(f"{version} is under way: a release takes its number first (CONTRIBUTING.md)")
    if tag is not None:
        if tag != f"v{version}":
            raise NotesError(f"the tag is {tag} and the version is {version}: the tag has to be v{version}")
        if found.pop(_UNRELEASED, ""):
            raise NotesError(f"CHANGELOG.md has something under {_UNRELEASED}: put it under {version}")
        if next(iter(found), None) != version:
            raise NotesError(f"the newest part of CHANGELOG.md is {next(iter(found), 'missing')} and not {version}")
    if not found.get(version):
        raise NotesError(f"CHANGELOG.md tells nothing of {version}")
    return found[version]


def main() -> int:
    """Print them; returns the exit code."""
    root, tag = Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else None
    version = tomllib.loads((root / "backend" / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    try:
        print(notes((root / "CHANGELOG.md").read_text(encoding="utf-8"), version, tag))
    except NotesError as error:
        print(f"notes: {error}.", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
