"""Addresses of a board link, as people write them."""

from __future__ import annotations

import pytest

from epf_gcs.errors import InvalidInputError
from epf_gcs.link.address import LinkAddress, parse_address


@pytest.mark.parametrize(
    ("text", "address"),
    [
        ("serial:///dev/ttyUSB0", LinkAddress("serial", "/dev/ttyUSB0")),
        ("serial:///dev/ttyUSB0?baud=57600", LinkAddress("serial", "/dev/ttyUSB0", baud=57600)),
        ("serial:///COM3?baud=9600", LinkAddress("serial", "COM3", baud=9600)),
        ("/dev/ttyACM0", LinkAddress("serial", "/dev/ttyACM0")),
        ("COM3", LinkAddress("serial", "COM3")),
        ("tcp://192.168.1.5:4000", LinkAddress("tcp", "192.168.1.5", 4000)),
        ("tcp://[::1]:4000", LinkAddress("tcp", "::1", 4000)),
        ("pty:///run/board", LinkAddress("pty", "/run/board")),
        ("pty://./board", LinkAddress("pty", "./board")),
        ("  pty:///run/board  ", LinkAddress("pty", "/run/board")),
    ],
)
def test_an_address_is_read(text: str, address: LinkAddress) -> None:
    assert parse_address(text) == address


@pytest.mark.parametrize(
    "text",
    [
        "serial:///dev/ttyUSB0?baud=57600",
        "tcp://[::1]:4000",
        "tcp://h:1",
        "pty:///run/board",
        "pty://./board",
        "COM3",
        "emulation:",
    ],
)
def test_an_address_written_back_is_the_same_address(text: str) -> None:
    address = parse_address(text)
    assert parse_address(address.url) == address


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "its kind is none of"),
        ("hello", "its kind is none of"),
        ("http://host:80", "its kind is none of"),
        ("tcp://host", "a host and a port"),
        ("tcp://:4000", "a host and a port"),
        ("tcp://host:0", "a host and a port"),
        ("tcp://host:99999", "Port out of range"),
        ("tcp://[::1:4000", "Invalid IPv6"),
        ("serial://dev/ttyUSB0", "three slashes"),
        ("serial:///", "three slashes"),
        ("serial:///dev/ttyUSB0?baud=1", "the baud rate must be one of 9600"),
        ("serial:///dev/ttyUSB0?baud=", "the baud rate must be one of 9600"),
        ("serial:///dev/ttyUSB0?baud=²", "the baud rate must be one of 9600"),
        ("serial:///dev/ttyUSB0?parity=even", "baud is the only option"),
        ("/dev/tty\nUSB0", "unprintable"),
        ("/" + "x" * 600, "too long"),
    ],
)
def test_a_wrong_address_says_what_is_wrong_with_it(text: str, why: str) -> None:
    with pytest.raises(InvalidInputError, match=why) as caught:
        parse_address(text)
    assert caught.value.code == "link_address_invalid"
    assert "serial:///dev/ttyUSB0?baud=115200" in caught.value.detail


def test_another_baud_rate_is_still_the_same_device() -> None:
    assert parse_address("/dev/ttyS0").same_device(parse_address("serial:///dev/ttyS0?baud=9600"))
    assert not parse_address("tcp://h:1").same_device(parse_address("tcp://h:2"))
