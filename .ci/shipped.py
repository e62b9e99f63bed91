"""What the product is made of besides our own code: the gateway's packages, the page's, the board's, the map's data.

Read from what is installed and locked, so that the bill of materials (`sbom.py`) and the licence texts cannot tell of
something else than what ships. The gateway itself need not be installed: an image is built before it is.
"""

from __future__ import annotations

import base64
import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import Distribution, distribution
from pathlib import Path
from typing import Any, Final, Literal
from urllib.parse import quote

from packaging.requirements import Requirement

PROJECT: Final = "backend/pyproject.toml"
PAGE_LOCK: Final = "frontend/package-lock.json"
MAP_DATA: Final = "frontend/scripts/mapData.json"
THIRD_PARTY: Final = "firmware/third_party"
# What the board's program holds of others, by folder: name, version, licence, where it is. Only its tests hold cmocka.
IN_BOARD: Final = {
    "freertos": ("FreeRTOS-Kernel", "11.2.0", "MIT", "pkg:github/FreeRTOS/FreeRTOS-Kernel@V11.2.0"),
    "littlefs": ("littlefs", "2.9", "BSD-3-Clause", "pkg:github/littlefs-project/littlefs@v2.9.0"),
}
_TEXT: Final = re.compile(r"(^|/)(licen[cs]e|copying|notice|copyright)[^/]*$", re.IGNORECASE)
# A longer value in the licence field is the full text of the licence, not its name.
_LONGEST_NAME: Final = 80
_CLASSIFIER: Final = "License :: "

Part = Literal["gateway", "page", "board", "map"]


@dataclass(frozen=True, slots=True)
class Component:
    """Something of others. `licence` as it names it itself; `purl` is the package URL, and the same for no other.

    `needs`: package URLs. `sha512`: of the file that the page's lock names, in hexadecimal.
    """

    part: Part
    name: str
    version: str
    licence: str | None
    purl: str
    needs: tuple[str, ...] = ()
    is_optional: bool = False
    sha512: str | None = None


def version(root: Path) -> str:
    """The product's own version."""
    said: str = _project(root)["version"]
    return said


def components(root: Path) -> list[Component]:
    """All of it, in a fixed order."""
    return [*of_gateway(root), *of_page(root), *of_board(root), *of_map(root)]


def of_gateway(root: Path) -> list[Component]:
    """The packages that the gateway needs here, and those of its extras. Raises PackageNotFoundError."""
    project = _project(root)
    needed = _closure([Requirement(line) for line in project["dependencies"]])
    extras = [line for name in ("sim", "maps", "flights") for line in project["optional-dependencies"][name]]
    everything = needed | _closure([Requirement(line) for line in extras])
    found = []
    for key in sorted(everything):
        package = everything[key]
        needs = sorted({_pypi(distribution(one.name)) for one in _requirements(package, frozenset())})
        found.append(
            Component(
                "gateway",
                package.metadata["Name"],
                package.version,
                _licence(package),
                _pypi(package),
                tuple(needs),
                is_optional=key not in needed,
            )
        )
    return found


def of_page(root: Path) -> list[Component]:
    """The packages whose code is in the built page."""
    locked: dict[str, dict[str, Any]] = json.loads((root / PAGE_LOCK).read_text(encoding="utf-8"))["packages"]
    shipped = {
        path: entry
        for path, entry in locked.items()
        if path and not entry.get("dev") and not entry.get("devOptional") and not entry.get("link")
    }
    found = []
    for path in sorted(shipped):
        entry = shipped[path]
        needs = {
            _npm(at, shipped[at]) for name in entry.get("dependencies", ()) if (at := _beside(path, name, shipped))
        }
        algorithm, _, digest = entry["integrity"].partition("-")
        found.append(
            Component(
                "page",
                _npm_name(path),
                entry["version"],
                entry.get("license"),
                _npm(path, entry),
                tuple(sorted(needs)),
                sha512=base64.b64decode(digest).hex() if algorithm == "sha512" else None,
            )
        )
    return found


def of_board(root: Path) -> Iterator[Component]:
    """What is compiled into the board's program. Raises ValueError where a README beside it says another version."""
    for folder, (name, number, licence, where) in IN_BOARD.items():
        readme = root / THIRD_PARTY / folder / "README.md"
        if number not in readme.read_text(encoding="utf-8"):
            raise ValueError(
                f"{THIRD_PARTY}/{folder}/README.md does not say {number}: put the new one into .ci/shipped.py"
            )
        yield Component("board", name, number, licence, where)


def of_map(root: Path) -> Iterator[Component]:
    """Data of others on the map."""
    for entry in json.loads((root / MAP_DATA).read_text(encoding="utf-8")):
        name, told = entry["name"], entry["version"]
        where = f"pkg:generic/{quote(name, safe='')}" + (f"@{quote(told, safe='')}" if told else "")
        yield Component("map", name, told, entry["licence"], where)


def texts(root: Path) -> Iterator[tuple[Component, str]]:
    """The licence texts of the gateway's packages and of what the board's program holds.

    Those of the page stand beside the page already. A package that brings no text is told with its licence's name.
    """
    for component in of_gateway(root):
        package = distribution(component.name)
        files = [path for path in package.files or () if _TEXT.search(str(path)) and ".dist-info/" in str(path)]
        read = [path.read_text(encoding="utf-8").strip() for path in sorted(files, key=str)]
        yield component, "\n\n".join(read) or f"Its package brings no text; it is under: {component.licence}."
    for component, folder in zip(of_board(root), IN_BOARD, strict=True):
        yield component, (root / THIRD_PARTY / folder / "LICENSE.md").read_text(encoding="utf-8").strip()


def _project(root: Path) -> dict[str, Any]:
    told: dict[str, Any] = tomllib.loads((root / PROJECT).read_text(encoding="utf-8"))["project"]
    return told


def _closure(todo: list[Requirement]) -> dict[str, Distribution]:
    """What these requirements need here, and what that needs. By name."""
    todo = [wanted for wanted in todo if wanted.marker is None or wanted.marker.evaluate({"extra": ""})]
    found: dict[str, Distribution] = {}
    seen: set[tuple[str, frozenset[str]]] = set()
    while todo:
        wanted = todo.pop()
        key = (_key(wanted.name), frozenset(wanted.extras))
        if key in seen:
            continue
        seen.add(key)
        package = found[key[0]] = distribution(wanted.name)
        todo += _requirements(package, key[1])
    return found


def _requirements(package: Distribution, extras: frozenset[str]) -> Iterator[Requirement]:
    for line in package.requires or ():
        wanted = Requirement(line)
        if wanted.marker is None or any(wanted.marker.evaluate({"extra": extra}) for extra in extras or {""}):
            yield wanted


def _key(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _pypi(package: Distribution) -> str:
    return f"pkg:pypi/{_key(package.metadata['Name'])}@{package.version}"


def _npm_name(path: str) -> str:
    return path.rpartition("node_modules/")[2]


def _npm(path: str, entry: Mapping[str, Any]) -> str:
    return f"pkg:npm/{quote(_npm_name(path))}@{entry['version']}"


def _beside(path: str, name: str, shipped: Mapping[str, object]) -> str | None:
    """Where Node finds a package for the one at `path`: in its own folder, else in the nearest one above."""
    at = path
    while True:
        found = f"{at}/node_modules/{name}" if at else f"node_modules/{name}"
        if found in shipped:
            return found
        if not at:
            return None
        at = at.rpartition("node_modules/")[0].rstrip("/")


def _licence(package: Distribution) -> str | None:
    """Its licence expression, else a short name, else its classifiers."""
    metadata = package.metadata
    for name in (*(metadata.get_all("License-Expression") or ()), *(metadata.get_all("License") or ())):
        if name.strip() and "\n" not in name and len(name) <= _LONGEST_NAME:
            return str(name.strip())
    filed = [
        line.rpartition(" :: ")[2] for line in metadata.get_all("Classifier") or () if line.startswith(_CLASSIFIER)
    ]
    return ", ".join(filed) or None
