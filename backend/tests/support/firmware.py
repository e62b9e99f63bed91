"""Builds firmware targets for tests, under a lock because several test workers share one tree."""

from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
from pathlib import Path
from typing import Final

from epf_gcs.launcher.emulated import QEMU

FIRMWARE: Final = Path(__file__).resolve().parents[3] / "firmware"
_ARM_COMPILER: Final = "arm-none-eabi-gcc"


def make(*targets: str) -> None:
    """Build the targets; a second caller waits and finds them up to date."""
    # Do not pass on the options of the make that runs the tests.
    environment = {
        name: value for name, value in os.environ.items() if not name.startswith("MAKE") and name != "MFLAGS"
    }
    build = FIRMWARE / "build"
    build.mkdir(exist_ok=True)
    with (build / "tests.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        subprocess.run(["make", "-s", "-C", str(FIRMWARE), *targets], env=environment, check=True)


def lacking_for_images() -> str | None:
    """What is missing on this computer to build and run the images of the board's processors; None if nothing."""
    missing = [program for program in (_ARM_COMPILER, QEMU) if shutil.which(program) is None]
    return f"{' and '.join(missing)} cannot be installed here" if missing else None
