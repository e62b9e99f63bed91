"""Every part of the gateway can be loaded, and every program tells its options, where modules of Linux are missing.

This is as far as this machine can try macOS and Windows: what those systems do not have is hidden from our code, except
from `system/`, whose modules ask which system it is; mypy checks those for both (`make check-platforms`).
"""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.support.waiting import DEADLINE_S

# Modules and names that Windows lacks; macOS lacks some of the names.
_REAL_TIME = "os.sched_setscheduler os.sched_param os.SCHED_RR os.fdatasync"
_POSIX = (
    "socket.AF_UNIX signal.SIGHUP signal.SIGKILL os.fork os.getuid os.geteuid os.killpg os.nice os.pread os.pwrite "
    "os.setpriority os.statvfs os.sync os.uname"
)
WINDOWS_LACKS = ("fcntl grp pty pwd resource termios tty uvloop", f"{_REAL_TIME} {_POSIX}")
MACOS_LACKS = ("", _REAL_TIME)

HIDDEN = """
import builtins, importlib, os, pkgutil, runpy, signal, socket, sys
modules, names, programs = sys.argv[1:4]
# Loaded before anything is hidden: other people's packages look for their own system.
import asyncio, ctypes, multiprocessing, tempfile
for name in (
    "cryptography defusedxml.ElementTree duckdb fastapi fastapi_offline httptools httpx ifaddr mcap numpy "
    "orjson platformdirs pmtiles.reader pyarrow.parquet pydantic pydantic_settings rasterio rich segno "
    "serial.tools.list_ports structlog typer uvicorn websockets zstandard"
).split():
    importlib.import_module(name)
import epf_gcs.system
for found in pkgutil.iter_modules(epf_gcs.system.__path__, "epf_gcs.system."):
    importlib.import_module(found.name)
real = builtins.__import__
def only_ours(name, globals=None, *rest, **named):
    if (globals or {}).get("__name__", "").startswith("epf_gcs") and name.partition(".")[0] in modules.split():
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    return real(name, globals, *rest, **named)
builtins.__import__ = only_ours
for name in names.split():
    module, _, attribute = name.partition(".")
    if hasattr(sys.modules[module], attribute):
        delattr(sys.modules[module], attribute)
import epf_gcs
for found in pkgutil.walk_packages(epf_gcs.__path__, "epf_gcs."):
    # `link/serial.py` loads one of two modules; the other one is of the other systems.
    if not found.name.endswith(("__main__", "_posix")):
        importlib.import_module(found.name)
print("all are loaded")
for program in programs.split():
    sys.argv = [program, "--help"]
    sys.modules.pop(program, None)
    try:
        runpy.run_module(program, run_name="__main__", alter_sys=True)
    except SystemExit as ended:
        print(f"{program} ended with {ended.code or 0}")
"""
PROGRAMS = "epf_gcs.launcher epf_gcs.launcher.gateway epf_gcs.flight epf_gcs.web epf_gcs.replay epf_gcs.simulator"


@pytest.mark.parametrize("lacking", [WINDOWS_LACKS, MACOS_LACKS], ids=["windows", "macos"])
def test_every_module_can_be_loaded_and_every_program_tells_its_options(lacking: tuple[str, str]) -> None:
    answer = subprocess.run(
        [sys.executable, "-c", HIDDEN, *lacking, PROGRAMS],
        capture_output=True,
        text=True,
        check=False,
        timeout=DEADLINE_S,
    )
    assert "all are loaded" in answer.stdout, answer.stderr[-2000:]
    for program in PROGRAMS.split():
        assert f"{program} ended with 0" in answer.stdout, answer.stderr[-2000:]
