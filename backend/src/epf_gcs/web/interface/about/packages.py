"""The packages this program needs at run time, and their licences."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from typing import Final

from packaging.requirements import InvalidRequirement, Requirement

from epf_gcs.extras import ALL

_OURS: Final = "epf-gcs"
# What a user may have installed besides; it is listed where it is there.
_EXTRAS: Final = frozenset(extra.name for extra in ALL)
_LICENCE_CLASSIFIER: Final = "License :: "
# A longer value in the licence field is the full text of the licence, not its name.
_LONGEST_NAME: Final = 80


@dataclass(frozen=True, slots=True)
class Package:
    """An installed package; `licence` is None if the package states none."""

    name: str
    version: str
    licence: str | None


@lru_cache(maxsize=1)
def packages() -> tuple[Package, ...]:
    """All packages that are needed at run time, by name. Reads many small files the first time."""
    found: dict[str, Package] = {}
    todo: list[tuple[str, frozenset[str]]] = [(_OURS, _EXTRAS)]
    seen: set[tuple[str, frozenset[str]]] = set()
    while todo:
        wanted = todo.pop()
        if wanted in seen:
            continue
        seen.add(wanted)
        name, extras = wanted
        try:
            package = distribution(name)
        except PackageNotFoundError:
            continue  # for another system or Python than this
        todo += [needed for line in package.requires or () if (needed := needed_by(line, extras)) is not None]
        key = name.lower().replace("_", "-")
        if key != _OURS:
            found[key] = Package(package.metadata["Name"], package.version, licence_of(package))
    return tuple(found[key] for key in sorted(found))


def needed_by(requirement: str, extras: frozenset[str]) -> tuple[str, frozenset[str]] | None:
    """Name and extras of a requirement; None if only another system, another Python or an unused extra needs it."""
    try:
        wanted = Requirement(requirement)
    except InvalidRequirement:
        return None
    marker = wanted.marker
    if marker is not None and not any(marker.evaluate({"extra": extra}) for extra in extras or {""}):
        return None
    return wanted.name, frozenset(wanted.extras)


def licence_of(package: Distribution) -> str | None:
    """The package's licence: its licence expression, else a short name, else its trove classifier."""
    metadata = package.metadata
    for name in (*(metadata.get_all("License-Expression") or ()), *(metadata.get_all("License") or ())):
        if name.strip() and "\n" not in name and len(name) <= _LONGEST_NAME:
            return str(name.strip())
    filed = [
        line.rsplit(" :: ", 1)[-1]
        for line in metadata.get_all("Classifier") or []
        if line.startswith(_LICENCE_CLASSIFIER) and line.count(" :: ") > 1
    ]
    return ", ".join(filed) or None
