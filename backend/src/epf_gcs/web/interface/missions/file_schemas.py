"""The shapes of plan files."""

from __future__ import annotations

from pydantic import Field

from epf_gcs.contract.shapes import Output, ParamValue
from epf_gcs.formats.mission_file import Format, NoteCode
from epf_gcs.web.interface.missions.schemas import MissionInput, WaypointModel


class MissionExport(MissionInput):
    """A plan that becomes a file; `name` is its title and the file's name."""

    name: str = Field("plan", min_length=1, max_length=80)


class MissionNote(Output):
    """Something about the file that a person should know before flying it, with the values for the sentence.

    altitude_missing {count, altitude_ft} and speed_missing {count, speed_kt}: filled in with this.
    altitude_clamped {count}: the file puts them on the ground, yet gives altitudes, which were taken.
    altitude_from_home {count, home_ft}: the planned home's altitude was added.
    home_skipped {latitude_deg, longitude_deg}: the first item of a .waypoints file is where the flight begins.
    items_skipped {count, kinds}, shapes_skipped {count}, columns_skipped {names}: what is no waypoint was left out.
    """

    code: NoteCode
    params: dict[str, ParamValue]


class MissionImport(Output):
    """What was in the file. Nothing was sent to the board."""

    format: Format
    waypoints: list[WaypointModel]
    notes: list[MissionNote]
