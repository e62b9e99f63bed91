"""A program on a running station: what it sees, what it commands, and what it is told when that is refused."""

from __future__ import annotations

import asyncio
import dataclasses
from collections.abc import AsyncIterator
from pathlib import Path
from typing import TypeVar

import pytest

from epf_gcs.access.roles import Role
from epf_gcs.client import Ahrs, ControlError, Gps, Heartbeat, Station, StationError, StationLostError, samples_gen
from epf_gcs.codec.messages_gen import ROUTES, XPLANE_ROWS
from epf_gcs.contract.events import ControlEvent, FaultEvent, ParameterEvent
from epf_gcs.contract.simulator_faults import WindState
from epf_gcs.web.stream.messages import TOPICS
from tests.support.callers import person, program, strict_gateway
from tests.support.embedded import embedded_simulator
from tests.support.fake_board import FakeBoard, own_row
from tests.support.gateway import Gateway, running_gateway
from tests.support.ports import free_udp_port
from tests.support.waiting import DEADLINE_S

GANDO = list(ROUTES["gando"].waypoints)


T = TypeVar("T")


async def first(coming: AsyncIterator[T]) -> T:
    """The first that comes."""
    return await anext(coming)


async def opened(gateway: Gateway, board: FakeBoard) -> AsyncIterator[Station]:
    """A program that has opened the board's line."""
    async with Station(gateway.base, name="logger") as station:
        await station.open_board(board.url)
        await station.until(lambda status: status.board.state == "open", DEADLINE_S)
        yield station


def test_samples_come_with_their_time_as_values_of_the_topics_type(gateway: Gateway, board: FakeBoard) -> None:
    async def watch() -> None:
        async for station in opened(gateway, board):
            await station.command("ahrs_on")
            async for sample in station.samples(Ahrs):
                assert (sample.values.roll_deg, sample.values.pitch_deg) == (-3.0, 5.0)
                break
            newest = await station.newest(Ahrs)
            assert newest is not None
            assert newest.values == sample.values
            assert not newest.stale
            assert await station.newest(Gps) is None

    asyncio.run(watch())


def test_a_command_answers_with_its_proof(gateway: Gateway, board: FakeBoard) -> None:
    async def command() -> None:
        async for station in opened(gateway, board):
            async with station.control():
                done = await station.command("autopilot_on")
                assert (done.state, done.by, done.done) == ("confirmed", "acknowledgement", True)
                board.refuse["autopilot_off"] = 2
                assert (await station.command("autopilot_off")).state == "rejected"
            async for sample in station.samples(Heartbeat):
                assert sample.values.autopilot_hil is True
                break

    asyncio.run(command())


def test_gains_and_plans_go_to_the_board_and_come_back(gateway: Gateway, board: FakeBoard) -> None:
    async def change() -> None:
        async for station in opened(gateway, board):
            assert (await station.gains())["k_pitch"].value is None
            assert (await station.load_gains())["k_pitch"].value == 2.0
            heard = asyncio.create_task(first(station.events(ParameterEvent)))
            await asyncio.sleep(0)
            changed = await station.set_gains({"k_pitch": 2.5})
            assert (changed["k_pitch"].value, changed["k_pitch"].state) == (2.5, "confirmed")
            assert set((await heard).parameters) == {"k_pitch"}
            assert (await station.undo_gains())["k_pitch"].value == board.gains["k_pitch"] == 2.0
            assert [entry.kind for entry in (await station.journal()).entries] == ["undo", "write"]
            assert await station.send_plan("hil", GANDO) == await station.plan("hil") == GANDO

    asyncio.run(change())


def test_the_boards_own_gains_come_with_their_table_and_are_written_like_the_others(
    gateway: Gateway, board: FakeBoard
) -> None:
    board.describe(own_row(0))

    async def change() -> None:
        async for station in opened(gateway, board):
            await station.load_gains()
            assert (await station.own_gains()).table.gains[0].unit == "1/rad"
            await station.set_gains({"line_k_bank": 4.0})
            held = (await station.own_gains()).values["line_k_bank"]
            assert (held.value, held.state) == (4.0, "confirmed")

    asyncio.run(change())


def test_a_refusal_is_an_error_with_its_code_and_sentence(gateway: Gateway) -> None:
    async def ask() -> None:
        async with Station(gateway.base) as station:
            with pytest.raises(StationError, match="k_pitch must be") as refused:
                await station.set_gains({"k_pitch": 1e9})
            assert refused.value.code == "parameter_out_of_range"
            assert refused.value.params["field"] == "k_pitch"

    asyncio.run(ask())


def test_control_is_never_taken_from_another(gateway: Gateway, board: FakeBoard) -> None:
    async def two() -> None:
        async for holder in opened(gateway, board):
            async with Station(gateway.base, name="second") as second:
                async with holder.control():
                    with pytest.raises(ControlError):
                        async with second.control():
                            raise AssertionError("it has control")
                    with pytest.raises(ControlError):
                        await second.command("autopilot_on")
                    assert "autopilot_on" not in board.received
                    released = asyncio.create_task(first(second.events(ControlEvent)))
                    await asyncio.sleep(0)
                assert (await released).client is None

    asyncio.run(two())


def test_a_program_that_comes_first_leaves_control_to_whoever_takes_it(gateway: Gateway) -> None:
    async def come() -> None:
        async with Station(gateway.base) as station:
            await station.until(lambda status: status.control.client is None, DEADLINE_S)
            async with station.control():
                mine = await station.until(lambda status: status.control.client is not None, DEADLINE_S)
                assert mine.control.kind == "local"

    asyncio.run(come())


def test_a_programs_key_opens_the_stream_and_a_viewers_commands_nothing(tmp_path: Path) -> None:
    async def ask(url: str, key: str) -> None:
        async with Station(url, key) as station:
            assert station.role == "viewer"
            assert station.status.board.state == "closed"
            with pytest.raises(StationError) as refused:
                await station.load_gains()
            assert refused.value.code == "role_too_low"

    async def enter(url: str, key: str | None) -> None:
        async with Station(url, key):
            raise AssertionError("it is in")

    with strict_gateway(tmp_path / "data") as gateway, person(gateway, Role.owner) as owner:
        client, key, _ = program(gateway, Role.viewer, owner)
        client.close()
        asyncio.run(ask(gateway.base, key))
        for wrong in (None, "wrong"):
            with pytest.raises(StationError) as refused:
                asyncio.run(enter(gateway.base, wrong))
            assert refused.value.code == "not_admitted"


def test_when_the_station_ends_nothing_it_said_stands_for_the_present(tmp_path: Path) -> None:
    async def watch(gateway: Gateway) -> None:
        async with Station(gateway.base) as station:
            assert station.status.board.state == "closed"
            loop = asyncio.create_task(first(station.samples(Ahrs)))
            await asyncio.sleep(0)
            gateway.server.should_exit = True
            with pytest.raises(StationLostError):
                await loop
            with pytest.raises(StationLostError):
                _ = station.status
            with pytest.raises(StationLostError):
                await station.until(lambda _: False)

    with running_gateway(tmp_path / "data") as gateway:
        asyncio.run(watch(gateway))


def test_an_address_at_which_nobody_listens_is_said() -> None:
    async def open_nothing() -> None:
        async with Station("http://127.0.0.1:9"):
            raise AssertionError("somebody is there")

    with pytest.raises(StationLostError, match=r"127\.0\.0\.1:9"):
        asyncio.run(open_nothing())


def test_every_topic_of_the_stream_has_a_type_but_the_raw_rows_and_the_ahrs_test() -> None:
    types = {kind.NAME for kind in samples_gen.Topic.__subclasses__()}
    assert types == set(TOPICS) - {"xplane_rows", "ahrs_test"}
    simulator = {field.name for field in dataclasses.fields(samples_gen.Simulator)}
    assert simulator == {value.name for row in XPLANE_ROWS["xp10"].values() for value in row.values}


def test_an_owners_program_lets_things_go_wrong_in_the_simulator_and_ends_them(gateway: Gateway) -> None:
    station_port = free_udp_port()

    async def teach(port: int) -> None:
        async with Station(gateway.base, name="instructor") as station:
            with pytest.raises(StationError, match="none is in the loop"):
                await station.begin_fault("pitot", "bias")
            await station.open_simulator(station_port, "127.0.0.1", port, "xp10")
            await station.until(lambda status: status.simulator.faults is not None, DEADLINE_S)
            heard = asyncio.create_task(first(station.events(FaultEvent)))
            await asyncio.sleep(0)
            begun = await station.begin_fault("pitot", "bias", strength=8.0, length_s=600.0)
            told = await heard
            assert (told.state, told.id, told.place, told.strength, told.unit) == (
                "begun",
                begun.id,
                "pitot",
                8.0,
                "kt",
            )
            assert (await station.set_wind(300.0, 12.0, "light")).wind == WindState(300.0, 12.0, "light")
            assert (await station.end_faults(begun.id)).faults == []
            assert (await station.end_faults()).faults == []

    with embedded_simulator(station_port) as port:
        asyncio.run(teach(port))
