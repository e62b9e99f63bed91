"""The doctor as the web process asks it: by its program, behind all others, and not for ever."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from epf_gcs.errors import ConflictError
from epf_gcs.web.setup.doctor import Doctor
from epf_gcs.web.setup.schemas import DoctorFinding
from tests.support.waiting import DEADLINE_S


def look(data: Path, doctor_says: str, longest_s: float = DEADLINE_S) -> list[DoctorFinding]:
    return asyncio.run(a_doctor(data, doctor_says, longest_s).look(8123, "es"))


def a_doctor(data: Path, code: str, longest_s: float = DEADLINE_S) -> Doctor:
    return Doctor(data, ("-c", code), longest_s)


def test_the_real_one_looks_at_this_folder_and_speaks_spanish(tmp_path: Path) -> None:
    found = asyncio.run(Doctor(tmp_path).look(0, "es"))
    assert DoctorFinding(state="ok", what=f"Carpeta de datos {tmp_path}", mend="") in found


def test_it_is_told_folder_port_and_language_and_faults_are_findings(tmp_path: Path) -> None:
    code = """
import json, sys
print(json.dumps([{"state": "fault", "what": " ".join(sys.argv[1:]), "mend": ""}]))
sys.exit(1)
"""
    (found,) = look(tmp_path, code)
    assert found.what == f"--data-dir {tmp_path} --port 8123 --language es"


def test_it_lets_all_others_go_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slowed: list[str] = []
    monkeypatch.setattr("epf_gcs.web.setup.doctor.slow_down", lambda process, _niceness: slowed.append(str(process)))
    code = """
import json, os
print(json.dumps([{"state": "ok", "what": str(os.getpid()), "mend": ""}]))
"""
    assert [found.what for found in look(tmp_path, code)] == slowed


@pytest.mark.parametrize("code", ["", "print('no JSON')", "print('[{}]')"])
def test_one_that_says_nothing_of_use_has_failed(tmp_path: Path, code: str) -> None:
    with pytest.raises(ConflictError) as failed:
        look(tmp_path, code)
    assert failed.value.code == "doctor_failed"


def test_one_that_hangs_is_given_up(tmp_path: Path) -> None:
    with pytest.raises(ConflictError) as late:
        look(tmp_path, "import threading; threading.Event().wait()", 0.2)
    assert late.value.code == "doctor_late"


def test_of_two_who_ask_at_once_the_second_waits(tmp_path: Path) -> None:
    alone = """
import os, sys
os.close(os.open(sys.argv[2] + "/alone", os.O_CREAT | os.O_EXCL))
print("[]", flush=True)
os.unlink(sys.argv[2] + "/alone")
"""

    async def two() -> list[list[DoctorFinding]]:
        doctor = a_doctor(tmp_path, alone)
        return list(await asyncio.gather(doctor.look(1, "es"), doctor.look(2, "en")))

    assert asyncio.run(two()) == [[], []]
