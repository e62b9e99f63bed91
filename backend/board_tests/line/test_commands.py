"""Every command of the protocol, sent to the running board."""

import pytest

from board_tests.line.others import ARGUMENTS, a_foreign_station_gets_no_extension
from board_tests.line.station import EXTENSIONS, LEVEL_FLIGHT, Station
from epf_gcs.codec.messages_gen import COMMANDS

DONE, BAD_VALUE, BAD_STATE, UNKNOWN, STORAGE_FAILED = range(5)

REFUSED_AT_FIRST = {
    # with the transmitter as control source its switches rule
    "autopilot_on": BAD_STATE, "autopilot_off": BAD_STATE, "autotrim_on": BAD_STATE, "autotrim_off": BAD_STATE,
    # no plan is loaded, no upload under way
    "fms_next_waypoint": BAD_STATE, "fms_previous_waypoint": BAD_STATE,
    "hil_fms_next_waypoint": BAD_STATE, "hil_fms_previous_waypoint": BAD_STATE,
    "mission_item": BAD_STATE, "mission_commit": BAD_STATE, "go_to_waypoint": BAD_STATE,
    # no card
    "store_parameters": STORAGE_FAILED,
}  # fmt: skip

UNANSWERED = {"do_nothing", "xplane_info"}


def test_every_command_is_acknowledged_with_what_became_of_it(extended: Station) -> None:
    last = ("reset", "exit_binary_mode")
    results = {
        name: extended.ask(name, *ARGUMENTS.get(name, ())) for name in COMMANDS if name not in UNANSWERED | set(last)
    }
    # Some commands before have changed the state that others need; those are tested one by one below.
    expected = dict.fromkeys(results, DONE) | REFUSED_AT_FIRST
    loaded = {"hil_load_gando", "hil_load_ruta_isla", "hil_load_alternativa", "hil_load_vuelo", "mission_begin"}
    changed = loaded | {"mission_item", "mission_commit", "go_to_waypoint"}
    assert {name: result for name, result in results.items() if name not in changed} == {
        name: result for name, result in expected.items() if name not in changed
    }
    assert {results[name] for name in loaded} == {DONE}
    assert extended.ask("exit_binary_mode") == DONE


@pytest.mark.parametrize("name", sorted(REFUSED_AT_FIRST))
def test_a_command_that_is_not_possible_yet_says_why(extended: Station, name: str) -> None:
    assert extended.ask(name, *ARGUMENTS.get(name, ())) == REFUSED_AT_FIRST[name]


def test_do_nothing_and_simulator_information_are_never_acknowledged(extended: Station) -> None:
    extended.command("do_nothing")
    extended.command("xplane_info", *LEVEL_FLIGHT)
    extended.next("hil_surfaces")
    extended.command("do_nothing")
    assert extended.ask("ahrs_off") == DONE
    assert extended.count("acknowledgement") == 1


def test_a_command_that_nobody_knows_is_answered_so(extended: Station) -> None:
    unknown = bytes.fromhex("2351542c2c000000d4ffffff0d0a0d0a")  # 44, unused by deployed boards
    assert extended.ask_bytes(44, unknown) == UNKNOWN


def test_a_value_out_of_range_is_refused_and_changes_nothing(extended: Station) -> None:
    assert extended.ask("control_source", 1) == DONE
    bad = extended.raw_command("control_source", (2).to_bytes(4, "little"))
    assert extended.ask_bytes(COMMANDS["control_source"].id, bad) == BAD_VALUE
    assert extended.heartbeat()["autopilot_hil"] == 2  # still the joystick
    for servo, position in ((20, 0.0), (-1, 0.0), (3, 1.5), (3, float("nan"))):
        payload = COMMANDS["servo_out"].struct.pack(servo, position)
        assert extended.ask_bytes(COMMANDS["servo_out"].id, extended.raw_command("servo_out", payload)) == BAD_VALUE
    extended.command("exit_binary_mode")
    assert any("3: 0" in line for line in extended.lines("servos"))


def test_autopilot_autotrim_and_source_show_in_the_heartbeat(binary: Station) -> None:
    binary.command("control_source", 1)
    binary.command("autopilot_on")
    binary.command("autotrim_on")
    flags = binary.heartbeat()
    assert (flags["autopilot_hil"], flags["autotrim_hil"]) == (3, 1)
    # The real aircraft's are those of the transmitter's switches.
    assert (flags["autopilot"], flags["autotrim"], flags["auto_switch"]) == (0, 0, 0)
    binary.command("autopilot_off")
    binary.command("autotrim_off")
    flags = binary.heartbeat()
    assert (flags["autopilot_hil"], flags["autotrim_hil"]) == (2, 0)
    binary.command("control_source", 0)
    assert binary.heartbeat()["autopilot_hil"] == 0


def test_servo_positions_and_mode_are_kept(binary: Station) -> None:
    binary.command("servos_control_mode_hil")
    for servo in range(20):
        binary.command("servo_out", servo, -1.0 + servo / 10.0)
    binary.command("exit_binary_mode")
    shown = " ".join(binary.lines("servos"))
    assert "follow hil" in shown
    for servo in range(20):
        assert f"{servo}: {round(-1.0 + servo / 10.0, 3):g}" in shown


def test_waypoints_go_on_and_back(extended: Station) -> None:
    extended.command("xplane_info", *LEVEL_FLIGHT)
    extended.ask("hil_load_gando")
    extended.ask("fms_hil_plan_on")
    for command, waypoint in (("hil_fms_next_waypoint", 1), ("hil_fms_next_waypoint", 2),
                              ("hil_fms_previous_waypoint", 1)):  # fmt: skip
        assert extended.ask(command) == DONE
        extended.next("fms_hil_plan")
        assert extended.next("fms_hil_plan").values[4] == waypoint


def test_the_board_status_comes_once_capabilities_were_asked_for(extended: Station) -> None:
    extended.ask("hil_load_vuelo")
    extended.ask("select_airspeed_source", 0)
    extended.ask("servos_control_mode_hil")
    extended.send(b"#QT,\xff\xff\xff\x0frubbish")
    status = extended.next("board_status").values
    assert status[:4] == (0, 1, 1, 3)
    assert status[4] >= 4  # frames received
    extended.wait(lambda: extended.next("board_status").values[5] >= 1)  # frames rejected


def test_the_capabilities_name_the_firmware(binary: Station) -> None:
    version, features, name, number, uptime_ms = binary.extend().values
    assert version == 1
    assert features == 1 + 4 + 8 + 32 + 64  # no card: nothing can be stored
    assert (name.rstrip(b"\0"), number.rstrip(b"\0")) == (b"epf-board", b"1.0.0")
    assert uptime_ms > 0


def test_a_station_that_opens_the_line_anew_is_not_sent_extensions(extended: Station) -> None:
    extended.next("board_status")
    extended.open_binary()
    extended.command("gps_on")
    extended.next("gps")
    extended.heartbeats(60)  # more than a second, in which a board status would come
    assert extended.names() & EXTENSIONS == set()


def test_a_foreign_station_gets_what_a_deployed_board_gives_and_nothing_else(binary: Station) -> None:
    a_foreign_station_gets_no_extension(binary)
