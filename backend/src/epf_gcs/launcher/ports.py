"""Which ports are free on the loopback, and which program has one that is taken."""

import contextlib
import errno
import ipaddress
import socket
import sys
from pathlib import Path
from typing import Final

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.listening import is_refused_by_browsers

LOOPBACK: Final = "127.0.0.1"
_LISTEN: Final = "0A"  # socket state in /proc/net/tcp


def require_tcp_port(host: str, port: int) -> None:
    """Raise LaunchError unless the port can be listened on and browsers open it.

    It names the program that has it, if that can be seen.
    """
    if is_refused_by_browsers(port):
        raise LaunchError(f"Port {port} is one that browsers refuse to open; {_instead(port)}.")
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        # As servers do: a port that is only in TIME_WAIT after a stop counts as free.
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except OSError as error:
            raise LaunchError(_why_not(port, error)) from error


def free_udp_port(wanted: int) -> int:
    """`wanted` if it is free on the loopback, else any other free port."""
    for port in (wanted, 0):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe, contextlib.suppress(OSError):
            probe.bind((LOOPBACK, port))
            chosen: int = probe.getsockname()[1]
            return chosen
    raise LaunchError("This computer has no free UDP port on the loopback: close some programs and try again.")


def free_tcp_port() -> int:
    """A TCP port of the loopback that nobody listens on."""
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        probe.bind((LOOPBACK, 0))
        chosen: int = probe.getsockname()[1]
        return chosen


def is_loopback(host: str) -> bool:
    """Whether only this computer reaches what listens there."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def listener_of(port: int) -> str | None:
    """Name and process number of the program that listens on a TCP port; None if that cannot be seen."""
    if sys.platform != "linux":
        return None
    inodes = _listening_inodes(port)
    for process in Path("/proc").iterdir():
        if process.name.isdigit() and inodes & _sockets_of(process):
            name = (process / "comm").read_text().strip()
            return f"{name}, process {process.name}"
    return None


def _why_not(port: int, error: OSError) -> str:
    instead = _instead(port)
    if error.errno == errno.EADDRINUSE:
        owner = listener_of(port)
        who = f"another program ({owner})" if owner else "another program"
        return f"Port {port} is taken by {who}. Stop that program, or {instead}."
    if error.errno == errno.EACCES:
        return f"Port {port} needs rights that this user does not have; {instead}."
    return f"Port {port} cannot be opened ({error.strerror}); {instead}."


def _instead(port: int) -> str:
    other = 8001 if port != 8001 else 8002
    return f"choose another one: `epf-run --port {other}` or `make run PORT={other}`"


def _listening_inodes(port: int) -> set[str]:
    inodes = set()
    for table in ("/proc/net/tcp", "/proc/net/tcp6"):
        with contextlib.suppress(OSError):
            for line in Path(table).read_text().splitlines()[1:]:
                fields = line.split()
                if fields[3] == _LISTEN and int(fields[1].rpartition(":")[2], 16) == port:
                    inodes.add(f"socket:[{fields[9]}]")
    return inodes


def _sockets_of(process: Path) -> set[str]:
    """Links of a process's open files; empty for another user's."""
    links = set()
    with contextlib.suppress(OSError):
        for entry in (process / "fd").iterdir():
            with contextlib.suppress(OSError):
                links.add(str(entry.readlink()))
    return links
