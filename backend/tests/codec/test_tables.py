"""The generated tables say what the deployed boards do."""

from __future__ import annotations

import struct

from epf_gcs.codec.messages_gen import (
    COMMANDS,
    COMMANDS_BY_ID,
    PARAMETERS,
    ROUTES,
    TELEMETRY,
    TELEMETRY_BY_NAME,
    XPLANE_ROWS,
)


def test_the_sizes_are_those_of_the_deployed_board() -> None:
    sizes = {message.name: message.size for message in TELEMETRY.values() if not message.extension}
    assert sizes == {
        "heartbeat": 12,
        "ahrs": 12,
        "inertial": 36,
        "analog": 40,
        "servos_in": 48,
        "fly_by_wire": 16,
        "fms_plan": 20,
        "fms_hil_plan": 20,
        "statistics": 4,
        "gps": 32,
        "hil_surfaces": 16,
        "autopilot_parameters": 68,
    }
    assert COMMANDS["xplane_info"].size + 16 == 76


def test_parameters_are_in_the_order_of_their_message_and_one_is_an_integer() -> None:
    message = TELEMETRY_BY_NAME["autopilot_parameters"]
    assert [p.name for p in PARAMETERS] == [value.name for value in message.values]
    assert [p.name for p in PARAMETERS if p.is_integer] == ["k_div_velocidad"]
    assert message.struct.format == "<ffffffiffffffffff"
    assert struct.calcsize(message.struct.format) == 68


def test_every_parameter_is_set_by_the_command_of_its_name() -> None:
    for parameter in PARAMETERS:
        command = COMMANDS_BY_ID[parameter.set_id]
        assert command.name == f"set_{parameter.name}"
        assert command.parameter == parameter.name
        assert command.confirm.by == "read_back"
        (value,) = command.values
        assert (value.minimum, value.maximum) == (parameter.minimum, parameter.maximum)
    assert sorted(p.set_id for p in PARAMETERS) == list(range(60, 77))


def test_switches_are_confirmed_by_the_heartbeat_flag_of_their_stream() -> None:
    assert COMMANDS["servos_in_on"].confirm.flags == {"servos": True}
    assert COMMANDS["autopilot_off"].confirm.flags == {"autopilot_hil": False}
    assert COMMANDS["control_source"].confirm.flags == {"source_joystick": "argument"}


def test_the_angular_rates_row_differs_between_the_profiles() -> None:
    assert [value.name for value in XPLANE_ROWS["xp10"][16].values] == ["q_rad_s", "p_rad_s", "r_rad_s"]
    assert [value.name for value in XPLANE_ROWS["xp12"][16].values] == ["p_deg_s", "q_deg_s", "r_deg_s"]
    assert XPLANE_ROWS["xp10"][17] == XPLANE_ROWS["xp12"][17]


def test_the_four_routes_have_their_waypoints() -> None:
    assert {name: len(route.waypoints) for name, route in ROUTES.items()} == {
        "gando": 8,
        "ruta_isla": 20,
        "alternativa": 11,
        "vuelo": 10,
    }
    assert [ROUTES[name].load_id for name in ("gando", "ruta_isla", "alternativa", "vuelo")] == [51, 52, 53, 54]
    last = ROUTES["ruta_isla"].waypoints[-1]
    assert (last.latitude_deg, last.longitude_deg, last.altitude_ft, last.speed_kt) == (27.9319, -15.3866, 800.0, 55.0)
