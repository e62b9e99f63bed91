"""What a caller may do, as one of three roles."""

from __future__ import annotations

from enum import IntEnum
from typing import Final, Literal, cast


class Role(IntEnum):
    """Each role may do all that the one before it may. The numbers are stored: never change them."""

    viewer = 1
    """Sees everything, changes nothing."""
    operator = 2
    """May also ask for control and, having it, command."""
    owner = 3
    """May also admit people, make keys, take control at once and delete flights."""


RoleName = Literal["viewer", "operator", "owner"]

OPEN: Final = 0
"""In place of a role: for anyone, also without a key."""

Least = Role | Literal[0]
"""The least role that something needs, or OPEN."""


def name_of(role: int) -> RoleName:
    """The name of a role, also of a stored number."""
    return cast(RoleName, Role(role).name)
