"""`epf-mavlink`: shows a station's aircraft to QGroundControl, Mission Planner, MAVProxy, MAVSDK and their like."""

from __future__ import annotations

import asyncio
import contextlib
import sys
from ipaddress import ip_address
from pathlib import Path
from typing import Annotated, Final, NoReturn, cast

import typer

from epf_gcs import __version__
from epf_gcs.extras import MAVLINK
from epf_gcs.mavlink.choice import Aircraft, Choice, Home
from epf_gcs.system.private_files import write_private_files

_NOT_INSTALLED: Final = 3
_REFUSED: Final = 2
_KEY_BYTES: Final = 32

app = typer.Typer(
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


@app.command()
def run(
    *,
    station: Annotated[str, typer.Argument(help="Address of the station, as in a browser.")] = "http://127.0.0.1:8000",
    key_file: Annotated[
        Path | None, typer.Option(help="File with a program's key. On the station's computer: none.")
    ] = None,
    aircraft: Annotated[str, typer.Option(help="flight: the real aircraft. hil: the simulator's.")] = "flight",
    udp: Annotated[
        str, typer.Option(help="Where MAVLink is sent from the start; whoever answers is heard.")
    ] = "127.0.0.1:14550",
    tcp: Annotated[str, typer.Option(help="Listen here as well, as 127.0.0.1:5760.")] = "",
    home: Annotated[
        str, typer.Option(help="Where heights above home begin: LATITUDE,LONGITUDE,METRES above the sea.")
    ] = "",
    speed_kt: Annotated[float | None, typer.Option(min=1, max=500, help="Speed of plans that name none.")] = None,
    signing_key_file: Annotated[
        Path | None, typer.Option(help="32 bytes: sign, and take signed messages alone.")
    ] = None,
    version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False,
) -> None:
    """Show a station's aircraft to MAVLink's ground stations and programs, until Ctrl+C.

    As in: epf-mavlink --aircraft hil --speed-kt 80
    """
    if version:
        print(f"epf-mavlink {__version__}")
        return
    if not MAVLINK.is_here:
        _end(_NOT_INSTALLED, MAVLINK.sentence())
    if aircraft not in ("flight", "hil"):
        _end(_REFUSED, f"There is no aircraft '{aircraft}': it is 'flight' or 'hil'.")
    # It needs pymavlink.
    from epf_gcs.mavlink.program import Ports, serve  # noqa: PLC0415

    choice = Choice(cast(Aircraft, aircraft), _home(home), speed_kt)
    key = None if key_file is None else _read(key_file).decode(errors="replace").strip()
    signing = None if signing_key_file is None else _read(signing_key_file)
    if signing is not None and len(signing) != _KEY_BYTES:
        _end(_REFUSED, f"{signing_key_file} has {len(signing)} bytes: a signing key has {_KEY_BYTES}.")
    if signing is None and not all(_is_here(one) for one in (udp, tcp) if one):
        _end(_REFUSED, "Beyond this computer MAVLink needs --signing-key-file: without it anybody could command.")
    ports = Ports(_address(udp), _address(tcp) if tcp else None, signing)
    with contextlib.suppress(KeyboardInterrupt):
        fault = asyncio.run(serve(station, key, choice, ports))
        _end(_REFUSED, fault)


def _home(text: str) -> Home | None:
    if not text:
        return None
    try:
        latitude_deg, longitude_deg, altitude_m = (float(part) for part in text.split(","))
    except ValueError:
        _end(_REFUSED, f"'{text}' is no home: give LATITUDE,LONGITUDE,METRES, as 27.93,-15.39,24.")
    return Home(latitude_deg, longitude_deg, altitude_m)


def _address(text: str) -> tuple[str, int]:
    host, colon, port = text.rpartition(":")
    if not colon or not port.isdecimal() or not 0 < int(port) < 65536:
        _end(_REFUSED, f"'{text}' is no address: give HOST:PORT, as 127.0.0.1:14550.")
    return host, int(port)


def _is_here(text: str) -> bool:
    """Whether an address is of this computer alone."""
    try:
        return ip_address(_address(text)[0]).is_loopback
    except ValueError:
        return _address(text)[0] == "localhost"


def _read(file: Path) -> bytes:
    try:
        return file.read_bytes()
    except OSError as error:
        _end(_REFUSED, f"{file} cannot be read: {error.strerror}.")


def _end(code: int, sentence: str) -> NoReturn:
    print(sentence, file=sys.stderr)
    raise SystemExit(code)


def main() -> None:
    """Entry point."""
    write_private_files()
    app()


if __name__ == "__main__":
    main()
