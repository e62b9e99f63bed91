"""The flying aircraft: a JSBSim model, commanded and read in X-Plane's signs and units.

JSBSim's pitfalls are handled here: geodetic latitude, the order of the start (run_ic,
engines, throttle), the engine that has to spin up before the first instant, opposite signs of
elevator and rudder, and angles of attack that are noise when the aircraft stands.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from epf_gcs.extras import SIM
from epf_gcs.simulator.models import AircraftModel
from epf_gcs.simulator.situation import AIRPORT_ELEVATION_FT, FT_S_PER_KT, Loading, Situation, Start, Turbulence, Wind
from epf_gcs.simulator.state import Controls, FlightState
from epf_gcs.units import FT_MIN_PER_FT_S

if TYPE_CHECKING:
    from jsbsim import FGFDMExec, FGPropertyNode

STEP_HZ: Final = 200
STEP_S: Final = 1.0 / STEP_HZ

# Below this true airspeed the angles of attack and side-slip are noise, and below this ground speed the track is.
_ANGLES_FROM_KT: Final = 5.0
_TRACK_FROM_KT: Final = 2.0

_BRAKE: Final = 0.3
_BRAKE_BELOW_THROTTLE: Final = 0.05

_EARTH_DEG_PER_S: Final = math.degrees(7.292115e-5)
_INHG_PER_PSF: Final = 1.0 / 70.7262
_FREEZING_RANKINE: Final = 491.67

# MIL-F-8785C: wind at 20 ft [ft/s] and the index of the probability of exceedance for JSBSim's model.
_TURBULENCE: Final = {
    Turbulence.LIGHT: (15.0 * FT_S_PER_KT, 3.0),
    Turbulence.MODERATE: (30.0 * FT_S_PER_KT, 4.0),
    Turbulence.SEVERE: (45.0 * FT_S_PER_KT, 6.0),
}
_MILSPEC: Final = 3.0

# The weight that moves the centre of gravity, as a share of the aircraft's. A lighter one would need a longer arm, by
# which the aircraft would turn more slowly.
_PAIR: Final = 0.1
_M_PER_IN: Final = 0.0254

_INTEGRATORS: Final = (
    "simulation/integrator/rate/rotational",
    "simulation/integrator/rate/translational",
    "simulation/integrator/position/rotational",
    "simulation/integrator/position/translational",
)

_COMMANDED: Final = (
    "fcs/elevator-cmd-norm",
    "fcs/aileron-cmd-norm",
    "fcs/rudder-cmd-norm",
    "fcs/throttle-cmd-norm",
    "fcs/left-brake-cmd-norm",
    "fcs/right-brake-cmd-norm",
)

_READ: Final = {
    "latitude_deg": "position/lat-geod-deg",
    "longitude_deg": "position/long-gc-deg",
    "altitude_ft": "position/h-sl-ft",
    "agl_ft": "position/h-agl-ft",
    "indicated_ft": "atmosphere/pressure-altitude",
    "roll_rad": "attitude/phi-rad",
    "pitch_rad": "attitude/theta-rad",
    "heading_rad": "attitude/psi-rad",
    "p": "velocities/p-rad_sec",
    "q": "velocities/q-rad_sec",
    "r": "velocities/r-rad_sec",
    "cas_kt": "velocities/vc-kts",
    "tas_ft_s": "velocities/vt-fps",
    "north_ft_s": "velocities/v-north-fps",
    "east_ft_s": "velocities/v-east-fps",
    "down_ft_s": "velocities/v-down-fps",
    "mach": "velocities/mach",
    "load_x": "accelerations/n-pilot-x-norm",
    "load_y": "accelerations/n-pilot-y-norm",
    "load_z": "accelerations/n-pilot-z-norm",
    "alpha_deg": "aero/alpha-deg",
    "beta_deg": "aero/beta-deg",
    "pressure_psf": "atmosphere/P-psf",
    "temperature_r": "atmosphere/T-R",
    "wheels": "gear/wow",
    "throttle": "fcs/throttle-pos-norm",
}


class AirframeError(Exception):
    """The flight model cannot be loaded, started or continued."""


@dataclass(frozen=True, slots=True)
class Motion:
    """Height above sea level, attitude and speed of the first instant.

    The body velocities u (forward), v (right), w (down) [ft/s] are relative to the air.
    """

    altitude_ft: float
    roll_deg: float = 0.0
    pitch_deg: float = 0.0
    u_ft_s: float = 0.0
    v_ft_s: float = 0.0
    w_ft_s: float = 0.0


class Airframe:
    """One aircraft in flight; `step` advances it by 1/200 s.

    Raises AirframeError if JSBSim refuses the model or the situation.
    """

    def __init__(
        self,
        model: AircraftModel,
        situation: Situation,
        motion: Motion,
        controls: Controls,
    ) -> None:
        self._model = model
        self._fdm = _load(model)
        self._set = [self._node(path).set_double_value for path in _COMMANDED]
        self._power = situation.loading.control_power
        if situation.loading.moves_mass:
            self._load_weights(situation.loading)
        self._begin(situation, motion)
        self._spin_up(controls)
        surfaces = zip(("elevator", "aileron", "rudder"), model.surface_positions, strict=True)
        self._get = {name: self._getter(path) for name, path in (*_READ.items(), *surfaces)}
        self._contacts = {
            part: self._getter(f"contact/unit[{number}]/WOW") for number, part in model.crash_contacts.items()
        }

    def command(self, controls: Controls) -> None:
        """Move the surfaces and the throttle (through the model's own actuators)."""
        # No row carries X-Plane's toe brakes, so they are held while the throttle is closed; otherwise an idling
        # propeller would pull a parked aircraft away.
        brake = _BRAKE if controls.throttle < _BRAKE_BELOW_THROTTLE else 0.0
        # JSBSim's elevator and rudder have the opposite sign of X-Plane's, the aileron the same.
        power = self._power
        surfaces = (-controls.elevator * power, controls.aileron * power, -controls.rudder * power)
        values = (*surfaces, controls.throttle, brake, brake)
        for put, value in zip(self._set, values, strict=True):
            put(value)

    def step(self, steps: int = 1) -> None:
        """Advance by `steps` times 1/200 s; raises AirframeError if the model fails."""
        try:
            for _ in range(steps):
                self._fdm.run()
        except RuntimeError as error:
            raise AirframeError(f"the flight model broke down: {error}") from error

    def blow(self, wind: Wind, turbulence: Turbulence) -> None:
        """From now on the steady wind and the turbulence are these; a gust goes on."""
        wind_at_20_ft, self._severity = _TURBULENCE.get(turbulence, (0.0, 0.0))
        self._fdm["atmosphere/turbulence/milspec/windspeed_at_20ft_AGL-fps"] = wind_at_20_ft
        self._fdm["atmosphere/turbulence/milspec/severity"] = self._severity
        self._wind = wind
        self.gust(self._gust_kt)

    def gust(self, more_kt: float) -> None:
        """The wind blows by so much more than the steady one, from where that comes."""
        self._gust_kt = more_kt
        north, east = replace(self._wind, speed_kt=self._wind.speed_kt + more_kt).towards_ft_s()
        self._fdm["atmosphere/wind-north-fps"] = north
        self._fdm["atmosphere/wind-east-fps"] = east

    def motion(self) -> Motion:
        """Attitude and velocity through the air of this instant."""
        fdm = self._fdm
        return Motion(
            altitude_ft=fdm["position/h-sl-ft"],
            roll_deg=math.degrees(fdm["attitude/phi-rad"]),
            pitch_deg=math.degrees(fdm["attitude/theta-rad"]),
            u_ft_s=fdm["velocities/u-aero-fps"],
            v_ft_s=fdm["velocities/v-aero-fps"],
            w_ft_s=fdm["velocities/w-aero-fps"],
        )

    def state(self) -> FlightState:
        """Read this instant."""
        raw = {name: get() for name, get in self._get.items()}
        heading_deg = math.degrees(raw["heading_rad"]) % 360.0
        true_kt = raw["tas_ft_s"] / FT_S_PER_KT
        ground_ft_s = math.hypot(raw["north_ft_s"], raw["east_ft_s"])
        flying = true_kt >= _ANGLES_FROM_KT
        moving = ground_ft_s / FT_S_PER_KT >= _TRACK_FROM_KT
        return FlightState(
            latitude_deg=raw["latitude_deg"],
            longitude_deg=raw["longitude_deg"],
            altitude_ft=raw["altitude_ft"],
            altitude_agl_ft=raw["agl_ft"],
            altitude_indicated_ft=raw["indicated_ft"],
            roll_deg=math.degrees(raw["roll_rad"]),
            pitch_deg=math.degrees(raw["pitch_rad"]),
            heading_deg=heading_deg,
            p_rad_s=raw["p"],
            q_rad_s=raw["q"],
            r_rad_s=raw["r"],
            airspeed_indicated_kt=raw["cas_kt"],
            airspeed_true_kt=true_kt,
            speed_ground_kt=ground_ft_s / FT_S_PER_KT,
            mach=raw["mach"],
            vvi_ft_min=-raw["down_ft_s"] * FT_MIN_PER_FT_S,
            load_normal_g=-raw["load_z"],
            load_axial_g=raw["load_x"],
            load_side_g=raw["load_y"],
            alpha_deg=raw["alpha_deg"] if flying else 0.0,
            beta_deg=raw["beta_deg"] if flying else 0.0,
            track_deg=ground_course(raw["north_ft_s"], raw["east_ft_s"], heading_deg),
            path_deg=math.degrees(math.atan2(-raw["down_ft_s"], ground_ft_s)) if moving else 0.0,
            pressure_inhg=raw["pressure_psf"] * _INHG_PER_PSF,
            temperature_degc=(raw["temperature_r"] - _FREEZING_RANKINE) * 5.0 / 9.0,
            on_ground=raw["wheels"] > 0.0,
            touching=next((part for part, touches in self._contacts.items() if touches() > 0.0), None),
            surfaces=Controls(-raw["elevator"], raw["aileron"], -raw["rudder"], raw["throttle"]),
        )

    def reader(self, names: Sequence[str]) -> Callable[[], list[float]]:
        """Reads these quantities of `_READ` in JSBSim's own units, quicker than `state`."""
        getters = [self._get[name] for name in names]
        return lambda: [get() for get in getters]

    def touches(self) -> bool:
        """Whether a part touches the ground that must not."""
        return any(touches() > 0.0 for touches in self._contacts.values())

    def _begin(self, situation: Situation, motion: Motion) -> None:
        fdm = self._fdm
        latitude_deg, longitude_deg = situation.place()
        # ic/lat-gc-deg would be the geocentric latitude: 17.7 km off at 28 degrees north.
        fdm["ic/lat-geod-deg"] = latitude_deg
        fdm["ic/long-gc-deg"] = longitude_deg + self._model.engine_settle_s * _EARTH_DEG_PER_S
        fdm["ic/terrain-elevation-ft"] = AIRPORT_ELEVATION_FT
        fdm["ic/h-sl-ft"] = motion.altitude_ft
        fdm["ic/phi-deg"] = motion.roll_deg
        fdm["ic/theta-deg"] = motion.pitch_deg
        fdm["ic/psi-true-deg"] = situation.heading_deg
        wind_north, wind_east = situation.wind.towards_ft_s()
        north, east, down = _to_earth(motion, situation.heading_deg)
        carried = situation.start is not Start.RUNWAY
        fdm["ic/vn-fps"] = north + wind_north * carried
        fdm["ic/ve-fps"] = east + wind_east * carried
        fdm["ic/vd-fps"] = down
        fdm["simulation/randomseed"] = situation.seed
        fdm["atmosphere/turb-type"] = _MILSPEC
        wind_at_20_ft, severity = _TURBULENCE.get(situation.turbulence, (0.0, 0.0))
        fdm["atmosphere/turbulence/milspec/windspeed_at_20ft_AGL-fps"] = wind_at_20_ft
        if not fdm.run_ic():
            raise AirframeError(f"JSBSim cannot start {self._model.name} in this situation")
        self._wind = situation.wind
        self.gust(0.0)
        self._severity = severity

    def _load_weights(self, loading: Loading) -> None:
        """A weight at the centre of gravity, and a pair that weighs nothing together and moves it."""
        if self._model.weights is None:
            raise AirframeError(f"{self._model.name} has no weights by which its mass could be changed")
        fdm = self._fdm
        usual_lb = fdm["inertia/empty-weight-lbs"]
        pair_lb = _PAIR * usual_lb
        arm_in = loading.cg_aft_m * loading.mass_factor / _PAIR / _M_PER_IN
        middle, aft = self._model.weights
        fdm[f"inertia/pointmass-weight-lbs[{middle}]"] = (loading.mass_factor - 1.0) * usual_lb - pair_lb
        fdm[f"inertia/pointmass-weight-lbs[{aft}]"] = pair_lb
        fdm[f"inertia/pointmass-location-X-inches[{aft}]"] = arm_in

    def _spin_up(self, controls: Controls) -> None:
        """Run the engine to its steady speed while the aircraft stands still in mid-air.

        A propeller's speed cannot be set from outside, and without it the first second of flight has no thrust.
        Meanwhile the aircraft does not turn with the Earth, so `_begin` places it further east by what the Earth turns.
        """
        fdm = self._fdm
        fdm["propulsion/set-running"] = -1
        self.command(controls)
        usual = {name: fdm[name] for name in _INTEGRATORS}
        for name in _INTEGRATORS:
            fdm[name] = 0
        self.step(round(self._model.engine_settle_s * STEP_HZ))
        for name, value in usual.items():
            fdm[name] = value
        # Turbulence starts only now, because during the spin-up it would use up random numbers.
        fdm["atmosphere/turbulence/milspec/severity"] = self._severity

    def _getter(self, path: str) -> Callable[[], float]:
        return self._node(path).get_double_value

    def _node(self, path: str) -> FGPropertyNode:
        node = self._fdm.get_property_manager().get_node(path)
        if node is None:
            raise AirframeError(f"JSBSim's {self._model.name} has no property {path}")
        return node


def ground_course(north_ft_s: float, east_ft_s: float, heading_deg: float) -> float:
    """Track over the ground, true, 0..360; the heading of an aircraft that stands."""
    if math.hypot(north_ft_s, east_ft_s) / FT_S_PER_KT < _TRACK_FROM_KT:
        return heading_deg
    return math.degrees(math.atan2(east_ft_s, north_ft_s)) % 360.0


def _load(model: AircraftModel) -> FGFDMExec:
    if not SIM.is_here:
        raise AirframeError(SIM.sentence())
    # It prints a banner on every start unless this is set before the import.
    os.environ.setdefault("JSBSIM_DEBUG", "0")
    import jsbsim  # noqa: PLC0415 - an extra: there is no wheel of it for every processor

    fdm = jsbsim.FGFDMExec(None)
    fdm.set_debug_level(0)
    fdm.set_dt(STEP_S)
    if model.directory is not None:
        fdm.set_aircraft_path(str(model.directory))
    try:
        loaded = fdm.load_model(model.name)
    except RuntimeError as error:
        raise AirframeError(f"JSBSim cannot load the aircraft {model.name}: {error}") from error
    if not loaded:
        raise AirframeError(f"JSBSim cannot load the aircraft {model.name}")
    return fdm


def _to_earth(motion: Motion, heading_deg: float) -> tuple[float, float, float]:
    """Turn the body velocity into north, east and down [ft/s]."""
    roll, pitch, yaw = (math.radians(a) for a in (motion.roll_deg, motion.pitch_deg, heading_deg))
    u, v, w = motion.u_ft_s, motion.v_ft_s, motion.w_ft_s
    level_v = v * math.cos(roll) - w * math.sin(roll)
    level_w = v * math.sin(roll) + w * math.cos(roll)
    ahead = u * math.cos(pitch) + level_w * math.sin(pitch)
    down = -u * math.sin(pitch) + level_w * math.cos(pitch)
    north = ahead * math.cos(yaw) - level_v * math.sin(yaw)
    east = ahead * math.sin(yaw) + level_v * math.cos(yaw)
    return north, east, down
