"""Make all files of a release that this machine can make, and say what it cannot.

Usage: release.py ROOT OUT [TAG]. Red where a part is missing, for a release is whole or is none. The images of the
containers are not among them: `make container` builds one for each kind of processor.
"""

from __future__ import annotations

import hashlib
import platform
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

sys.path.insert(0, str(Path(__file__).parent))

import notes
import sbom
import shipped

SUMS: Final = "SHA256SUMS"
NOTES: Final = "NOTES.md"
# Processors with a board's program in their wheel, and images of the firmware that are no debugging aid.
MACHINES: Final = ("x86_64", "aarch64")
IMAGES: Final = ("stm32f405",)


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a release. `make`: the Makefile's verb and variables; `lacking`: why it cannot be made here, or "";
    `files`: name in the release and where it is, of what is not built into OUT."""

    name: str
    make: tuple[str, ...]
    lacking: Callable[[], str] = str
    files: tuple[tuple[str, str], ...] = ()


def compiler(machine: str) -> Callable[[], str]:
    """Whether the board's program can be compiled for a processor."""

    def lacking() -> str:
        name = f"{machine}-linux-gnu-gcc"
        here = machine == platform.machine() or shutil.which(name) is not None
        return (
            ""
            if here
            else f"{name} is not here; on Debian or Ubuntu: apt install gcc-{machine.replace('_', '-')}-linux-gnu"
        )

    return lacking


def packager(machine: str) -> Callable[[], str]:
    """Whether the Debian package can be made for a processor."""

    def lacking() -> str:
        return compiler(machine)() or ("" if shutil.which("dpkg-deb") else "dpkg-deb is not here")

    return lacking


def parts(root: Path, version: str) -> Iterator[Part]:
    """All of them."""
    for machine in MACHINES:
        yield Part(f"wheel for {machine}", ("wheel", f"PLATFORM={machine}"), compiler(machine))
    for machine in MACHINES:
        yield Part(f"package and all wheels for {machine}", ("deb", f"PLATFORM={machine}"), packager(machine))
    yield Part("wheel without a board's program", ("wheel", "PLATFORM=none"))
    yield Part("source archive", ("sdist",))

    def no_arm() -> str:
        asked = subprocess.run(["bash", root / ".ci" / "arm", "--lacking"], capture_output=True, text=True, check=False)
        return asked.stdout.strip()

    images = tuple(
        (f"epf-board-{version}-{image}.{kind}", f"firmware/build/{image}/epf-board.{kind}")
        for image in IMAGES
        for kind in ("bin", "elf")
    )
    yield Part("firmware images", ("images",), no_arm, images)
    yield Part("documents", ("docs-archive",))


def build(root: Path, out: Path, part: Part) -> str:
    """Make one part; returns a sentence where that failed."""
    lacking = part.lacking()
    if lacking:
        return lacking
    done = subprocess.run(["make", "--no-print-directory", f"OUT={out}", *part.make], cwd=root, check=False)
    if done.returncode:
        return f"make {' '.join(part.make)} failed"
    for name, built in part.files:
        shutil.copy2(root / built, out / name)
    return ""


def sums(out: Path) -> str:
    """Checksums of all files, as `sha256sum --check` reads them."""
    files = sorted(path for path in out.iterdir() if path.name not in (SUMS, NOTES))
    return "".join(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files)


def invalid(text: str) -> str:
    """What CycloneDX's own schema says against a bill of materials, or ""."""
    found = JsonStrictValidator(SchemaVersion.V1_6).validate_str(text)
    return "" if found is None else str(found)


def main() -> int:
    """Make all of it; returns the exit code."""
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    tag = sys.argv[3] if len(sys.argv) > 3 and sys.argv[3] else None
    version = shipped.version(root)
    try:
        told = notes.notes((root / "CHANGELOG.md").read_text(encoding="utf-8"), version, tag)
    except notes.NotesError as error:
        print(f"release: {error}.", file=sys.stderr)
        return 1
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    missing = {part.name: sentence for part in parts(root, version) if (sentence := build(root, out, part))}
    bill = sbom.text(root)
    if sentence := invalid(bill):
        missing["bill of materials"] = sentence
    (out / f"epf-gcs-{version}.cdx.json").write_text(bill, encoding="utf-8")
    (out / SUMS).write_text(sums(out), encoding="utf-8")
    (out / NOTES).write_text(told + "\n", encoding="utf-8")
    print(f"release: {version} in {out}:")
    for path in sorted(out.iterdir()):
        print(f"  {path.stat().st_size:>10}  {path.name}")
    for name, sentence in missing.items():
        print(f"release: MISSING {name}: {sentence}.")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
