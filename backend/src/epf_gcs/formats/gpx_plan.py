"""Flight plans as GPX 1.1: reads routes of hand-held receivers and planners; ours keep the speeds in an extension."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final
from xml.etree.ElementTree import Element

from epf_gcs.codec.tables import Waypoint
from epf_gcs.formats.mission_file import FilePlan, Note, Place, Point, number
from epf_gcs.formats.xml_tree import EPF, GPX, add, child, child_text, decimal, every, local, plain, xml_bytes
from epf_gcs.units import ft_from_m, m_from_ft

EVENT_TYPE: Final = "epf:"
"""How the type of a point begins at which something happened in a flight: it is no waypoint."""


def write_gpx(name: str, waypoints: Sequence[Waypoint]) -> bytes:
    """A GPX 1.1 document with one route."""
    root = Element("gpx", {"xmlns": GPX, "xmlns:epf": EPF, "version": "1.1", "creator": "EPF GCS"})
    route = add(root, "rte")
    add(route, "name", plain(name))
    for index, waypoint in enumerate(waypoints):
        point = add(route, "rtept", lat=decimal(waypoint.latitude_deg), lon=decimal(waypoint.longitude_deg))
        add(point, "ele", decimal(m_from_ft(waypoint.altitude_ft)))
        add(point, "name", str(index))
        add(add(point, "extensions"), "epf:speed_kt", decimal(waypoint.speed_kt))
    return xml_bytes(root)


def read_gpx(root: Element) -> FilePlan:
    """The first route with points, else all single waypoints, else the first track. Raises FileFault.

    Elevations are metres above mean sea level. A speed is read from our own extension only: in a hand-held's file it
    is the speed at which a track was recorded, not one to fly.
    """
    groups = [
        *_groups(root, "rte", "rtept"),
        [point for point in every(root, "wpt") if not (child_text(point, "type") or "").startswith(EVENT_TYPE)],
        *_groups(root, "trk", "trkpt"),
    ]
    filled = [group for group in groups if group]
    if not filled:
        return FilePlan("gpx", [])
    skipped = len(filled) - 1
    notes = [Note("shapes_skipped", {"count": skipped})] if skipped else []
    points = [_point(element, index) for index, element in enumerate(filled[0], 1)]
    return FilePlan("gpx", points, notes, is_track=local(filled[0][0]) == "trkpt")


def _groups(root: Element, group: str, point: str) -> list[list[Element]]:
    return [list(every(found, point)) for found in every(root, group)]


def _point(element: Element, index: int) -> Point:
    place = Place(local(element), index)
    elevation = child_text(element, "ele")
    speed = None
    extensions = child(element, "extensions")
    if extensions is not None:
        speed = next((found for found in extensions if found.tag == f"{{{EPF}}}speed_kt"), None)
    return Point(
        place,
        number(element.get("lat"), "latitude_deg", place),
        number(element.get("lon"), "longitude_deg", place),
        None if elevation is None else ft_from_m(number(elevation, "ele", place)),
        None if speed is None else number(speed.text, "speed_kt", place),
    )
