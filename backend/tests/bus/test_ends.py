"""Both ends over a real socket: what is told, asked and lost."""

from __future__ import annotations

import asyncio
import socket
import stat
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import orjson
import pytest

from epf_gcs.bus.address import FILE, Listener, connect
from epf_gcs.bus.definition import Asker, Kind, NamedText, pack
from epf_gcs.bus.station_end import StationEnd
from epf_gcs.bus.vehicle_end import Broadcast, VehicleEnd
from epf_gcs.contract.answers import AircraftName
from epf_gcs.contract.events import ConsoleEvent, FlightProcessEvent
from epf_gcs.contract.hello import Hello
from epf_gcs.contract.notices import Notice, Pace, StickRelease
from epf_gcs.contract.playback import Playback
from epf_gcs.contract.requests import LoadParameters, NameAircraft, ReadHil, ReadPlan, ReadPorts
from epf_gcs.contract.status import HilState, Status
from epf_gcs.errors import ConflictError, GatewayError, InvalidInputError, UnavailableError
from tests.support.contract import a_playback
from tests.support.waiting import DEADLINE_S, eventually_async

HELLO = Hello("1", "live", Status())


class Heard:
    """Keeps what a vehicle said."""

    def __init__(self) -> None:
        self.hellos: list[Hello] = []
        self.samples: list[NamedText] = []
        self.ends = 0
        self.events: list[NamedText] = []
        self.statuses: list[Status] = []
        self.losses: list[bool] = []
        self.silences: list[bool] = []
        self.playbacks: list[Playback] = []
        self.order: list[str] = []

    def on_hello(self, hello: Hello) -> None:
        self.hellos.append(hello)

    def on_sample(self, sample: NamedText) -> None:
        self.samples.append(sample)

    def on_samples_end(self) -> None:
        self.ends += 1
        self.order.append("end of samples")

    def on_event(self, event: NamedText) -> None:
        self.events.append(event)

    def on_status(self, status: Status) -> None:
        self.statuses.append(status)

    def on_playback(self, playback: Playback) -> None:
        self.playbacks.append(playback)
        self.order.append("playback")

    def on_silence(self, *, silent: bool) -> None:
        self.silences.append(silent)

    def on_lost(self, *, ended: bool) -> None:
        self.losses.append(ended)


class Vehicle:
    """A vehicle that answers a few requests."""

    def __init__(self, folder: Path) -> None:
        self.listener = Listener(folder)
        self.broadcast = Broadcast(lambda: 5.0)
        self.notices: list[Notice] = []
        self.gone = 0
        self.released = asyncio.Event()
        self.end = VehicleEnd(
            self.broadcast,
            hello=lambda: HELLO,
            samples=lambda: [("ahrs", 1.0, {"roll_deg": 1.0})],
            requests={NameAircraft: self._echo, ReadPlan: self._refuse, ReadPorts: self._break, ReadHil: self._hang},
            on_notice=lambda notice: self.notices.append(notice),  # noqa: PLW0108 (a test takes the list away)
            on_gone=self._gone,
        )
        self.task = asyncio.ensure_future(self.end.run(self.listener))

    async def stop(self) -> None:
        self.task.cancel()
        await asyncio.wait([self.task])
        self.listener.close()

    def _gone(self) -> None:
        self.gone += 1

    async def _echo(self, request: NameAircraft, by: Asker) -> AircraftName:
        return AircraftName(f"{request.name} by {by.name}")

    async def _refuse(self, _: ReadPlan, __: Asker) -> Any:
        raise InvalidInputError("mission_invalid", "No.", plan="hil")

    async def _break(self, _: ReadPorts, __: Asker) -> Any:
        raise ZeroDivisionError

    async def _hang(self, _: ReadHil, __: Asker) -> HilState:
        await self.released.wait()
        return HilState()


@asynccontextmanager
async def connected(folder: Path, heard: Heard, silent_after_s: float | None = None) -> AsyncIterator[StationEnd]:
    station = StationEnd(folder, heard, silent_after_s=silent_after_s)
    task = asyncio.ensure_future(station.run())
    try:
        yield station
    finally:
        task.cancel()
        await asyncio.wait([task])


@pytest.mark.anyio
async def test_a_station_hears_how_everything_stands_and_then_what_happens(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard):
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        assert (heard.hellos, [sample.name for sample in heard.samples]) == ([HELLO], ["ahrs"])
        vehicle.broadcast.sample("gps", 2.0, {"latitude_deg": None})
        assert len(heard.samples) == 1
        vehicle.broadcast.event(FlightProcessEvent("back"))
        vehicle.broadcast.status(Status())
        await eventually_async(lambda: len(heard.statuses) == 1, "all arrives")
        assert heard.samples[1].name == "gps", "an event does not overtake the samples before it"
        assert orjson.loads(heard.events[0].text) == {
            "type": "event",
            "event": "flight",
            "t_s": 5.0,
            "data": {"state": "back"},
        }
    await eventually_async(lambda: vehicle.gone == 1, "the vehicle notices that the station went")
    await vehicle.stop()


@pytest.mark.anyio
async def test_samples_are_gathered_for_a_station_that_looks_seldom_and_none_is_lost(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        station.notice(Pace(1))
        await eventually_async(lambda: vehicle.broadcast.gathers, "the vehicle knows the pace")
        for number in range(9):
            vehicle.broadcast.sample("gps", float(number), {"n": number})
            vehicle.broadcast.flush()
        vehicle.broadcast.status(Status())
        await eventually_async(lambda: bool(heard.statuses), "the status arrives")
        assert [sample.t_s for sample in heard.samples[1:]] == [float(number) for number in range(9)]
        # One group at once, the other just before the status: neither one for each sample, nor after the status.
        assert heard.ends <= 3
        vehicle.broadcast.sample("gps", 9.0, {"n": 9})
        vehicle.broadcast.flush()
        await station.ask(NameAircraft())
        assert heard.samples[-1].t_s == 9.0, "an answer does not overtake the samples before it"
        vehicle.broadcast.sample("gps", 10.0, {"n": 10})
        vehicle.broadcast.flush()
        vehicle.broadcast.playback(a_playback())
        await eventually_async(lambda: bool(heard.playbacks), "the replay's position arrives")
        assert heard.samples[-1].t_s == 10.0, "nor does a replay's position"
        assert heard.order[-2:] == ["end of samples", "playback"], "the samples leave before it"
        vehicle.broadcast.sample("gps", 11.0, {"n": 11})
        vehicle.broadcast.flush()
        station.notice(Pace(0))
        await eventually_async(lambda: heard.samples[-1].t_s == 11.0, "what was gathered is sent when the pace changes")
        assert not vehicle.broadcast.gathers
    await vehicle.stop()


@pytest.mark.anyio
async def test_frames_wait_for_the_samples_that_leave_next_and_nothing_overtakes_them(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    decoded: list[float] = []

    def decode() -> None:
        decoded.append(float(len(decoded)))
        vehicle.broadcast.sample("gps", decoded[-1], {"n": 0})
        vehicle.broadcast.flush()

    assert vehicle.broadcast.later(decode), "without a station they wait for whoever looks"
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        assert not vehicle.broadcast.later(decode), "each is wanted at once"
        station.notice(Pace(1))
        await eventually_async(lambda: vehicle.broadcast.gathers, "the vehicle knows the pace")
        assert not vehicle.broadcast.later(decode), "it is time for samples"
        decode()
        assert vehicle.broadcast.later(decode)
        assert vehicle.broadcast.later(decode)
        assert decoded == [0.0]
        vehicle.broadcast.status(Status())
        await eventually_async(lambda: bool(heard.statuses), "the status arrives")
        assert [sample.t_s for sample in heard.samples[1:]] == [0.0, 1.0]
        assert vehicle.broadcast.later(decode)
        await eventually_async(lambda: decoded == [0.0, 1.0, 2.0], "they are decoded when their time has come")
        await eventually_async(lambda: heard.samples[-1].t_s == 2.0, "and leave")
    await vehicle.stop()


@pytest.mark.anyio
async def test_one_station_that_wants_each_sample_at_once_is_enough(tmp_path: Path) -> None:
    vehicle, seldom, always = Vehicle(tmp_path), Heard(), Heard()
    async with connected(tmp_path, seldom) as station:
        await eventually_async(lambda: seldom.ends == 1, "it is connected")
        station.notice(Pace(1))
        await eventually_async(lambda: vehicle.broadcast.gathers, "its pace is known")
        async with connected(tmp_path, always):
            await eventually_async(lambda: always.ends == 1, "the other is connected")
            assert not vehicle.broadcast.gathers
        await eventually_async(lambda: vehicle.broadcast.gathers, "the other has gone")
    assert vehicle.notices == [], "the pace is the stream's own matter"
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_request_brings_the_result_or_the_very_error(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        assert await station.ask(NameAircraft("3"), Asker("c1", "tablet")) == AircraftName("3 by tablet")
        with pytest.raises(InvalidInputError) as refused:
            await station.ask(ReadPlan("hil"))
        assert (refused.value.code, refused.value.params) == ("mission_invalid", {"plan": "hil"})
        for request in (ReadPorts(), LoadParameters()):
            with pytest.raises(GatewayError) as failed:
                await station.ask(request)
            assert failed.value.code == "internal"
        station.notice(StickRelease("c1"))
        await eventually_async(lambda: vehicle.notices == [StickRelease("c1")], "the notice arrives")
    await vehicle.stop()


@pytest.mark.anyio
async def test_an_answer_for_which_nobody_waits_any_more_is_ignored(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    faults: list[dict[str, Any]] = []
    asyncio.get_running_loop().set_exception_handler(lambda _, context: faults.append(context))
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        asked = asyncio.ensure_future(station.ask(ReadHil()))
        assert await station.ask(NameAircraft()) == AircraftName("None by None"), "the other is asked too"
        asked.cancel()
        await asyncio.wait([asked])
        vehicle.released.set()
        assert await station.ask(NameAircraft("2")) == AircraftName("2 by None")
        assert await station.ask(NameAircraft("3")) == AircraftName("3 by None")
    assert faults == []
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_vehicle_that_goes_ends_every_request_and_is_found_again(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        hanging = asyncio.ensure_future(station.ask(ReadHil()))
        await asyncio.sleep(0)
        await vehicle.stop()
        with pytest.raises(ConflictError) as away:
            await hanging
        assert away.value.code == "flight_away"
        assert heard.losses == [True], "it said goodbye"
        with pytest.raises(ConflictError):
            await station.ask(NameAircraft())
        again = Vehicle(tmp_path)
        await eventually_async(lambda: len(heard.hellos) == 2, "it is found again")
        assert await station.ask(NameAircraft()) == AircraftName("None by None")
    await again.stop()


def let_pass(station: StationEnd, from_s: float, to_s: float) -> None:
    """Looks ten times a second, at times after now."""
    now_s = asyncio.get_running_loop().time()
    for tenths in range(round(10 * from_s), round(10 * to_s)):
        station.look(now_s + 0.1 * tenths)


@pytest.mark.anyio
async def test_a_vehicle_that_hangs_is_noticed_and_whoever_waits_for_it_is_told_until_it_is_heard_again(
    tmp_path: Path,
) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard, silent_after_s=1000.0) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        waiting = asyncio.ensure_future(station.ask(ReadHil()))
        await asyncio.sleep(0)
        let_pass(station, 0.0, 990.0)
        assert heard.silences == []
        let_pass(station, 990.0, 1002.0)
        assert heard.silences == [True]
        let_pass(station, 1002.0, 4010.0)
        for asked in (waiting, station.ask(NameAircraft())):
            with pytest.raises(UnavailableError):
                await asked
        vehicle.broadcast.event(FlightProcessEvent("back"))
        await eventually_async(lambda: len(heard.events) == 1, "it is heard")
        assert heard.silences == [True, False]
        assert await station.ask(NameAircraft()) == AircraftName("None by None")
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_short_silence_fails_nothing_that_was_asked_and_no_read_but_takes_no_new_order(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard, silent_after_s=1000.0) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        waiting = asyncio.ensure_future(station.ask(ReadHil(), Asker("c1", "Ana")))
        await asyncio.sleep(0)
        let_pass(station, 0.0, 1002.0)
        assert heard.silences == [True]
        with pytest.raises(UnavailableError):
            await station.ask(NameAircraft(), Asker("c1", "Ana"))
        assert not waiting.done()
        assert await station.ask(NameAircraft()) == AircraftName("None by None")
        vehicle.released.set()
        await waiting
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_stall_of_this_process_is_no_silence_of_the_vehicle(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard, silent_after_s=1000.0) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        station.look(asyncio.get_running_loop().time() + 2000.0)
        assert heard.silences == []
        assert await station.ask(NameAircraft()) == AircraftName("None by None")
    await vehicle.stop()


@pytest.mark.anyio
async def test_whoever_does_not_speak_the_stream_is_let_go_and_harms_nobody(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        stranger = await connect(tmp_path)
        loop = asyncio.get_running_loop()
        await loop.sock_sendall(stranger, b"GET / HTTP/1.1\r\n\r\n" * 10)
        while await loop.sock_recv(stranger, 65536):
            pass
        stranger.close()
        assert await station.ask(NameAircraft("1")) == AircraftName("1 by None")
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_listener_that_does_not_read_is_let_go_and_costs_bounded_memory(tmp_path: Path) -> None:
    vehicle = Vehicle(tmp_path)
    stopped = await connect(tmp_path)
    await eventually_async(lambda: vehicle.broadcast.has_listeners, "it is there")
    for _ in range(3000):
        vehicle.broadcast.event(ConsoleEvent("received", "x" * 10_000))
        await asyncio.sleep(0)
    assert not vehicle.broadcast.has_listeners
    assert vehicle.gone == 1, "a stick that came through it must be let go"
    stopped.close()
    await vehicle.stop()


def test_only_the_owner_may_open_the_socket(tmp_path: Path) -> None:
    listener = Listener(tmp_path)
    where = orjson.loads((tmp_path / FILE).read_bytes())
    assert stat.S_IMODE(Path(where["unix"]).stat().st_mode) == 0o600
    assert stat.S_IMODE((tmp_path / FILE).stat().st_mode) == 0o600
    listener.close()


@pytest.mark.anyio
async def test_a_data_folder_with_a_long_name_has_its_socket_elsewhere(tmp_path: Path) -> None:
    folder = tmp_path / ("long" * 30)
    vehicle, heard = Vehicle(folder), Heard()
    async with connected(folder, heard):
        await eventually_async(lambda: len(heard.hellos) == 1, "it is found")
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_vehicle_that_does_not_speak_the_stream_is_let_go_and_looked_for_again(tmp_path: Path) -> None:
    listener, heard = Listener(tmp_path), Heard()
    async with connected(tmp_path, heard):
        stranger = await listener.accept()
        assert stranger is not None
        await asyncio.get_running_loop().sock_sendall(stranger, b"\xff" * 64)
        await eventually_async(lambda: heard.losses == [False], "it is let go, and not as one that said goodbye")
        again = await listener.accept()
        assert again is not None
        stranger.close()
        again.close()
    listener.close()


@pytest.mark.anyio
async def test_samples_go_on_at_the_pace_of_the_one_who_looks(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        station.notice(Pace(50))
        await eventually_async(lambda: vehicle.broadcast.gathers, "the vehicle knows the pace")
        for number in range(5):
            vehicle.broadcast.sample("gps", float(number), {"n": number})
            vehicle.broadcast.flush()
            await eventually_async(lambda number=number: heard.samples[-1].t_s == float(number), "it follows")  # type: ignore[misc]
        assert heard.ends >= 3, "one by one, not all at the end"
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_record_of_a_kind_that_a_later_version_has_is_passed_over(tmp_path: Path) -> None:
    vehicle = Vehicle(tmp_path)
    newer = await connect(tmp_path)
    notice = orjson.dumps({"name": "StickRelease", "arguments": {"client": "c1"}})
    later_kind: Any = 99
    await asyncio.get_running_loop().sock_sendall(newer, pack(later_kind, b"") + pack(Kind.NOTICE, notice))
    await eventually_async(lambda: vehicle.notices == [StickRelease("c1")], "what follows it is heard")
    assert vehicle.gone == 0
    newer.close()
    await vehicle.stop()


@pytest.fixture
def without_local_sockets(monkeypatch: pytest.MonkeyPatch) -> None:
    """As on a system that has none: the stream goes through a port of the loopback."""
    monkeypatch.setattr("epf_gcs.bus.address.HAS_LOCAL", False)


@pytest.mark.anyio
@pytest.mark.usefixtures("without_local_sockets")
async def test_through_a_port_a_station_that_read_the_secret_in_the_folder_is_heard(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        assert await station.ask(NameAircraft("1")) == AircraftName("1 by None")
    await vehicle.stop()


@pytest.mark.anyio
@pytest.mark.usefixtures("without_local_sockets")
@pytest.mark.parametrize("cut", [0, 1, 5, -1])
async def test_through_a_port_only_the_whole_secret_opens_in_whatever_pieces_it_comes(tmp_path: Path, cut: int) -> None:
    listener, loop = Listener(tmp_path), asyncio.get_running_loop()
    where = orjson.loads((tmp_path / FILE).read_bytes())
    secret = bytes.fromhex(where["secret"])
    assert len(secret) >= 16
    for said in (b"", secret[:-1], bytes(len(secret)), secret[::-1], secret):
        with socket.socket() as caller:
            caller.setblocking(False)
            await loop.sock_connect(caller, ("127.0.0.1", where["tcp"]))
            accepted = asyncio.ensure_future(listener.accept())
            for piece in (said[:cut], said[cut:]):
                await loop.sock_sendall(caller, piece)
                await asyncio.sleep(0.001)
            caller.shutdown(socket.SHUT_WR)
            connection = await accepted
            assert (connection is not None) == (said == secret)
            if connection is not None:
                connection.close()
    listener.close()


@pytest.mark.usefixtures("without_local_sockets")
def test_two_stations_of_one_machine_have_a_port_each(tmp_path: Path) -> None:
    listeners = [Listener(tmp_path / name) for name in ("one", "other")]
    ports = [orjson.loads((tmp_path / name / FILE).read_bytes())["tcp"] for name in ("one", "other")]
    assert ports[0] != ports[1]
    assert min(ports) >= 1024, "below, only the administrator may listen"
    for listener in listeners:
        listener.close()


@pytest.mark.anyio
async def test_what_fails_on_a_record_costs_none_that_came_with_it(tmp_path: Path) -> None:
    class Failing(Heard):
        def on_sample(self, sample: NamedText) -> None:
            super().on_sample(sample)
            raise ZeroDivisionError

        def on_samples_end(self) -> None:
            super().on_samples_end()
            raise ZeroDivisionError

        def on_event(self, event: NamedText) -> None:
            raise ZeroDivisionError

    vehicle, heard = Vehicle(tmp_path), Failing()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        vehicle.broadcast.event(FlightProcessEvent("back"))
        for topic in ("gps", "ahrs"):
            vehicle.broadcast.sample(topic, 2.0, {})
        async with asyncio.timeout(DEADLINE_S):
            assert await station.ask(NameAircraft("1")) == AircraftName("1 by None")
        assert [sample.name for sample in heard.samples] == ["ahrs", "gps", "ahrs"]
    await vehicle.stop()


@pytest.mark.anyio
async def test_a_request_behind_a_notice_that_fails_is_answered(tmp_path: Path) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    vehicle.notices = None  # type: ignore[assignment]
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: heard.ends == 1, "the snapshot arrives")
        station.notice(StickRelease("c1"))
        async with asyncio.timeout(DEADLINE_S):
            assert await station.ask(NameAircraft("1")) == AircraftName("1 by None")
    await vehicle.stop()


@pytest.mark.anyio
async def test_more_requests_than_a_vehicle_can_have_under_way_are_refused_at_once_and_later_ones_are_answered(
    tmp_path: Path,
) -> None:
    vehicle, heard = Vehicle(tmp_path), Heard()
    async with connected(tmp_path, heard) as station:
        await eventually_async(lambda: station.is_connected, "it connects")
        hanging = [asyncio.ensure_future(station.ask(ReadHil())) for _ in range(256)]
        await asyncio.sleep(0)
        with pytest.raises(GatewayError, match="Too much") as busy:
            await station.ask(NameAircraft())
        assert busy.value.code == "internal"
        vehicle.released.set()
        assert await asyncio.gather(*hanging) == [HilState()] * 256
        assert await station.ask(NameAircraft("1")) == AircraftName("1 by None")
    await vehicle.stop()
