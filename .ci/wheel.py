"""Build the wheel that holds the whole product: gateway, page, the board's program, and the licences of all of it.

Usage: wheel.py ROOT OUT [PLATFORM]

The page and the board's program have been built before. With a board's program the wheel is for one platform, by
default this machine's; the program is linked statically, so that any Linux of that processor runs it.
"""

from __future__ import annotations

import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Final

PAGE: Final = Path("frontend/dist")
BOARD: Final = Path("firmware/build/static/epf-board")
THIRD_PARTY: Final = Path("firmware/third_party")
# What the board's program holds of others; cmocka is in its tests alone.
IN_BOARD: Final = {"freertos": "LICENSE.md", "littlefs": "LICENSE.md"}
# glibc is linked in; the kernel of any Linux since 2014 runs it.
_LINUX: Final = "manylinux_2_17"


def stage(root: Path, folder: Path) -> None:
    """Copy the gateway's sources and put beside them what is built elsewhere. Raises FileNotFoundError."""
    for name in ("pyproject.toml", "README.md"):
        shutil.copy2(root / "backend" / name, folder / name)
    shutil.copy2(root / "LICENSE", folder / "LICENSE")
    shutil.copytree(
        root / "backend" / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info")
    )
    product = folder / "src" / "epf_gcs" / "_product"
    shutil.copytree(root / PAGE, product / "page")
    board = product / "board" / "posix"
    board.mkdir(parents=True)
    shutil.copy2(root / BOARD, board / "epf-board")
    for name, licence in IN_BOARD.items():
        shutil.copy2(root / THIRD_PARTY / name / licence, board.parent / f"licence-{name}.txt")


def main() -> int:
    """Build it; returns the exit code."""
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    tag = sys.argv[3] if len(sys.argv) > 3 else f"{_LINUX}_{platform.machine()}"
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as staged:
        try:
            stage(root, Path(staged))
        except FileNotFoundError as error:
            print(f"wheel: {error.filename} is missing: run `make wheel`, which builds it first.", file=sys.stderr)
            return 1
        return subprocess.run(
            [
                *(sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps"),
                *("--no-build-isolation", "--wheel-dir", str(out)),
                f"--config-settings=--build-option=--plat-name={tag}",
                staged,
            ],
            check=False,
        ).returncode


if __name__ == "__main__":
    sys.exit(main())
