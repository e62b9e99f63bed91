"""Whether an answer is the whole of one piece: a server may cut it, or say a false length, without an error."""

from __future__ import annotations

import struct
import zlib
from typing import Final

_PNG: Final = b"\x89PNG\r\n\x1a\n"
_JPEG: Final = b"\xff\xd8\xff"
_JPEG_END: Final = b"\xff\xd9"
_TIFF: Final = (b"II*\x00", b"MM\x00*", b"II+\x00", b"MM\x00+")
_LAYER: Final = 3
_LAYER_NAME: Final = 1
_VARINT, _BYTES = 0, 2
_FIXED: Final = {1: 8, 5: 4}
_MOST_FIELDS: Final = 200_000
# No server's tile is larger; a few bytes can claim to be a picture of any size.
_LARGEST_SIDE: Final = 2048


def is_whole_picture(data: bytes) -> bool:
    """Whether these bytes are a PNG, JPEG or WebP picture to its end, of a tile's size."""
    if data.startswith(_PNG):
        return _is_whole_png(data)
    if data.startswith(_JPEG):
        return data.rstrip(b"\0").endswith(_JPEG_END) and _is_tile_jpeg(data)
    if data.startswith(b"RIFF") and data[8:12] == b"WEBP":
        (length,) = struct.unpack_from("<I", data, 4)
        return bool(length + 8 in (len(data), len(data) + 1))
    return False


def is_whole_terrarium(data: bytes) -> bool:
    """Whether these bytes are a PNG of 256 or 512 pixels, as heights come."""
    if not data.startswith(_PNG) or not _is_whole_png(data):
        return False
    width, height = struct.unpack_from(">II", data, 16)
    return bool(width == height and width in (256, 512))


def is_tiff(data: bytes) -> bool:
    """Whether these bytes begin as a TIFF; that it is whole is seen when its heights are read."""
    return data[:4] in _TIFF


def is_whole_vector(data: bytes) -> bool:
    """Whether these bytes are a vector tile (MVT) to its end: layers, each with a name and its fields whole.

    What the fields hold is not looked at here: the page's worker does that, within its own limits.
    """
    fields = _fields(data, 0, len(data))
    if not fields:
        return False
    for number, start, end in fields:
        inner = _fields(data, start, end) if number == _LAYER else None
        if number == _LAYER and (inner is None or all(name != _LAYER_NAME for name, _, _ in inner)):
            return False
    return any(number == _LAYER for number, _, _ in fields)


def _fields(data: bytes, at: int, end: int) -> list[tuple[int, int, int]] | None:
    """Number, start and end of each field of a Protobuf message; None if it does not end where it must."""
    found: list[tuple[int, int, int]] = []
    while at < end:
        key, at = _varint(data, at, end)
        kind = key & 7
        if kind == _VARINT:
            value_end = _varint(data, at, end)[1]
        elif kind == _BYTES:
            length, at = _varint(data, at, end)
            value_end = at + length
        else:
            value_end = at + _FIXED.get(kind, end)
        if key >> 3 == 0 or value_end > end or len(found) >= _MOST_FIELDS:
            return None
        found.append((key >> 3, at, value_end))
        at = value_end
    return found if at == end else None


def _varint(data: bytes, at: int, end: int) -> tuple[int, int]:
    """A number, and where it ends: beyond `end` if it is cut or too long."""
    value = 0
    for shift in range(0, 70, 7):
        if at >= end:
            break
        value |= (data[at] & 0x7F) << shift
        at += 1
        if data[at - 1] < 0x80:
            return value, at
    return 1 << 70, end + 1


def begins_as_vector(data: bytes) -> bool:
    """Whether these bytes are at least the beginning of a vector tile: of its first layer."""
    return not data or data[0] == _LAYER << 3 | _BYTES


def begins_as_map(data: bytes) -> bool:
    """Whether these bytes are at least the beginning of a piece."""
    return not data or is_tiff(data) or data.startswith((_PNG[: len(data)], _JPEG[: len(data)], b"RIFF"[: len(data)]))


def _is_whole_png(data: bytes) -> bool:
    """Every chunk with its checksum, up to the last."""
    at = len(_PNG)
    while at + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, at)
        end = at + 12 + length
        if end > len(data):
            return False
        (checksum,) = struct.unpack_from(">I", data, end - 4)
        if zlib.crc32(memoryview(data)[at + 4 : end - 4]) != checksum:
            return False
        kind = data[at + 4 : at + 8]
        if kind == b"IHDR":
            width, height = struct.unpack_from(">II", data, at + 8)
            if not 0 < width <= _LARGEST_SIDE or not 0 < height <= _LARGEST_SIDE:
                return False
        if kind == b"IEND":
            return True
        at = end
    return False


def _is_tile_jpeg(data: bytes) -> bool:
    """Whether its frame header (SOF) says the size of a tile."""
    at = 2
    while at + 9 <= len(data) and data[at] == 0xFF:
        marker = data[at + 1]
        if 0xC0 <= marker <= 0xCF and marker not in (0xC4, 0xC8, 0xCC):
            height, width = struct.unpack_from(">HH", data, at + 5)
            return bool(0 < width <= _LARGEST_SIDE and 0 < height <= _LARGEST_SIDE)
        at += 2 + struct.unpack_from(">H", data, at + 2)[0]
    return False
