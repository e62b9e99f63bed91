"""What one part tells another is a value: nobody can change it afterwards, or give it something that nobody reads."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator
from dataclasses import is_dataclass
from typing import Any, Final

import epf_gcs
from epf_gcs.flight.recording.repair import _FileExtent

_PARTS: Final = ("bus", "codec", "flight", "vehicle", "xplane")
# Collects while a file is read, and is seen by nobody else.
_CHANGES: Final[frozenset[type]] = frozenset({_FileExtent})


def data_classes() -> Iterator[Any]:
    """The data classes of these parts, each once."""
    for found in pkgutil.walk_packages(epf_gcs.__path__, "epf_gcs."):
        if found.name.split(".")[1] in _PARTS and not found.name.endswith("__main__"):
            module = importlib.import_module(found.name)
            for one in vars(module).values():
                if isinstance(one, type) and is_dataclass(one) and one.__module__ == module.__name__:
                    yield one


def test_what_one_part_tells_another_cannot_be_changed_and_takes_nothing_more() -> None:
    classes = [one for one in data_classes() if one not in _CHANGES]
    assert len(classes) > 30
    assert [one for one in classes if not one.__dataclass_params__.frozen] == []
    assert [one for one in classes if "__slots__" not in vars(one)] == []
