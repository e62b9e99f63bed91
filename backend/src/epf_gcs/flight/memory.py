"""What the gateway remembers from one start to the next: links, path of control, streams, thresholds, map sources."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import orjson

from epf_gcs.errors import GatewayError
from epf_gcs.vehicle.wanted import Wanted


@dataclass(frozen=True, slots=True)
class Remembered:
    """Plain values, as they stand in the file."""

    board_url: str | None = None
    board_identity: str | None = None
    simulator: dict[str, Any] | None = None
    hil_path: str = "manual"
    wanted: Wanted = field(default_factory=Wanted)
    thresholds: dict[str, Any] = field(default_factory=dict)
    online: dict[str, Any] = field(default_factory=dict)


class Memory:
    """One small JSON file, replaced as a whole. A disk that refuses it is reported, and nothing else changes."""

    def __init__(self, path: Path, report: Callable[[GatewayError], None]) -> None:
        self._path = path
        self._report = report
        self.now = self._load()

    def update(self, **changes: Any) -> None:
        """Remember these from now on."""
        changed = replace(self.now, **changes)
        if changed == self.now:
            return
        self.now = changed
        temporary = self._path.with_suffix(".new")
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            temporary.write_bytes(_encode(changed))
            temporary.replace(self._path)
        except OSError as error:
            self._report(
                GatewayError(
                    "memory_not_written",
                    f"The settings could not be kept in {self._path} ({error.strerror or error}): "
                    "free the disk or correct its permissions, or they are lost at the next start.",
                    path=str(self._path),
                )
            )

    def _load(self) -> Remembered:
        try:
            return _decode(orjson.loads(self._path.read_bytes()))
        except FileNotFoundError:
            return Remembered()
        except (OSError, ValueError, TypeError, KeyError, AttributeError) as error:
            self._report(
                GatewayError(
                    "memory_unreadable",
                    f"The settings in {self._path} could not be read ({type(error).__name__}): "
                    "the gateway starts without them.",
                    path=str(self._path),
                )
            )
            return Remembered()


def _encode(values: Remembered) -> bytes:
    return orjson.dumps(
        {
            "board_url": values.board_url,
            "board_identity": values.board_identity,
            "simulator": values.simulator,
            "hil_path": values.hil_path,
            "streams": sorted(values.wanted.streams),
            "periods_ms": dict(values.wanted.periods_ms),
            "source": values.wanted.source,
            "thresholds": values.thresholds,
            "online": values.online,
        },
        option=orjson.OPT_INDENT_2,
    )


def _decode(values: dict[str, Any]) -> Remembered:
    source = values["source"]
    return Remembered(
        board_url=_text(values["board_url"]),
        board_identity=_text(values["board_identity"]),
        simulator=dict(values["simulator"]) if values["simulator"] is not None else None,
        hil_path="assisted" if values["hil_path"] == "assisted" else "manual",
        wanted=Wanted(
            frozenset(str(stream) for stream in values["streams"]),
            {str(name): int(period) for name, period in values["periods_ms"].items()},
            None if source is None else int(source),
        ),
        # Not in the files of earlier versions.
        thresholds=dict(values.get("thresholds", {})),
        online=dict(values.get("online", {})),
    )


def _text(value: Any) -> str | None:
    return None if value is None else str(value)
