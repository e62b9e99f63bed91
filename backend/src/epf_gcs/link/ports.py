"""The serial ports of this machine, and where a known USB device is after it got another port name."""

from __future__ import annotations

from dataclasses import dataclass

from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo


@dataclass(frozen=True, slots=True)
class SerialPort:
    """A port and its description. `identity` names the USB device (vendor, product, serial number) on any port."""

    path: str
    description: str
    identity: str | None


def list_serial_ports() -> list[SerialPort]:
    """All ports present now, sorted by name."""
    found = [
        SerialPort(port.device, _describe(port.description, port.manufacturer), _identity(port))
        for port in list_ports.comports()
    ]
    return sorted(found, key=lambda port: port.path)


def find_identity(path: str) -> str | None:
    """The identity of the device at this path; None if unknown."""
    return next((port.identity for port in list_serial_ports() if port.path == path), None)


def find_path(identity: str) -> str | None:
    """The path at which a known device is now; None if it is not there."""
    return next((port.path for port in list_serial_ports() if port.identity == identity), None)


def _describe(description: str | None, manufacturer: str | None) -> str:
    text = description if description and description != "n/a" else ""
    return f"{text} ({manufacturer})" if text and manufacturer else text or manufacturer or ""


def _identity(port: ListPortInfo) -> str | None:
    if port.vid is None or not port.serial_number:
        return None
    return f"{port.vid:04x}:{port.pid or 0:04x}:{port.serial_number}"
