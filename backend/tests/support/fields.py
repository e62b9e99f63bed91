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
VECTOR_ZOOMS = (10, 13)


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


def _field(number: int, data: bytes | int) -> bytes:
    """One field of a Protobuf message."""
    if isinstance(data, int):
        return _varint(number << 3) + _varint(data)
    return _varint(number << 3 | 2) + _varint(len(data)) + data


def _varint(value: int) -> bytes:
    found = bytearray()
    while value > 0x7F:
        found.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*found, value])


def _packed(values: list[int]) -> bytes:
    return b"".join(map(_varint, values))


def _zigzag(value: int) -> int:
    return value << 1 ^ value >> 31


def layer(called: str, kind: int, lines: list[list[tuple[int, int]]], **tags: str) -> bytes:
    """A layer of an MVT with one feature. `kind`: 2 lines, 3 areas; places in units of 1/4096 of the tile."""
    commands, at = [], (0, 0)
    for line in lines:
        for index, place in enumerate(line):
            if index < 2:
                commands.append(9 if index == 0 else (len(line) - 1) << 3 | 2)
            commands += [_zigzag(place[0] - at[0]), _zigzag(place[1] - at[1])]
            at = place
        if kind == 3:
            commands.append(15)
    numbers = _packed([number for index in range(len(tags)) for number in (index, index)])
    feature = _field(2, numbers) + _field(3, kind) + _field(4, _packed(commands))
    keys = b"".join(_field(3, key.encode()) for key in tags)
    values = b"".join(_field(4, _field(1, value.encode())) for value in tags.values())
    content = _field(15, 2) + _field(1, called.encode()) + _field(2, feature) + keys + values + _field(5, 4096)
    return _field(3, content)


def roads(zoom: int, column: int, row: int) -> bytes:
    """A vector tile of a road across it, a river, a lake and a house, as OpenMapTiles names them."""
    name = f"GC-{zoom}-{column}-{row}"
    return (
        layer("transportation", 2, [[(0, 2048), (2048, 1700), (4096, 2048)]], **{"class": "primary"})
        + layer("transportation_name", 2, [[(0, 2048), (2048, 1700), (4096, 2048)]], name=name, ref="GC-1")
        + layer("waterway", 2, [[(1000, 0), (1400, 2000), (900, 4096)]], **{"class": "river"}, name="Barranco")
        + layer("water", 3, [[(3000, 300), (3700, 300), (3700, 1000), (3000, 1000)]], **{"class": "lake"})
        + layer("building", 3, [[(1800, 2400), (2100, 2400), (2100, 2700), (1800, 2700)]], height="7")
    )


def tile(path: str) -> bytes | None:
    """What a server has at this path: `/pictures/z/x/y`, `/heights/z/x/y` and `/roads/z/x/y`."""
    _, kind, zoom, column, row = path.split("/")
    make = {"pictures": imagery, "heights": terrarium, "roads": roads}[kind]
    return make(int(zoom), int(column), int(row))


def order(base: str, *, name: str = "Gando", radius_m: float = 3000.0, kinds: str = "both") -> dict[str, Any]:
    """The body of an order from this server. `kinds`: heights, imagery, vector, both (heights and imagery) or all."""
    parts = []
    if kinds in ("heights", "both", "all"):
        parts.append(_part("heights", f"{base}/heights/{{z}}/{{x}}/{{y}}", HEIGHTS_ZOOM, HEIGHTS_ZOOM))
    if kinds in ("imagery", "both", "all"):
        parts.append(_part("imagery", f"{base}/pictures/{{z}}/{{x}}/{{y}}", *IMAGERY_ZOOMS))
    if kinds in ("vector", "all"):
        parts.append(_part("vector", f"{base}/roads/{{z}}/{{x}}/{{y}}", *VECTOR_ZOOMS))
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
