"""The parts of the product that are not Python: found in the installed package, or where a source tree builds them."""

from __future__ import annotations

from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Final

# A wheel holds them in this folder of the package; a source tree has no such folder.
_IN_PACKAGE: Final = "_product"
# The file that marks the root of a source tree with an editable install.
_TREE_MARK: Final = Path("backend", "pyproject.toml")


@dataclass(frozen=True, slots=True)
class Part:
    """A folder of built files: `in_package` below the package's `_product`, `in_tree` below a source tree's root."""

    name: str
    in_package: str
    in_tree: str
    made_by: str

    @property
    def folder(self) -> Path:
        """Where it is; where it should be if it is nowhere."""
        packaged = _package() / _IN_PACKAGE / self.in_package
        tree = source_tree()
        return packaged if tree is None or packaged.is_dir() else tree / self.in_tree

    def file(self, name: str) -> Path:
        """One of its files. Raises FileNotFoundError with a sentence that says what to do."""
        path = self.folder / name
        if not path.is_file():
            raise FileNotFoundError(
                f"{self.name} is missing: {path} does not exist. In a source tree build it with `{self.made_by}`; "
                "otherwise install epf-gcs again, from the wheel for this kind of computer."
            )
        return path


def source_tree() -> Path | None:
    """The root of the source tree that this package runs from; None where it was installed from a wheel."""
    return next((parent for parent in _package().parents if (parent / _TREE_MARK).is_file()), None)


def _package() -> Path:
    return Path(str(files("epf_gcs")))


PAGE: Final = Part("The page", "page", "frontend/dist", "make run")
BOARD: Final = Part("The board's program", "board", "firmware/build", "make board")
