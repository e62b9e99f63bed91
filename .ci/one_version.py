"""Fail when a version of the project is said in a second place.

Usage: one_version.py ROOT

The station's version is said in backend/pyproject.toml; everything else asks for it (`epf_gcs.__version__`; the page
shows the gateway's answer). The board's firmware has a version of its own, because it stays on boards when the
station is renewed; it is said in one header. The newest release in CHANGELOG.md must be the station's version, or come
before it while the next one is under way (1.2.0.dev0): what is built in between is newer than what was released.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from packaging.version import Version

SOURCE: Final = "backend/pyproject.toml"
PACKAGES: Final = ("frontend/package", "e2e/package")
# What looks like a version of ours: a name that ends in "version", then a number of three parts.
_SAID: Final = re.compile(r"""version["']?\s*(?::\s*\w+\s*)?[:=]?\s*["'](\d+\.\d+\.\d+)["']""", re.IGNORECASE)
_FIRMWARE: Final = "BOARD_FIRMWARE_VERSION"
_ENDINGS: Final = frozenset(
    {".py", ".ts", ".tsx", ".mjs", ".json", ".toml", ".html", ".yml", ".c", ".h", ".mk", ".sh", ".cfg"}
)
_NAMES: Final = frozenset({"Makefile", "Dockerfile"})
# Versions of something else, and what tests make up.
_NOT_OURS: Final = re.compile(
    r"(^|/)(third_party|tests?|board_tests|definition|vectors|public)/|\.test\.tsx?$|package-lock\.json$"
    r"|^backend/src/epf_gcs/(formats/|web/interface/maps/routes\.py$)"  # of other programs' file formats
)
_RELEASE: Final = re.compile(r"^## (\d+\.\d+\.\d+)\b", re.MULTILINE)


def second_versions(root: Path, files: list[str]) -> Iterator[str]:
    """Yield a sentence for each place beside the source."""
    firmware = []
    for name in files:
        path = root / name
        if name == SOURCE or _NOT_OURS.search(name) or (path.suffix not in _ENDINGS and path.name not in _NAMES):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if _SAID.search(line) is None:
                continue
            if _FIRMWARE in line:
                firmware.append(f"{name}:{number}")
            else:
                yield f"{name}:{number} says a version: it is said in {SOURCE} alone"
    if len(firmware) != 1:
        yield f"the firmware's version is said {len(firmware)} times and not once: {', '.join(firmware)}"


def of_packages(root: Path) -> Iterator[str]:
    """Yield a sentence for each private package of ours that has a version."""
    for name in PACKAGES:
        if "version" in json.loads((root / f"{name}.json").read_text(encoding="utf-8")):
            yield f"{name}.json has a version: private packages need none"
        lock = json.loads((root / f"{name}-lock.json").read_text(encoding="utf-8"))
        if "version" in lock or "version" in lock["packages"][""]:
            yield f"{name}-lock.json has a version of the package itself"


def of_releases(root: Path, version: str) -> Iterator[str]:
    """Yield a sentence where the newest release does not go with this version."""
    found = _RELEASE.search((root / "CHANGELOG.md").read_text(encoding="utf-8"))
    newest = Version(found[1] if found else "0")
    is_right = newest < Version(version) if Version(version).is_devrelease else newest == Version(version)
    if not is_right:
        yield f"the newest release in CHANGELOG.md is {newest}, the version is {version}"


def main(root: Path) -> int:
    """Check the tree below `root`; return the exit code."""
    version = tomllib.loads((root / SOURCE).read_text(encoding="utf-8"))["project"]["version"]
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True)
    files = [name for name in listed.stdout.split("\0") if name and (root / name).is_file()]
    found = [*second_versions(root, files), *of_packages(root), *of_releases(root, version)]
    print("\n".join(found) if found else f"version: {version}, said once")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
