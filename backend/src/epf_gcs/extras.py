"""Parts that only some need, and what installs them: each is an extra of the package, missing until it is asked for."""

from __future__ import annotations

import shlex
import sys
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, requires
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from packaging.requirements import InvalidRequirement, Requirement


@dataclass(frozen=True, slots=True)
class Extra:
    """`name` is what stands in the brackets of `epf-gcs[...]`; `modules` are what it brings; `what` needs them."""

    name: str
    modules: tuple[str, ...]
    what: str

    @property
    def is_here(self) -> bool:
        """Whether its modules are installed; loads none of them."""
        return all(find_spec(module) is not None for module in self.modules)

    def command(self) -> str:
        """What installs it here, beside this very program."""
        wanted = [shlex.quote(one) for one in self._requirements()]
        # pipx keeps each program in an environment of its own, without pip.
        if Path(sys.prefix).parent.name == "venvs" and "pipx" in Path(sys.prefix).parts:
            return f"pipx inject epf-gcs {' '.join(wanted)}"
        return f"{shlex.quote(sys.executable)} -m pip install {' '.join(wanted)}"

    def sentence(self) -> str:
        """That it is missing, and what to do."""
        return f"{self.what} needs {' and '.join(self.modules)}, which is not installed here: {self.command()}"

    def _requirements(self) -> list[str]:
        """The packages with their versions, as this package asks for them; the plain names if it is not installed."""
        try:
            lines = requires("epf-gcs") or []
        except PackageNotFoundError:
            lines = []
        found = [text for line in lines if (text := self._needed(line))]
        return found or list(self.modules)

    def _needed(self, line: str) -> str:
        try:
            wanted = Requirement(line)
        except InvalidRequirement:
            return ""
        marker = wanted.marker
        if marker is None or marker.evaluate({"extra": ""}) or not marker.evaluate({"extra": self.name}):
            return ""
        return f"{wanted.name}{wanted.specifier}"


SIM: Final = Extra("sim", ("jsbsim",), "The embedded simulator")
MAPS: Final = Extra("maps", ("rasterio",), "Importing heights")
FLIGHTS: Final = Extra("flights", ("pyarrow", "duckdb"), "Looking into recorded flights")
LOGS: Final = Extra("logs", ("pymavlink", "pyulog"), "Reading the logs of other autopilots")
MAVLINK: Final = Extra("mavlink", ("pymavlink",), "Speaking MAVLink")
ALL: Final = (SIM, MAPS, FLIGHTS, LOGS)
"""What the page and the doctor look at: parts of the station itself."""
