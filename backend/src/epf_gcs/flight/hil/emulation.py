"""A link without a board: example values sent as real frames and datagrams through the whole path.

It takes no commands and answers only the request that opens a session. Its data is never recorded and never moves
a simulator: see `Board.is_emulated`.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Iterator
from typing import Final

from epf_gcs.codec.encode import encode_telemetry
from epf_gcs.codec.frame import TO_BOARD, Frame, FrameDecoder
from epf_gcs.codec.messages_gen import COMMANDS, NO_VALUE, PARAMETERS, TELEMETRY_BY_NAME, VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.earth import GRAVITY_M_S2
from epf_gcs.link.address import DEFAULT_BAUD
from epf_gcs.link.base import LinkCallbacks
from epf_gcs.repeating import Repeating
from epf_gcs.vehicle.example_flight import (
    ALPHA_DEG,
    MEAN_ALTITUDE_FT,
    SPEED_KT,
    TEMPERATURE_DEGC,
    ExampleMoment,
    moment,
)
from epf_gcs.vehicle.wanted import RATE_COMMANDS
from epf_gcs.xplane.datagram import Record, build

PROFILE: Final = "xp10"
_PARAMETER_MS, _FMS_MS, _SERVOS_MS = (int(COMMANDS[name].values[0].default or 0) for name in RATE_COMMANDS)
_STATUS_MS: Final = 1000
_PROTOCOL_VERSION: Final = 1
_NO_FEATURES: Final = 0
_HEARTBEAT_FLAGS: Final = TELEMETRY_BY_NAME["heartbeat"].size
_BATTERY_V: Final = 11.8
_SWAY_PERIOD_S: Final = 7.0

_Frames = Iterator[tuple[str, tuple[float, ...]]]


class EmulationLink:
    """Implements `Link`. `on_datagram` gets the datagrams a simulator would send. Constructed on a running loop."""

    def __init__(self, on_datagram: Callable[[bytes], object]) -> None:
        self._loop = asyncio.get_running_loop()
        self._on_datagram = on_datagram
        self._callbacks: LinkCallbacks | None = None
        self._commands = FrameDecoder(TO_BOARD)
        self._steps: Repeating | None = None
        self._started_s = 0.0
        self._last_ms = -1
        self._next_ms = 0

    @property
    def baud(self) -> int:
        """The rate of a deployed board's line, in baud."""
        return DEFAULT_BAUD

    @property
    def backlog(self) -> int:
        """Always 0: nothing is queued."""
        return 0

    def start(self, callbacks: LinkCallbacks) -> None:
        """Start sending frames and datagrams."""
        self._callbacks = callbacks
        self._started_s = self._loop.time()
        self._steps = Repeating(self._loop, "the emulated board", self._step, after_failure_s=_SERVOS_MS / 1000.0)
        self._steps.arm()

    def deliver(self) -> None:
        """Nothing waits here."""

    def write(self, data: bytes) -> bool:
        """Answer the request that opens a session; all other commands are refused before they get here."""
        for found in self._commands.feed(data):
            if isinstance(found, Frame) and found.message.name == "capabilities":
                self._loop.call_soon(self._answer_capabilities)
        return True

    def close(self) -> None:
        """Stop sending."""
        self._callbacks = None
        if self._steps is not None:
            self._steps.stop()

    def _answer_capabilities(self) -> None:
        """Send the board's identity and the default gains."""
        uptime_ms = int(1000.0 * (self._loop.time() - self._started_s))
        self._bring(
            encode_telemetry("capabilities", _PROTOCOL_VERSION, _NO_FEATURES, b"emulation", b"examples", uptime_ms),
            encode_telemetry(
                "autopilot_parameters",
                *(int(gain.default) if gain.is_integer else gain.default for gain in PARAMETERS),
            ),
        )

    def _step(self) -> float:
        """Send everything due in one period of the fastest task; returns in how many seconds the next is due."""
        t_ms = self._next_ms
        now = moment(t_ms / 1000.0)
        due = [frames for period_ms, frames in _TASKS if t_ms // period_ms != self._last_ms // period_ms]
        # After a stall of the event loop go on from now: do not send the missed periods.
        elapsed_ms = int(1000.0 * (self._loop.time() - self._started_s))
        self._last_ms, self._next_ms = t_ms, max(t_ms, elapsed_ms // _SERVOS_MS * _SERVOS_MS) + _SERVOS_MS
        self._bring(*(encode_telemetry(name, *values) for frames in due for name, values in frames(now)))
        self._on_datagram(simulator_datagram(now))
        return self._started_s + self._next_ms / 1000.0 - self._loop.time()

    def _bring(self, *frames: bytes) -> None:
        if self._callbacks is not None and frames:
            self._callbacks.on_bytes(b"".join(frames))


def simulator_datagram(now: ExampleMoment) -> bytes:
    """The rows of a simulator at this moment."""
    p_rad_s, q_rad_s, r_rad_s = now.rates_rad_s
    aileron, elevator, rudder, throttle = _controls(now)
    values = {
        "indicated_airspeed_kt": SPEED_KT,
        "ground_speed_kt": SPEED_KT,
        "mach": SPEED_KT / 661.5,
        "vvi_ft_min": now.vvi_ft_min,
        "g_normal": -now.forces_m_s2[2] / GRAVITY_M_S2,
        "g_axial": now.forces_m_s2[0] / GRAVITY_M_S2,
        "g_side": 0.0,
        "ambient_pressure_inhg": now.pressure_hpa / 33.8639,
        "ambient_temperature_degc": TEMPERATURE_DEGC,
        "stick_elevator": elevator,
        "stick_aileron": aileron,
        "stick_rudder": rudder,
        "surface_elevator": elevator,
        "surface_aileron": aileron,
        "surface_rudder": rudder,
        "q_rad_s": q_rad_s,
        "p_rad_s": p_rad_s,
        "r_rad_s": r_rad_s,
        "pitch_deg": now.pitch_deg,
        "roll_deg": now.roll_deg,
        "true_heading_deg": now.heading_deg,
        "alpha_deg": ALPHA_DEG,
        "beta_deg": 0.0,
        "horizontal_path_deg": now.heading_deg,
        "vertical_path_deg": now.pitch_deg - ALPHA_DEG,
        "latitude_deg": now.latitude_deg,
        "longitude_deg": now.longitude_deg,
        "altitude_msl_ft": now.altitude_ft,
        "altitude_indicated_ft": now.altitude_ft,
        "throttle_command": throttle,
    }
    records = []
    for row in XPLANE_ROWS[PROFILE].values():
        eight = [NO_VALUE] * VALUES_PER_ROW
        for wanted in row.values:
            eight[wanted.index] = values[wanted.name]
        records.append(Record(row.id, tuple(eight)))
    return build(records)


def _controls(now: ExampleMoment) -> tuple[float, float, float, float]:
    """Aileron, elevator, rudder, throttle of a pilot who holds a steady turn."""
    sway = math.sin(2.0 * math.pi * now.t_s / _SWAY_PERIOD_S)
    return 0.05 + 0.04 * sway, -0.1 - 0.03 * sway, 0.02, 0.6 + 0.05 * sway


def _parameter_task(now: ExampleMoment) -> _Frames:
    yield "heartbeat", (1,) * _HEARTBEAT_FLAGS
    yield "ahrs", (now.heading_deg, now.pitch_deg, now.roll_deg)
    yield "inertial", (*now.rates_rad_s, *now.forces_m_s2, *now.field)
    yield (
        "analog",
        (
            now.pressure_hpa,
            now.altitude_m,
            math.nan,
            now.pitot_pa,
            SPEED_KT,
            ALPHA_DEG,
            0.0,
            TEMPERATURE_DEGC,
            _BATTERY_V,
            now.vvi_ft_min,
        ),
    )


def _fms_task(now: ExampleMoment) -> _Frames:
    for name, ahead in (("fms_plan", 0), ("fms_hil_plan", 1)):
        bearing_deg, distance_m, index = now.to_waypoint(ahead)
        yield name, (bearing_deg, MEAN_ALTITUDE_FT, SPEED_KT, round(distance_m), index)
    load = round(5.0 * math.sin(2.0 * math.pi * now.t_s / _SWAY_PERIOD_S))
    yield "statistics", (35 + load, 45 - load)
    yield (
        "gps",
        (
            now.latitude_deg,
            now.longitude_deg,
            now.altitude_m,
            SPEED_KT,
            now.heading_deg,
            int.from_bytes(b"11", "big"),
            ord("3"),
            ord("A"),
        ),
    )


def _servos_task(now: ExampleMoment) -> _Frames:
    aileron, elevator, rudder, throttle = _controls(now)
    yield "servos_in", (aileron, elevator, throttle, rudder, *(0.0,) * 8)
    yield "fly_by_wire", (aileron, throttle, elevator, rudder)
    yield "hil_surfaces", (elevator, aileron, rudder, throttle)


def _status_task(_: ExampleMoment) -> _Frames:
    yield "board_status", (0, 0, 0, 0, 0, 0)


# Period and task. All frames due at once are sent in one chunk, as a serial line delivers them.
_TASKS: Final = (
    (_SERVOS_MS, _servos_task),
    (_PARAMETER_MS, _parameter_task),
    (_FMS_MS, _fms_task),
    (_STATUS_MS, _status_task),
)
