"""Build the Debian package of the station: the wheels of wheelhouse.py, the service's files and dpkg's scripts.

Usage: deb.py ROOT OUT MACHINE PYTHON... for example: deb.py . dist x86_64 3.11 3.13

OUT holds the archive of wheels already. The scripts in packaging/debian make the environment on the computer that
installs it, because Debian 12 and 13 have different Pythons. Two builds of one tree are equal.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Final

sys.path.insert(0, str(Path(__file__).parent))

import shipped
import wheel
import wheelhouse

ARCHITECTURES: Final = {"x86_64": "amd64", "aarch64": "arm64"}
CONF: Final = "etc/epf-gcs.conf"
# Where the tree's files go.
FILES: Final = {
    "packaging/linux/epf-gcs.service": "usr/lib/systemd/system/epf-gcs.service",
    "packaging/linux/epf-gcs-first-key.service": "usr/lib/systemd/system/epf-gcs-first-key.service",
    "packaging/linux/70-epf-gcs.rules": "usr/lib/udev/rules.d/70-epf-gcs.rules",
    "packaging/linux/epf-gcs.conf": CONF,
    "packaging/linux/README.md": "usr/share/epf-gcs/README.md",
    "LICENSE": "usr/share/doc/epf-gcs/copyright",
}
SCRIPTS: Final = ("preinst", "postinst", "prerm", "postrm")
WHEELS: Final = "usr/share/epf-gcs/wheels"
LINK: Final = ("usr/bin/epf-gcs", "/opt/epf-gcs/bin/epf-gcs")


def debian_version(version: str) -> str:
    """A Python version as Debian orders it: 1.1.0.dev0 comes before 1.1.0."""
    return version.replace(".dev", "~dev")


def python_range(pythons: Sequence[str]) -> str:
    """The dependency on a Python for which there are wheels: one of these, and none between them."""
    minors = sorted(int(python.removeprefix("3.")) for python in pythons)
    alternatives = [f"python3 (>= 3.{minors[0]})", f"python3 (<< 3.{minors[-1] + 1})"]
    for before, after in pairwise(minors):
        if after > before + 1:
            alternatives.append(f"python3 (<< 3.{before + 1}) | python3 (>= 3.{after})")
    return ", ".join(alternatives)


def control(version: str, machine: str, pythons: Sequence[str], kilobytes: int) -> str:
    """What dpkg reads of the package."""
    return f"""\
Package: epf-gcs
Version: {debian_version(version)}
Architecture: {ARCHITECTURES[machine]}
Maintainer: The EPF GCS authors
Installed-Size: {kilobytes}
Depends: {python_range(pythons)}, python3-venv, libexpat1, passwd
Section: misc
Priority: optional
Description: ground control station in the browser for a small autopilot board
 A gateway between an autopilot board, X-Plane or the embedded flight simulator
 and pages in browsers, installed as a service of systemd. It needs no network:
 all Python packages lie in /{WHEELS}, from which
 its environment in /opt/epf-gcs is made (Python {" or ".join(pythons)}).
"""


def stage(root: Path, archive: Path, folder: Path) -> None:
    """Lay the installed files into the folder. Raises FileNotFoundError."""
    for source, target in FILES.items():
        (folder / target).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / source, folder / target)
    wheels = folder / WHEELS
    wheels.mkdir(parents=True)
    with tarfile.open(archive) as packed:
        for entry in packed:
            content = packed.extractfile(entry)
            assert content is not None  # noqa: S101 - the archive is ours and holds files alone
            with (wheels / Path(entry.name).name).open("wb") as target_file:
                shutil.copyfileobj(content, target_file)
    link = folder / LINK[0]
    link.parent.mkdir(parents=True, exist_ok=True)
    link.symlink_to(LINK[1])


def describe(root: Path, folder: Path, version: str, machine: str, pythons: Sequence[str]) -> None:
    """Lay what dpkg reads beside the staged files."""
    size = sum(path.lstat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    told = folder / "DEBIAN"
    told.mkdir()
    (told / "control").write_text(control(version, machine, pythons, -(-size // 1024)), encoding="utf-8")
    (told / "conffiles").write_text(f"/{CONF}\n", encoding="utf-8")
    for name in (*SCRIPTS, "triggers"):
        shutil.copyfile(root / "packaging/debian" / name, told / name)


def settle(folder: Path, made_s: int) -> None:
    """Give everything the modes and the one time (Unix s) that do not depend on who builds."""
    for path in [folder, *folder.rglob("*")]:
        if not path.is_symlink():
            is_program = path.is_dir() or (path.parent.name == "DEBIAN" and path.name in SCRIPTS)
            path.chmod(0o755 if is_program else 0o644)
        os.utime(path, (made_s, made_s), follow_symlinks=False)


def build(root: Path, archive: Path, out: Path, machine: str, pythons: Sequence[str]) -> Path:
    """Make the package; returns its file. Raises FileNotFoundError, CalledProcessError."""
    version = shipped.version(root)
    made_s = wheelhouse.made_s(root)
    package = out / f"epf-gcs_{debian_version(version)}_{ARCHITECTURES[machine]}.deb"
    with tempfile.TemporaryDirectory() as staged:
        folder = Path(staged)
        stage(root, archive, folder)
        describe(root, folder, version, machine, pythons)
        settle(folder, made_s)
        # Wheels are compressed; a second time costs minutes and saves nothing.
        command = ("dpkg-deb", "--root-owner-group", "-Znone", "--build", str(folder), str(package))
        environment = {**os.environ, wheel.EPOCH: str(made_s)}
        subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    return package


def main() -> int:
    """Build it; returns the exit code."""
    root, out, machine, *pythons = sys.argv[1:]
    target = Path(out).resolve()
    archive = target / f"epf-gcs-{shipped.version(Path(root))}-wheels-{machine}.tar"
    if shutil.which("dpkg-deb") is None:
        print("deb: dpkg-deb is not here; it is part of Debian's dpkg.", file=sys.stderr)
        return 1
    try:
        print(build(Path(root), archive, target, machine, pythons))
    except FileNotFoundError as error:
        print(f"deb: {error.filename} is missing: `make deb` makes it first.", file=sys.stderr)
        return 1
    except subprocess.CalledProcessError as error:
        return error.returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
