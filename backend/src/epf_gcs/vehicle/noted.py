"""What the notes of a recording say of the gains and of whose flight it is, in the interface's shapes.

A recording may be a stranger's: what is not as noted by a station is not known.
"""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.codec.messages_gen import PARAMETERS

# What is known of a gain (`vehicle/parameters.py`); another word can only come from a stranger's file.
_STATES: Final = ("unknown", "loaded", "pending", "confirmed", "rejected")


def gains_of(content: dict[str, Any]) -> list[dict[str, Any]]:
    """The gains from their note ({name: {"value", "state", "loaded"}}), as GET /parameters gives them."""
    found = []
    for gain in PARAMETERS:
        given = content.get(gain.name)
        held: dict[str, Any] = given if isinstance(given, dict) else {}
        found.append(
            {
                "name": gain.name,
                "group": gain.group,
                "value": _number(held.get("value")),
                "loaded": _number(held.get("loaded")),
                "state": held["state"] if held.get("state") in _STATES else "unknown",
                "unit": "1",
                "minimum": gain.minimum,
                "maximum": gain.maximum,
                "step": gain.step,
                "default": gain.default,
                "is_integer": gain.is_integer,
                "doc": gain.doc,
            }
        )
    return found


def _number(value: Any) -> float | None:
    return value if isinstance(value, int | float) and not isinstance(value, bool) else None


def identity_of(content: Any) -> dict[str, Any]:
    """The identity from its note; nothing is known without one."""
    given: dict[str, Any] = content if isinstance(content, dict) else {}
    board = given.get("board")
    name = board.get("name") if isinstance(board, dict) else board
    texts = {key: given.get(key) for key in ("station", "firmware", "aircraft", "operator")}
    clean = {key: value if isinstance(value, str) else None for key, value in texts.items()}
    return {**clean, "board": name if isinstance(name, str) else None, "emulated": given.get("emulated") is True}
