"""The aircraft's shape: whole, symmetrical, its nose where KML has the north."""

from __future__ import annotations

from lxml import etree

from epf_gcs.formats.aircraft_model import aircraft_dae

ROOT = etree.fromstring(aircraft_dae())


def found(name: str) -> etree._Element:
    return next(ROOT.iter(f"{{*}}{name}"))


def points() -> list[tuple[float, ...]]:
    numbers = [float(text) for text in found("float_array").text.split()]
    return [tuple(numbers[index : index + 3]) for index in range(0, len(numbers), 3)]


def test_every_reference_leads_somewhere() -> None:
    ids = {element.get("id") for element in ROOT.iter() if element.get("id")}
    references = {
        element.get(attribute).removeprefix("#")
        for element in ROOT.iter()
        for attribute in ("url", "target", "source")
        if element.get(attribute)
    }
    assert references <= ids
    assert int(found("float_array").get("count")) == 3 * len(points()) == 3 * int(found("accessor").get("count"))


def test_every_corner_is_a_point_and_every_triangle_is_seen_from_both_sides() -> None:
    corners = [int(text) for text in found("p").text.split()]
    assert max(corners) < len(points())
    triangles = [tuple(corners[index : index + 3]) for index in range(0, len(corners), 3)]
    assert len(triangles) == int(found("triangles").get("count"))
    assert all(triangle[::-1] in triangles for triangle in triangles)


def test_the_nose_is_north_the_fin_is_up_and_both_sides_are_alike() -> None:
    assert found("up_axis").text == "Z_UP"
    shape = set(points())
    assert {(-x if x else x, y, z) for x, y, z in shape} == shape
    assert max(y for _, y, _ in shape) == 4.0
    assert max(shape, key=lambda point: point[2])[1] < 0, "the highest point is the fin, behind"
