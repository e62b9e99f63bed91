"""Build the wheel that holds the whole product: gateway, page, the board's program, and the licences of all of it.

Usage: wheel.py ROOT OUT [MACHINE]

The page and the board's program have been built before. The program is linked statically, so that any Linux of its
processor runs it: the wheel is for MACHINE, by default this one (x86_64, aarch64). With `none` it holds no program and
is for every system: it connects real boards, and flies no demonstration. `sdist` makes a source archive of the same
contents, from which such a wheel can be built.
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
BUILT: Final = Path("firmware/build")
PROGRAM: Final = Path("static/epf-board")
THIRD_PARTY: Final = Path("firmware/third_party")
# What the board's program holds of others; cmocka is in its tests alone.
IN_BOARD: Final = {"freertos": "LICENSE.md", "littlefs": "LICENSE.md"}
WITHOUT: Final = ("none", "sdist")
# glibc is linked in; the kernel of any Linux since 2014 runs it.
_LINUX: Final = "manylinux_2_17"


def stage(root: Path, folder: Path, board: Path | None) -> None:
    """Copy the gateway's sources and put beside them what is built elsewhere. Raises FileNotFoundError."""
    for name in ("pyproject.toml", "README.md"):
        shutil.copy2(root / "backend" / name, folder / name)
    shutil.copy2(root / "LICENSE", folder / "LICENSE")
    shutil.copytree(
        root / "backend" / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info")
    )
    product = folder / "src" / "epf_gcs" / "_product"
    shutil.copytree(root / PAGE, product / "page")
    if board is None:
        return
    target = product / "board" / "posix"
    target.mkdir(parents=True)
    shutil.copy2(root / board, target / "epf-board")
    for name, licence in IN_BOARD.items():
        shutil.copy2(root / THIRD_PARTY / name / licence, target.parent / f"licence-{name}.txt")


def program_of(machine: str) -> Path | None:
    """Where the board's program for a processor is built; None for wheels without one."""
    if machine in WITHOUT:
        return None
    return BUILT / PROGRAM if machine == platform.machine() else BUILT / machine / PROGRAM


def command(machine: str, staged: str, out: Path) -> list[str]:
    """The program that builds what was staged."""
    if machine == "sdist":
        build = f"from setuptools import build_meta; build_meta.build_sdist({str(out)!r})"
        return [sys.executable, "-c", build]
    tag = [] if machine in WITHOUT else [f"--config-settings=--build-option=--plat-name={_LINUX}_{machine}"]
    return [
        *(sys.executable, "-m", "pip", "wheel", "--quiet", "--disable-pip-version-check", "--no-deps"),
        *("--no-build-isolation", "--wheel-dir", str(out), *tag, staged),
    ]


def main() -> int:
    """Build it; returns the exit code."""
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    machine = sys.argv[3] if len(sys.argv) > 3 else platform.machine()
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as staged:
        try:
            stage(root, Path(staged), program_of(machine))
        except FileNotFoundError as error:
            print(f"wheel: {error.filename} is missing: run `make wheel`, which builds it first.", file=sys.stderr)
            return 1
        built = subprocess.run(
            command(machine, staged, out), cwd=staged, check=False, stdout=subprocess.PIPE, text=True
        )
        if built.returncode:
            print(built.stdout, file=sys.stderr)
        return built.returncode


if __name__ == "__main__":
    sys.exit(main())
