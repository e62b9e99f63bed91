"""The report's page names alarms as the interface does, in both languages."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path

import orjson
import pytest

import epf_gcs.flights.report

FRONTEND = Path(__file__).parents[4] / "frontend" / "src" / "features" / "alarms"


@pytest.mark.parametrize("language", ["es", "en"])
def test_alarms_have_the_same_names_as_in_the_interface(language: str) -> None:
    words = orjson.loads(files(epf_gcs.flights.report).joinpath(f"words_gen.{language}.json").read_bytes())
    shown = orjson.loads((FRONTEND / f"alarms.{language}.json").read_bytes())
    assert words["alarmNames"] == shown["alarmName"]
