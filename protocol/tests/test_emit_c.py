"""The C that is made compiles without a warning and packs the bytes that the definition says."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from generator import emit_c
from tests.example import definition

WARNINGS = (
    "-std=c11 -Wall -Wextra -Werror -pedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wshadow -Wundef "
    "-Wcast-align -Wswitch-enum -Wmissing-prototypes -Wstrict-prototypes -fsanitize=address,undefined"
)

PROGRAM = r"""
#include "parameters_gen.h"
#include "protocol_gen.h"
#include "routes_gen.h"
#include <stdio.h>
#include <string.h>

static void show(const uint8_t* bytes, size_t size)
{
    for (size_t i = 0; i < size; i++)
    {
        printf("%02x", (unsigned)bytes[i]);
    }
    printf("\n");
}

int main(void)
{
    uint8_t payload[PROTOCOL_TELEMETRY_SIZE_MAX + 1u] = {0};
    const message_heartbeat_t heartbeat = {1, MESSAGE_HEARTBEAT_BIT_STICK, -2};
    message_heartbeat_pack(&heartbeat, payload);
    show(payload, MESSAGE_HEARTBEAT_SIZE);
    message_heartbeat_t back;
    message_heartbeat_unpack(&back, payload);
    printf("%d %d %d\n", back.armed, back.modes, back.count);

    const message_attitude_t attitude = {-12.125f, {0.5f, -1.0f}, 0x3132};
    message_attitude_pack(&attitude, payload);
    show(payload, MESSAGE_ATTITUDE_SIZE);
    message_attitude_t again;
    message_attitude_unpack(&again, payload);
    printf("%g %g %g %d\n", (double)again.roll_deg, (double)again.servo[0], (double)again.servo[1], again.digits);

    message_place_t place = {27.5, "Gando", "Gran Canaria", "Runway 03"};
    message_place_pack(&place, payload);
    show(payload, MESSAGE_PLACE_SIZE);
    memset(&place, 0, sizeof place);
    message_place_unpack(&place, payload);
    printf("%g %s %s %s\n", place.latitude_deg, place.title, place.country, place.note);

    printf("%d %d %d\n", (int)protocol_telemetry_size(0x100u), (int)protocol_command_size(1u),
           (int)protocol_command_size(7u));
    const parameter_definition_t* const time = &parameter_definitions[PARAMETER_K_TIME];
    printf("%s %u %d %g\n", time->name, (unsigned)time->set_command, time->is_integer, (double)time->default_value);
    printf("%s %zu %g %d\n", routes[ROUTE_HOME].title, routes[ROUTE_HOME].count,
           routes[ROUTE_HOME].waypoints[1].latitude_deg, routes[ROUTE_HOME].loop);
    printf("%d %x\n", COMMAND_MODE_MODE_STICK, PROTOCOL_TO_PC_HEADER);
    printf("%d %d %d %d\n", MESSAGE_HEARTBEAT_COUNT_ABSENT, COMMAND_PACE_PERIOD_MS_MINIMUM,
           COMMAND_PACE_PERIOD_MS_MAXIMUM, COMMAND_PACE_PERIOD_MS_DEFAULT);
    return 0;
}
"""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    folder: Path = tmp_path_factory.mktemp("c")
    model = definition()
    texts = {
        "protocol_gen.h": emit_c.protocol_header(model),
        "protocol_gen.c": emit_c.protocol_source(model),
        "parameters_gen.h": emit_c.parameters_header(model),
        "parameters_gen.c": emit_c.parameters_source(model),
        "routes_gen.h": emit_c.routes_header(model),
        "routes_gen.c": emit_c.routes_source(model),
        "main.c": PROGRAM,
    }
    for name, text in texts.items():
        (folder / name).write_text(text, "utf-8")
    sources = [str(folder / name) for name in texts if name.endswith(".c")]
    subprocess.run(["gcc", *WARNINGS.split(), *sources, "-o", str(folder / "example")], check=True)
    ran = subprocess.run([str(folder / "example")], capture_output=True, check=True)
    return ran.stdout.decode("ascii").splitlines()


def test_small_integers_and_flag_bits_are_packed_in_order(output: list[str]) -> None:
    assert output[:2] == ["0102feff", "1 2 -2"]


def test_floats_arrays_and_words_are_little_endian(output: list[str]) -> None:
    assert output[2:4] == ["000042c1" + "0000003f" + "000080bf" + "32310000", "-12.125 0.5 -1 12594"]


def test_doubles_and_text_are_packed(output: list[str]) -> None:
    texts = b"Gando".ljust(16, b"\0") + b"Gran Canaria".ljust(32, b"\0") + b"Runway 03".ljust(64, b"\0")
    assert output[4:6] == ["0000000000803b40" + texts.hex(), "27.5 Gando Gran Canaria Runway 03"]


def test_sizes_are_known_by_type_and_unknown_types_have_none(output: list[str]) -> None:
    assert output[6] == "120 0 -1"


def test_parameters_routes_and_constants_are_in_their_tables(output: list[str]) -> None:
    assert output[7:] == ["k_time 61 1 700", "Home 2 27.95 1", "1 2c54510d", "-1 20 900 50"]
