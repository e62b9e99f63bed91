"""The shapes of flights: the library, one flight's events, signals and track, and jobs.

`t_s` is Unix time in seconds; `at_s`, and every `from_s` and `to_s`, are seconds since the flight's first message.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from epf_gcs.contract.flights import Flight, Job
from epf_gcs.contract.shapes import Input, Output
from epf_gcs.formats.kml_words import Language
from epf_gcs.recordings.export_names import ExportFormat
from epf_gcs.web.interface.flights.settings_schemas import FlightDisk

Tag = Annotated[str, Field(min_length=1, max_length=40)]
TopicName = Annotated[str, StringConstraints(pattern=r"^[a-z0-9_]{1,64}$")]
MarkText = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=500)]


class JobStart(Output):
    """The id of a job that was started."""

    job: str


class JobList(Output):
    """Jobs under way and the last that ended, newest first."""

    jobs: list[Job]


class FlightList(Output):
    """One page of the flights that were asked for. `total` counts all pages; `tags`, `boards`, `all_aircraft` and
    `operators` are those of the whole library; `unnamed` are files among the recordings whose names are no flight's,
    which an import makes flights; `indexing` are the jobs that prepare flights now; `aircraft` is what the aircraft
    that flies now is called, empty for no name."""

    flights: list[Flight]
    total: int
    tags: list[str]
    boards: list[str]
    all_aircraft: list[str]
    operators: list[str]
    unnamed: list[str]
    indexing: list[Job]
    disk: FlightDisk
    aircraft: str


class DeletedFlight(Output):
    """A flight in the bin; from `gone_s` on it may be removed for good."""

    id: str
    title: str
    started_s: float
    bytes: int
    deleted_s: float
    gone_s: float


class FlightBin(Output):
    """The bin, deleted last first."""

    flights: list[DeletedFlight]


class FlightChange(Input):
    """What a person says about a flight; what is left out stays."""

    title: Annotated[str, Field(max_length=200)] | None = None
    tags: Annotated[list[Tag], Field(max_length=20)] | None = None
    notes: Annotated[str, Field(max_length=20_000)] | None = None
    pinned: bool | None = None


class MarkInput(Input):
    """The words of a mark."""

    text: MarkText


class MarkAtInput(Input):
    """A mark. Without `at_s` it is set in the flight that is being recorded, `ago_s` before now: words take time, and
    the mark is of the moment at which somebody pressed the key. With `at_s` it is set at that moment of the flight."""

    text: MarkText
    at_s: Annotated[float, Field(ge=0, le=10_000_000)] | None = None
    ago_s: Annotated[float, Field(ge=0, le=600)] = 0.0


class ExportInput(Input):
    """What becomes a file. Without `topics` all of them, without times the whole flight.

    Only mcap-decoded, csv and parquet have topics; a single topic of csv and parquet is one file and no archive.
    `lang` is the language of the names in KML, KMZ, GPX and CZML, by default the browser's.
    KML, KMZ and GPX leave out what is less than a metre from the track, unless `every_point`.
    """

    format: ExportFormat
    topics: Annotated[list[TopicName], Field(min_length=1, max_length=100)] | None = None
    from_s: Annotated[float, Field(ge=0, le=10_000_000)] | None = None
    to_s: Annotated[float, Field(ge=0, le=10_000_000)] | None = None
    lang: Language | None = None
    every_point: bool = False


class Playback(Output):
    """Where a replay is (message `playback` and status). `edge_s` is how far the recording reaches, `loop` is
    [from_s, to_s], `jumps` counts the moments that it went to."""

    flight: str
    at_s: float
    t_s: float
    state: Literal["playing", "paused", "ended"]
    rate: float
    loop: list[float] | None
    duration_s: float
    edge_s: float
    jumps: int
