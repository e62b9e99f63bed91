"""What is started with which arguments."""

from pathlib import Path

import pytest

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.options import EVERY_INTERFACE, Options, XPlane

DEMONSTRATION = Options(data=Path("/somewhere/data"))


def test_the_demonstrations_board_is_on_a_line_in_the_data_folder() -> None:
    assert DEMONSTRATION.board_url() == "pty:///somewhere/data/board.pty"
    assert DEMONSTRATION.board_command()[1:] == [
        *("--pty", "/somewhere/data/board.pty"),
        *("--card", "/somewhere/data/card"),
    ]


@pytest.mark.parametrize(
    ("given", "url"),
    [
        ("/dev/ttyUSB0", "serial:///dev/ttyUSB0"),
        ("serial:///dev/ttyUSB0?baud=57600", "serial:///dev/ttyUSB0?baud=57600"),
        ("tcp://10.0.0.7:4000", "tcp://10.0.0.7:4000"),
        ("pty:///run/board", "pty:///run/board"),
    ],
)
def test_a_real_board_is_a_device_or_an_address(given: str, url: str) -> None:
    assert Options(board=given).board_url() == url


def test_what_is_no_board_is_told_with_what_would_be() -> None:
    with pytest.raises(LaunchError, match=r"http://somewhere is not the address of a board.*/dev/ttyUSB0"):
        Options(board="http://somewhere").board_url()


def test_only_the_gateways_first_start_is_told_the_board() -> None:
    first = DEMONSTRATION.gateway_command(first=True)
    again = DEMONSTRATION.gateway_command(first=False)
    assert first == [*again, "--board", "pty:///somewhere/data/board.pty"]


def test_the_page_is_served_to_this_computer_only_unless_the_network_is_asked_for() -> None:
    def host(options: Options) -> str:
        command = options.gateway_command(first=True)
        return command[command.index("--host") + 1]

    assert host(DEMONSTRATION) == "127.0.0.1"
    assert host(Options(lan=True)) == EVERY_INTERFACE
    assert DEMONSTRATION.url == "http://127.0.0.1:8000"


def test_the_simulator_and_the_gateway_are_wired_to_each_other() -> None:
    command = DEMONSTRATION.simulator_command(XPlane("127.0.0.1", 49000, 49003))
    assert command[command.index("--listen") + 1] == "127.0.0.1:49000"
    assert command[command.index("--send-to") + 1] == "127.0.0.1:49003"


@pytest.mark.parametrize(
    ("address", "host", "port"), [("192.168.1.20", "192.168.1.20", 49000), ("flightbox:50000", "flightbox", 50000)]
)
def test_x_plane_is_a_computer_and_its_port_where_that_is_another(address: str, host: str, port: int) -> None:
    assert XPlane.at(address, 49003, "xp12") == XPlane(host, port, 49003, "xp12")


@pytest.mark.parametrize("address", ["", ":49000", "flightbox:", "flightbox:x", "flightbox:70000"])
def test_what_is_no_address_of_x_plane_is_told_with_what_would_be(address: str) -> None:
    with pytest.raises(LaunchError, match="give HOST or HOST:PORT"):
        XPlane.at(address, 49003, "xp10")


def test_without_flight_dynamics_the_sentence_says_how_to_get_them(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("epf_gcs.extras.find_spec", lambda _name: None)
    with pytest.raises(LaunchError, match=r"(?s)jsbsim.*install jsbsim==.*Or fly with X-Plane"):
        DEMONSTRATION.simulator_command(XPlane("127.0.0.1", 49000, 49003))
