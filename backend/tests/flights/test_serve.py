"""Questions about flights as the worker answers them: of one that is indexed, and of one that is being recorded."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path
from typing import Any

import orjson
import pyarrow as pa
import pytest

from epf_gcs.contract.flight_questions import SpanQuestion
from epf_gcs.flights.serve import Flights, serve
from epf_gcs.recordings.places import Places
from epf_gcs.workers.pipe import receive, send
from tests.flights.flown_flights import FLIGHT, SPEED_M_S, indexed, recording

SECONDS = 30
SIGNALS: dict[str, Any] = {
    "do": "signals",
    "names": "gps.speed_kt,ahrs.roll_deg",
    "from_s": None,
    "to_s": None,
    "points": 50,
    "arrow": False,
}


def ask(data: Path, *questions: dict[str, Any]) -> list[tuple[dict[str, Any], bytes]]:
    """Head and bytes of each answer."""
    requests, replies = BytesIO(), BytesIO()
    for question in questions:
        send(requests, {"flight": FLIGHT, "growing": False, **question})
    requests.seek(0)
    serve(Flights(Places(data)), requests, replies)
    replies.seek(0)
    found = []
    while (answer := receive(replies)) is not None:
        found.append((orjson.loads(answer[0]), answer[1]))
    assert len(found) == len(questions)
    return found


def known_of(values: list[float | None]) -> list[float]:
    return [value for value in values if value is not None]


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A data folder with an indexed flight, and the same bytes as one that grows."""
    folder = tmp_path_factory.mktemp("data")
    indexed(folder, recording(SECONDS, stalls=((10.0, 13.0),)))
    return folder


@pytest.mark.parametrize("growing", [False, True], ids=["indexed", "growing"])
def test_a_flight_in_the_air_answers_as_one_that_has_landed(data: Path, growing: bool) -> None:
    questions: list[dict[str, Any]] = [
        {"do": "topics"},
        SIGNALS,
        {"do": "overview", "points": 40},
        {"do": "track", "source": "flight", "points": None},
        {"do": "known", "at_s": 20.0},
        {"do": "span"},
        {"do": "events"},
        {"do": "path", "source": "flight", "most": 100},
    ]
    answers = ask(data, *({**question, "growing": growing} for question in questions))
    assert all(head == {} for head, _ in answers)
    topics, signals, overview, track, known, span, events, path = (body for _, body in answers)
    counted = {one["name"]: one["count"] for one in orjson.loads(topics)["topics"]}
    assert counted["ahrs"] == SECONDS * 50
    assert counted["gps"] == SECONDS * 10
    speed, roll = orjson.loads(signals)["signals"]
    assert max(known_of(speed["max"])) == pytest.approx(SPEED_M_S / 0.514444, rel=1e-5)
    assert min(known_of(roll["min"])) < -15.0
    assert max(known_of(roll["max"])) > 15.0
    assert None in speed["max"], "nothing is drawn over the three seconds without samples"
    assert orjson.loads(overview)["duration_s"] == pytest.approx(SECONDS, abs=0.1)
    assert track.startswith(b"EPT1")
    assert orjson.loads(known)["identity"]["aircraft"] == "ala fija"
    told = orjson.loads(span)
    assert told["end_s"] - told["start_s"] == pytest.approx(SECONDS, abs=0.1)
    assert isinstance(orjson.loads(events)["events"], list)
    assert orjson.loads(path)["points"] > 10


def test_both_kinds_of_flight_give_the_same_values(data: Path) -> None:
    (_, landed), (_, growing) = ask(data, SIGNALS, {**SIGNALS, "growing": True})
    assert orjson.loads(landed) == orjson.loads(growing)


def test_arrow_has_the_values_of_the_json(data: Path) -> None:
    stretch = {**SIGNALS, "from_s": 2.0, "to_s": 6.0, "points": 5000}
    (_, text), (_, arrow) = ask(data, stretch, {**stretch, "arrow": True})
    table = pa.ipc.open_stream(arrow).read_all()
    expected = [
        {"name": one["name"], "at_s": at_s, "min": least, "max": most}
        for one in orjson.loads(text)["signals"]
        for at_s, least, most in zip(one["at_s"], one["min"], one["max"], strict=True)
    ]
    assert len(expected) > 200
    assert table.to_pylist() == expected


@pytest.mark.parametrize(
    ("question", "code"),
    [
        ({"do": "span", "flight": "../state"}, "flight_not_indexed"),
        ({"do": "span", "flight": "20200101T000000Z"}, "flight_not_indexed"),
        ({**SIGNALS, "names": "gps.nothing"}, "signal_unknown"),
        ({"do": "span", "flight": "20200101T000000Z", "growing": True}, "recording_unreadable"),
        ({"do": "nothing"}, "recording_unreadable"),
    ],
)
def test_what_cannot_be_answered_is_told_and_the_next_question_is_answered(
    data: Path, question: dict[str, Any], code: str
) -> None:
    (head, body), (after, _) = ask(data, question, {"do": "span"})
    assert (head["fault"]["code"], body) == (code, b"")
    assert head["fault"]["detail"]
    assert after == {}


def test_columns_that_were_made_again_are_read_again(tmp_path: Path) -> None:
    indexed(tmp_path, recording(4))
    flights = Flights(Places(tmp_path))
    question = SpanQuestion(FLIGHT, growing=False)
    before = orjson.loads(flights.answer(question))
    indexed(tmp_path, recording(8))
    after = orjson.loads(flights.answer(question))
    assert after["end_s"] - before["end_s"] == pytest.approx(4.0, abs=0.1)
