"""Exported tables have names beside the numbers of commands, results and choices."""

from __future__ import annotations

import csv
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from jsonschema import Draft202012Validator

from epf_gcs.codec.encode import encode_command, encode_telemetry
from tests.flights.flown_flights import indexed
from tests.flights.test_columns import recording as recording_of
from tests.flights.test_exports import columns_of, decoded, export

ANSWERED = [(256, 0), (55, 2), (9999, 3)]
NAMES = [("capabilities", "done"), ("control_source", "bad_state"), (None, "unknown")]


@pytest.fixture(scope="module")
def flight(tmp_path_factory: pytest.TempPathFactory) -> Path:
    received = b"".join(encode_telemetry("acknowledgement", *one) for one in ANSWERED)
    return indexed(
        tmp_path_factory.mktemp("names"), recording_of(received, encode_command("control_source", 1) * len(ANSWERED))
    )


def test_csv_names_the_command_and_its_result(flight: Path) -> None:
    rows = list(csv.DictReader(export(flight, "csv", "--topics", "acknowledgement").read_text().splitlines()))
    assert [(int(row["command_type"]), int(row["result"])) for row in rows] == ANSWERED
    assert [(row["command_type_text"] or None, row["result_text"]) for row in rows] == NAMES
    assert list(rows[0])[2:] == ["command_type", "command_type_text", "result", "result_text"]
    sent = list(csv.DictReader(export(flight, "csv", "--topics", "sent_control_source").read_text().splitlines()))
    assert {(row["source"], row["source_text"]) for row in sent} == {("1", "joystick")}


@pytest.mark.parametrize("stretch", [(), ("--from-s", "0")])
def test_parquet_does_too_and_keeps_everything_else(flight: Path, stretch: tuple[str, ...]) -> None:
    table = pq.read_table(export(flight, "parquet", "--topics", "acknowledgement", *stretch))
    assert list(zip(*(table[f"{name}_text"].to_pylist() for name in ("command_type", "result")), strict=True)) == NAMES
    plain = table.drop_columns(["command_type_text", "result_text"])
    assert plain.equals(columns_of(flight)["acknowledgement"])


def test_decoded_mcap_does_too(flight: Path) -> None:
    found = [one for one in decoded(export(flight, "mcap-decoded")) if one[0] == "acknowledgement"]
    assert [(one[2].get("command_type_text"), one[2]["result_text"]) for one in found] == NAMES
    for _, _, message, schema in found:
        Draft202012Validator(schema).validate(message)
        assert set(message) <= set(schema["properties"])
