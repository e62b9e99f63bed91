"""Where the station's data lie unless the user says otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from platformdirs import user_data_path

from epf_gcs.product import source_tree

DEFAULT: Final = "data in a source tree, else this user's place for data"
"""The same in words, for help texts."""
DEMONSTRATION: Final = "data-demonstration in a source tree, else epf-gcs-demonstration in this user's place for data"
"""The demonstration's folder in words."""


def data_folder() -> Path:
    """`data` in a source tree; else the place that this system has for a user's data, never where one stands."""
    return _folder("data", "epf-gcs")


def demonstration_folder() -> Path:
    """Of `epf-run` with a board of its own: what a demonstration flew and was linked with is no station's business."""
    return _folder("data-demonstration", "epf-gcs-demonstration")


def _folder(in_tree: str, of_user: str) -> Path:
    tree = source_tree()
    return user_data_path(of_user, appauthor=False) if tree is None else tree / in_tree
