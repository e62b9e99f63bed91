"""Build the wheel that holds the whole product: gateway, page, the board's program, the licences of all of it, and the
bill of materials (PEP 770: `.dist-info/sboms`).

Usage: wheel.py ROOT OUT [MACHINE]

The page and the board's program have been built before. The program is linked statically, so that any Linux of its
processor runs it: the wheel is for MACHINE, by default this one (x86_64, aarch64). With `none` it holds no program and
is for every system: it connects real boards, and flies no demonstration. `sdist` makes a source archive of the same
contents, from which such a wheel can be built.
"""

from __future__ import annotations

import base64
import hashlib
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Final

sys.path.insert(0, str(Path(__file__).parent))

import sbom
import shipped

PAGE: Final = Path("frontend/dist")
BUILT: Final = Path("firmware/build")
PROGRAM: Final = Path("static/epf-board")
# The board's laws, which the lab loads with the system's C library; an older one than of 2022 says so.
LAWS: Final = Path("posix/libepf-flight.so")
# The texts of the page's packages, which the About window links.
LICENCES: Final = "licences.txt"
BILL: Final = "epf-gcs.cdx.json"
WITHOUT: Final = ("none", "sdist")
EPOCH: Final = "SOURCE_DATE_EPOCH"
# The earliest time that a zip can say.
_FIRST_S: Final = "315532800"
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
    with (product / "page" / LICENCES).open("a", encoding="utf-8") as licences:
        for component, text in shipped.texts(root):
            licences.write(f"\n## {component.name} - {component.version} ({component.licence})\n\n{text}\n")
    if board is None:
        return
    target = product / "board" / "posix"
    target.mkdir(parents=True)
    shutil.copy2(root / board, target / "epf-board")
    shutil.copy2(root / board.parents[1] / LAWS, target / LAWS.name)
    for name in shipped.IN_BOARD:
        shutil.copy2(root / shipped.THIRD_PARTY / name / "LICENSE.md", target.parent / f"licence-{name}.txt")


def add_bill(wheel: Path, bill: str) -> None:
    """Put the bill of materials into a wheel, and into the wheel's list of its files."""
    data = bill.encode()
    with zipfile.ZipFile(wheel) as built:
        held = [(entry, built.read(entry)) for entry in built.infolist()]
    (record,) = (entry.filename for entry, _ in held if entry.filename.endswith(".dist-info/RECORD"))
    name = f"{record.rpartition('/')[0]}/sboms/{BILL}"
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    row = f"{name},sha256={digest},{len(data)}\n".encode()
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as made:
        for entry, content in held:
            if entry.filename == record:
                # Of the list's own time, so that nothing depends on when this was done.
                added = zipfile.ZipInfo(name, entry.date_time)
                added.external_attr, added.compress_type = entry.external_attr, zipfile.ZIP_DEFLATED
                made.writestr(added, data)
                content = row + content  # noqa: PLW2901
            made.writestr(entry, content)


def program_of(machine: str) -> Path | None:
    """Where the board's program for a processor is built; None for wheels without one."""
    if machine in WITHOUT:
        return None
    return BUILT / PROGRAM if machine == platform.machine() else BUILT / machine / PROGRAM


def committed_s(root: Path) -> str:
    """When the tree was last changed (Unix s), which all files of the wheel say: two builds of one tree are equal."""
    asked = ["git", "-C", str(root), "log", "-1", "--format=%ct"]
    return subprocess.run(asked, capture_output=True, text=True, check=False).stdout.strip() or _FIRST_S


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
    with tempfile.TemporaryDirectory() as staged, tempfile.TemporaryDirectory() as made:
        try:
            stage(root, Path(staged), program_of(machine))
        except FileNotFoundError as error:
            print(f"wheel: {error.filename} is missing: run `make wheel`, which builds it first.", file=sys.stderr)
            return 1
        built = subprocess.run(
            command(machine, staged, Path(made)),
            cwd=staged,
            env={**os.environ, EPOCH: os.environ.get(EPOCH) or committed_s(root)},
            check=False,
            stdout=subprocess.PIPE,
            text=True,
        )
        if built.returncode:
            print(built.stdout, file=sys.stderr)
            return built.returncode
        for path in Path(made).iterdir():
            if path.suffix == ".whl":
                add_bill(path, sbom.text(root))
            shutil.move(path, out / path.name)
        return 0


if __name__ == "__main__":
    sys.exit(main())
