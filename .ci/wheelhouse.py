"""Collect all wheels that the station needs on a computer without internet, and pack them as one archive.

Usage: wheelhouse.py ROOT OUT MACHINE PYTHON... for example: wheelhouse.py . dist x86_64 3.11 3.13

The station's own wheel for MACHINE (x86_64, aarch64) lies in OUT already. Each other one is what the lock names, held
against its hash there. `requirements.txt` among them is the lock of these files: `pip install --no-index --find-links
FOLDER --require-hashes -r FOLDER/requirements.txt` installs the station with every extra that has wheels for this
machine. The Debian package holds the same folder.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final

from packaging.requirements import Requirement

sys.path.insert(0, str(Path(__file__).parent))

import shipped
import wheel

LOCK: Final = "backend/requirements.lock"
REQUIREMENTS: Final = "requirements.txt"
# What only builds, and what the registry has for no aarch64: without it there is no simulator (packaging/jsbsim).
BUILDS: Final = frozenset({"setuptools"})
NO_WHEEL: Final = {"aarch64": frozenset({"jsbsim"})}
# What pip calls the systems that these wheels run on: Debian 12 and newer, any Linux with glibc 2.28.
_GLIBC: Final = ("manylinux_2_28", "manylinux_2_27", "manylinux_2_26", "manylinux_2_24", "manylinux_2_17")
_OLDER: Final = ("manylinux2014", "manylinux_2_12", "manylinux2010", "manylinux_2_5", "manylinux1")
_BLOCK: Final = re.compile(r"^([^\s#][^\n]*?) \\\n((?:    --hash=\S+(?: \\)?\n)+)", re.MULTILINE)

Pin = tuple[Requirement, str]
"""A package as the lock names it, and the lines with its hashes."""


def pins(lock: str) -> Iterator[Pin]:
    """Each package of a lock."""
    for said, hashes in _BLOCK.findall(lock):
        yield Requirement(said), hashes


def wanted(lock: str, machine: str) -> list[Pin]:
    """The packages of a lock that a station on this machine is made of, whatever its Python."""
    left_out = BUILDS | NO_WHEEL.get(machine, frozenset())
    return [pin for pin in pins(lock) if pin[0].name not in left_out]


def text(chosen: Sequence[Pin]) -> str:
    """These packages as a lock again."""
    return "".join(f"{package} \\\n{hashes}" for package, hashes in chosen)


def for_python(chosen: Sequence[Pin], python: str, machine: str) -> list[Pin]:
    """Those that this Python ("3.13") needs, without their conditions: pip judges these by its own Python alone."""
    environment = {
        "python_version": python,
        "python_full_version": f"{python}.0",
        "platform_machine": machine,
        "sys_platform": "linux",
        "platform_system": "Linux",
    }
    return [
        (Requirement(str(package).partition(";")[0]), hashes)
        for package, hashes in chosen
        if package.marker is None or package.marker.evaluate(environment)
    ]


def download(command: Sequence[str], chosen: Sequence[Pin], python: str, machine: str, folder: Path) -> None:
    """Put the wheels for one Python into the folder. Raises CalledProcessError where one is missing."""
    platforms = [f"--platform={name}_{machine}" for name in (*_GLIBC, *_OLDER)]
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as named:
        named.write(text(for_python(chosen, python, machine)))
        named.flush()
        options = ("--quiet", "--disable-pip-version-check", "--no-deps", "--require-hashes", "--only-binary=:all:")
        given = (*options, f"--python-version={python}", *platforms, f"--dest={folder}", f"--requirement={named.name}")
        subprocess.run([*command, "download", *given], check=True)


def own_wheel(out: Path, version: str, machine: str) -> Path:
    """The station's wheel for a machine. Raises FileNotFoundError."""
    found = sorted(out.glob(f"epf_gcs-{version}-*_{machine}.whl"))
    if not found:
        raise FileNotFoundError(2, "missing", str(out / f"epf_gcs-{version}-….whl"))
    return found[0]


def collect(root: Path, out: Path, machine: str, pythons: Sequence[str], folder: Path) -> None:
    """Fill a folder. Raises FileNotFoundError without the station's own wheel, CalledProcessError without another."""
    version = shipped.version(root)
    own = own_wheel(out, version, machine)
    chosen = wanted((root / LOCK).read_text(encoding="utf-8"), machine)
    for python in pythons:
        download((sys.executable, "-m", "pip"), chosen, python, machine, folder)
    shutil.copyfile(own, folder / own.name)
    digest = hashlib.sha256(own.read_bytes()).hexdigest()
    station = f"epf-gcs=={version} \\\n    --hash=sha256:{digest}\n"
    (folder / REQUIREMENTS).write_text(station + text(chosen), encoding="utf-8")


def pack(folder: Path, name: str, archive: Path, made_s: int) -> None:
    """Write the folder as an uncompressed archive (wheels are compressed) in which only `made_s` (Unix s) is a time."""
    with tarfile.open(archive, "w", format=tarfile.GNU_FORMAT) as packed:
        for path in sorted(folder.iterdir()):
            entry = tarfile.TarInfo(f"{name}/{path.name}")
            entry.size, entry.mtime, entry.mode = path.stat().st_size, made_s, 0o644
            with path.open("rb") as content:
                packed.addfile(entry, content)


def made_s(root: Path) -> int:
    """The time (Unix s) that all files of a build of this tree say."""
    return int(os.environ.get(wheel.EPOCH) or wheel.committed_s(root))


def main() -> int:
    """Collect and pack; returns the exit code."""
    root, out, machine, *pythons = sys.argv[1:]
    target = Path(out).resolve()
    name = f"epf-gcs-{shipped.version(Path(root))}-wheels-{machine}"
    with tempfile.TemporaryDirectory() as made:
        try:
            collect(Path(root), target, machine, pythons, Path(made))
        except FileNotFoundError as error:
            print(f"wheelhouse: {error.filename} is missing: `make wheelhouse` builds it first.", file=sys.stderr)
            return 1
        except subprocess.CalledProcessError as error:
            print(f"wheelhouse: pip found no wheel for {machine}, for the reason above.", file=sys.stderr)
            return error.returncode
        pack(Path(made), name, target / f"{name}.tar", made_s(Path(root)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
