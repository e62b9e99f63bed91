"""The notebook runs from its first cell to its last on a real flight, and nothing that it showed is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import nbformat
import pyarrow.parquet as pq
import pytest
from nbclient import NotebookClient

from tests.flights.flown_flights import FLIGHT, indexed, recording
from tests.support.waiting import DEADLINE_S

NOTEBOOK = Path(__file__).parents[3] / "notebooks" / "flight.ipynb"


@pytest.fixture
def notebook() -> Any:
    return nbformat.read(NOTEBOOK, as_version=4)  # type: ignore[no-untyped-call]


# What the kernel's libraries do when they start and end.
@pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning")
def test_it_reads_a_flights_parquet_and_plots_it(
    notebook: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    indexed(tmp_path, recording(20))
    monkeypatch.setenv("EPF_COLUMNS", str(tmp_path / "columns"))
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path / "ipython"))
    monkeypatch.setenv("JUPYTER_RUNTIME_DIR", str(tmp_path / "runtime"))
    NotebookClient(notebook, timeout=DEADLINE_S, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in shown), "a plot was drawn"
    assert any(FLIGHT in output.get("data", {}).get("text/plain", "") for output in shown), "the flight is listed"
    (folder,) = (tmp_path / "columns").glob("*/*/*")
    positions = pq.read_metadata(folder / "gps.parquet").num_rows
    assert any(f"{positions} positions" in output.get("text", "") for output in shown)


def test_nothing_that_it_showed_is_committed(notebook: Any) -> None:
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert len(code) >= 5
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code)
