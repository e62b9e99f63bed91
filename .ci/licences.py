"""Fail when a package that ships with the station has a licence that nobody has agreed to.

Usage: licences.py ROOT. Tools of the developers are not looked at: they do not ship.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from epf_gcs.web.interface.about.packages import packages

# All allow what we do: ship them unchanged with their texts, in a product under the MIT licence. The LGPL allows it for
# a library that the user can replace (jsbsim and pymavlink are packages of their own), the MPL for files that stay as
# they are.
ALLOWED: Final = frozenset(
    {
        *("0bsd", "apache-2.0", "bsd", "bsd license", "bsd-2-clause", "bsd-3-clause", "cc0-1.0", "isc", "isc license"),
        *("mit", "mit license", "mit-0", "mpl-2.0", "new bsd", "ofl-1.1", "psf-2.0", "psfl", "zlib"),
        *("gnu lesser general public license v2 or later (lgplv2+)", "lgplv3"),
    }
)


def is_allowed(licence: str | None) -> bool:
    """Whether each part of an expression that joins licences is allowed; with OR one that is allowed is enough."""
    if licence is None:
        return False
    text = licence.strip().lower()
    if text in ALLOWED:
        return True
    parts = [part for part in re.split(r"[()]|\band\b", text) if part.strip()]
    return bool(parts) and all(any(choice.strip() in ALLOWED for choice in re.split(r"\bor\b", part)) for part in parts)


def shipped(root: Path) -> Iterator[tuple[str, str | None]]:
    """Name and licence of every package that ships: of the gateway, then of the page."""
    for package in packages():
        yield package.name, package.licence
    lock = json.loads((root / "frontend" / "package-lock.json").read_text(encoding="utf-8"))
    for path, entry in lock["packages"].items():
        if path and not entry.get("dev") and not entry.get("devOptional"):
            yield path.rpartition("node_modules/")[2], entry.get("license")


def main() -> int:
    """Look at all of them; returns the exit code."""
    found = list(shipped(Path(sys.argv[1])))
    refused = [(name, licence) for name, licence in found if not is_allowed(licence)]
    for name, licence in refused:
        print(f"licences: {name} is under '{licence}': read it, then add it to .ci/licences.py or do without.")
    if not found or refused:
        return 1
    print(f"licences: {len(found)} packages ship, all under licences that were agreed to.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
