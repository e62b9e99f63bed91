"""The points of a file as a plan for the board: altitudes above the sea, converted from what is known, or refused."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from epf_gcs.codec.messages_gen import COMMANDS
from epf_gcs.codec.tables import Waypoint
from epf_gcs.codec.values import argument_fault
from epf_gcs.errors import Params
from epf_gcs.formats.mission_file import (
    MAX_WAYPOINTS,
    AltitudeOrigin,
    FileFault,
    FilePlan,
    MissionFile,
    Note,
    Place,
    Point,
    place_params,
)

# For waypoints whose file gives no speed or altitude, as in most files of other programs: the cruise speed of the
# board's own routes, and a round altitude at which a person notices that it was not in the file.
DEFAULT_SPEED_KT: Final = 55.0
DEFAULT_ALTITUDE_FT: Final = 1000.0

_ITEM: Final = {value.name: value for value in COMMANDS["mission_item"].values}
_FIELDS: Final = ("latitude_deg", "longitude_deg", "altitude_ft", "speed_kt")
# Rounds to 0.03 mm and 0.05 mm/s, just enough to remove the error of converting units twice (1000.0000000000001 ft).
_DECIMALS: Final = 4
# A planned home farther from the ground than this is more often one that was never measured.
_HOME_OFF_GROUND_FT: Final = 100.0


def settle(plan: FilePlan, ground_ft: Sequence[float | None] = (), home_ft: float | None = None) -> MissionFile:
    """The points as a plan. Raises FileFault, naming the place, if a value is outside what the board accepts, or if a
    height counts from what nobody knows.

    `ground_ft`: the ground's altitude below each point, None where not known; empty: nowhere. `home_ft`: home's, as a
    person says it, for a file that does not. Missing altitudes and speeds are filled in with defaults, and noted.
    """
    points = plan.points
    if not points:
        raise FileFault("mission_file_no_waypoints", "there are no waypoints in it", format=plan.format)
    if len(points) > MAX_WAYPOINTS:
        raise FileFault(
            "mission_file_too_long",
            f"it has more than {MAX_WAYPOINTS} waypoints, which is what a plan takes",
            maximum=MAX_WAYPOINTS,
        )
    ground_ft = ground_ft or [None] * len(points)
    origins = _origins(points, ground_ft, plan.home_ft if plan.home_ft is not None else home_ft)
    notes = [*plan.notes, *_origin_notes(origins, ground_ft, plan.home_ft)]
    without_altitude = sum(point.altitude_ft is None for point in points)
    if without_altitude:
        notes.append(Note("altitude_missing", {"count": without_altitude, "altitude_ft": DEFAULT_ALTITUDE_FT}))
    without_speed = sum(point.speed_kt is None for point in points)
    if without_speed:
        notes.append(Note("speed_missing", {"count": without_speed, "speed_kt": DEFAULT_SPEED_KT}))
    waypoints = [_waypoint(point, origin) for point, origin in zip(points, origins, strict=True)]
    return MissionFile(plan.format, tuple(waypoints), tuple(notes), tuple(origins))


def is_admissible(field: str, value: float) -> bool:
    """Whether the board accepts this value of a waypoint's field, in the field's own unit."""
    return argument_fault(_ITEM[field], value) is None


def _origins(
    points: Sequence[Point], ground_ft: Sequence[float | None], home_ft: float | None
) -> list[AltitudeOrigin | None]:
    above_home = [point for point in points if point.frame == "home" and point.altitude_ft is not None]
    if above_home and home_ft is None:
        raise _no_home(above_home, ground_ft[0])
    without_ground = [
        point
        for point, ground in zip(points, ground_ft, strict=True)
        if point.frame == "ground" and point.altitude_ft is not None and ground is None
    ]
    if without_ground:
        raise _no_ground(without_ground)
    return [
        _origin(point, home_ft if point.frame == "home" else ground)
        for point, ground in zip(points, ground_ft, strict=True)
    ]


def _origin(point: Point, reference_ft: float | None) -> AltitudeOrigin | None:
    if point.frame == "sea" or point.altitude_ft is None or reference_ft is None:
        return None
    return AltitudeOrigin(point.frame, round(point.altitude_ft, _DECIMALS), round(reference_ft, _DECIMALS))


def _origin_notes(
    origins: Sequence[AltitudeOrigin | None], ground_ft: Sequence[float | None], file_home_ft: float | None
) -> list[Note]:
    notes: list[Note] = []
    from_home = [origin for origin in origins if origin is not None and origin.frame == "home"]
    if from_home:
        home_ft = from_home[0].reference_ft
        notes.append(Note("altitude_from_home", {"count": len(from_home), "home_ft": round(home_ft, 1)}))
        if file_home_ft is not None and ground_ft[0] is not None:
            off_ft = home_ft - ground_ft[0]
            if abs(off_ft) > _HOME_OFF_GROUND_FT:
                figures: Params = {"home_ft": round(home_ft, 1), "ground_ft": round(ground_ft[0], 1)}
                notes.append(Note("home_off_ground", figures))
    below_ft = [origin.reference_ft for origin in origins if origin is not None and origin.frame == "ground"]
    if below_ft:
        span = {"lowest_ft": round(min(below_ft), 1), "highest_ft": round(max(below_ft), 1)}
        notes.append(Note("altitude_from_ground", {"count": len(below_ft), **span}))
    return notes


def _no_home(points: Sequence[Point], ground_ft: float | None) -> FileFault:
    """A question: the same file can be read with the altitude of home."""
    place = points[0].place
    return FileFault(
        "mission_file_no_home",
        f"the height of {place} counts from home and the file does not say how high home is: say it with `home_ft`",
        count=len(points),
        ground_ft=None if ground_ft is None else round(ground_ft, 1),
        **place_params(place),
    )


def _no_ground(points: Sequence[Point]) -> FileFault:
    place = points[0].place
    return FileFault(
        "mission_file_above_ground",
        f"the height of {place} is above the ground, and the station does not know how high the ground is there: "
        "bring heights of the field, or save it with absolute altitudes",
        count=len(points),
        **place_params(place),
    )


def _waypoint(point: Point, origin: AltitudeOrigin | None) -> Waypoint:
    altitude_ft = DEFAULT_ALTITUDE_FT if point.altitude_ft is None else point.altitude_ft
    waypoint = Waypoint(
        point.latitude_deg,
        point.longitude_deg,
        round(altitude_ft if origin is None else origin.height_ft + origin.reference_ft, _DECIMALS),
        DEFAULT_SPEED_KT if point.speed_kt is None else round(point.speed_kt, _DECIMALS),
    )
    for field in _FIELDS:
        value, given = _ITEM[field], getattr(waypoint, field)
        fault = argument_fault(value, given)
        if fault is not None:
            raise _out_of_range(point.place, field, given, fault)
    return waypoint


def _out_of_range(place: Place, field: str, given: float, fault: str) -> FileFault:
    value = _ITEM[field]
    return FileFault(
        "mission_file_out_of_range",
        f"in {place} {fault}",
        field=field,
        value=given,
        minimum=value.minimum,
        maximum=value.maximum,
        **place_params(place),
    )
