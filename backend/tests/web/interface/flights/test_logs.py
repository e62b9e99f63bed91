"""Logs of other autopilots stand in the library as flights."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest

from tests.flights.logs.others_logs import ROWS, dataflash
from tests.support.gateway import Gateway
from tests.web.interface.flights.conftest import indexed


def test_a_log_of_another_autopilot_is_a_flight_with_its_signals_and_its_track(gateway: Gateway) -> None:
    address = f"/flights/{indexed(gateway, dataflash(1))}"
    flight = gateway.http.get(address).json()
    assert (flight["log"], flight["damage"], flight["imported"]) == ("dataflash", None, True)
    assert flight["highest_ft"] > 1000.0
    topics = {topic["name"]: topic["fields"] for topic in gateway.http.get(f"{address}/topics").json()["topics"]}
    assert {"name": "GyrX", "unit": "rad/s", "kind": "number"} in topics["IMU_1"]
    (signal,) = gateway.http.get(f"{address}/signals", params={"names": "rate(POS.Alt)"}).json()["signals"]
    assert (signal["unit"], signal["count"]) == ("m/s", ROWS - 1)
    assert len(gateway.http.get(f"{address}/track", params={"source": "flight"}).content) > 16 * (ROWS - 1)
    report = gateway.http.get(f"{address}/report").raise_for_status().json()
    assert report["times"]["duration_s"] == pytest.approx(0.1 * (ROWS - 1), abs=0.2)
    answer = gateway.http.get(f"{address}/export", params={"format": "csv"}).raise_for_status()
    with zipfile.ZipFile(io.BytesIO(answer.content)) as tables:
        assert {"POS.csv", "IMU_0.csv", "gps.csv"} <= {Path(one).name for one in tables.namelist()}
