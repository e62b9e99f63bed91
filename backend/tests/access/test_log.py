"""The log of what people did: only appended to, whole after a power cut, and never in anybody's way."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from pathlib import Path

import orjson
import pytest

from epf_gcs.access import log as log_module
from epf_gcs.access.caller import LOCAL
from epf_gcs.access.log import FILE, DeedLog
from epf_gcs.errors import GatewayError


@pytest.fixture
def faults() -> list[GatewayError]:
    return []


@pytest.fixture
def deeds(tmp_path: Path, faults: list[GatewayError]) -> Iterator[DeedLog]:
    times = iter(range(1, 100000))
    log = DeedLog(tmp_path, lambda: float(next(times)), faults.append)
    yield log
    log.close()


async def settled(log: DeedLog) -> None:
    """Until all that waits is written."""
    while log._is_writing:  # noqa: ASYNC110 - the log tells nobody that it is done
        await asyncio.sleep(0)


def written(folder: Path) -> list[str]:
    """All that stands in the files, oldest first."""
    older = sorted(folder.glob("people.*.jsonl"))
    assert len(older) > 2
    newest = folder / FILE
    files = [*older, newest] if newest.exists() else older
    return [orjson.loads(line)["what"] for file in files for line in file.read_bytes().splitlines()]


@pytest.mark.anyio
async def test_deeds_come_newest_first_and_can_be_searched(deeds: DeedLog) -> None:
    for number in range(20):
        deeds.note(LOCAL if number % 2 else None, "10.0.0.1", "command", f"Número {number}", "200")
    assert [deed["what"] for deed in await deeds.newest(None, 3, "")] == ["Número 19", "Número 18", "Número 17"]
    third = (await deeds.newest(None, 20, ""))[-3]["at"]
    assert [deed["t_s"] for deed in await deeds.newest(third, 10, "")] == [2.0, 1.0]
    assert [deed["what"] for deed in await deeds.newest(None, 10, "NÚMERO 7")] == ["Número 7"]
    assert {deed["kind"] for deed in await deeds.newest(None, 10, "")} == {"local", "stranger"}


@pytest.mark.anyio
async def test_a_line_that_a_power_cut_tore_is_left_out_and_the_next_ones_are_not(
    tmp_path: Path, deeds: DeedLog
) -> None:
    deeds.note(LOCAL, "", "command", "first", "200")
    await settled(deeds)
    with (tmp_path / FILE).open("ab") as file:
        file.write(b'{"t_s": 2.0, "name": "An')
    deeds.note(LOCAL, "", "command", "second", "200")
    await settled(deeds)
    deeds.note(LOCAL, "", "command", "third", "200")
    await settled(deeds)
    assert [deed["what"] for deed in await deeds.newest(None, 10, "")] == ["third", "second", "first"]


@pytest.mark.anyio
async def test_a_full_file_is_put_aside_and_still_read(
    tmp_path: Path, deeds: DeedLog, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(log_module, "TURNED_OVER_BYTES", 1000)
    for number in range(30):
        deeds.note(LOCAL, "", "command", str(number), "200")
        await settled(deeds)
    assert written(tmp_path) == [str(number) for number in range(30)]
    assert [deed["what"] for deed in await deeds.newest(None, 100, "")] == [str(number) for number in range(29, -1, -1)]


@pytest.mark.anyio
@pytest.mark.parametrize("block", [7, 65536])
async def test_page_after_page_shows_each_deed_once_whatever_the_clock_does_and_while_files_are_put_aside(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, block: int
) -> None:
    monkeypatch.setattr(log_module, "TURNED_OVER_BYTES", 700)
    monkeypatch.setattr(log_module, "_BLOCK", block)
    times = iter([5.0] * 10 + [3.0] * 10 + [4.0] * 100)
    deeds = DeedLog(tmp_path, lambda: next(times), lambda fault: pytest.fail(fault.detail))
    for number in range(25):
        deeds.note(None, "", "command", str(number), "200")
        await settled(deeds)
    read: list[str] = []
    before = None
    while page := await deeds.newest(before, 4, ""):
        read += [deed["what"] for deed in page]
        before = page[-1]["at"]
        deeds.note(None, "", "command", "later", "200")
        await settled(deeds)
    assert read == [str(number) for number in range(24, -1, -1)]
    deeds.close()


@pytest.mark.anyio
async def test_a_disk_that_takes_nothing_is_reported(tmp_path: Path, faults: list[GatewayError]) -> None:
    log = DeedLog(tmp_path / "gone", lambda: 0.0, faults.append)
    log.note(LOCAL, "", "command", "", "200")
    await settled(log)
    log.close()
    assert [fault.code for fault in faults] == ["people_log_not_written"]


@pytest.mark.anyio
async def test_a_link_in_the_place_of_the_log_is_not_written_through_and_that_is_told(
    deeds: DeedLog, faults: list[GatewayError], tmp_path: Path
) -> None:
    foreign = tmp_path / "foreign"
    foreign.write_bytes(b"of somebody else\n")
    (tmp_path / FILE).symlink_to(foreign)
    deeds.note(LOCAL, "", "holder", "a > b", "taken")
    await settled(deeds)
    assert foreign.read_bytes() == b"of somebody else\n"
    assert [fault.code for fault in faults] == ["people_log_not_written"]
