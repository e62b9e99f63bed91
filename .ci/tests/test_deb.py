"""The Debian package: what it holds, what dpkg reads of it, and two builds that are equal."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

CI = Path(__file__).parents[1]
ROOT = CI.parent
sys.path.insert(0, str(CI))

import deb  # noqa: E402
import shipped  # noqa: E402
import wheelhouse  # noqa: E402

PYTHONS = ("3.11", "3.13")
needs_dpkg = pytest.mark.skipif(shutil.which("dpkg-deb") is None, reason="dpkg-deb is not on this machine")


def built(folder: Path) -> Path:
    wheels = folder / "wheels"
    wheels.mkdir(parents=True)
    (wheels / "station.whl").write_text("a wheel")
    (wheels / wheelhouse.REQUIREMENTS).write_text("epf-gcs==1\n")
    wheelhouse.pack(wheels, "wheels", folder / "wheels.tar", 0)
    return deb.build(ROOT, folder / "wheels.tar", folder, "x86_64", PYTHONS)


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built(tmp_path_factory.mktemp("package"))


def asked(*command: str | Path) -> str:
    return subprocess.run(["dpkg-deb", *command], capture_output=True, text=True, check=True).stdout


@needs_dpkg
def test_it_holds_the_service_its_settings_the_wheels_and_the_command_all_of_root(package: Path) -> None:
    rows = [line.split(maxsplit=5) for line in asked("--contents", package).splitlines()]
    assert {row[1] for row in rows} == {"root/root"}
    modes = {row[5].removeprefix("./"): row[0] for row in rows if not row[5].endswith("/")}
    assert modes.pop("usr/bin/epf-gcs -> /opt/epf-gcs/bin/epf-gcs").startswith("l")
    assert set(modes.values()) == {"-rw-r--r--"}
    wheels = {f"{deb.WHEELS}/station.whl", f"{deb.WHEELS}/{wheelhouse.REQUIREMENTS}"}
    assert set(modes) == {*deb.FILES.values(), *wheels}


@needs_dpkg
def test_the_units_are_those_of_the_tree(package: Path, tmp_path: Path) -> None:
    asked("--extract", package, tmp_path)
    for source, target in deb.FILES.items():
        assert (tmp_path / target).read_bytes() == (ROOT / source).read_bytes()


@needs_dpkg
def test_dpkg_reads_what_it_is_for_and_what_it_needs(package: Path, tmp_path: Path) -> None:
    fields = dict(line.split(": ", 1) for line in asked("--field", package).splitlines() if line[0] != " ")
    assert fields["Package"] == "epf-gcs"
    assert fields["Architecture"] == "amd64"
    assert fields["Version"] == deb.debian_version(shipped.version(ROOT))
    assert "python3-venv" in fields["Depends"]
    # Through GDAL, which the slim systems have no library of XML for.
    assert "libexpat1" in fields["Depends"]
    asked("--control", package, tmp_path)
    assert (tmp_path / "conffiles").read_text() == "/etc/epf-gcs.conf\n"
    for name in deb.SCRIPTS:
        assert os.access(tmp_path / name, os.X_OK)
        subprocess.run(["sh", "-n", tmp_path / name], check=True)


@needs_dpkg
def test_two_builds_are_equal(package: Path, tmp_path: Path) -> None:
    assert built(tmp_path).read_bytes() == package.read_bytes()


def test_a_version_under_way_comes_before_its_release() -> None:
    assert deb.debian_version("1.1.0.dev0") == "1.1.0~dev0"
    assert deb.debian_version("1.1.0") == "1.1.0"


@pytest.mark.parametrize(
    ("pythons", "needed"),
    [
        (("3.13",), "python3 (>= 3.13), python3 (<< 3.14)"),
        (("3.12", "3.11"), "python3 (>= 3.11), python3 (<< 3.13)"),
        (PYTHONS, "python3 (>= 3.11), python3 (<< 3.14), python3 (<< 3.12) | python3 (>= 3.13)"),
    ],
)
def test_only_a_python_with_wheels_in_the_package_will_do(pythons: tuple[str, ...], needed: str) -> None:
    assert deb.python_range(pythons) == needed
