"""The aircraft that the simulator can fly, with the data that their JSBSim files do not hold."""

from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Final

AIRCRAFT_DIRECTORY: Final = Path(__file__).parent / "aircraft"


@dataclass(frozen=True, slots=True)
class TrimGains:
    """Gains of the pilot who flies the copy that finds the trimmed state (`trim.py`).

    Surfaces are -1..1 in X-Plane's signs, angles rad, rates rad/s, speeds ft/s, times s.
    """

    pitch_per_climb: float  # rad of pitch wanted per ft/s of climb error
    climb_integral_s: float  # integral time: a steady climb error's part of the wanted pitch doubles in it
    elevator_per_pitch: float
    elevator_per_rate: float
    elevator_integral_s: float
    aileron_per_roll: float
    aileron_per_rate: float
    aileron_integral_s: float
    throttle_per_speed: float
    throttle_integral_s: float


@dataclass(frozen=True, slots=True)
class AircraftModel:
    """An aircraft: its JSBSim model and the figures of its flight."""

    name: str
    directory: Path | None  # parent of the model's folder; None: the aircraft of the jsbsim package
    cruise_kt: float  # indicated airspeed of a start in the air
    approach_kt: float  # indicated airspeed of a start on final
    wheels_height_ft: float  # of the centre of gravity over the ground with the wheels just touching
    engine_settle_s: float  # time the engine takes to its steady speed
    surface_positions: tuple[str, str, str]  # JSBSim's elevator, aileron and rudder, -1..1
    crash_contacts: MappingProxyType[int, str]  # JSBSim contact number -> the part that must not touch
    trim_gains: TrimGains
    # JSBSim's numbers of two weights that weigh nothing until they are used: one changes the mass, and both the centre
    # of gravity; None: the model has none.
    weights: tuple[int, int] | None = None


AIRCRAFT: Final = MappingProxyType(
    {
        model.name: model
        for model in (
            # 12 kg, 3 m span, electric: the airframe made for this simulator.
            AircraftModel(
                name="rc",
                directory=AIRCRAFT_DIRECTORY,
                cruise_kt=55.0,
                approach_kt=45.0,
                wheels_height_ft=1.0,
                engine_settle_s=2.0,
                surface_positions=("fcs/elevator-servo", "fcs/aileron-servo", "fcs/rudder-servo"),
                crash_contacts=MappingProxyType({4: "left tip", 5: "right tip", 6: "nose"}),
                trim_gains=TrimGains(
                    pitch_per_climb=0.006,
                    climb_integral_s=3.0,
                    elevator_per_pitch=1.0,
                    elevator_per_rate=0.3,
                    elevator_integral_s=1.5,
                    aileron_per_roll=0.5,
                    aileron_per_rate=0.1,
                    aileron_integral_s=3.0,
                    throttle_per_speed=0.02,
                    throttle_integral_s=3.0,
                ),
                weights=(0, 1),
            ),
            AircraftModel(
                name="c172p",
                directory=None,
                cruise_kt=95.0,
                approach_kt=70.0,
                wheels_height_ft=4.8,
                engine_settle_s=10.0,
                surface_positions=("fcs/elevator-pos-norm", "fcs/left-aileron-pos-norm", "fcs/rudder-pos-norm"),
                crash_contacts=MappingProxyType({3: "nose", 5: "left tip", 6: "right tip"}),
                trim_gains=TrimGains(
                    pitch_per_climb=0.003,
                    climb_integral_s=3.0,
                    elevator_per_pitch=1.5,
                    elevator_per_rate=0.8,
                    elevator_integral_s=2.0,
                    aileron_per_roll=0.5,
                    aileron_per_rate=0.3,
                    aileron_integral_s=4.0,
                    throttle_per_speed=0.03,
                    throttle_integral_s=8.0,
                ),
            ),
        )
    }
)
