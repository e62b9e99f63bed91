"""The trimmed state an aircraft starts from in the air, found by flying a copy in closed loop.

JSBSim's own trim does not converge on light propeller models, so a copy is flown for 60 simulated
seconds by a simple pilot who holds climb, airspeed and level wings, and its last state is taken.
The results are kept in `aircraft/trim.json` so that a start costs nothing: `python -m epf_gcs.simulator.trim`
writes the file, and a test compares it with a fresh computation.
"""

import json
import math
from dataclasses import asdict, dataclass, replace
from functools import cache
from typing import Final

from epf_gcs.simulator.airframe import STEP_S, Airframe, AirframeError, Motion
from epf_gcs.simulator.models import AIRCRAFT, AIRCRAFT_DIRECTORY, AircraftModel, TrimGains
from epf_gcs.simulator.situation import (
    AIR_ALTITUDE_FT,
    AIRPORT_ELEVATION_FT,
    FINAL_ALTITUDE_FT,
    FINAL_PATH_DEG,
    FT_S_PER_KT,
    Situation,
    Start,
)
from epf_gcs.simulator.state import NEUTRAL, Controls, FlightState

TRIM_FILE: Final = AIRCRAFT_DIRECTORY / "trim.json"

_FLIGHT_S: Final = 60.0
# The limits within which the last state of that flight counts as trimmed.
_STEADY_CLIMB_FT_MIN: Final = 6.0
_STEADY_SPEED_KT: Final = 0.2
_STEADY_ROLL_DEG: Final = 0.5
_STANDING_FT_S: Final = 0.1


@dataclass(frozen=True, slots=True)
class Trim:
    """A steady state: motion through the air, and the controls that keep it."""

    motion: Motion
    controls: Controls


def trimmed(model: AircraftModel, start: Start) -> Trim:
    """The trimmed state of a start, from the file."""
    entry = _stored()[model.name][start.value]
    return Trim(Motion(**entry["motion"]), Controls(**entry["controls"]))


def fly_trim(model: AircraftModel, start: Start) -> Trim:
    """Compute the trimmed state; raises AirframeError if the aircraft does not settle."""
    if start is Start.RUNWAY:
        return _stand(model)
    final = start is Start.FINAL
    speed_kt = model.approach_kt if final else model.cruise_kt
    climb_ft_s = speed_kt * FT_S_PER_KT * math.sin(math.radians(FINAL_PATH_DEG)) if final else 0.0
    altitude_ft = FINAL_ALTITUDE_FT if final else AIR_ALTITUDE_FT
    first = Motion(altitude_ft - climb_ft_s * _FLIGHT_S, u_ft_s=speed_kt * FT_S_PER_KT)
    controls = replace(NEUTRAL, throttle=0.5)
    craft = Airframe(model, Situation(), first, controls)
    pilot = _Pilot(model.trim_gains, climb_ft_s, speed_kt)
    for _ in range(round(_FLIGHT_S / STEP_S)):
        controls = pilot.hold(craft.state())
        craft.command(controls)
        craft.step()
    last = craft.state()
    if (
        abs(last.vvi_ft_min - climb_ft_s * 60.0) > _STEADY_CLIMB_FT_MIN
        or abs(last.airspeed_indicated_kt - speed_kt) > _STEADY_SPEED_KT
        or abs(last.roll_deg) > _STEADY_ROLL_DEG
    ):
        raise AirframeError(f"{model.name} does not settle at {speed_kt} kt: {last}")
    return Trim(replace(craft.motion(), altitude_ft=altitude_ft), controls)


def _stand(model: AircraftModel) -> Trim:
    """Let the aircraft settle on its landing gear, so that it starts at rest."""
    craft = Airframe(model, Situation(), Motion(AIRPORT_ELEVATION_FT + model.wheels_height_ft), NEUTRAL)
    craft.step(round(_FLIGHT_S / STEP_S))
    last = craft.motion()
    if not craft.state().on_ground or math.hypot(last.u_ft_s, last.v_ft_s) > _STANDING_FT_S:
        raise AirframeError(f"{model.name} does not stand still on the runway: {last}")
    return Trim(Motion(last.altitude_ft, last.roll_deg, last.pitch_deg), NEUTRAL)


class _Pilot:
    """Holds climb, airspeed and level wings: good enough to settle, not to follow a route."""

    def __init__(self, gains: TrimGains, climb_ft_s: float, speed_kt: float) -> None:
        self._gains = gains
        self._climb_ft_s = climb_ft_s
        self._speed_kt = speed_kt
        self._pitch_rad = 0.0
        self._elevator = 0.0
        self._aileron = 0.0
        self._throttle = 0.5

    def hold(self, state: FlightState) -> Controls:
        gains = self._gains
        climb_error = self._climb_ft_s - state.vvi_ft_min / 60.0
        self._pitch_rad += gains.pitch_per_climb * climb_error * STEP_S / gains.climb_integral_s
        wanted_rad = self._pitch_rad + gains.pitch_per_climb * climb_error

        pitch_error = wanted_rad - math.radians(state.pitch_deg)
        self._elevator += gains.elevator_per_pitch * pitch_error * STEP_S / gains.elevator_integral_s
        elevator = self._elevator + gains.elevator_per_pitch * pitch_error - gains.elevator_per_rate * state.q_rad_s

        roll_error = -math.radians(state.roll_deg)
        self._aileron += gains.aileron_per_roll * roll_error * STEP_S / gains.aileron_integral_s
        aileron = self._aileron + gains.aileron_per_roll * roll_error - gains.aileron_per_rate * state.p_rad_s

        speed_error = self._speed_kt - state.airspeed_indicated_kt
        self._throttle += gains.throttle_per_speed * speed_error * STEP_S / gains.throttle_integral_s
        throttle = self._throttle + gains.throttle_per_speed * speed_error
        return Controls(_clip(elevator, -1.0), _clip(aileron, -1.0), 0.0, _clip(throttle, 0.0))


def _clip(value: float, lowest: float) -> float:
    return min(1.0, max(lowest, value))


@cache
def _stored() -> dict[str, dict[str, dict[str, dict[str, float]]]]:
    stored: dict[str, dict[str, dict[str, dict[str, float]]]] = json.loads(TRIM_FILE.read_text("ascii"))
    return stored


def write_trim_file() -> None:
    """Compute every trimmed state and write the file."""
    entries = {
        name: {
            start.value: {"motion": _rounded(trim.motion), "controls": _rounded(trim.controls)}
            for start, trim in ((s, fly_trim(model, s)) for s in Start)
        }
        for name, model in AIRCRAFT.items()
    }
    TRIM_FILE.write_text(json.dumps(entries, indent=2) + "\n", "ascii")


def _rounded(values: Motion | Controls) -> dict[str, float]:
    return {name: round(value, 6) for name, value in asdict(values).items()}


if __name__ == "__main__":
    write_trim_file()
    print(f"wrote {TRIM_FILE}")
