"""The aircraft's state as X-Plane's ten rows. The place of each value comes from the protocol's table."""

import math
from collections.abc import Mapping

from epf_gcs.codec.messages_gen import NO_VALUE, VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.simulator.state import Controls, FlightState
from epf_gcs.xplane.datagram import Eight, Record


class RowWriter:
    """Writes the rows of one profile (xp10: X-Plane 10 and 11; xp12: X-Plane 12)."""

    def __init__(self, profile: str) -> None:
        self._rows = tuple(
            (row.id, tuple((value.index, value.name) for value in row.values)) for row in XPLANE_ROWS[profile].values()
        )

    def rows(self, state: FlightState, stick: Controls) -> list[Record]:
        """Every row of this instant; `stick` is the position of the pilot's own stick and throttle lever."""
        quantities = _quantities(state, stick)
        return [Record(number, _row(places, quantities)) for number, places in self._rows]


def _row(places: tuple[tuple[int, str], ...], quantities: Mapping[str, float]) -> Eight:
    values = [NO_VALUE] * VALUES_PER_ROW
    for index, name in places:
        values[index] = quantities[name]
    return tuple(values)


def _quantities(state: FlightState, stick: Controls) -> dict[str, float]:
    return {
        "indicated_airspeed_kt": state.airspeed_indicated_kt,
        "ground_speed_kt": state.speed_ground_kt,
        "mach": state.mach,
        "vvi_ft_min": state.vvi_ft_min,
        "g_normal": state.load_normal_g,
        "g_axial": state.load_axial_g,
        "g_side": state.load_side_g,
        "ambient_pressure_inhg": state.pressure_inhg,
        "ambient_temperature_degc": state.temperature_degc,
        "stick_elevator": stick.elevator,
        "stick_aileron": stick.aileron,
        "stick_rudder": stick.rudder,
        "surface_elevator": state.surfaces.elevator,
        "surface_aileron": state.surfaces.aileron,
        "surface_rudder": state.surfaces.rudder,
        "p_rad_s": state.p_rad_s,
        "q_rad_s": state.q_rad_s,
        "r_rad_s": state.r_rad_s,
        "p_deg_s": math.degrees(state.p_rad_s),
        "q_deg_s": math.degrees(state.q_rad_s),
        "r_deg_s": math.degrees(state.r_rad_s),
        "pitch_deg": state.pitch_deg,
        "roll_deg": state.roll_deg,
        "true_heading_deg": state.heading_deg,
        "alpha_deg": state.alpha_deg,
        "beta_deg": state.beta_deg,
        "horizontal_path_deg": state.track_deg,
        "vertical_path_deg": state.path_deg,
        "latitude_deg": state.latitude_deg,
        "longitude_deg": state.longitude_deg,
        "altitude_msl_ft": state.altitude_ft,
        "altitude_indicated_ft": state.altitude_indicated_ft,
        "throttle_command": stick.throttle,
    }
