"""The serial ports of this machine, and which of them is a device that we knew under another name."""

from __future__ import annotations

from dataclasses import dataclass

from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo


@dataclass(frozen=True, slots=True)
class SerialPort:
    """A port as a person would recognise it. `identity` names the USB device behind it, wherever it is plugged in."""

    path: str
    description: str
    identity: str | None


def list_serial_ports() -> list[SerialPort]:
    """All ports now, in the order of their names."""
    found = [
        SerialPort(port.device, _describe(port.description, port.manufacturer), _identity(port))
        for port in list_ports.comports()
    ]
    return sorted(found, key=lambda port: port.path)


def find_identity(path: str) -> str | None:
    """Who is behind this path, where that can be told."""
    return next((port.identity for port in list_serial_ports() if port.path == path), None)


def find_path(identity: str) -> str | None:
    """Where a known device is now."""
    return next((port.path for port in list_serial_ports() if port.identity == identity), None)


def _describe(description: str | None, manufacturer: str | None) -> str:
    text = description if description and description != "n/a" else ""
    return f"{text} ({manufacturer})" if text and manufacturer else text or manufacturer or ""


def _identity(port: ListPortInfo) -> str | None:
    if port.vid is None or not port.serial_number:
        return None
    return f"{port.vid:04x}:{port.pid or 0:04x}:{port.serial_number}"
