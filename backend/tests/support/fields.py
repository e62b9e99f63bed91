"""Tiles as public sources have them, made here: pictures and heights of a hill near Gando."""

from __future__ import annotations

import struct
import zlib
from typing import Any

import numpy as np
import numpy.typing as npt

LATITUDE_DEG, LONGITUDE_DEG = 27.93, -15.39
IMAGERY_ZOOMS = (10, 14)
HEIGHTS_ZOOM = 12


def rgb_png(pixels: npt.NDArray[np.uint8]) -> bytes:
    """A PNG of `(height, width, 3)`."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width, _ = pixels.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)], axis=1)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    packed = zlib.compress(rows.tobytes(), 1)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def height_m(longitude_deg: Any, latitude_deg: Any) -> Any:
    """A cone of 900 m at 27.93 N 15.42 W, 5 km wide, with a plain of 20 m around it."""
    x = (longitude_deg + 15.42) * 98_400.0
    y = (latitude_deg - 27.93) * 111_320.0
    return np.maximum(20.0, 900.0 - np.hypot(x, y) * 0.18)


def imagery(zoom: int, column: int, row: int) -> bytes:
    """A small picture of one colour that no other tile has."""
    pixels = np.full((8, 8, 3), (zoom * 7 % 256, column % 256, row % 256), np.uint8)
    return rgb_png(pixels)


def terrarium(zoom: int, column: int, row: int) -> bytes:
    """Heights as PNG of the form Terrarium."""
    places = (np.arange(256) + 0.5) / 256
    longitude_deg = (column + places) / 2**zoom * 360 - 180
    latitude_deg = np.degrees(np.arctan(np.sinh(np.pi * (1 - 2 * (row + places) / 2**zoom))))
    value = np.round((height_m(*np.meshgrid(longitude_deg, latitude_deg)) + 32768.0) * 256.0).astype(np.int64)
    return rgb_png(np.stack([value >> 16, value >> 8 & 255, value & 255], axis=-1).astype(np.uint8))


def tile(path: str) -> bytes | None:
    """What a server has at this path: `/pictures/z/x/y` and `/heights/z/x/y`."""
    _, kind, zoom, column, row = path.split("/")
    make = imagery if kind == "pictures" else terrarium
    return make(int(zoom), int(column), int(row))


def order(base: str, *, name: str = "Gando", radius_m: float = 3000.0, kinds: str = "both") -> dict[str, Any]:
    """The body of an order from this server."""
    parts = []
    if kinds != "imagery":
        parts.append(_part("heights", f"{base}/heights/{{z}}/{{x}}/{{y}}", HEIGHTS_ZOOM, HEIGHTS_ZOOM))
    if kinds != "heights":
        parts.append(_part("imagery", f"{base}/pictures/{{z}}/{{x}}/{{y}}", *IMAGERY_ZOOMS))
    return {
        "name": name,
        "points": [{"latitude_deg": LATITUDE_DEG, "longitude_deg": LONGITUDE_DEG}],
        "radius_m": radius_m,
        "parts": parts,
        "accepts_terms": True,
    }


def _part(kind: str, url: str, lowest: int, highest: int) -> dict[str, Any]:
    return {
        "kind": kind,
        "name": f"Test {kind}",
        "url": url,
        "attribution": "© test",
        "minimum_zoom": lowest,
        "maximum_zoom": highest,
    }
