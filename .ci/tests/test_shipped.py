"""The bill of materials, the licence texts and the checksums tell of what ships, all of it, and the same each time."""

from __future__ import annotations

import base64
import hashlib
import json
import sys
import zipfile
from importlib.metadata import distribution
from pathlib import Path

CI = Path(__file__).parents[1]
ROOT = CI.parent
sys.path.insert(0, str(CI))

import sbom  # noqa: E402
import shipped  # noqa: E402
import wheel  # noqa: E402


def test_each_package_that_the_gateway_names_is_in_the_bill_with_the_version_that_is_installed() -> None:
    told = {one["purl"] for one in sbom.bill(ROOT)["components"]}
    for name in ("fastapi", "pyserial", "jsbsim", "rasterio", "duckdb", "starlette"):
        assert f"pkg:pypi/{name}@{distribution(name).version}" in told


def test_tools_of_the_developers_are_not_in_the_bill() -> None:
    names = {one["name"] for one in sbom.bill(ROOT)["components"]}
    assert not names & {"pytest", "mypy", "ruff", "vite", "vitest", "typescript", "@biomejs/biome", "cmocka"}


def test_page_board_and_map_are_in_the_bill() -> None:
    names = {one["name"] for one in sbom.bill(ROOT)["components"]}
    assert names >= {"react", "@cesium/engine", "three", "FreeRTOS-Kernel", "littlefs", "OurAirports", "GeoNames"}


def test_whatever_is_needed_is_in_the_bill_and_everything_has_a_licence() -> None:
    bill = sbom.bill(ROOT)
    known = {one["bom-ref"] for one in bill["components"]} | {bill["metadata"]["component"]["bom-ref"]}
    assert len(known) == len(bill["components"]) + 1
    for row in bill["dependencies"]:
        assert {row["ref"], *row["dependsOn"]} <= known
    assert [one["name"] for one in bill["components"] if not one.get("licenses")] == []


def test_the_bill_is_the_same_each_time() -> None:
    assert sbom.text(ROOT) == sbom.text(ROOT)


def test_each_licence_of_the_gateway_comes_with_its_text() -> None:
    told = {component.name: text for component, text in shipped.texts(ROOT)}
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in told["jsbsim"]
    assert "Permission is hereby granted" in told["FreeRTOS-Kernel"]
    assert len(told) > 40
    # These bring none; one more is looked at, and its text found elsewhere.
    assert [name for name, text in told.items() if "brings no text" in text] == ["mcap", "pmtiles", "pyserial"]


def test_a_wheel_gets_the_bill_and_its_list_of_files_stays_whole(tmp_path: Path) -> None:
    path = tmp_path / "a-1.0-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as made:
        made.writestr("a/__init__.py", "")
        program = zipfile.ZipInfo("a/program", (2026, 1, 2, 3, 4, 6))
        program.external_attr = 0o100755 << 16
        made.writestr(program, "#!")
        made.writestr("a-1.0.dist-info/RECORD", "a/__init__.py,,\na/program,,\na-1.0.dist-info/RECORD,,\n")
    wheel.add_bill(path, '{"bomFormat": "CycloneDX"}')
    with zipfile.ZipFile(path) as made:
        name = "a-1.0.dist-info/sboms/epf-gcs.cdx.json"
        rows = [row.split(",") for row in made.read("a-1.0.dist-info/RECORD").decode().splitlines()]
        assert {row[0] for row in rows} == set(made.namelist())
        assert json.loads(made.read(name)) == {"bomFormat": "CycloneDX"}
        digest = base64.urlsafe_b64encode(hashlib.sha256(made.read(name)).digest()).rstrip(b"=").decode()
        assert [name, f"sha256={digest}", "26"] in rows
        assert made.getinfo("a/program").external_attr == 0o100755 << 16
