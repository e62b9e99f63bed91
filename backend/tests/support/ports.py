"""Ports of the loopback that are free now."""

from __future__ import annotations

import socket

LOOPBACK = "127.0.0.1"


def free_port(kind: socket.SocketKind) -> int:
    """A port that is free: SOCK_DGRAM for UDP, SOCK_STREAM for TCP."""
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.bind((LOOPBACK, 0))
        port: int = probe.getsockname()[1]
        return port


def free_udp_port() -> int:
    """A UDP port that is free."""
    return free_port(socket.SOCK_DGRAM)
