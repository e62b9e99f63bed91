"""What this station is: versions, machine, board and the licences of what it is made of."""

from __future__ import annotations

import asyncio
import platform
from dataclasses import asdict
from typing import Literal

from fastapi import APIRouter

from epf_gcs import __version__
from epf_gcs.contract.shapes import Output
from epf_gcs.contract.status import Firmware
from epf_gcs.web.interface.about.packages import packages
from epf_gcs.web.interface.deps import MirrorDep
from epf_gcs.web.serving.problems import reading_problems

router = APIRouter(tags=["state"])


class AboutBoard(Output):
    """The board that is open; a legacy board has no name."""

    name: str | None
    version: str | None
    mode: Literal["legacy", "extended"]


class AboutPackage(Output):
    """A package that the gateway runs with; `licence` is null where it does not name one."""

    name: str
    version: str
    licence: str | None


class About(Output):
    """Versions and licences."""

    version: str
    python: str
    platform: str
    board: AboutBoard | None
    packages: list[AboutPackage]


@router.get("/about", responses=reading_problems())
async def get_about(mirror: MirrorDep) -> About:
    """Versions of the gateway, of Python and of the board, and the packages in use with their licences."""
    found = await asyncio.to_thread(packages)
    board = mirror.status.board
    firmware = board.firmware or Firmware(None, None)
    return About.model_validate(
        {
            "version": __version__,
            "python": platform.python_version(),
            "platform": f"{platform.system()} {platform.machine()}",
            "board": {**asdict(firmware), "mode": board.mode} if board.state == "open" and board.mode else None,
            "packages": [asdict(package) for package in found],
        }
    )
