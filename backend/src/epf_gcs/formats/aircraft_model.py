"""A small aircraft as COLLADA 1.4, the only model format that Google Earth reads: metres, nose to +y, z up."""

from __future__ import annotations

from typing import Final
from xml.etree.ElementTree import Element

from epf_gcs.formats.xml_tree import add, xml_bytes

MEDIA_TYPE: Final = "model/vnd.collada+xml"
_COLLADA: Final = "http://www.collada.org/2005/11/COLLADASchema"
_PAINT: Final = "1 0.8 0 1"

_POINTS: Final = (
    # fuselage: nose, right, left, canopy, belly, tail
    (0.0, 4.0, 0.0),
    (0.5, 0.5, 0.0),
    (-0.5, 0.5, 0.0),
    (0.0, 0.8, 0.7),
    (0.0, 0.5, -0.6),
    (0.0, -4.0, 0.2),
    # wing: root front, tips, root back
    (0.0, 1.4, 0.2),
    (6.0, 0.4, 0.4),
    (-6.0, 0.4, 0.4),
    (0.0, -0.2, 0.2),
    # tailplane: front, tips, back
    (0.0, -2.9, 0.2),
    (2.0, -3.8, 0.2),
    (-2.0, -3.8, 0.2),
    (0.0, -3.9, 0.2),
    # fin: front, top, back
    (0.0, -2.8, 0.2),
    (0.0, -4.2, 1.6),
    (0.0, -4.0, 0.2),
)
_TRIANGLES: Final = (
    *((0, 1, 3), (0, 3, 2), (0, 4, 1), (0, 2, 4), (5, 3, 1), (5, 2, 3), (5, 1, 4), (5, 4, 2)),
    *((6, 9, 7), (6, 8, 9)),
    *((10, 13, 11), (10, 12, 13)),
    (14, 15, 16),
)


def aircraft_dae() -> bytes:
    """The file."""
    root = Element("COLLADA", {"xmlns": _COLLADA, "version": "1.4.1"})
    asset = add(root, "asset")
    add(asset, "created", "2026-01-01T00:00:00Z")
    add(asset, "modified", "2026-01-01T00:00:00Z")
    add(asset, "unit", name="meter", meter="1")
    add(asset, "up_axis", "Z_UP")
    _add_material(root)
    _add_geometry(root)
    scene = add(add(root, "library_visual_scenes"), "visual_scene", id="scene")
    instance = add(add(scene, "node", id="aircraft"), "instance_geometry", url="#shape")
    technique = add(add(instance, "bind_material"), "technique_common")
    add(technique, "instance_material", symbol="paint", target="#paint")
    add(add(root, "scene"), "instance_visual_scene", url="#scene")
    return xml_bytes(root)


def _add_material(root: Element) -> None:
    material = add(add(root, "library_materials"), "material", id="paint")
    add(material, "instance_effect", url="#paint-effect")
    profile = add(add(add(root, "library_effects"), "effect", id="paint-effect"), "profile_COMMON")
    lambert = add(add(profile, "technique", sid="common"), "lambert")
    add(add(lambert, "diffuse"), "color", _PAINT)


def _add_geometry(root: Element) -> None:
    mesh = add(add(add(root, "library_geometries"), "geometry", id="shape"), "mesh")
    source = add(mesh, "source", id="points")
    numbers = " ".join(f"{value:g}" for point in _POINTS for value in point)
    add(source, "float_array", numbers, id="points-array", count=str(3 * len(_POINTS)))
    accessor = add(
        add(source, "technique_common"), "accessor", source="#points-array", count=str(len(_POINTS)), stride="3"
    )
    for axis in "XYZ":
        add(accessor, "param", name=axis, type="float")
    vertices = add(mesh, "vertices", id="vertices")
    add(vertices, "input", semantic="POSITION", source="#points")
    # Each triangle in both orientations, because a thin wing is seen from above and from below.
    both = [*_TRIANGLES, *(triangle[::-1] for triangle in _TRIANGLES)]
    triangles = add(mesh, "triangles", material="paint", count=str(len(both)))
    add(triangles, "input", semantic="VERTEX", source="#vertices", offset="0")
    add(triangles, "p", " ".join(str(index) for triangle in both for index in triangle))
