"""Recognise the format of a plan file and read it; and the writers by format."""

from __future__ import annotations

import codecs
import io
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Final
from xml.etree.ElementTree import Element

from epf_gcs.codec.tables import Waypoint
from epf_gcs.contract.flights import FlownPath
from epf_gcs.errors import InvalidInputError, Params
from epf_gcs.formats.csv_plan import read_csv, write_csv
from epf_gcs.formats.fence_rows import FenceRowFault, are_rows, fence_items
from epf_gcs.formats.file_kind import FileKind, kind_of
from epf_gcs.formats.gpx_plan import read_gpx, write_gpx
from epf_gcs.formats.kml_plan import read_kml, write_kml
from epf_gcs.formats.kmz import DOCUMENT, kmz_pieces
from epf_gcs.formats.mission_file import (
    MAX_WAYPOINTS,
    FileFault,
    FileFormat,
    FilePlan,
    MissionFile,
    Note,
    Place,
    Point,
)
from epf_gcs.formats.plan_altitudes import settle
from epf_gcs.formats.qgc_plan import has_fence, read_plan, write_plan
from epf_gcs.formats.track_thinning import thinned
from epf_gcs.formats.wpl_plan import SIGNATURE, FirstItem, read_wpl
from epf_gcs.formats.xml_tree import every, local, parse_xml
from epf_gcs.formats.zip_faults import ZIP_FAULTS
from epf_gcs.units import ft_from_m

MAX_FILE_BYTES: Final = 1_000_000
"""A hundred waypoints take 50 kB in the longest of the formats. A larger file, such as a day's track, is not a plan."""

_ZIP: Final = b"PK\x03\x04"

WRITERS: Final[Mapping[FileFormat, Callable[[str, Sequence[Waypoint]], bytes]]] = {
    "kml": write_kml,
    "kmz": lambda name, waypoints: b"".join(kmz_pieces([(DOCUMENT, [write_kml(name, waypoints)])])),
    "gpx": write_gpx,
    "csv": lambda _, waypoints: write_csv(waypoints),
    "plan": lambda _, waypoints: write_plan(waypoints),
}


def read_plan_file(name: str, data: bytes, *, thin: bool = False, first: FirstItem | None = None) -> FilePlan:
    """What a file has, whose format is recognised by its first bytes. Raises InvalidInputError naming the file.

    `thin`: a flown track becomes the few waypoints that it differs least from; else it is refused with their number.
    `first`: what item 0 of a .waypoints is, where the file leaves it open; else such a file is refused.
    """
    with _named(name):
        plan = _read(data, first)
        return _thinned(plan, is_wanted=thin) if plan.is_track else plan


def plan_of_path(name: str, path: FlownPath, *, thin: bool) -> FilePlan:
    """A flown track that was thinned as a plan. Raises InvalidInputError with its figures if that is not wanted."""
    points = [
        Point(Place("trkpt", nth), latitude_deg, longitude_deg, ft_from_m(altitude_m), None)
        for nth, (latitude_deg, longitude_deg, altitude_m) in enumerate(path.places, 1)
    ]
    notes = [Note("track_pieces", {"count": path.pieces})] if path.pieces > 1 else []
    track = FilePlan("flight", points, notes, is_track=True)
    with _named(name):
        return _as_plan(track, path.points, path.deviation_m, is_wanted=thin) if points else track


def settle_plan(
    name: str, plan: FilePlan, ground_ft: Sequence[float | None] = (), home_ft: float | None = None
) -> MissionFile:
    """The plan for the board, with its altitudes above the sea (see `settle`). Raises InvalidInputError."""
    with _named(name):
        return settle(plan, ground_ft, home_ft)


@contextmanager
def _named(name: str) -> Iterator[None]:
    try:
        yield
    except FileFault as fault:
        raise InvalidInputError(
            fault.code, f"'{name}' cannot be read as a flight plan because {fault.why}.", name=name, **fault.params
        ) from fault


def _thinned(track: FilePlan, *, is_wanted: bool) -> FilePlan:
    points, deviation_m = thinned(track.points, MAX_WAYPOINTS)
    return _as_plan(replace(track, points=points), len(track.points), deviation_m, is_wanted=is_wanted)


def _as_plan(track: FilePlan, points: int, deviation_m: float, *, is_wanted: bool) -> FilePlan:
    """A track that was thinned from so many points. Raises FileFault if nobody asked for it as a plan."""
    figures: Params = {"points": points, "waypoints": len(track.points), "deviation_m": round(deviation_m, 1)}
    if not is_wanted:
        raise FileFault(
            "mission_file_track",
            f"it is a flown track of {points} points: as a plan of {len(track.points)} waypoints it differs by up to "
            f"{deviation_m:.0f} m: ask for it with `thin`",
            **figures,
        )
    return replace(track, notes=[*track.notes, Note("track_thinned", figures)])


def _read(data: bytes, first: FirstItem | None) -> FilePlan:
    data = unpacked_kml(data)
    plan = _read_kind(data, first)
    if not plan.points:
        _refuse_other(data)
    return plan


def _read_kind(data: bytes, first: FirstItem | None) -> FilePlan:
    start = data.removeprefix(codecs.BOM_UTF8).lstrip()[:8]
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        start = data[2:16].replace(b"\0", b"").lstrip()
    if not start:
        raise FileFault("mission_file_empty", "it is empty")
    if start.startswith(b"<"):
        return _read_xml(parse_xml(data))
    if start == SIGNATURE:
        return read_wpl(data.removeprefix(codecs.BOM_UTF8).lstrip(), first)
    try:
        return read_plan(data) if start.startswith(b"{") else read_csv(data)
    except FileFault as fault:
        if fault.code in ("mission_file_unknown", "mission_file_header"):
            _refuse_other(data)
        raise


def _refuse_other(data: bytes) -> None:
    """Raises FileFault if the file is something else of this field, with what it is."""
    plain = data.removeprefix(codecs.BOM_UTF8).lstrip(b" \t\r\n")
    if _is_fence(plain):
        raise FileFault("mission_file_fence", "it is a fence and no plan: read it as the fence of the map")
    kind = kind_of(plain)
    if kind is not None:
        why = f"it has {_KIND_WORDS[kind]} and no plan"
        raise FileFault("mission_file_other", why, kind=f"@problem.file_{kind}")


_KIND_WORDS: Final[Mapping[FileKind, str]] = {
    "areas": "shapes of a map as GeoJSON",
    "log": "the log of an autopilot or a station",
    "parameters": "parameters of an autopilot",
    "rally": "rally points",
    "recording": "a recorded flight, which the library of flights takes,",
}


def _is_fence(data: bytes) -> bool:
    """Whether it has areas, where it has no waypoints."""
    if data.startswith(SIGNATURE):
        try:
            return bool(fence_items(data))
        except FenceRowFault:
            return True
    if data.startswith(b"{"):
        return has_fence(data)
    return next(every(parse_xml(data), "Polygon"), None) is not None if data.startswith(b"<") else are_rows(data)


def _read_xml(root: Element) -> FilePlan:
    reader = {"kml": read_kml, "gpx": read_gpx}.get(local(root))
    if reader is None:
        raise FileFault("mission_file_unknown", f"it is XML, but neither KML nor GPX (<{local(root)[:30]}>)")
    return reader(root)


def unpacked_kml(data: bytes) -> bytes:
    """The first KML of a KMZ, as Google Earth saves it; other data as it is. Raises FileFault.

    At most one byte more than MAX_FILE_BYTES is unpacked.
    """
    if not data.startswith(_ZIP):
        return data
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            inside = next(entry for entry in archive.infolist() if entry.filename.lower().endswith(".kml"))
            with archive.open(inside) as file:
                unpacked = file.read(MAX_FILE_BYTES + 1)
    except (StopIteration, *ZIP_FAULTS) as error:
        raise FileFault("mission_file_archive", "it is an archive without a KML that can be read") from error
    if len(unpacked) > MAX_FILE_BYTES:
        raise FileFault("mission_file_archive", f"its KML is longer than {MAX_FILE_BYTES} bytes")
    return unpacked
