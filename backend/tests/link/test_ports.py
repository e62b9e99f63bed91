"""The list of serial ports, and a device found again under another name."""

from __future__ import annotations

import pytest
from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

from epf_gcs.link.ports import find_identity, find_path, list_serial_ports


def _port(path: str, serial_number: str | None, vid: int | None = 0x0403) -> ListPortInfo:
    port = ListPortInfo(path)
    port.vid, port.pid, port.serial_number = vid, 0x6001, serial_number
    port.description, port.manufacturer = "USB serial", "FTDI"
    return port


def test_a_device_is_the_same_wherever_it_is_plugged_in(monkeypatch: pytest.MonkeyPatch) -> None:
    present = [_port("/dev/ttyUSB1", "A1"), _port("/dev/ttyUSB0", "B2")]
    monkeypatch.setattr(list_ports, "comports", lambda: present)
    assert [port.path for port in list_serial_ports()] == ["/dev/ttyUSB0", "/dev/ttyUSB1"]
    assert list_serial_ports()[0].description == "USB serial (FTDI)"
    identity = find_identity("/dev/ttyUSB1")
    assert identity == "0403:6001:A1"
    present[0] = _port("/dev/ttyUSB7", "A1")
    assert find_path(identity) == "/dev/ttyUSB7"


def test_a_port_without_a_serial_number_has_no_identity(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(list_ports, "comports", lambda: [_port("/dev/ttyS0", None), _port("/dev/ttyS1", "X", None)])
    assert find_identity("/dev/ttyS0") is None
    assert find_identity("/dev/ttyS1") is None
    assert find_identity("/dev/gone") is None
    assert find_path("0403:6001:A1") is None


def test_the_ports_of_this_machine_can_be_listed() -> None:
    assert all(port.path.startswith("/dev/") for port in list_serial_ports())
