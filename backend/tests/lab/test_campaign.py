"""What a campaign flies: read from its file, drawn by number, kept flight by flight."""

from __future__ import annotations

import resource
from collections.abc import Iterator
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from pathlib import Path

import orjson
import pyarrow.parquet as pq
import pytest

from epf_gcs.lab import flying
from epf_gcs.lab.campaign import Campaign, read
from epf_gcs.lab.conditions import Conditions, gains_of
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.rows import PARQUET, Results, Row, row

TEXT = """
route = "gando"
flights = 6
seed = 3
[fixed]
turbulence = "light"
[drawn]
wind_kt = { uniform = [0, 25] }
mass_factor = { normal = [1.0, 0.05] }
start = { choice = ["air", "final"] }
"gains.k_roll" = { uniform = [1.5, 3.0] }
"""


def campaign(folder: Path, text: str = TEXT) -> Campaign:
    path = folder / "campaign.toml"
    path.write_text(text, encoding="utf-8")
    return read(path)


def unflown(wanted: Campaign, number: int, *_: object) -> Row:
    return row(wanted.order(number), None, "not flown in this test")


def campaign_or_none(folder: Path, text: str) -> Campaign | None:
    try:
        return campaign(folder, text)
    except LabError:
        return None


@contextmanager
def largest_file(size: int) -> Iterator[None]:
    """A disk that takes files of this size, and no larger ones."""
    usual = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, usual[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, usual)


def kept(results: Results, rows: list[Row]) -> bytes:
    """The table with these rows too."""
    for one in rows:
        results.add(one)
    return results.finish().read_bytes()


def test_a_number_always_gives_the_same_flight_and_others_give_others(tmp_path: Path) -> None:
    wanted = campaign(tmp_path)
    orders = [wanted.order(number) for number in range(200)]
    assert orders == [campaign(tmp_path).order(number) for number in range(200)]
    conditions = [Conditions.of(order.conditions) for order in orders]
    assert len({one.seed for one in conditions}) == 200
    assert all(0.0 <= one.wind_kt <= 25.0 for one in conditions)
    assert all(0.85 <= one.mass_factor <= 1.15 for one in conditions)
    assert {one.start for one in conditions} == {"air", "final"}
    assert {one.turbulence for one in conditions} == {"light"}
    assert all(1.5 <= gains_of(order.gains)["k_roll"] <= 3.0 for order in orders)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ("flights = 0", "`flights`, 1 to 1000000"),
        ('flights = 2\nroute = "nowhere"', "routes with a name are gando"),
        ("flights = 2\nfixed = 3", "`fixed` must be a table"),
        ("flights = 2\n[fixed]\nwing_kt = 3", "no condition wing_kt"),
        ("flights = 2\n[fixed]\nwind_kt = -3", "wind_kt is -3.0, and must be 0 to 100"),
        ('flights = 2\n[fixed]\nturbulence = "wild"', "none, light, moderate, severe"),
        ('flights = 2\n[fixed]\nwind_kt = "much"', "wind_kt cannot be 'much': it must be a number"),
        ("flights = 2\n[drawn]\nrate_hz = { uniform = [20, 90] }", "rate_hz cannot be .*: it must be a whole number"),
        ('flights = 2\n[fixed.gains]\nk_roll = "much"', "gains.k_roll cannot be 'much': it must be a number"),
        ("flights = 2\n[drawn]\nwind_kt = { uniform = [0] }", "wind_kt must be drawn by one of"),
        ("flights = 2\n[fixed]\nseed = 1\n[drawn]\nseed = { choice = [1, 2] }", "cannot be fixed and drawn"),
        ("flights = 2\nspeed = 3", "has speed, which a campaign has not"),
        ("flights = ", "is no campaign"),
    ],
)
def test_a_file_that_cannot_be_flown_says_what_is_wrong(tmp_path: Path, wrong: str, said: str) -> None:
    with pytest.raises(LabError, match=said):
        campaign(tmp_path, wrong)


def test_a_campaign_that_stopped_goes_on_and_ends_in_the_same_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(flying, "_flown", lambda one, numbers, *_: (unflown(one, number) for number in numbers))
    wanted = campaign(tmp_path)
    with Results(tmp_path / "whole", wanted) as whole:
        flying.fly_all(wanted, whole, 1)
        whole.finish()
    with Results(tmp_path / "cut", wanted) as cut:
        for number in (4, 1):
            cut.add(unflown(wanted, number))
    journal = tmp_path / "cut" / "flights.jsonl"
    journal.write_bytes(journal.read_bytes() + b'{"number":2,"wind')
    flown: list[int] = []
    with Results(tmp_path / "cut", wanted) as again:
        flying.fly_all(wanted, again, 1, on_row=lambda one: flown.append(one["number"]))
        again.finish()
    assert flown == [0, 2, 3, 5], "what was half written is flown again, what was there is not"
    assert (tmp_path / "cut" / PARQUET).read_bytes() == (tmp_path / "whole" / PARQUET).read_bytes()


def test_a_process_that_dies_costs_its_flight_three_tries_and_the_others_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def dies_at_2(one: Campaign, numbers: list[int], _workers: int, _library: None, tries: dict[int, int]) -> object:
        for number in numbers:
            if number == 2:
                tries[2] = tries.get(2, 0) + 1
                raise BrokenProcessPool
            yield unflown(one, number)

    monkeypatch.setattr(flying, "_flown", dies_at_2)
    wanted = campaign(tmp_path)
    with Results(tmp_path / "results", wanted) as results:
        flying.fly_all(wanted, results, 1)
    assert sorted(results.rows) == list(range(6))
    assert [number for number, one in results.rows.items() if "died" in one["error"]] == [2]


def test_a_folder_of_another_campaign_is_refused(tmp_path: Path) -> None:
    with Results(tmp_path / "results", campaign(tmp_path)):
        pass
    with pytest.raises(LabError, match="flights of another campaign"):
        Results(tmp_path / "results", campaign(tmp_path, TEXT.replace("seed = 3", "seed = 4")))


def test_values_that_cannot_be_flown_are_rows_with_the_columns_of_all_others(tmp_path: Path) -> None:
    text = 'flights = 40\n[drawn]\nwind_kt = { choice = [5, 5, 500, "much"] }\n'
    text += '"gains.k_roll" = { choice = [2, 2, nan, "much", 1e300] }\n'
    # A campaign whose first flight cannot be flown is refused.
    wanted = next(filter(None, (campaign_or_none(tmp_path, f"seed = {seed}\n{text}") for seed in range(100))))
    with Results(tmp_path / "results", wanted) as results:
        for number in range(wanted.flights):
            order = wanted.order(number)
            is_flown = order.conditions["wind_kt"] == 5 and order.gains["k_roll"] == 2
            results.add(unflown(wanted, number) if is_flown else flying.fly_order(wanted, number))
        table = pq.read_table(results.finish())
    said = {one["error"] for one in table.to_pylist()}
    assert {"wind_kt is 500.0, and must be 0 to 100", "wind_kt cannot be 'much': it must be a number"} <= said
    assert "gains.k_roll cannot be 'much': it must be a number" in said
    assert any("k_roll: value must be a number" in one for one in said)
    assert {str(table.schema.field(name).type) for name in ("wind_kt", "gains.k_roll")} == {"double"}
    before = (tmp_path / "results" / PARQUET).read_bytes()
    with Results(tmp_path / "results", wanted) as again:
        assert again.finish().read_bytes() == before


@pytest.mark.parametrize("limit", [700, 6000], ids=["in the second flight", "in the table"])
def test_a_full_disk_is_told_in_a_sentence_and_the_campaign_goes_on_where_it_was(tmp_path: Path, limit: int) -> None:
    wanted = campaign(tmp_path)
    rows = [unflown(wanted, number) for number in range(wanted.flights)]
    with Results(tmp_path / "whole", wanted) as whole:
        expected = kept(whole, rows)
    assert len(orjson.dumps(rows[0])) < 700 < 2 * len(orjson.dumps(rows[0])) < 6 * len(orjson.dumps(rows[0])) < 6000
    assert len(expected) > 6000
    with Results(tmp_path / "full", wanted) as full, largest_file(limit), pytest.raises(LabError, match="Make room"):
        kept(full, rows)
    with Results(tmp_path / "full", wanted) as again:
        assert list(again.missing()) == (list(range(1, 6)) if limit == 700 else [])
        assert kept(again, [rows[number] for number in again.missing()]) == expected


def test_two_processes_fly_what_one_flies(tmp_path: Path) -> None:
    short = 'route = "plan.csv"\nflights = 3\n[drawn]\nwind_kt = { uniform = [0, 10] }\n'
    plan = "latitude_deg,longitude_deg,altitude_ft,speed_kt\n27.9380,-15.3830,1000,55\n"
    (tmp_path / "plan.csv").write_text(plan, encoding="utf-8")
    wanted = campaign(tmp_path, short)
    with Results(tmp_path / "results", wanted) as results:
        flying.fly_all(wanted, results, 2)
        results.finish()
    table = pq.read_table(tmp_path / "results" / PARQUET).to_pylist()
    assert [one["error"] for one in table] == [None, None, None]
    assert [one["captured_honestly"] for one in table] == [1, 1, 1]
    assert table == [flying.fly_order(wanted, number) for number in range(3)]
