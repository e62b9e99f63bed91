"""The line itself: peers that come and go, that do not read, that send rubbish; starting and stopping."""

import os
import signal
import socket
import stat
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from board_tests.line.conftest import Boards
from board_tests.line.station import LEVEL_FLIGHT, VERSION, Station
from epf_gcs.codec.encode import encode_command
from tests.support.firmware import FIRMWARE
from tests.support.waiting import DEADLINE_S

Keep = Callable[[Station], Station]
READ_ALL_BYTES = 16 * 10 + 12 + 12 + 36 + 40 + 48 + 16 + 20 + 20 + 4 + 32
"""Ten frames: heartbeat and the nine streams."""


@pytest.fixture(params=["posix", "posix-asan"], ids=["shipped", "sanitized"])
def flavour(request: pytest.FixtureRequest, built: None) -> str:
    """The board as it ships too."""
    return str(request.param)


def test_the_link_leads_to_a_terminal_that_changes_no_byte(text: Station, boards: Boards) -> None:
    assert boards.link.is_symlink()
    assert stat.S_ISCHR(boards.link.stat().st_mode)
    text.open_binary()
    # A servo number of 13 and a command 10 are carriage return and line feed: a cooked terminal would change them.
    for servo in (3, 4, 10, 13, 17, 19):
        text.command("servo_out", servo, 0.5)
    text.command("exit_binary_mode")
    shown = " ".join(text.lines("servos"))
    assert all(f"{servo}: 0.5" in shown for servo in (3, 4, 10, 13, 17, 19))


def test_nothing_is_echoed(text: Station) -> None:
    assert text.line("param k_roll").startswith("k_roll")
    assert b"param" not in text.received


def test_a_station_can_close_the_terminal_and_open_it_again(boards: Boards, stations: Keep) -> None:
    boards("--pty", str(boards.link))
    for _ in range(5):
        station = stations(Station.on_pty(boards.link))
        station.open_binary()
        station.command("gps_on")
        station.next("gps")
        station.close()


def test_the_board_keeps_its_state_over_the_gap_but_no_old_bytes(boards: Boards, stations: Keep) -> None:
    board = boards("--pty", str(boards.link))
    station = stations(Station.on_pty(boards.link))
    station.open_binary()
    station.command("servos_in_on")
    station.next("servos_in")
    connected = board.null_devices()
    for _ in range(8):
        station.write_without_reading(encode_command("read_all"))
    board.wait(lambda: station.unread() >= 8 * READ_ALL_BYTES)
    station.close()
    board.wait(lambda: board.null_devices() > connected)
    again = stations(Station.on_pty(boards.link))
    again.wait(lambda: again.count("servos_in") >= 20)
    assert again.names() == {"heartbeat", "servos_in"}


def test_tcp_serves_one_station_after_the_other(boards: Boards, stations: Keep) -> None:
    board = boards("--tcp", "0")
    first = stations(Station.on_tcp(board.tcp_port))
    first.open_binary()
    second = stations(Station.on_tcp(board.tcp_port))
    second.send(b"#QT\n")
    first.heartbeats(3)
    assert second.frames == []
    first.close()
    second.next("heartbeat")
    second.command("xplane_info", *LEVEL_FLIGHT)
    second.next("hil_surfaces")


def test_a_tcp_connection_that_breaks_is_followed_by_the_next(boards: Boards, stations: Keep) -> None:
    board = boards("--tcp", "0")
    for _ in range(5):
        link = socket.create_connection(("127.0.0.1", board.tcp_port))
        link.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\x01\0\0\0\0\0\0\0")  # reset instead of a goodbye
        link.sendall(b"#QT\n" + encode_command("start"))
        link.close()
    station = stations(Station.on_tcp(board.tcp_port))
    station.open_binary()


def test_a_board_on_a_serial_device_speaks_there(boards: Boards) -> None:
    near, far = os.openpty()
    name = os.ttyname(far)
    board = boards("--serial", name)
    station = Station(near)
    station.open_binary()
    assert board.greeting == f"epf-board: ready on serial://{name}\n"
    station.close()
    os.close(far)
    # The device is gone now; the board waits for it to come back.
    assert board.stop() == (0, "")


def test_a_serial_device_may_be_unplugged_and_plugged_in_again(boards: Boards) -> None:
    for attempt in range(3):
        near, far = os.openpty()
        boards.link.unlink(missing_ok=True)
        boards.link.symlink_to(os.ttyname(far))
        if attempt == 0:
            boards("--serial", str(boards.link))
        station = Station(near)
        station.open_binary()
        station.close()
        os.close(far)


@pytest.mark.parametrize("kind", ["pty", "tcp"])
def test_a_station_that_does_not_read_does_not_stop_the_board(boards: Boards, stations: Keep, kind: str) -> None:
    if kind == "pty":
        boards("--pty", str(boards.link))
        station = stations(Station.on_pty(boards.link))
    else:
        station = stations(Station.on_tcp(boards("--tcp", "0").tcp_port))
    station.open_binary()
    station.command("start")
    station.command("set_parameter_task_rate", 20)
    station.command("set_servos_task_rate", 20)
    # Not reading a byte, let more be sent than any buffer on the way holds. The commands are taken all the same.
    frame = encode_command("read_all")
    for _ in range(8000):
        station.write_without_reading(frame)
    station.command("stop")
    station.leave_binary()
    station.wait(lambda: int(station.table("status").get("frames dropped", "0")) > 100)
    assert station.failed <= 1  # only whole frames are dropped
    # A busy computer may cut a command with a pause, which the board has to take for its end.
    assert int(station.table("status")["frames received"]) >= 7990


def test_garbage_on_the_line_costs_nothing_but_itself(extended: Station) -> None:
    rubbish = (
        b"\xff" * 100,
        b"#QT,",
        b"#QT,\x05\0\0\0\xfb\xff\xff\xff\r\n\r",
        b"#QT,\xff\xff\xff\x7f",
        b"#QT,\x3a\0\0\0\x01",
        bytes(range(256)) * 4,
        encode_command("ahrs_on")[:-1] + b"\x0b",
        encode_command("autopilot_on")[5:],
    )
    for piece in rubbish:
        extended.send(piece)
        assert extended.ask("set_servos_task_rate", 20) == 0
    assert extended.heartbeat()["ahrs"] == 0


def test_a_frame_that_breaks_off_is_given_up_after_a_silence(extended: Station) -> None:
    # The beginning of a long frame would swallow the next commands if the board waited for its end.
    extended.send(encode_command("xplane_info", *LEVEL_FLIGHT)[:20])
    assert extended.ask("ahrs_on") == 0
    assert extended.ask("ahrs_off") == 0
    extended.frames.clear()
    extended.command("xplane_info", *LEVEL_FLIGHT)
    extended.wait(lambda: extended.newest("hil_surfaces"))
    assert extended.count("hil_surfaces") == 1


def test_commands_cut_at_every_place_are_understood(extended: Station) -> None:
    frame = encode_command("servo_out", 3, 0.5)

    def is_understood(cut: int) -> bool:
        extended.send(frame[:cut])
        extended.heartbeats(1)  # time for the board to have taken the first part
        extended.frames.clear()
        extended.send(frame[cut:])
        extended.wait(lambda: extended.acknowledgements("servo_out") or extended.count("heartbeat") >= 10)
        return extended.acknowledgements("servo_out") > 0

    for cut in range(1, len(frame)):
        # Said again where a busy computer made a pause that the board has to take for a command's end.
        extended.wait(lambda cut=cut: is_understood(cut))  # type: ignore[misc]


def test_the_link_is_removed_at_the_end(boards: Boards) -> None:
    for ending in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        board = boards("--pty", str(boards.link))
        assert board.stop(ending) == (0, "")
        assert not os.path.lexists(boards.link)


def test_a_killed_board_leaves_a_link_that_the_next_one_takes_over(boards: Boards, stations: Keep) -> None:
    board = boards("--pty", str(boards.link))
    assert board.stop(signal.SIGKILL)[0] == -signal.SIGKILL
    assert boards.link.is_symlink()
    boards("--pty", str(boards.link))
    stations(Station.on_pty(boards.link)).open_binary()


def test_a_link_that_another_board_took_over_is_left_to_it(boards: Boards, stations: Keep) -> None:
    first = boards("--pty", str(boards.link))
    boards("--pty", str(boards.link))
    assert first.stop() == (0, "")
    stations(Station.on_pty(boards.link)).open_binary()


def test_a_board_that_is_stopped_closes_the_line(text: Station, boards: Boards, stations: Keep) -> None:
    text.open_binary()
    text.command("start")
    text.next("gps")
    text.close()
    board = boards("--tcp", "0")
    station = stations(Station.on_tcp(board.tcp_port))
    station.open_binary()
    assert board.stop() == (0, "")
    station.wait(lambda: station.is_closed)


WRONG = {
    (): "--pty PATH, --tcp PORT or --serial DEVICE",
    ("--tcp", "1", "--pty", "x"): "Exactly one of",
    ("--tcp", "70000"): "from 0 to 65535",
    ("--tcp", "-1"): "from 0 to 65535",
    ("--pty",): "a value is needed",
    ("--fast",): "no such option",
    ("--tcp", "0", "extra"): "extra: not an option",
    ("--tcp", "0", "--hil-period-ms", "1001"): "from 0 to 1000",
    ("--tcp", "0", "--seed", "one"): "from 0 to 4294967295",
}


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    program = FIRMWARE / "build" / "posix" / "epf-board"
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=DEADLINE_S, check=False)


@pytest.mark.usefixtures("built")
@pytest.mark.parametrize("arguments", WRONG, ids=" ".join)
def test_a_wrong_command_line_gets_one_clear_sentence(arguments: tuple[str, ...]) -> None:
    ended = run(*arguments)
    assert ended.returncode == 2
    assert ended.stdout == ""
    assert ended.stderr.startswith("epf-board: ")
    assert WRONG[arguments] in ended.stderr
    assert ended.stderr.count("\n") == 1


@pytest.mark.usefixtures("built")
def test_a_line_or_card_that_cannot_be_used_gets_one_clear_sentence(tmp_path: Path) -> None:
    occupied = socket.create_server(("127.0.0.1", 0))
    file = tmp_path / "file"
    file.write_text("precious")
    for arguments, why in (
        (("--tcp", str(occupied.getsockname()[1])), "cannot be opened"),
        (("--pty", str(tmp_path / "none" / "board")), "cannot be made"),
        (("--pty", str(file)), "it is no link"),
        (("--serial", str(tmp_path / "none")), "cannot be opened as a serial line"),
        (("--tcp", "0", "--card", str(file)), "not a folder"),
    ):
        ended = run(*arguments)
        assert (ended.returncode, ended.stdout) == (1, "")
        assert why in ended.stderr
        assert ended.stderr.count("\n") == 1
    occupied.close()
    assert file.read_text() == "precious"


@pytest.mark.usefixtures("built")
def test_help_and_version_are_for_people() -> None:
    helped = run("--help")
    assert (helped.returncode, helped.stderr) == (0, "")
    for option in ("--pty", "--tcp", "--serial", "--card", "--legacy", "--hil-period-ms", "--seed", "--version"):
        assert option in helped.stdout
    assert max(map(len, helped.stdout.splitlines())) <= 120
    assert run("--version").stdout == f"{VERSION}\n"
