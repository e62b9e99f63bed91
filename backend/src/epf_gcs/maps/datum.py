"""What the heights of a set of terrain count from: what the set says of it, and what a person chose for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final, Literal

import orjson

from epf_gcs.disk import KeptFile
from epf_gcs.errors import ConflictError
from epf_gcs.maps.layer import Datum, LayerFormat
from epf_gcs.maps.open_files import Stamp

METADATA_KEY: Final = "vertical_datum"
"""Under this name our own sets say it."""
DATUM_OF_FORMAT: Final[Mapping[LayerFormat, Datum]] = {"hgt": "orthometric", "field_terrain": "orthometric"}
"""Formats that have one datum: SRTM's files count from EGM96, as do the sources of prepared fields from the sea."""

_FILE: Final = ".heights.json"
# Names under which programs write it; no specification has one.
_KEYS: Final = (METADATA_KEY, "verticaldatum", "heightreference", "height_reference", "vdatum")
_WORDS: Final[tuple[tuple[Datum, tuple[str, ...]], ...]] = (
    ("orthometric", ("orthometric", "egm96", "egm2008", "egm08", "geoid", "sea level", "msl", "5773", "3855")),
    ("ellipsoidal", ("ellipsoid", "4979")),
)


def stated_datum(metadata: Mapping[str, Any]) -> Datum | None:
    """The datum that a layer.json or the metadata of MBTiles states; None if it states none that is known."""
    said = {key.lower(): str(value).lower() for key, value in metadata.items()}
    return next((datum for key in _KEYS if (datum := datum_in(said.get(key, ""))) is not None), None)


def datum_in(words: str) -> Datum | None:
    """The datum that these words name, in lower case; None for others."""
    return next((datum for datum, names in _WORDS if any(name in words for name in names)), None)


class DatumChoices:
    """What was chosen for sets that say nothing, kept in the maps' folder. Blocks; thread-safe by its one writer.

    A choice holds for the file as it was: one with the same name and another stamp is asked for again.
    """

    def __init__(self, folder: Path, on_damage: Callable[[Path | None], None] = lambda _kept: None) -> None:
        self._file = KeptFile(folder / _FILE, _decode, orjson.dumps)
        self._on_damage = on_damage
        self._chosen: dict[str, tuple[Stamp, Datum]] | None = None

    def of(self, layer_id: str, stamp: Stamp) -> Datum | None:
        """The choice for a set; None if there is none."""
        chosen = self._read().get(layer_id)
        return chosen[1] if chosen is not None and chosen[0] == stamp else None

    def put(self, layer_id: str, stamp: Stamp, datum: Datum) -> None:
        """Keep a choice. Raises ConflictError if the disk does not take it; then nothing changes."""
        changed = {**self._read(), layer_id: (stamp, datum)}
        try:
            self._file.write(changed)
        except OSError as error:
            why = error.strerror or str(error)
            raise ConflictError(
                "map_not_written",
                f"'{layer_id}' could not be written ({why}): correct the permissions of the maps' folder.",
                name=layer_id,
                why=why,
            ) from error
        self._chosen = changed

    def _read(self) -> dict[str, tuple[Stamp, Datum]]:
        if self._chosen is None:
            try:
                self._chosen = self._file.read_or_set_aside(self._on_damage) or {}
            except OSError:
                return {}
        return self._chosen


def _decode(text: bytes) -> dict[str, tuple[Stamp, Datum]]:
    return {key: (tuple(map(int, stamp)), _known(datum)) for key, (stamp, datum) in orjson.loads(text).items()}


def _known(datum: object) -> Literal["orthometric", "ellipsoidal"]:
    if datum == "orthometric":
        return "orthometric"
    if datum == "ellipsoidal":
        return "ellipsoidal"
    raise ValueError(f"'{datum}' is no datum")
