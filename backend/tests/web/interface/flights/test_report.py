"""The report over REST: as values and as a page of its own, in both languages, beside an earlier flight."""

from __future__ import annotations

import base64
import hashlib
from typing import Any, cast

import pytest
from lxml import html

from tests.support.fake_board import FakeBoard
from tests.support.gateway import Gateway
from tests.support.waiting import eventually
from tests.web.interface.flights.conftest import indexed
from tests.web.interface.flights.test_routes import NOW_NS
from tests.web.interface.flights.test_routes import recording as short_recording


def report(gateway: Gateway, flight: str, **asked: str) -> dict[str, Any]:
    answer = gateway.http.get(f"/flights/{flight}/report", params=asked)
    return cast(dict[str, Any], answer.raise_for_status().json())


def test_the_report_has_the_figures_of_the_flight_and_says_what_it_cannot_know(station: Gateway, kept: str) -> None:
    found = report(station, kept)
    assert found["flight"] == kept
    assert found["times"]["duration_s"] == pytest.approx(20.0, abs=0.5)
    assert found["link"]["frames"] > 100
    assert (found["manoeuvres"], found["no_manoeuvres"]) == ([], "no_targets")
    assert found["unknown"]
    assert report(station, kept) == found, "the report that is kept is the one that was made"


@pytest.mark.parametrize(("lang", "title"), [("es", "Informe de vuelo"), ("en", "Flight report")])
def test_the_report_is_a_page_of_its_own_in_both_languages(station: Gateway, kept: str, lang: str, title: str) -> None:
    answer = station.http.get(f"/flights/{kept}/report", params={"format": "html", "lang": lang}).raise_for_status()
    assert answer.headers["content-type"].startswith("text/html")
    page = html.fromstring(answer.text)
    assert (page.get("lang"), page.findtext(".//h1")) == (lang, title)
    assert kept in page.text_content()
    assert page.xpath("//script | //link | //*[@src] | //*[@style]") == []
    digest = base64.b64encode(hashlib.sha256(page.findtext(".//style").encode()).digest()).decode()
    policy = answer.headers["content-security-policy"]
    assert f"style-src 'sha256-{digest}';" in policy, "the browser shows the page with its style"
    assert "default-src 'none'" in policy


def test_an_earlier_flight_stands_beside_it(station: Gateway, kept: str) -> None:
    other = indexed(station, short_recording([NOW_NS, NOW_NS + 5 * 10**9]))
    assert report(station, kept, compare=other)["earlier"]["flight"] == other
    query = {"format": "html", "lang": "en", "compare": other}
    assert other in station.http.get(f"/flights/{kept}/report", params=query).raise_for_status().text


def test_what_has_no_report_is_refused_with_its_reason(gateway: Gateway, board: FakeBoard) -> None:
    unknown = gateway.http.get("/flights/20200101T000000Z/report")
    assert (unknown.status_code, unknown.json()["code"]) == (404, "flight_unknown")
    gateway.open_board(board.url)
    eventually(lambda: gateway.status()["recording"]["file"] is not None, "it records")
    growing = str(gateway.status()["recording"]["file"]).removesuffix(".mcap")
    refused = gateway.http.get(f"/flights/{growing}/report")
    assert (refused.status_code, refused.json()["code"]) == (409, "flight_recording")
