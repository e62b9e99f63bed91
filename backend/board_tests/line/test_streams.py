"""What binary mode sends by itself, and how often."""

import pytest

from board_tests.line.station import HEARTBEAT, Station
from epf_gcs.codec.messages_gen import COMMANDS
from tests.support.waiting import eventually

SWITCHED = {
    "ahrs": "ahrs",
    "inertial": "inertial",
    "analog": "analog",
    "statistics": "statistics",
    "gps": "gps",
    "servos_in": "servos",
    "fly_by_wire": "fly_by_wire",
    "fms_plan": None,
    "fms_hil_plan": None,
}
"""Every stream that a command switches, and its flag in the heartbeat where it has one."""


def falls_silent(board: Station) -> None:
    """Six heartbeats come with nothing between; a busy board may read the command after some."""

    def is_silent() -> bool:
        board.heartbeats(6)
        return board.names() == {"heartbeat"}

    eventually(is_silent, "only the heartbeat is sent")


def test_after_opening_only_the_heartbeat_is_sent(text: Station) -> None:
    text.open_binary()
    text.heartbeats(6)
    assert text.names() == {"heartbeat"}
    assert bytes(text.received[:8]) == b"\rQT,\0\0\0\x80"


@pytest.mark.parametrize("stream", SWITCHED)
def test_a_stream_is_switched_on_and_off_and_the_heartbeat_says_so(binary: Station, stream: str) -> None:
    flag = SWITCHED[stream]
    binary.command(f"{stream}_on")
    binary.next(stream)
    flags = binary.heartbeat()
    assert {name for name in HEARTBEAT if flags[name]} == ({flag} if flag else set())
    binary.command(f"{stream}_off")
    falls_silent(binary)


def test_start_switches_every_stream_on_and_stop_off(binary: Station) -> None:
    binary.command("start")
    binary.wait(lambda: binary.names() >= set(SWITCHED))
    binary.command("stop")
    falls_silent(binary)


def test_read_all_sends_every_stream_once_and_leaves_them_off(binary: Station) -> None:
    binary.frames.clear()
    binary.command("read_all")
    binary.wait(lambda: binary.names() >= set(SWITCHED))
    binary.wait(lambda: binary.count("heartbeat") >= 6)
    assert {stream: binary.count(stream) for stream in SWITCHED} == dict.fromkeys(SWITCHED, 1)


def test_streams_come_at_the_rate_of_their_task(text: Station) -> None:
    # 20 ms against 100 ms against 100 ms, at first.
    text.open_binary()
    text.command("start")
    text.wait(lambda: text.names() >= set(SWITCHED))
    text.heartbeats(20)
    for of_parameter_task in ("ahrs", "inertial", "analog"):
        assert abs(text.count(of_parameter_task) - 20) <= 1
    for of_fms_task in ("fms_plan", "fms_hil_plan", "statistics", "gps"):
        assert 14 <= text.count(of_fms_task) <= 26
    assert 60 <= text.count("servos_in") <= 140
    assert abs(text.count("servos_in") - text.count("fly_by_wire")) <= 1


def test_the_station_sets_the_rate_of_each_task(binary: Station) -> None:
    binary.command("start")
    binary.command("set_parameter_task_rate", 20)
    binary.command("set_fms_task_rate", 200)
    binary.command("set_servos_task_rate", 100)
    binary.heartbeats(10)
    binary.heartbeats(100)
    assert 5 <= binary.count("fms_plan") <= 15
    assert 14 <= binary.count("servos_in") <= 26


def test_a_new_rate_does_not_wait_for_the_end_of_a_long_period(binary: Station) -> None:
    binary.command("set_parameter_task_rate", 10000)
    binary.command("set_servos_task_rate", 100)
    binary.command("servos_in_on")
    binary.next("servos_in")
    binary.frames.clear()
    binary.wait(lambda: binary.count("servos_in") >= 3)
    binary.frames.clear()
    binary.wait(lambda: binary.count("servos_in") >= 3)
    assert binary.count("heartbeat") == 0  # its long period has begun
    binary.command("set_parameter_task_rate", 20)
    # With the old period ten seconds would pass: a hundred of the frames that come every 100 ms.
    binary.wait(lambda: binary.count("heartbeat") >= 2)
    assert binary.count("servos_in") < 50


def test_rates_outside_of_their_range_change_nothing(extended: Station) -> None:
    for name, low, high in (("set_parameter_task_rate", 19, 10001), ("set_fms_task_rate", 49, 10001),
                            ("set_servos_task_rate", 19, 10001)):  # fmt: skip
        for period_ms in (low, high, 0, -1):
            payload = period_ms.to_bytes(4, "little", signed=True)
            assert extended.ask_bytes(COMMANDS[name].id, extended.raw_command(name, payload)) == 1
    extended.command("servos_in_on")
    extended.heartbeats(50)
    assert 30 <= extended.count("servos_in") <= 70


def test_statistics_are_loads_of_a_board_at_work(binary: Station) -> None:
    binary.command("statistics_on")
    # The first second is still being measured.
    sensor_dsc, control_dsc = binary.wait(lambda: next((frame.values for frame in binary.frames if frame.message.name
                                                        == "statistics" and all(frame.values)), None))  # fmt: skip
    assert 1 <= sensor_dsc <= 100
    assert 1 <= control_dsc <= 100


def test_leaving_binary_mode_silences_the_board(binary: Station) -> None:
    binary.command("start")
    binary.wait(lambda: binary.names() >= set(SWITCHED))
    binary.command("exit_binary_mode")
    assert "uptime" in binary.table("status")
    binary.frames.clear()
    for _ in range(3):
        assert "uptime" in binary.table("status")
    assert binary.frames == []


def test_text_right_behind_the_exit_command_is_text(binary: Station) -> None:
    binary.send(binary.raw_command("exit_binary_mode", b"") + b"param k_roll\n")
    binary.wait(lambda: "k_roll" in binary.text)


def test_streams_stay_as_they_were_when_binary_mode_is_opened_again(binary: Station) -> None:
    binary.command("gps_on")
    binary.next("gps")
    binary.command("exit_binary_mode")
    assert binary.table("stream list")["gps"] == "on"
    binary.open_binary()
    binary.next("gps")


def test_a_reset_ends_binary_mode_with_everything_off(binary: Station) -> None:
    binary.command("start")
    binary.command("hil_load_gando")
    binary.wait(lambda: binary.names() >= set(SWITCHED))
    binary.command("reset")
    assert binary.table("stream list")["ahrs"] == "off"
    assert binary.table("hil")["plan"] == "none"
    binary.open_binary()
    binary.heartbeats(6)
    assert binary.names() == {"heartbeat"}
