"""The shapes of plan files."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Final, Literal, Self

from fastapi import Query
from pydantic import Field

from epf_gcs.contract.shapes import Output, ParamValue
from epf_gcs.contract.surroundings import HeightSet
from epf_gcs.formats.mission_file import Format, MissionFile, NoteCode
from epf_gcs.web.interface.missions.schemas import MissionInput

_BY_THE_GROUND: Final = frozenset({"altitude_from_ground", "home_off_ground"})

Thinned = Annotated[bool, Query(description="Read a flown track as a plan of few waypoints; else it is refused.")]


class MissionExport(MissionInput):
    """A plan that becomes a file; `name` is its title and the file's name."""

    name: str = Field("plan", min_length=1, max_length=80)


class MissionNote(Output):
    """Something about the file that a person should know before flying it, with the values for the sentence.

    altitude_missing {count, altitude_ft} and speed_missing {count, speed_kt}: filled in with this.
    altitude_clamped {count}: the file puts them on the ground, yet gives altitudes, which were taken.
    altitude_from_home {count, home_ft}: heights above home; home's altitude was added.
    altitude_from_ground {count, lowest_ft, highest_ft}: heights above the ground; the ground's altitude, between these,
    was added.
    home_off_ground {home_ft, ground_ft}: the file's home is far above or below the ground at its first waypoint.
    track_thinned {points, waypoints, deviation_m}: a flown track, as the waypoints that it differs least from.
    track_pieces {count}: the track has so many pieces, of which the longest was taken.
    home_skipped {latitude_deg, longitude_deg}: the first item of a .waypoints file is where the flight begins.
    items_skipped {count, kinds}, shapes_skipped {count}, columns_skipped {names}: what is no waypoint was left out.
    """

    code: NoteCode
    params: dict[str, ParamValue]


class AltitudeOrigin(Output):
    """What an altitude was converted from: `height_ft` above home or the ground, whose altitude is `reference_ft`."""

    frame: Literal["home", "ground"]
    height_ft: float
    reference_ft: float


class ImportedWaypoint(Output):
    """A waypoint as the board takes it: `altitude_ft` above mean sea level, as the file says it or from `origin`."""

    latitude_deg: float
    longitude_deg: float
    altitude_ft: float
    speed_kt: float
    origin: AltitudeOrigin | None


class MissionImport(Output):
    """What was in the file. Nothing was sent to the board. `heights`: the sets of terrain by which its altitudes were
    converted or compared; empty if none was needed."""

    format: Format
    waypoints: list[ImportedWaypoint]
    notes: list[MissionNote]
    heights: list[HeightSet]

    @classmethod
    def of(cls, found: MissionFile, heights: Sequence[HeightSet]) -> Self:
        """A plan that was read. `heights`: what the ground below its waypoints is known by."""
        return cls(
            format=found.format,
            waypoints=[
                ImportedWaypoint(
                    latitude_deg=waypoint.latitude_deg,
                    longitude_deg=waypoint.longitude_deg,
                    altitude_ft=waypoint.altitude_ft,
                    speed_kt=waypoint.speed_kt,
                    origin=None if origin is None else AltitudeOrigin(**origin._asdict()),
                )
                for waypoint, origin in zip(found.waypoints, found.origins, strict=True)
            ],
            notes=[MissionNote(code=note.code, params=note.params) for note in found.notes],
            heights=list(heights) if any(note.code in _BY_THE_GROUND for note in found.notes) else [],
        )
