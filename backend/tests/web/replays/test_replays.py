"""A recording on the stream, in the real web process with real replay processes."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import orjson
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from epf_gcs.contract.flight_knowledge import FlightKnowledge
from epf_gcs.contract.inspector import Inspector
from epf_gcs.contract.status import Status
from epf_gcs.replay.outlet import Silence
from epf_gcs.replay.playhead import Playhead
from epf_gcs.replay.timeline import Timeline
from epf_gcs.shares.holder import Standing
from epf_gcs.shares.table import SHARES
from tests.replay.recordings import SECOND_NS, STARTS_NS, flight, plain, write
from tests.support.contract import read_as
from tests.support.gateway import Gateway, Stream, running_gateway
from tests.support.outlet import KeptOutlet
from tests.support.programs import children_of, gateway_process, words_of
from tests.support.waiting import eventually, first_of

ID = "20260101T120000Z"
MOST = SHARES.replays.parts[Standing.own].each


@pytest.fixture(scope="module")
def station(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    data = tmp_path_factory.mktemp("data")
    (data / "recordings").mkdir()
    write(data / "recordings" / f"{ID}.mcap", flight(12.0))
    (data / "recordings" / "20260101T130000Z.mcap").write_bytes(b"no recording at all")
    with running_gateway(data) as gateway:
        yield gateway


def replays() -> list[int]:
    """Process numbers of the replays that run."""
    return [pid for pid in children_of(os.getpid()) if "epf_gcs.replay" in words_of(pid)]


def samples_until(stream: Stream, wanted: Any) -> list[dict[str, Any]]:
    """The samples until a playback message of which `wanted` says yes, and those of the batch that it came with: what
    happens is sent before the samples of its turn. Every batch is acknowledged."""
    found: list[dict[str, Any]] = []
    is_wanted = False

    def told(message: dict[str, Any]) -> bool | None:
        nonlocal is_wanted
        if message["type"] == "batch":
            assert message["missed"] == 0
            found.extend(message["samples"])
            stream.acknowledge(message)
            return True if is_wanted else None
        is_wanted = is_wanted or (message["type"] == "playback" and bool(wanted(message)))
        return None

    first_of(stream.receive, told, "a playback that was wanted")
    return found


def test_it_says_hello_as_the_past_and_shows_the_moment(station: Gateway) -> None:
    with station.stream(f"?flight={ID}&at_s=5.5") as stream:
        hello = stream.hello
        assert (hello["flight"], hello["role"], hello["has_control"]) == (ID, "owner", False)
        assert hello["starts_s"] == pytest.approx(STARTS_NS * 1e-9)
        assert hello["server_time_s"] == pytest.approx(hello["starts_s"] + 5.5)
        assert hello["duration_s"] == pytest.approx(11.96, abs=0.1)
        assert hello["status"]["playback"]["state"] == "paused"
        read_as(Status, {name: value for name, value in hello["status"].items() if name != "playback"})
        batch = stream.next("batch")
        expected = Playhead(Timeline(station.flight_thread.data_dir / "recordings" / f"{ID}.mcap"), Silence())
        expected.advance(STARTS_NS + round(5.5 * SECOND_NS))
        newest = {topic: plain(one.values) for topic, one in expected.vehicle.telemetry.samples().items()}
        assert {sample["topic"]: sample["values"] for sample in batch["samples"]} == newest
    eventually(lambda: not replays(), "its process ends with the viewer")


def test_every_sample_of_a_replay_at_high_speed_is_every_sample_of_the_flight(station: Gateway) -> None:
    with station.stream(f"?flight={ID}&rate=0") as stream:
        stream.send({"type": "play", "rate": 100})
        found = samples_until(stream, lambda playback: playback["state"] == "ended")
    outlet = KeptOutlet()
    timeline = Timeline(station.flight_thread.data_dir / "recordings" / f"{ID}.mcap")
    Playhead(timeline, outlet).advance(timeline.edge_ns)
    for topic in {topic for topic, _, _ in outlet.samples}:
        expected = [(round(t_s, 6), plain(values)) for name, t_s, values in outlet.samples if name == topic]
        got = [(one["t_s"], one["values"]) for one in found if one["topic"] == topic]
        assert got == expected[-len(got) :]
        assert len(expected) - len(got) <= 1, "only what came in the first moment may be in the hello's own batch"


def test_after_a_seek_back_the_first_batch_holds_every_topic_and_an_earlier_time(station: Gateway) -> None:
    with station.stream(f"?flight={ID}&at_s=9") as stream:
        before = stream.next("batch")
        stream.send({"type": "seek", "at_s": 2.25})
        playback = stream.next("playback")
        while playback["at_s"] > 3:
            playback = stream.next("playback")
        assert playback["at_s"] == pytest.approx(2.25)
        batch = stream.next("batch")
        assert batch["t_s"] < before["t_s"]
        assert {one["topic"] for one in batch["samples"]} == {one["topic"] for one in before["samples"]}
        assert all(one["t_s"] <= playback["t_s"] for one in batch["samples"])


def test_play_pause_step_and_loop_are_answered_at_once(station: Gateway) -> None:
    with station.stream(f"?flight={ID}") as stream:
        for wish, state in (({"type": "play", "rate": 2.0}, "playing"), ({"type": "pause"}, "paused")):
            stream.send(wish)
            while stream.next("playback")["state"] != state:
                pass
        stream.send({"type": "loop", "from_s": 3, "to_s": 4})
        while (playback := stream.next("playback"))["loop"] is None:
            pass
        assert playback["loop"] == [3.0, 4.0]
        stream.send({"type": "step", "frames": 1})
        assert stream.next("playback")["at_s"] > playback["at_s"]


@pytest.mark.parametrize(
    ("wish", "words"),
    [
        ({"type": "stick", "elevator": 1.0}, "nothing can be flown"),
        ({"type": "command", "name": "start"}, "no known type"),
        ({"type": "seek", "at_s": "5"}, "no known type"),
        ({"type": "play", "rate": -1}, "0.01 to 100 times"),
        ({"type": "play", "rate": 1e9}, "0.01 to 100 times"),
        ({"type": "play", "rate": "fast"}, "0.01 to 100 times"),
        ({"type": "step", "frames": 5}, "no known type"),
        ({"type": "loop", "from_s": 5}, "to a later one"),
        ({"type": "loop", "from_s": 50, "to_s": 10}, "to a later one"),
        ([1], "no known type"),
    ],
)
def test_what_is_no_wish_of_a_viewer_is_refused_in_words(station: Gateway, wish: Any, words: str) -> None:
    with station.stream(f"?flight={ID}") as stream:
        stream.send(wish)
        refused = stream.event("error")
        assert refused["code"] == "stream_message_invalid"
        assert words in refused["detail"]


@pytest.mark.parametrize(
    ("query", "status"),
    [
        ("?flight=20990101T120000Z", 404),
        ("?flight=../state", 404),
        ("?flight=current", 404),
        (f"?flight={ID}&at_s=nan", 400),
        (f"?flight={ID}&rate=61", 400),
    ],
)
def test_what_cannot_be_replayed_is_refused_before_anything_is_started(
    station: Gateway, query: str, status: int
) -> None:
    eventually(lambda: not replays(), "earlier ones have ended")
    with pytest.raises(InvalidStatus) as refused, station.stream(query):
        pass
    assert refused.value.response.status_code == status
    assert not replays()


def test_a_file_that_is_no_recording_is_told_and_the_stream_closed(station: Gateway) -> None:
    with station.stream("?flight=20260101T130000Z") as stream:
        assert stream.hello["type"] == "event"
        assert "no recording" in stream.hello["data"]["detail"]
        with pytest.raises(ConnectionClosed):
            stream.receive()


def test_so_many_replays_and_no_more_and_a_live_viewer_beside_them_sees_nothing_of_it(station: Gateway) -> None:
    with station.stream() as live:
        eventually(lambda: not replays(), "earlier ones have ended")
        streams = [station.stream(f"?flight={ID}&at_s={number}") for number in range(MOST)]
        opened = [stream.__enter__() for stream in streams]
        assert len(replays()) == 1, "those of one recording share a process"
        with station.stream(f"?flight={ID}") as refused:
            assert (refused.hello["event"], refused.hello["data"]["code"]) == ("error", "replays_own")
            assert refused.hello["data"]["params"] == {"limit": MOST}
        assert len({stream.hello["status"]["playback"]["at_s"] for stream in opened}) == MOST
        for stream in streams:
            stream.__exit__(None, None, None)
        eventually(lambda: not replays(), "all end")
        live.connection.send(orjson.dumps({"type": "rate", "rate": 1}).decode())
        assert live.hello["status"]["viewers"] == 0
        assert live.next("status")["data"]["viewers"] == 1
        assert "playback" not in live.next("status")["data"]


def test_viewers_of_one_recording_are_each_at_their_own_moment_and_one_may_leave(station: Gateway) -> None:
    with station.stream(f"?flight={ID}&at_s=2") as stays:
        with station.stream(f"?flight={ID}&at_s=9") as leaves:
            leaves.send({"type": "seek", "at_s": 10})
            while (there := leaves.next("playback"))["jumps"] == leaves.hello["status"]["playback"]["jumps"]:
                pass
            assert there["at_s"] == 10.0
        stays.send({"type": "play", "rate": 100})
        while (playback := stays.next("playback"))["state"] != "ended":
            pass
        assert playback["jumps"] == stays.hello["status"]["playback"]["jumps"], "nobody else's wish moved it"
        assert len(replays()) == 1


def test_a_replay_ends_when_the_web_process_is_killed(tmp_path: Path) -> None:
    (tmp_path / "recordings").mkdir()
    write(tmp_path / "recordings" / f"{ID}.mcap", flight(2.0))
    with gateway_process(tmp_path) as gateway:
        url = gateway.wait_for_words(r"url=(http://\S+)").replace("http", "ws")
        with connect(f"{url}/api/v1/stream?flight={ID}") as connection:
            assert Stream(connection).hello["type"] == "hello"
            (web,) = [pid for pid in children_of(gateway.process.pid) if "epf_gcs.web" in words_of(pid)]
            (replay,) = [pid for pid in children_of(web) if "epf_gcs.replay" in words_of(pid)]
            os.kill(web, signal.SIGKILL)
            eventually(lambda: not Path(f"/proc/{replay}").exists() or not words_of(replay), "the replay ends")


def test_a_viewer_asks_what_was_known_and_measured_at_the_moment_shown(station: Gateway) -> None:
    with station.stream(f"?flight={ID}&at_s=5") as stream:
        stream.send({"type": "ask", "about": "inspector"})
        first = stream.next("answer")
        assert first["about"] == "inspector"
        read_as(Inspector, first["data"])
        stream.send({"type": "seek", "at_s": 10})
        while stream.next("playback")["at_s"] < 10:
            pass
        stream.send({"type": "ask", "about": "inspector"})
        later = stream.next("answer")["data"]
        counts = [{one["name"]: one["count"] for one in found["board"]} for found in (first["data"], later)]
        assert counts[1]["ahrs"] > counts[0]["ahrs"] > 0
        assert later["t_s"] == pytest.approx(first["data"]["t_s"] + 5.0)
        assert later["link"]["round_trips"] is None
        stream.send({"type": "ask", "about": "known"})
        known = read_as(FlightKnowledge, stream.next("answer")["data"])
        assert known.at_s == pytest.approx(10.0)
        assert known.parameters is None, "nobody noted a gain"
        stream.send({"type": "ask", "about": "secrets"})
        assert stream.event("error")["code"] == "stream_message_invalid"


def test_a_flight_that_is_deleted_or_whose_file_is_removed_goes_on_for_those_who_look_at_it(tmp_path: Path) -> None:
    other = "20260101T120000Z-2"
    (tmp_path / "recordings").mkdir()
    for name in (ID, other):
        write(tmp_path / "recordings" / f"{name}.mcap", flight(12.0))
    with running_gateway(tmp_path) as gateway:
        eventually(lambda: gateway.http.get(f"/flights/{ID}").json()["state"] == "indexed", "it is prepared")
        for name in (ID, other):
            with gateway.stream(f"?flight={name}&at_s=2") as stays:
                if name == ID:
                    gateway.http.delete(f"/flights/{name}", params={"confirm": name}).raise_for_status()
                else:
                    (tmp_path / "recordings" / f"{name}.mcap").unlink()
                stays.send({"type": "rate", "rate": 0})
                stays.send({"type": "seek", "at_s": 0})
                stays.send({"type": "play", "rate": 100})
                samples = samples_until(stays, lambda playback: playback["state"] == "ended")
                assert [one["topic"] for one in samples].count("ahrs") >= 200, "all of it is shown, to its end"
                with pytest.raises(InvalidStatus) as refused, gateway.stream(f"?flight={name}"):
                    pass
                assert refused.value.response.status_code == 404
                answer = gateway.http.get(f"/flights/{name}/signals", params={"names": "ahrs.roll_deg"})
                assert (answer.status_code, answer.json()["code"]) == (404, "flight_unknown")


def test_a_flight_that_is_looked_at_is_not_deleted_to_make_room(tmp_path: Path) -> None:
    names = (ID, f"{ID}-2")
    (tmp_path / "recordings").mkdir()
    for name in names:
        write(tmp_path / "recordings" / f"{name}.mcap", flight(4.0))
    with running_gateway(tmp_path) as gateway, gateway.stream(f"?flight={ID}"):
        policy = {"delete_oldest": True, "keep_free_bytes": 10_000_000_000_000}
        gateway.http.put("/flights/policy", json=policy).raise_for_status()
        eventually(
            lambda: [one.stem for one in (tmp_path / "recordings").glob("*.mcap")] == [ID], "only the other goes"
        )
