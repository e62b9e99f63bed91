"""Each line's load is that of its own bytes."""

from __future__ import annotations

from pathlib import Path

import pytest

from epf_gcs.flight.flight import Flight
from epf_gcs.flight.state.line_rates import LineRates


@pytest.mark.anyio
async def test_each_line_has_the_rate_of_its_own_bytes(tmp_path: Path) -> None:
    station = Flight(tmp_path, record=False)
    rates = LineRates()
    rates.note(10.0, station.board, station.simulator)
    station.board.bytes_in += 1000
    station.board.bytes_out += 200
    station.simulator.bytes_in += 30
    rates.note(10.5, station.board, station.simulator)
    assert (rates.board_in.per_s(), rates.board_out.per_s(), rates.simulator_in.per_s()) == (2000.0, 400.0, 60.0)
