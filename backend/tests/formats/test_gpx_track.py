"""Tracks as GPX: every point with its time, and no name can get into the structure."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from epf_gcs.formats.gpx_track import TimedTrack, gpx_track_pieces
from epf_gcs.formats.samples import Samples

GPX = "{http://www.topografix.com/GPX/1/1}"
TPX = "{http://www.garmin.com/xmlschemas/TrackPointExtension/v2}"


def part(*times_s: float) -> Samples:
    times = np.array(times_s)
    flat = np.zeros_like(times)
    return Samples(times, 27.0 + times * 1e-4, flat - 15.0, times * 10.0, flat, flat, flat, flat + 20.0, flat + 0.0)


def written(*tracks: TimedTrack) -> etree._Element:
    return etree.fromstring(b"".join(gpx_track_pieces(tracks)))


def test_each_line_is_a_segment_with_place_height_and_time() -> None:
    root = written(TimedTrack("one", [[part(1.0, 2.5), part(3.0)], [part(60.0, 61.0)]]), TimedTrack("two", []))
    assert [track.findtext(f"{GPX}name") for track in root.iter(f"{GPX}trk")] == ["one"]
    assert [len(segment) for segment in root.iter(f"{GPX}trkseg")] == [3, 2]
    point = list(root.iter(f"{GPX}trkpt"))[1]
    assert dict(point.attrib) == {"lat": "27.0002500", "lon": "-15.0000000"}
    assert [child.text for child in point][:2] == ["25.000", "1970-01-01T00:00:02.500Z"]
    assert [child.tag for child in point] == [f"{GPX}{name}" for name in ("ele", "time", "extensions")], "the schema's"
    assert [found.text for found in point.iter(f"{TPX}speed", f"{TPX}course")] == ["20.00", "0.0"]


def test_a_point_whose_speed_and_course_nobody_sent_has_neither() -> None:
    unknown = part(1.0, 2.0)
    unknown.speed_mps[0] = unknown.course_deg[0] = unknown.course_deg[1] = np.nan
    first, second = written(TimedTrack("one", [[unknown]])).iter(f"{GPX}trkpt")
    assert len(first) == 2
    assert [found.tag for found in second.iter(f"{TPX}speed", f"{TPX}course")] == [f"{TPX}speed"]


@given(st.text())
def test_no_name_gets_into_the_structure(name: str) -> None:
    root = written(TimedTrack(name, [[part(1.0, 2.0)]]))
    assert len(list(root.iter(f"{GPX}trk"))) == 1
