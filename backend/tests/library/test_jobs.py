"""Workers are of the lowest priority, end when they are told to, and never outlive the web process."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import pytest

from epf_gcs.recordings.mcap_file import Tally, closing, data_end, message_record, opening
from epf_gcs.recordings.topics import TOPICS
from tests.support.gateway import Gateway, running_gateway
from tests.support.programs import Program, children_of, gateway_process, sockets_of, words_of
from tests.support.waiting import DEADLINE_S, eventually

FLIGHT = "20260101T100000Z"
SILENT = Path(__file__).parents[1] / "support" / "silent_packing"


@pytest.fixture
def large(tmp_path: Path) -> Path:
    """A data folder with a recording that takes seconds to prepare."""
    start_ns, tally = 1_767_261_600_000_000_000, Tally()
    pieces = [opening("test", TOPICS)]
    for number in range(60_000):
        t_ns = start_ns + number * 1_000_000
        pieces.append(message_record(1, tally.add(1, t_ns), t_ns, os.urandom(500)))
    body = b"".join(pieces) + data_end()
    folder = tmp_path / "data" / "recordings"
    folder.mkdir(parents=True)
    (folder / f"{FLIGHT}.mcap").write_bytes(body + closing(TOPICS, tally, len(body)))
    return tmp_path / "data"


def is_alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def found(pid: int, words: str) -> list[int]:
    """The children of a process whose command has these words."""
    return [child for child in children_of(pid) if words in " ".join(words_of(child))]


def waits(gateway: Gateway, kind: str, condition: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
    """The newest job of this kind, once it is so."""

    def jobs() -> list[dict[str, Any]]:
        return [job for job in gateway.http.get("/jobs").json()["jobs"] if job["kind"] == kind and condition(job)]

    eventually(lambda: bool(jobs()), f"a job {kind}")
    return jobs()[0]


def test_a_cancelled_job_leaves_nothing_and_is_not_begun_again_by_itself(large: Path) -> None:
    with running_gateway(large) as gateway, gateway.stream() as stream:
        job = waits(gateway, "pack", lambda job: job["state"] == "running" and job["progress"] > 0)
        assert gateway.http.get(f"/flights/{FLIGHT}").json()["state"] == "indexing"
        before = (large / "recordings" / f"{FLIGHT}.mcap").read_bytes()
        (worker,) = found(os.getpid(), "epf_gcs.flights pack")
        cancelled = gateway.http.delete(f"/jobs/{job['id']}").raise_for_status().json()
        assert (cancelled["state"], cancelled["fault"]) == ("cancelled", None)
        assert not is_alive(worker)
        while (told := stream.event("job"))["state"] != "cancelled":
            assert told["id"] == job["id"]
        assert [path.name for path in (large / "recordings").iterdir()] == [f"{FLIGHT}.mcap"]
        assert (large / "recordings" / f"{FLIGHT}.mcap").read_bytes() == before
        assert gateway.http.get(f"/flights/{FLIGHT}").json()["state"] == "waiting"
        assert not [one for one in gateway.http.get("/jobs").json()["jobs"] if one["state"] in ("waiting", "running")]
        gateway.http.post(f"/flights/{FLIGHT}/index", timeout=DEADLINE_S).raise_for_status()
        waits(gateway, "pack", lambda job: job["state"] == "running")


def test_a_packing_that_was_killed_leaves_no_half_file_neither_does_one_of_an_earlier_run(large: Path) -> None:
    recordings = large / "recordings"
    (recordings / "20250101T100000Z.mcap.packing").write_bytes(b"of an earlier run")
    with running_gateway(large) as gateway:
        job = waits(gateway, "pack", lambda job: job["state"] == "running" and job["progress"] > 0)
        assert [path.name for path in recordings.glob("*.packing")] == [f"{FLIGHT}.mcap.packing"]
        (worker,) = found(os.getpid(), "epf_gcs.flights pack")
        os.kill(worker, signal.SIGKILL)
        waits(gateway, "pack", lambda one: one["id"] == job["id"] and one["state"] == "failed")
        eventually(lambda: not list(recordings.glob("*.packing")), "the half file is removed")


def test_a_gateway_that_ends_ends_its_workers(large: Path) -> None:
    with running_gateway(large) as gateway:
        waits(gateway, "pack", lambda job: job["state"] == "running" and job["progress"] > 0)
        (worker,) = found(os.getpid(), "epf_gcs.flights pack")
    assert not is_alive(worker)


@pytest.fixture
def silent_packing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Workers that pack say nothing, in all programs that are started from now on."""
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(filter(None, (str(SILENT), os.environ.get("PYTHONPATH")))))


def silent_worker(gateway: Program, data: Path) -> tuple[int, int]:
    """The web process of a gateway and a worker of it that says nothing, so that no broken pipe ends it."""
    port = gateway.wait_for_words(r"http://127\.0\.0\.1:(\d+)")
    eventually(lambda: bool(found(gateway.process.pid, "epf_gcs.web")), "the web process")
    (web,) = found(gateway.process.pid, "epf_gcs.web")
    (data / "recordings").mkdir(exist_ok=True)
    (data / "recordings" / f"{FLIGHT}.mcap").write_bytes(opening("test", TOPICS))
    httpx.post(f"http://127.0.0.1:{port}/api/v1/flights/{FLIGHT}/index", timeout=DEADLINE_S).raise_for_status()
    eventually(lambda: bool(found(web, "epf_gcs.flights pack")), "its worker")
    (worker,) = found(web, "epf_gcs.flights pack")
    eventually(lambda: len(list(Path(f"/proc/{worker}/task").iterdir())) > 1, "the worker watches for its parent's end")
    return web, worker


@pytest.mark.usefixtures("true_priority", "silent_packing")
def test_a_worker_is_of_the_lowest_priority(tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data") as gateway:
        _web, worker = silent_worker(gateway, tmp_path / "data")
        eventually(lambda: os.getpriority(os.PRIO_PROCESS, worker) == 19, "it steps back before it works")


@pytest.mark.usefixtures("silent_packing")
def test_a_web_process_that_is_killed_leaves_no_worker_even_one_that_is_silent(tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data") as gateway:
        web, worker = silent_worker(gateway, tmp_path / "data")
        os.kill(web, signal.SIGKILL)
        eventually(lambda: not is_alive(worker), "the worker ends")


@pytest.mark.usefixtures("silent_packing")
def test_a_worker_does_not_hold_the_port_which_a_gateway_that_was_killed_has_to_let_go(tmp_path: Path) -> None:
    with gateway_process(tmp_path / "data") as gateway:
        _web, worker = silent_worker(gateway, tmp_path / "data")
        # The launcher has no socket but the listening one.
        assert len(sockets_of(gateway.process.pid)) == 1
        assert not sockets_of(gateway.process.pid) & sockets_of(worker)
