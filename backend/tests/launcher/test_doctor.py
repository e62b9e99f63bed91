"""The doctor finds each fault and says the command that mends it."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import socket
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest
from typer.testing import CliRunner

from epf_gcs.data_folder.lock import DataFolder
from epf_gcs.data_folder.version import FORMAT, write_format
from epf_gcs.launcher import doctor, doctor_serial
from epf_gcs.launcher.doctor import findings, report
from epf_gcs.launcher.findings import Finding
from epf_gcs.launcher.gateway import app
from epf_gcs.launcher.spanish import SPANISH


def all_of(data: Path, port: int = 8000) -> list[Finding]:
    return list(findings(data, port))


def the_one(found: Iterator[Finding] | list[Finding], words: str) -> Finding:
    matching = [one for one in found if words in one.what]
    assert len(matching) == 1, [one.what for one in found]
    return matching[0]


def test_a_taken_port_names_the_program_that_has_it(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        found = the_one(doctor._ports(tmp_path, port), f"TCP port {port}")
    assert found.state == "fault"
    assert f"process {os.getpid()}" in found.what
    assert "epf-gcs --port" in found.mend


def test_a_taken_port_of_the_simulator_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        monkeypatch.setattr(doctor, "_SIMULATOR_PORT", taken.getsockname()[1])
        found = the_one(doctor._ports(tmp_path, 0), "where X-Plane sends to")
    assert (found.state, "sudo ss -ulpn" in found.mend) == ("fault", True)


def test_the_ports_of_the_station_that_runs_are_no_fault(tmp_path: Path) -> None:
    with DataFolder(tmp_path), socket.create_server(("127.0.0.1", 0)) as own:
        (found,) = doctor._ports(tmp_path, own.getsockname()[1])
    assert found.state == "ok"


def test_a_full_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    usage = type(shutil.disk_usage(tmp_path))(10**12, 10**12 - 1000, 1000)
    monkeypatch.setattr(shutil, "disk_usage", lambda _path: usage)
    found = the_one(all_of(tmp_path), "recordings stop when it is full")
    assert (found.state, "--data-dir" in found.mend) == ("fault", True)


def test_a_file_of_root_in_the_data_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "state.json").write_text("{}")
    real = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: Path(path).name != "state.json" and real(path, mode))
    found = the_one(doctor._data_folder(tmp_path), "state.json")
    assert (found.state, found.mend.startswith(f'sudo chown -R "$USER" {tmp_path}')) == ("fault", True)


def test_a_folder_that_may_not_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda _path, _mode: False)
    (found,) = doctor._data_folder(tmp_path / "deep" / "data")
    assert (found.state, "sudo chown" in found.mend) == ("fault", True)


def test_a_disk_that_is_mounted_read_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    flags = type("Flags", (), {"f_flag": os.ST_RDONLY})
    monkeypatch.setattr(os, "statvfs", lambda _path: flags)
    (found,) = doctor._data_folder(tmp_path)
    assert (found.state, "mount -o remount,rw" in found.mend) == ("fault", True)


def test_a_folder_of_a_newer_version(tmp_path: Path) -> None:
    write_format(tmp_path, FORMAT + 1, "9.0.0")
    (found,) = doctor._data_folder(tmp_path)
    assert (found.state, found.mend) == ("fault", "Install epf-gcs 9.0.0")


def test_a_package_of_another_version(monkeypatch: pytest.MonkeyPatch) -> None:
    assert list(doctor._wrong_packages()) == []
    monkeypatch.setattr(
        doctor, "requires", lambda _name: ["orjson==0.0.1", "no-such-package==1.0", 'jsbsim==0.1; extra == "sim"']
    )
    wrong = list(doctor._wrong_packages())
    assert [line.rpartition(" ")[0] for line in wrong] == [wrong[0].rpartition(" ")[0], "no-such-package is"]
    assert wrong[0].endswith("not 0.0.1")
    (_, found) = doctor._versions()
    assert (found.state, "pipx install --force" in found.mend) == ("fault", True)


@pytest.mark.parametrize(
    ("library", "command"), [("libexpat.so.1", "sudo apt install libexpat1"), ("x", "--force-reinstall")]
)
def test_a_library_of_the_system_that_is_missing(library: str, command: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(name: str) -> None:
        if name == "rasterio":
            raise ImportError(f"{library}: cannot open shared object file")

    monkeypatch.setattr(doctor, "import_module", fails)
    found = the_one(doctor._extras(), "Importing heights fails")
    assert (found.state, command in found.mend) == ("fault", True)


def test_a_part_that_was_not_installed_is_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("epf_gcs.extras.find_spec", lambda name: None if name == "jsbsim" else object())
    found = the_one(doctor._extras(), "jsbsim not installed")
    assert (found.state, "install jsbsim" in found.mend) == ("note", True)


def test_a_clock_that_stands_in_the_past(monkeypatch: pytest.MonkeyPatch) -> None:
    past = __import__("time").gmtime(0)
    monkeypatch.setattr("epf_gcs.launcher.doctor.time.gmtime", lambda: past)
    (found,) = doctor._clock()
    assert (found.state, "1970" in found.what, "sudo date" in found.mend) == ("fault", True, True)


def test_a_clock_that_nobody_vouches_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor, "is_synchronised", lambda: False)
    (found,) = doctor._clock()
    assert (found.state, "timedatectl set-ntp" in found.mend) == ("note", True)


def port(monkeypatch: pytest.MonkeyPatch) -> None:
    one = type("Port", (), {"device": "/dev/ttyUSB0", "hwid": "USB"})
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: [one])
    monkeypatch.setattr(os, "access", lambda _path, _mode: False)
    monkeypatch.setattr(doctor_serial, "_group_of", lambda _path: "dialout")


def test_a_port_that_may_not_be_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    port(monkeypatch)
    monkeypatch.setattr(doctor_serial, "_groups_on_paper", set)
    (found,) = doctor_serial.serial_ports()
    assert (found.state, "usermod -a -G dialout" in found.mend) == ("fault", True)


def test_a_group_that_counts_from_the_next_login(monkeypatch: pytest.MonkeyPatch) -> None:
    port(monkeypatch)
    monkeypatch.setattr(doctor_serial, "_groups_on_paper", lambda: {"dialout"})
    (found,) = doctor_serial.serial_ports()
    assert (found.state, found.mend) == ("fault", "Log out and in again.")


@pytest.mark.parametrize("program", ["ModemManager", "brltty"])
def test_programs_that_take_serial_ports(program: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(doctor_serial, "_RULES", ())
    monkeypatch.setattr(doctor_serial, "_process_names", lambda: iter(["init", program]))
    (found,) = doctor_serial.takers_of_ports()
    assert found.what.startswith(f"{program} runs")
    assert "systemctl disable" in found.mend
    monkeypatch.setattr(doctor_serial, "_process_names", lambda: iter(["init"]))
    assert list(doctor_serial.takers_of_ports()) == []


def test_the_report_counts_what_is_to_be_mended() -> None:
    said = report([Finding("ok", "good"), Finding("fault", "bad", "do this")])
    assert said.splitlines() == ["ok     good", "FAULT  bad", "       -> do this", "1 to mend."]


def test_every_sentence_is_there_in_spanish_too_with_the_same_values() -> None:
    said = set(_sentences(doctor)) | set(_sentences(doctor_serial))
    assert len(said) > 40
    assert sorted(said - SPANISH.keys()) == []
    names = re.compile(r"{\w+}")
    different = [text for text in said if sorted(names.findall(text)) != sorted(names.findall(SPANISH[text]))]
    assert different == []


def test_the_command_speaks_spanish(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["doctor", "--data-dir", str(tmp_path), "--language", "es"])
    assert f"Carpeta de datos {tmp_path}" in result.output


def test_the_command_answers_programs_in_json(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["doctor", "--data-dir", str(tmp_path), "--json"])
    assert {"state": "ok", "what": f"Data folder {tmp_path}", "mend": ""} in json.loads(result.output)


def _sentences(module: ModuleType) -> Iterator[str]:
    """Every text that the module gives to `found`."""
    for call in ast.walk(ast.parse(Path(str(module.__file__)).read_text())):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "found":
            for argument in call.args[1:]:
                texts = (node.value for node in ast.walk(argument) if isinstance(node, ast.Constant))
                yield from (text for text in texts if isinstance(text, str) and text)
