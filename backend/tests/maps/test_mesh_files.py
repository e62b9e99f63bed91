"""Terrain that others made, in a folder or an archive; and paths that lead nowhere else."""

from __future__ import annotations

import zipfile
from pathlib import Path
from typing import Any

import orjson
import pytest

from epf_gcs.errors import GatewayError
from epf_gcs.maps.layer import Bounds, Range
from epf_gcs.maps.mesh_files import MeshFiles

CONTENTS: dict[str, Any] = {
    "format": "quantized-mesh-1.0",
    "scheme": "tms",
    "bounds": [-16, 27, -15, 28.5],
    "maxzoom": 2,
    "attribution": "© IGN",
    "extensions": ["octvertexnormals", "strange"],
    "available": [
        [{"startX": 0, "startY": 0, "endX": 1, "endY": 0}],
        [{"startX": 1, "startY": 1, "endX": 1, "endY": 1}],
    ],
}
TILES = {"0/0/0.terrain": b"\x1f\x8bzero", "0/1/0.terrain": b"one", "2/3/2.terrain": b"two"}


def in_folder(tmp_path: Path, contents: Any = CONTENTS) -> Path:
    folder = tmp_path / "terrain"
    for name, data in {**TILES, "layer.json": orjson.dumps(contents)}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return folder


def in_zip(tmp_path: Path, top: str = "") -> Path:
    path = tmp_path / "terrain.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in {**TILES, "layer.json": orjson.dumps(CONTENTS)}.items():
            archive.writestr(top + name, data)
    return path


@pytest.mark.parametrize("kind", ["folder", "zip", "zip with a folder"])
def test_tiles_and_contents_are_as_they_were_made(tmp_path: Path, kind: str) -> None:
    path = in_folder(tmp_path) if kind == "folder" else in_zip(tmp_path, "" if kind == "zip" else "canarias/tiles/")
    source = MeshFiles(path, "terrain")
    found = source.description
    assert (found.kind, found.maximum_zoom, found.attribution) == ("terrain", 2, "© IGN")
    assert (found.bounds, found.extensions) == (Bounds(-16, 27, -15, 28.5), ("octvertexnormals",))
    assert found.available == ((Range(0, 0, 1, 0),), (Range(1, 1, 1, 1),))
    packed, plain = source.tile(0, 0, 0), source.tile(2, 3, 2)
    assert packed is not None
    assert plain is not None
    assert (packed.data, packed.encoding) == (b"\x1f\x8bzero", "gzip")
    assert (plain.data, plain.encoding) == (b"two", None)
    assert source.tile(1, 0, 0) is None
    source.close()


@pytest.mark.parametrize(
    ("contents", "code"),
    [
        ([1], "map_file_no_layer_json"),
        ({"format": "heightmap-1.0"}, "map_file_not_mesh"),
    ],
)
def test_what_cannot_be_shown_is_refused_in_words(tmp_path: Path, contents: Any, code: str) -> None:
    with pytest.raises(GatewayError) as caught:
        MeshFiles(in_folder(tmp_path, contents), "terrain")
    assert caught.value.code == code


def test_an_archive_without_contents_or_that_is_none_is_refused(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "photos.zip", "w") as archive:
        archive.writestr("a.jpg", b"x")
    (tmp_path / "noise.zip").write_bytes(b"PK\x03\x04 and no more")
    codes = []
    for name in ("photos.zip", "noise.zip"):
        with pytest.raises(GatewayError) as caught:
            MeshFiles(tmp_path / name, name)
        codes.append(caught.value.code)
    assert codes == ["map_file_no_layer_json", "map_file_damaged"]


def test_contents_that_say_little_or_nonsense_are_taken_as_far_as_they_go(tmp_path: Path) -> None:
    contents = {"bounds": [20, 0, -20, 5], "available": [[{"startX": "?"}]], "maxzoom": "14", "scheme": "slippyMap"}
    source = MeshFiles(in_folder(tmp_path, contents), "terrain")
    found = source.description
    assert (found.bounds, found.available, found.maximum_zoom, found.scheme) == (Bounds(), None, 0, "slippyMap")
    source.close()


def test_an_entry_that_unpacks_to_more_than_a_tile_is_none(tmp_path: Path) -> None:
    path = in_zip(tmp_path)
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("3/0/0.terrain", bytes(9_000_000))
    source = MeshFiles(path, "terrain")
    assert source.tile(3, 0, 0) is None
    source.close()
