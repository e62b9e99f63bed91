"""What dpkg's scripts do on the computer that installs, upgrades, removes and purges, with stand-ins for the system."""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "packaging" / "debian"
# A Python whose environments hold a pip that installs the station, as one script that names its folder.
PYTHON = """\
#!/bin/sh
case "$1$2" in
  -c*) echo "Python $(cat "$DPKG_ROOT/python-is")" ;;
  -mvenv)
    shift 2
    mkdir -p "$3/bin" "$3/lib"
    echo "command = $3" >"$3/pyvenv.cfg"
    cp "$0" "$3/bin/python3" ;;
  -mpip)
    [ ! -e "$DPKG_ROOT/pip-fails" ] || exit 1
    printf '#!/bin/sh\\n# %s\\n' "$(dirname "$0")" >"$(dirname "$0")/epf-gcs"
    cat "$DPKG_ROOT/usr/share/epf-gcs/wheels/requirements.txt" >"$(dirname "$0")/../version"
    chmod +x "$(dirname "$0")/epf-gcs" ;;
esac
"""
# `fails-with-TEXT`: each call of which TEXT is a part fails.
STAND_IN = """\
#!/bin/sh
echo "$(basename "$0") $*" >>"$DPKG_ROOT/asked"
for failing in "$DPKG_ROOT"/fails-with-*; do
  case "$*" in *"$(cat "$failing" 2>/dev/null || echo never)"*) exit 1 ;; esac
done
"""


@dataclass
class Computer:
    root: Path

    def run(self, script: str, *words: str) -> subprocess.CompletedProcess[str]:
        environment = {"PATH": f"{self.root}/stand-ins:{os.environ['PATH']}", "DPKG_ROOT": str(self.root)}
        command = ["sh", str(SCRIPTS / script), *words]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)

    def asked(self) -> list[str]:
        path = self.root / "asked"
        found = path.read_text().splitlines() if path.exists() else []
        path.unlink(missing_ok=True)
        return found

    def unpack(self, version: str) -> None:
        """What dpkg has done before the scripts run."""
        wheels = self.root / "usr/share/epf-gcs/wheels"
        wheels.mkdir(parents=True, exist_ok=True)
        (wheels / "requirements.txt").write_text(version)
        (wheels.parent / "README.md").write_text("read me")

    def version(self) -> str:
        return (self.root / "opt/epf-gcs/version").read_text()

    def environments(self) -> list[str]:
        return sorted(path.name for path in (self.root / "opt").iterdir())


@pytest.fixture
def computer(tmp_path: Path) -> Computer:
    """One with systemd, on which the package was unpacked."""
    for folder in ("usr/bin", "opt", "run/systemd/system", "stand-ins", "var/lib"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "python-is").write_text("3.11")
    (tmp_path / "usr/bin/python3").write_text(PYTHON)
    (tmp_path / "usr/bin/python3").chmod(0o755)
    helpers = ("deb-systemd-helper", "deb-systemd-invoke", "systemctl", "udevadm", "useradd", "userdel", "getent")
    for name in (*helpers, "install"):
        (tmp_path / "stand-ins" / name).write_text(STAND_IN)
        (tmp_path / "stand-ins" / name).chmod(0o755)
    made = Computer(tmp_path)
    made.unpack("1.0")
    return made


def test_an_installation_makes_environment_user_and_folder_and_starts_the_station(computer: Computer) -> None:
    (computer.root / "fails-with-user").write_text("passwd epf-gcs")
    assert computer.run("postinst", "configure", "").returncode == 0
    asked = computer.asked()
    assert any(line.startswith("useradd --system") for line in asked)
    assert any(line.startswith("install -d -o epf-gcs -g epf-gcs -m 0700") for line in asked)
    assert "deb-systemd-helper enable epf-gcs.service" in asked
    assert "deb-systemd-invoke restart epf-gcs.service" in asked
    assert computer.environments() == ["epf-gcs"]
    # What was made beside its place names its place.
    for name in ("bin/epf-gcs", "pyvenv.cfg"):
        text = (computer.root / "opt/epf-gcs" / name).read_text()
        assert "/opt/epf-gcs" in text
        assert ".new" not in text


def test_without_systemd_nothing_is_started(computer: Computer) -> None:
    shutil.rmtree(computer.root / "run")
    assert computer.run("postinst", "configure", "").returncode == 0
    assert computer.run("prerm", "remove").returncode == 0
    assert computer.run("postrm", "remove").returncode == 0
    assert not [line for line in computer.asked() if line.startswith(("systemctl", "deb-systemd-invoke", "udevadm"))]


def test_an_upgrade_leaves_the_station_running_until_the_new_environment_is_in_its_place(computer: Computer) -> None:
    computer.run("postinst", "configure", "")
    computer.asked()
    assert computer.run("prerm", "upgrade", "2.0").returncode == 0
    assert computer.run("postrm", "upgrade", "2.0").returncode == 0
    assert computer.asked() == []
    assert computer.version() == "1.0"
    computer.unpack("2.0")
    assert computer.run("postinst", "configure", "1.0").returncode == 0
    assert computer.version() == "2.0"
    assert computer.environments() == ["epf-gcs"]


def test_where_the_wheels_cannot_be_installed_the_version_before_stays(computer: Computer) -> None:
    computer.run("postinst", "configure", "")
    computer.asked()
    computer.unpack("2.0")
    (computer.root / "pip-fails").touch()
    done = computer.run("postinst", "configure", "1.0")
    assert done.returncode == 1
    assert "nothing was changed" in done.stderr
    assert computer.version() == "1.0"
    assert computer.environments() == ["epf-gcs"]
    assert "deb-systemd-invoke restart epf-gcs.service" not in computer.asked()


def test_a_version_that_does_not_start_is_taken_back_and_is_tried_again_by_dpkg(computer: Computer) -> None:
    computer.run("postinst", "configure", "")
    computer.unpack("2.0")
    failing = computer.root / "stand-ins/deb-systemd-invoke"
    failing.write_text('#!/bin/sh\n! grep -q 2.0 "$DPKG_ROOT/opt/epf-gcs/version"\n')
    done = computer.run("postinst", "configure", "1.0")
    assert done.returncode == 1
    assert "the one before runs again" in done.stderr
    assert computer.version() == "1.0"
    assert computer.environments() == ["epf-gcs"]
    failing.write_text("#!/bin/sh\n")
    assert computer.run("postinst", "configure", "1.0").returncode == 0
    assert computer.version() == "2.0"


def test_another_python_of_the_system_gets_another_environment_and_the_same_one_none(computer: Computer) -> None:
    computer.run("postinst", "configure", "")
    computer.asked()
    assert computer.run("postinst", "triggered", "/usr/bin/python3").returncode == 0
    assert computer.asked() == []
    (computer.root / "python-is").write_text("3.13")
    assert computer.run("postinst", "triggered", "/usr/bin/python3").returncode == 0
    assert "Python 3.13" in (computer.root / "opt/epf-gcs/made-from").read_text()
    # Whether it is enabled is the administrator's.
    asked = computer.asked()
    assert "deb-systemd-invoke restart epf-gcs.service" in asked
    assert not [line for line in asked if line.startswith("deb-systemd-helper")]


def test_a_station_of_the_script_gives_way_and_its_files_are_kept_aside(computer: Computer) -> None:
    units = computer.root / "etc/systemd/system"
    units.mkdir(parents=True)
    (units / "epf-gcs.service").write_text("changed by somebody")
    link = computer.root / "usr/local/bin/epf-gcs"
    link.parent.mkdir(parents=True)
    link.symlink_to("/opt/epf-gcs/bin/epf-gcs")
    assert computer.run("preinst", "install").returncode == 0
    assert [path.name for path in units.iterdir()] == ["epf-gcs.service.before-package"]
    assert not link.is_symlink()


def test_a_removal_takes_the_program_and_no_data(computer: Computer) -> None:
    computer.run("postinst", "configure", "")
    data = computer.root / "var/lib/epf-gcs"
    data.mkdir()
    (data / "access.sqlite").touch()
    assert computer.run("prerm", "remove").returncode == 0
    assert any("stop" in line and "epf-gcs.service" in line for line in computer.asked())
    assert computer.run("postrm", "remove").returncode == 0
    assert computer.environments() == []
    assert (data / "access.sqlite").exists()


def test_a_purge_keeps_recordings_and_says_where_they_are(computer: Computer) -> None:
    data = computer.root / "var/lib/epf-gcs"
    for name in ("recordings/a.mcap", "recordings/a.json", "bin/b.mcap", "tls/authority.pem", "columns/c"):
        (data / name).parent.mkdir(parents=True, exist_ok=True)
        (data / name).touch()
    done = computer.run("postrm", "purge")
    assert done.returncode == 0
    assert f"2 recordings of flights stay in {data}" in done.stdout
    assert f"rm -r {data}" in done.stdout
    assert sorted(path.name for path in data.rglob("*") if path.is_file()) == ["a.json", "a.mcap", "b.mcap"]
    assert not [line for line in computer.asked() if line.startswith("userdel")]


def test_a_purge_without_recordings_leaves_nothing(computer: Computer) -> None:
    data = computer.root / "var/lib/epf-gcs"
    (data / "recordings").mkdir(parents=True)
    assert computer.run("postrm", "purge").returncode == 0
    assert not data.exists()
    assert "userdel epf-gcs" in computer.asked()
