"""Each notebook runs from its first cell to its last, and nothing that it showed is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import nbformat
import pyarrow.parquet as pq
import pytest
from nbclient import NotebookClient

from tests.flights.flown_flights import FLIGHT, indexed, recording
from tests.support.waiting import DEADLINE_S

NOTEBOOKS = Path(__file__).parents[3] / "notebooks"


def read(name: str) -> Any:
    return nbformat.read(NOTEBOOKS / f"{name}.ipynb", as_version=4)  # type: ignore[no-untyped-call]


def run(name: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What its cells show."""
    notebook = read(name)
    monkeypatch.setenv("IPYTHONDIR", str(folder / "ipython"))
    monkeypatch.setenv("JUPYTER_RUNTIME_DIR", str(folder / "runtime"))
    NotebookClient(notebook, timeout=DEADLINE_S, resources={"metadata": {"path": str(folder)}}).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in shown), "a plot was drawn"
    return shown


# What the kernel's libraries do when they start and end.
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_flights_parquet_is_read_and_plotted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    indexed(tmp_path, recording(20))
    monkeypatch.setenv("EPF_COLUMNS", str(tmp_path / "columns"))
    shown = run("flight", tmp_path, monkeypatch)
    assert any(FLIGHT in output.get("data", {}).get("text/plain", "") for output in shown), "the flight is listed"
    (folder,) = (tmp_path / "columns").glob("*/*/*")
    positions = pq.read_metadata(folder / "gps.parquet").num_rows
    assert any(f"{positions} positions" in output.get("text", "") for output in shown)


@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_a_campaign_is_flown_and_plotted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("EPF_FLIGHTS", "2")
    shown = run("campaign", tmp_path, monkeypatch)
    assert any("of 2 flights were safe" in output.get("text", "") for output in shown)


@pytest.mark.parametrize("name", ["flight", "campaign"])
def test_nothing_that_it_showed_is_committed(name: str) -> None:
    code = [cell for cell in read(name).cells if cell.cell_type == "code"]
    assert len(code) >= 5
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code)
