"""Logs of other programs become flights whose figures are those that their own readers have."""

from __future__ import annotations

import contextlib
import csv
import gc
import json
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from pymavlink import mavutil
from pymavlink.DFReader import DFReader_binary
from pyulog import ULog

from epf_gcs.errors import GatewayError
from epf_gcs.extras import Extra
from epf_gcs.flights import answers
from epf_gcs.flights.columns import write_columns
from epf_gcs.flights.flight_data import PeriodCache
from epf_gcs.flights.importing import run
from epf_gcs.flights.indexed import Columns, IndexedFlight
from epf_gcs.flights.logs import reading
from epf_gcs.recordings.log_table import LogTable, packed, unpacked
from tests.flights.flown_flights import quiet
from tests.flights.logs.others_logs import ROWS, START_S, dataflash, mcap, table, tlog, ulog, written

Figures = dict[str, tuple[list[float], list[float]]]
"""By signal: Unix times (s) and values."""
SEEDS = range(6)


def taken_in(folder: Path, content: bytes) -> tuple[dict[str, Any], IndexedFlight]:
    """What importing says, and the flight that came of it."""
    target = folder / "20231114T221320Z.mcap"
    said = run([str(written(folder / "came.mcap", content)), str(target)], quiet)
    made = write_columns(target, folder / "columns", quiet)
    assert made.counts.first_ns is not None
    assert made.counts.last_ns is not None
    flight = IndexedFlight(made.folder, made.notes, made.counts.first_ns, made.counts.last_ns, columns=Columns())
    return dict(said), flight


def read_by(reader: Any) -> Iterator[Any]:
    with contextlib.closing(reader):
        while (message := reader.recv_msg()) is not None:
            yield message


def of_dataflash(path: Path) -> Figures:
    found: Figures = {}
    reader = DFReader_binary(str(path))
    for message in read_by(reader):
        name = message.get_type()
        topic = f"{name}_{message.I}" if name == "IMU" else name
        if name in ("POS", "IMU", "GPS"):
            for field in message.get_fieldnames()[1:]:
                times, values = found.setdefault(f"{topic}.{field}", ([], []))
                times.append(message._timestamp)
                values.append(getattr(message, field))
    return {("log_GPS" + name[3:]) if name.startswith("GPS.") else name: one for name, one in found.items()}


def of_tlog(path: Path) -> Figures:
    found: Figures = {}
    reader = mavutil.mavlogfile(str(path))
    for message in read_by(reader):
        system = message.get_srcSystem()
        topic = message.get_type() if system == 1 else f"{message.get_type()}_of_{system}"
        # `heartbeat` is the name of one of the station's own topics, whatever the case.
        topic = f"log_{topic}" if topic.lower() == "heartbeat" else topic
        for field in message.get_fieldnames():
            times, values = found.setdefault(f"{topic}.{field}", ([], []))
            times.append(message._timestamp)
            values.append(getattr(message, field))
    return found


def of_ulog(path: Path) -> Figures:
    found: Figures = {}
    for one in ULog(str(path)).data_list:
        topic = f"{one.name}_{one.multi_id}" if one.multi_id else one.name
        times = (one.data["timestamp"] - 1_000_000) / 1e6 + START_S
        for field, values in one.data.items():
            if field != "timestamp":
                plain = field.replace("[", "_").replace("]", "")
                found[f"{topic}.{plain}"] = (times.tolist(), values.tolist())
    return found


def of_mcap(path: Path) -> Figures:
    found: Figures = {}
    with path.open("rb") as file:
        for _, _, message in make_reader(file).iter_messages():
            pose = json.loads(message.data)
            figures = {
                **{f"position_{one}": pose["position"][one] for one in "xy"},
                **{f"q_{place}": one for place, one in enumerate(pose["q"])},
                "ok": float(pose["ok"]),
            }
            for field, value in figures.items():
                times, values = found.setdefault(f"robot_pose.{field}", ([], []))
                times.append(message.log_time / 1e9)
                values.append(value)
    return found


def of_table(path: Path) -> Figures:
    rows = list(csv.reader(path.read_text().replace(",", ".").splitlines(), delimiter=";"))[1:]
    times = [float(row[0]) for row in rows]
    return {
        "csv.altitud": (times, [float(row[1]) for row in rows]),
        "csv.Vel": (times, [float(row[2]) for row in rows]),
    }


KINDS: dict[str, tuple[Callable[[int], bytes], Callable[[Path], Figures]]] = {
    "dataflash": (dataflash, of_dataflash),
    "tlog": (tlog, of_tlog),
    "ulog": (ulog, of_ulog),
    "mcap": (mcap, of_mcap),
    "csv": (table, of_table),
}


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_figure_and_its_time_are_those_of_the_logs_own_reader(tmp_path: Path, kind: str, seed: int) -> None:
    make, read = KINDS[kind]
    said, flight = taken_in(tmp_path, make(seed))
    assert said["log"] == kind
    theirs = read(written(tmp_path / "theirs", make(seed)))
    assert len(theirs) > 1
    for name, (times, values) in theirs.items():
        topic, field = name.split(".")
        found = flight.samples(topic, field)
        np.testing.assert_array_equal(found.values, np.array(values, np.float64), err_msg=name)
        np.testing.assert_allclose(found.t_s + flight.start_ns * 1e-9, times, rtol=0, atol=2e-6, err_msg=name)


def test_units_are_those_that_the_log_says(tmp_path: Path) -> None:
    _, flight = taken_in(tmp_path, dataflash(1))
    assert {name: one.unit for name, one in flight.fields("POS").items()} == {
        "Lat": "deglatitude",
        "Lng": "deglatitude",
        "Alt": "m",
        "RelHomeAlt": "m",
    }
    _, flight = taken_in(tmp_path, table(1))
    assert {name: one.unit for name, one in flight.fields("csv").items()} == {"altitud": "m", "Vel": "m/s"}


@pytest.mark.parametrize("kind", ["dataflash", "tlog", "ulog"])
def test_the_position_is_ours_too_so_that_track_time_bar_and_row_have_it(tmp_path: Path, kind: str) -> None:
    _, flight = taken_in(tmp_path, KINDS[kind][0](3))
    shown = answers.overview(flight, PeriodCache(), 20)
    assert shown.signal == "gps.altitude_m"
    assert all(one is not None for one in shown.altitude_ft)
    latitude = flight.samples("gps", "latitude_deg").values
    assert len(latitude) == ROWS
    assert latitude[0] == pytest.approx(27.93)
    assert len(answers.track(flight, "flight", None)) > 16 * (ROWS - 1)


@pytest.mark.parametrize("content", [dataflash(1, knows_time=False), ulog(1, knows_time=False), b"time,x\n0,1\n1,2\n"])
def test_a_log_that_does_not_know_the_day_says_so(tmp_path: Path, content: bytes) -> None:
    said, flight = taken_in(tmp_path, content)
    assert "does not say when it was flown" in str(said["damage"])
    assert flight.end_ns > flight.start_ns


@pytest.mark.parametrize(
    ("text", "times"),
    [
        ("time_ms,v\n1700000000000,1\n1700000000500,2\n", [0.0, 0.5]),
        ("t_us,v\n0,1\n500000,2\n", [0.0, 0.5]),
        ("datetime,v\n2024-01-01 10:00:00,1\n2024-01-01 10:00:02,2\n", [0.0, 2.0]),
        ("x,Time\n7,10.25\n8,10.75\n,11.25\n", [0.0, 0.5, 1.0]),
    ],
)
def test_a_table_says_its_times_in_many_ways(tmp_path: Path, text: str, times: list[float]) -> None:
    _, flight = taken_in(tmp_path, text.encode())
    (topic,) = flight.topics()
    found = flight.samples("csv", next(iter(flight.fields("csv"))))
    assert topic.samples == len(times)
    np.testing.assert_allclose(found.t_s, times, atol=1e-6)


def test_what_is_left_out_is_said(tmp_path: Path) -> None:
    said, _ = taken_in(tmp_path, table(1))
    assert said["damage"] == "Columns that are no numbers are left out: modo."
    said, flight = taken_in(tmp_path, b"time,x\n1700000000,1\n1700000001,2,3\n1700000002,3\n")
    assert said["damage"] == "Rows with too many or too few cells are left out: 1."
    assert flight.samples("csv", "x").values.tolist() == [1.0, 3.0]
    said, flight = taken_in(tmp_path, mcap(1, broken=7))
    assert said["damage"] == "Messages that are no JSON, or have no possible time, are left out: 7."
    assert flight.topics()[0].samples == ROWS - 7


def test_columns_of_one_name_are_told_apart_and_the_first_column_of_times_counts(tmp_path: Path) -> None:
    _, flight = taken_in(tmp_path, b"time,a b,a b,time\n0,1,2,50\n1,3,4,90\n")
    assert {name: flight.samples("csv", name).values.tolist() for name in flight.fields("csv")} == {
        "a_b": [1.0, 3.0],
        "a_b_2": [2.0, 4.0],
        "time": [50.0, 90.0],
    }
    assert flight.samples("csv", "a_b").t_s.tolist() == [0.0, 1.0]


def test_two_logs_with_the_same_times_are_two(tmp_path: Path) -> None:
    rows = [b"time,x\n" + b"".join(b"%d,%d\n" % (START_S + row, row + more) for row in range(50)) for more in (0, 1)]
    prints = [taken_in(tmp_path, one)[0]["fingerprint"] for one in (*rows, rows[0])]
    assert prints[0] == prints[2] != prints[1]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"a,b\n1,2\n", "recording_foreign"),
        (b"Dear all,\nthe time, as it flies\n", "recording_foreign"),
        (b"time,x\nsoon,1\n", "log_no_time"),
        (b"time,name\n1,x\n", "recording_empty"),
        (b"ULog\x01\x12\x35\x01", "log_unreadable"),
        (b"\xa3\x95", "recording_empty"),
    ],
)
def test_what_is_no_log_is_refused_and_leaves_nothing(tmp_path: Path, content: bytes, code: str) -> None:
    source, target = written(tmp_path / "came.mcap", content), tmp_path / "checked.mcap"
    with pytest.raises(GatewayError) as refused:
        run([str(source), str(target)], quiet)
    assert refused.value.code == code
    assert list(tmp_path.iterdir()) == [source]


# A library that gives up leaves its file open until its worker ends.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("kind", KINDS)
def test_a_damaged_log_is_read_in_part_or_refused_in_words(tmp_path: Path, kind: str) -> None:
    whole, drawn = KINDS[kind][0](1), random.Random(4)
    for number in range(12):
        content = bytearray(whole[: drawn.randrange(20, len(whole))])
        for _ in range(number):
            content[drawn.randrange(8, len(content))] = drawn.randrange(256)
        source, target = written(tmp_path / "came.mcap", bytes(content)), tmp_path / "checked.mcap"
        with contextlib.suppress(GatewayError):
            run([str(source), str(target)], quiet)
            write_columns(target, tmp_path / "columns", quiet)
    # Here, where it is not looked at, and not in whichever test comes next.
    gc.collect()


def test_a_recording_that_was_made_of_a_log_is_taken_in_again_as_it_is(tmp_path: Path) -> None:
    said, flight = taken_in(tmp_path, ulog(2))
    before = flight.samples("sensor_gyro_1", "rate_2")
    again, flight = taken_in(tmp_path, (tmp_path / "20231114T221320Z.mcap").read_bytes())
    assert again["fingerprint"] == said["fingerprint"]
    assert again["damage"] is None
    np.testing.assert_array_equal(flight.samples("sensor_gyro_1", "rate_2"), before)


def test_without_its_reader_the_log_says_what_installs_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "LOGS", Extra("logs", ("no_such_module",), "Reading the logs of other autopilots"))
    with pytest.raises(GatewayError, match="no_such_module, which is not installed here") as refused:
        run([str(written(tmp_path / "came.mcap", ulog(1))), str(tmp_path / "checked.mcap")], quiet)
    assert refused.value.code == "extra_missing"


def test_a_strangers_rows_are_taken_only_as_they_are_agreed() -> None:
    good = LogTable("a", {"x": "m"}, np.array([1, 2]), [np.array([0.5, np.nan])])
    found = unpacked(packed(good))
    assert found is not None
    np.testing.assert_array_equal(found.columns[0], good.columns[0])
    for bad in (
        b"",
        packed(good)[:-1],
        packed(good) + b"\0",
        b"\xff\xff\xff\xff" + packed(good)[4:],
        packed(good._replace(topic="../a")),
        packed(good._replace(units={"t_ns": "m"})),
        packed(good._replace(units={"x": "\n"})),
        packed(good._replace(t_ns=np.empty(0, np.int64), columns=[np.empty(0)])),
    ):
        assert unpacked(bad) is None


@pytest.mark.parametrize("topic", ["events", "gps", "sent_a", "keyframes"])
def test_a_strangers_rows_by_a_name_of_ours_are_damage(
    tmp_path: Path, topic: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("epf_gcs.flights.importing.own_topics", lambda one: [one._replace(topic=topic)])
    target = tmp_path / "checked.mcap"
    run([str(written(tmp_path / "came.mcap", mcap(1))), str(target)], quiet)
    made = write_columns(target, tmp_path / "columns", quiet)
    assert made.counts.damaged == {"log": 1}
    assert [file.stem for file in made.folder.glob(f"{topic}.parquet")] in ([], ["keyframes"])
