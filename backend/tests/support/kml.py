"""Validates KML against the OGC's schema of KML 2.2, which fastkml includes."""

from __future__ import annotations

from typing import Any

from fastkml.validator import get_schema_parser
from lxml import etree

NAMESPACE = "{http://www.opengis.net/kml/2.2}"


def schema_faults(data: bytes) -> list[str]:
    """The schema errors of this document.

    The schema has one type for the tilt of a camera and of a model, 0..180. But a model's nose can point up or down:
    Google's reference allows -180..180. So a model's tilt is checked against that, then set to zero for the schema.
    """
    root = etree.fromstring(data)
    for orientation in root.iter(f"{NAMESPACE}Orientation"):
        tilt = orientation.find(f"{NAMESPACE}tilt")
        assert -180 <= float(tilt.text) <= 180
        tilt.text = "0"
    schema = get_schema_parser()
    schema.validate(root)
    return [str(entry.message) for entry in schema.error_log]


def texts(data: bytes, name: str) -> list[str]:
    """The text of every element of this name, in order."""
    return [element.text or "" for element in etree.fromstring(data).iter(f"{NAMESPACE}{name}")]


def element(data: bytes, name: str) -> Any:
    """The first element of this name."""
    return next(etree.fromstring(data).iter(f"{NAMESPACE}{name}"))


def child_texts(found: Any) -> dict[str, str]:
    """The text of each child by its name."""
    return {child.tag.removeprefix(NAMESPACE): child.text or "" for child in found}
