"""The whole report of a flight: of one that flew its targets, and of one that is indexed, kept and shown as a page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from lxml import html

from epf_gcs.contract.report import FlightReport
from epf_gcs.flights.index import run as index
from epf_gcs.flights.report.compare import compare
from epf_gcs.flights.report.making import report
from epf_gcs.flights.report.page import page
from epf_gcs.flights.report.report import run
from epf_gcs.recordings.flight_summary import FlightSummary
from tests.flights.flown_flights import FLIGHT, quiet, recording
from tests.flights.report.made import make
from tests.flights.test_events import START_NS

SUMMARY = FlightSummary(START_NS, START_NS + 10**11, frames=5000, frames_damaged=3)


def of_made(seed: int) -> FlightReport:
    times = np.arange(0.0, 1e9, 2e7)
    return report(FLIGHT, make(seed).flight, SUMMARY, [], times, times + 4e6)


def made_of(file: Path, *options: str) -> FlightReport:
    found = run([str(file), *options], quiet)["report"]
    assert isinstance(found, FlightReport)
    return found


@pytest.mark.parametrize("language", ["es", "en"])
def test_the_page_shows_each_manoeuvre_beside_the_earlier_flights(language: str) -> None:
    both = compare(of_made(1), of_made(2))
    assert both.earlier is not None
    assert both.earlier.flight == FLIGHT
    assert len(both.manoeuvres) > 5
    shown = html.fromstring(page(both, language))
    assert len(shown.xpath("//svg")) >= len(both.manoeuvres)
    # Of two pictures each says which flight it is of.
    for figures in ([*card.iter("figure")] for card in shown.find_class("card")):
        captions = [figure.findtext("figcaption") for figure in figures]
        assert len(set(captions)) == len(figures)
        assert (captions == [None]) == (len(figures) == 1)


def test_a_report_is_made_once_of_an_indexed_flight_and_kept(tmp_path: Path) -> None:
    file = tmp_path / "recordings" / f"{FLIGHT}.mcap"
    file.parent.mkdir()
    file.write_bytes(recording(20))
    index([str(file)], quiet)
    first = made_of(file)
    assert first.times.duration_s == pytest.approx(20.0, abs=0.5)
    assert first.distances.distance_nm is None or first.distances.distance_nm >= 0.0
    assert made_of(file) == first
    other = made_of(file, "--compare", str(file)).earlier
    assert other is not None
    assert other.flight == FLIGHT
    assert "<html" in str(run([str(file), "--page", "es"], quiet)["page"])


@pytest.mark.parametrize(("language", "words"), [("es", "ningún objetivo cambió"), ("en", "no target changed")])
def test_the_page_of_a_flight_without_manoeuvres_says_so(language: str, words: str) -> None:
    times = np.arange(0.0, 1e9, 2e7)
    made = report(FLIGHT, make(1, steps=0).flight, SUMMARY, [], times, times + 4e6)
    assert made.manoeuvres == []
    assert words in html.fromstring(page(made, language)).text_content()
