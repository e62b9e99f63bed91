"""Errors as the interface gives them: their values are texts, numbers and flags, whatever the code counted with."""

from __future__ import annotations

import pytest
from pydantic import TypeAdapter

from epf_gcs.contract.flights import Fault
from epf_gcs.contract.maps import MapImport, problem_parts
from epf_gcs.errors import ConflictError

FULL = ConflictError("map_disk_full", "It does not fit.", name="Gando", free_mb=5, whole=False, why=None)


@pytest.mark.filterwarnings("error")
def test_a_whole_number_of_an_error_is_sent_without_a_warning_of_the_interface() -> None:
    told = MapImport(
        *problem_parts(FULL),
        id="a",
        name="Gando",
        state="failed",
        bytes=1,
        total_bytes=None,
        percent=None,
        layer=None,
    )
    params = {"name": "Gando", "free_mb": 5.0, "whole": False, "why": None}
    assert TypeAdapter(MapImport).dump_python(told)["problem_params"] == params
    assert TypeAdapter(Fault).dump_python(Fault.of(FULL))["params"] == params
