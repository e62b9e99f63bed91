"""The examples without a board: board and simulator tell the same flight, each task in its own period."""

from __future__ import annotations

import asyncio
from collections import Counter
from typing import Any, cast

import pytest

from epf_gcs.codec.encode import encode_command
from epf_gcs.codec.frame import FROM_BOARD, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import PARAMETERS, XPLANE_ROWS
from epf_gcs.codec.values import meaning
from epf_gcs.flight.hil.emulation import PROFILE, EmulationLink
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.vehicle.example_flight import moment
from epf_gcs.xplane.datagram import Record, parse
from epf_gcs.xplane.mapping import surfaces_from_servos_in
from tests.support.held_loop import HeldLoop

pytestmark = pytest.mark.anyio


START_S = 0.3


class Examples:
    """The link on that loop, and what came of it in each step."""

    def __init__(self) -> None:
        self.loop = HeldLoop(START_S)
        self.values: dict[str, dict[str, Any]] = {}
        self.counts: Counter[str] = Counter()
        self.chunks = 0
        self.records: list[Record] = []
        self.row: dict[str, float] = {}
        self._decoder = FrameDecoder(FROM_BOARD)
        self.link = EmulationLink(self._on_datagram)
        self.link._loop = cast(asyncio.AbstractEventLoop, self.loop)
        self.link.start(LinkCallbacks(self._on_bytes, lambda *_: None))

    def step(self, late_s: float = 0.0) -> float:
        """Let what is due happen; returns how long after the start it was due, in seconds."""
        return round(self.loop.step(late_s) - START_S, 6)

    def until(self, t_s: float) -> None:
        while self.step() < t_s:
            pass

    def _on_bytes(self, data: bytes) -> None:
        self.chunks += 1
        for found in self._decoder.feed(data):
            assert isinstance(found, Frame)
            self.counts[found.message.name] += 1
            self.values[found.message.name] = dict(meaning(found).values)

    def _on_datagram(self, data: bytes) -> None:
        definitions = XPLANE_ROWS[PROFILE]
        self.counts["datagram"] += 1
        self.records = parse(data) or []
        self.row = {
            value.name: record.values[value.index]
            for record in self.records
            for value in definitions[record.row].values
        }


async def test_each_task_sends_in_its_own_period_and_all_that_is_due_in_one_chunk() -> None:
    examples = Examples()
    assert [examples.step() for _ in range(3)] == [0.0, 0.02, 0.04]
    examples.until(1.98)
    assert examples.counts["fly_by_wire"] == examples.counts["datagram"] == examples.chunks == 100
    assert examples.counts["heartbeat"] == examples.counts["analog"] == examples.counts["gps"] == 20
    assert examples.counts["board_status"] == 2


async def test_after_a_stall_it_goes_on_from_now_in_its_rhythm() -> None:
    examples = Examples()
    assert examples.step(late_s=0.513) == 0.0
    assert examples.step() == 0.52
    assert examples.step() == 0.54
    assert examples.counts["gps"] == 2, "what a task missed is sent once"


@pytest.mark.parametrize("t_s", [0.0, 3.0, 17.5, 40.0])
async def test_simulator_and_board_tell_the_same_flight(t_s: float) -> None:
    examples = Examples()
    examples.until(t_s)
    row, board = examples.row, examples.values
    ahrs, inertial, analog, gps = (board[name] for name in ("ahrs", "inertial", "analog", "gps"))
    same = {
        "true_heading_deg": ahrs["yaw_deg"],
        "horizontal_path_deg": ahrs["yaw_deg"],
        "pitch_deg": ahrs["pitch_deg"],
        "roll_deg": ahrs["roll_deg"],
        "vertical_path_deg": ahrs["pitch_deg"] - 3.0,
        "alpha_deg": 3.0,
        "beta_deg": 0.0,
        "p_rad_s": inertial["gx_rad_s"],
        "q_rad_s": inertial["gy_rad_s"],
        "r_rad_s": inertial["gz_rad_s"],
        "g_axial": inertial["accx_m_s2"] / 9.80665,
        "g_normal": -inertial["accz_m_s2"] / 9.80665,
        "g_side": 0.0,
        "ambient_pressure_inhg": analog["baro_hpa"] / 33.8639,
        "ambient_temperature_degc": 19.0,
        "indicated_airspeed_kt": 60.0,
        "mach": 60.0 / 661.5,
        "vvi_ft_min": analog["vvi_ft_min"],
        "latitude_deg": gps["latitude_deg"],
        "longitude_deg": gps["longitude_deg"],
        "altitude_msl_ft": gps["altitude_m"] / 0.3048,
        "altitude_indicated_ft": analog["altitude_m"] / 0.3048,
    }
    assert (analog["alpha_deg"], analog["beta_deg"], analog["temperature_degc"]) == (3.0, 0.0, 19.0)
    assert (analog["battery_v"], analog["calibrated_airspeed_kt"]) == (pytest.approx(11.8), 60.0)
    assert analog["pitot_pa"] == pytest.approx(0.5 * 1.225 * (60.0 * 1852.0 / 3600.0) ** 2, rel=1e-4)
    assert (gps["speed_kt"], gps["heading_deg"]) == (60.0, ahrs["yaw_deg"])
    assert (gps["satellites"], gps["fix"], gps["valid"]) == (11, 3, True)
    assert {name: row[name] for name in same} == pytest.approx(same, rel=1e-4, abs=1e-4)
    surfaces = board["hil_surfaces"]
    for name in ("elevator", "aileron", "rudder"):
        assert row[f"stick_{name}"] == row[f"surface_{name}"] == pytest.approx(surfaces[name], abs=1e-4)
    assert row["throttle_command"] == pytest.approx(surfaces["throttle"], abs=1e-4)
    assert board["fly_by_wire"] == surfaces
    channels = list(board["servos_in"].values())
    assert surfaces_from_servos_in(channels)._asdict() == surfaces, "the receiver hears the same hand"
    assert channels[4:] == [0.0] * 8


@pytest.mark.parametrize(("t_s", "sway"), [(0.0, 0.0), (1.74, 1.0), (3.5, 0.0), (5.24, -1.0), (7.0, 0.0), (8.74, 1.0)])
async def test_the_pilots_hand_sways_once_in_seven_seconds(t_s: float, sway: float) -> None:
    examples = Examples()
    examples.until(t_s)
    hand = [examples.row[f"stick_{name}"] for name in ("aileron", "elevator", "rudder")]
    assert hand == pytest.approx([0.05 + 0.04 * sway, -0.1 - 0.03 * sway, 0.02], abs=1e-4)
    assert examples.row["throttle_command"] == pytest.approx(0.6 + 0.05 * sway, abs=1e-4)


@pytest.mark.parametrize(("t_s", "loads"), [(0.0, (35, 45)), (1.7, (40, 40)), (5.3, (30, 50)), (7.7, (38, 42))])
async def test_the_load_of_the_boards_processors_sways_too(t_s: float, loads: tuple[int, int]) -> None:
    examples = Examples()
    examples.until(t_s)
    assert tuple(examples.values["statistics"].values()) == loads


async def test_the_next_waypoints_of_both_plans_follow_each_other() -> None:
    examples = Examples()
    examples.until(10.0)
    plan, hil_plan = examples.values["fms_plan"], examples.values["fms_hil_plan"]
    assert (plan["waypoint"], hil_plan["waypoint"]) in [(0, 1), (1, 2), (2, 3), (3, 0)]
    assert (plan["altitude_ft"], plan["speed_kt"]) == (1000.0, 60.0)
    assert plan["distance_m"] != hil_plan["distance_m"]
    for ahead, one in enumerate((plan, hil_plan)):
        bearing_deg, distance_m, _ = moment(10.0).to_waypoint(ahead)
        assert one["bearing_deg"] == pytest.approx(bearing_deg, abs=1e-3)
        assert one["distance_m"] == round(distance_m)


async def test_in_the_example_all_runs_and_what_nobody_measures_is_left_empty() -> None:
    examples = Examples()
    examples.step()
    assert set(examples.values["board_status"].values()) == {0}
    flags = examples.values["heartbeat"]
    assert [name for name, is_on in flags.items() if not is_on] == ["source_joystick"]
    assert examples.values["analog"]["altitude_external_m"] is None, "nobody measures it"
    magnetic = [examples.values["inertial"][f"mag{axis}"] for axis in "xyz"]
    assert magnetic == pytest.approx(moment(0.0).field, abs=1e-6)
    told = {row.id: {value.index for value in row.values} for row in XPLANE_ROWS[PROFILE].values()}
    assert {record.row for record in examples.records} == set(told)
    for record in examples.records:
        empty = [value for index, value in enumerate(record.values) if index not in told[record.row]]
        assert set(empty) <= {-999.0}


async def test_the_link_that_is_closed_sends_nothing_more() -> None:
    examples = Examples()
    examples.step()
    before = examples.counts.copy()
    examples.link.close()
    assert not examples.loop.due
    assert examples.counts == before


async def test_it_says_who_it_is_since_when_and_the_default_gains() -> None:
    examples = Examples()
    examples.until(2.48)
    examples.loop.now_s += 0.0205
    assert examples.link.write(encode_command("ahrs_on"))
    assert "capabilities" not in examples.values
    assert examples.link.write(encode_command("capabilities"))
    examples.loop.run_until(examples.loop.now_s)
    told = examples.values["capabilities"]
    assert (told["firmware_name"], told["firmware_version"], told["uptime_ms"]) == ("emulation", "examples", 2500)
    assert told["protocol_version"] == 1
    assert not any(one for name, one in told.items() if name.startswith("has_"))
    held = examples.values["autopilot_parameters"]
    assert {gain.name: held[gain.name] for gain in PARAMETERS} == pytest.approx(
        {gain.name: gain.default for gain in PARAMETERS}
    )
    assert (examples.link.baud, examples.link.backlog) == (115200, 0)
