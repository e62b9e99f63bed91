"""What is installed apart says in one sentence that it is missing, and with which command it comes."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from epf_gcs import extras
from epf_gcs.errors import ConflictError
from epf_gcs.extras import ALL, FLIGHTS, MAPS, SIM
from epf_gcs.workers.missing import require
from tests.support.waiting import DEADLINE_S

# Each program is loaded in an interpreter of its own that does not find these.
WITHOUT = """
import importlib.abc, runpy, sys
gone = set(sys.argv.pop(1).split(","))
class Missing(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in gone:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
sys.meta_path.insert(0, Missing())
import importlib.util
real = importlib.util.find_spec
importlib.util.find_spec = lambda name, package=None: None if name in gone else real(name, package)
sys.argv = sys.argv[1:]
runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
"""
EVERY = ",".join(module for extra in ALL for module in extra.modules)


def without(modules: str, *program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", WITHOUT, modules, *program],
        capture_output=True,
        text=True,
        check=False,
        timeout=DEADLINE_S,
    )


@pytest.mark.parametrize(
    "program",
    [
        "epf_gcs.launcher",
        "epf_gcs.launcher.gateway",
        "epf_gcs.flight",
        "epf_gcs.web",
        "epf_gcs.replay",
        "epf_gcs.simulator",
        "epf_gcs.web.invite",
    ],
)
def test_every_program_is_there_without_any_extra(program: str) -> None:
    answer = without(EVERY, program, "--help")
    assert answer.returncode == 0, answer.stderr
    assert "usage" in answer.stdout.lower()


def test_the_simulator_without_its_dynamics_says_what_to_install() -> None:
    answer = without("jsbsim", "epf_gcs.simulator")
    assert answer.returncode == 1
    assert "needs jsbsim, which is not installed here" in answer.stderr
    assert "pip install jsbsim==" in answer.stderr
    assert "Traceback" not in answer.stderr


def test_the_command_installs_the_very_versions_beside_this_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        extras,
        "requires",
        lambda _name: [
            "orjson==3.13.0",
            'duckdb==2.0.0; extra == "flights"',
            'pyarrow==26.0.1; extra == "flights"',
            'rasterio==1.4.4; extra == "maps"',
        ],
    )
    monkeypatch.setattr(sys, "executable", "/opt/the station/bin/python")
    assert FLIGHTS.command() == "'/opt/the station/bin/python' -m pip install duckdb==2.0.0 pyarrow==26.0.1"
    assert MAPS.command().endswith("install rasterio==1.4.4")
    monkeypatch.setattr(sys, "prefix", str(Path("/home/ana/.local/share/pipx/venvs/epf-gcs")))
    assert FLIGHTS.command() == "pipx inject epf-gcs duckdb==2.0.0 pyarrow==26.0.1"


def test_what_is_there_is_not_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    require(SIM)
    monkeypatch.setattr(extras, "find_spec", lambda _name: None)
    with pytest.raises(ConflictError) as told:
        require(SIM)
    assert (told.value.code, told.value.params["extra"]) == ("extra_missing", "sim")
    assert str(told.value.params["command"]) in told.value.detail
