"""`epf-sim`: the embedded simulator as a program of its own, in X-Plane's place."""

import signal
import socket
import sys
from enum import StrEnum
from types import FrameType
from typing import Annotated, NoReturn

import typer

from epf_gcs import __version__
from epf_gcs.codec.messages_gen import RECEIVE_PORT, SEND_PORT
from epf_gcs.simulator.airframe import AirframeError
from epf_gcs.simulator.link import LinkQuality
from epf_gcs.simulator.server import Address, Pace, Server
from epf_gcs.simulator.simulation import HIGHEST_RATE_HZ, LOWEST_RATE_HZ, Simulation, SimulationOptions
from epf_gcs.simulator.situation import (
    AIRPORT_LATITUDE_DEG,
    AIRPORT_LONGITUDE_DEG,
    RUNWAY_HEADING_DEG,
    Situation,
    Start,
    Turbulence,
    Wind,
    parse_wind,
)
from epf_gcs.system.private_files import write_private_files
from epf_gcs.system.signals import POLITE

LOOPBACK = "127.0.0.1"

app = typer.Typer(
    pretty_exceptions_enable=False, rich_markup_mode=None, context_settings={"help_option_names": ["-h", "--help"]}
)


def _print_version(asked: bool) -> None:  # noqa: FBT001 - how an option's callback is called
    if asked:
        print(f"epf-sim {__version__}")
        raise typer.Exit


class Aircraft(StrEnum):
    """The aircraft that can be flown."""

    RC = "rc"
    C172P = "c172p"


class Profile(StrEnum):
    """Generations of X-Plane that order the rows differently."""

    XP10 = "xp10"
    XP12 = "xp12"


_FLIGHT = "Flight"
_WEATHER = "Weather"
_NETWORK = "Network"
_TIME = "Time"


@app.command()
def simulate(
    *,
    aircraft: Annotated[
        Aircraft, typer.Option(help="rc: 12 kg, 3 m, electric. c172p: Cessna 172.", rich_help_panel=_FLIGHT)
    ] = Aircraft.RC,
    start: Annotated[
        Start,
        typer.Option(
            help="air: trimmed at 1000 ft over the place. runway: standing there, throttle closed. "
            "final: trimmed in a 3 degree descent, 1500 m before the place.",
            rich_help_panel=_FLIGHT,
        ),
    ] = Start.AIR,
    lat: Annotated[
        float,
        typer.Option(
            min=-85.0, max=85.0, help="Latitude of the place in degrees, north positive.", rich_help_panel=_FLIGHT
        ),
    ] = AIRPORT_LATITUDE_DEG,
    lon: Annotated[
        float, typer.Option(min=-180.0, max=180.0, help="Longitude in degrees, east positive.", rich_help_panel=_FLIGHT)
    ] = AIRPORT_LONGITUDE_DEG,
    heading: Annotated[
        float, typer.Option(min=0.0, max=360.0, help="True heading at the start in degrees.", rich_help_panel=_FLIGHT)
    ] = RUNWAY_HEADING_DEG,
    throttle: Annotated[
        float | None,
        typer.Option(
            min=0.0,
            max=1.0,
            help="The pilot's throttle lever, 0..1.",
            show_default="what holds the start: closed on the runway",
            rich_help_panel=_FLIGHT,
        ),
    ] = None,
    wind: Annotated[
        str,
        typer.Option(
            metavar="FROM/SPEED", help="Degrees true it blows from, and knots: 330/20.", rich_help_panel=_WEATHER
        ),
    ] = "0/0",
    turbulence: Annotated[Turbulence, typer.Option(help="Of MIL-F-8785C.", rich_help_panel=_WEATHER)] = Turbulence.NONE,
    seed: Annotated[
        int,
        typer.Option(
            min=1, help="Of turbulence, jitter and loss: the same seed, the same bytes.", rich_help_panel=_WEATHER
        ),
    ] = 1,
    send_to: Annotated[
        str,
        typer.Option(metavar="HOST:PORT", help="Where the rows go: the station.", rich_help_panel=_NETWORK),
    ] = f"{LOOPBACK}:{RECEIVE_PORT}",
    listen: Annotated[
        str,
        typer.Option(
            metavar="[HOST:]PORT",
            help="Where commands are taken. Without a host only from this computer; 0.0.0.0:PORT from any.",
            rich_help_panel=_NETWORK,
        ),
    ] = f"{LOOPBACK}:{SEND_PORT}",
    profile: Annotated[
        Profile,
        typer.Option(
            help="xp10: X-Plane 10 and 11. xp12: X-Plane 12 (row 16 is P, Q, R in deg/s).", rich_help_panel=_NETWORK
        ),
    ] = Profile.XP10,
    one_row_per_datagram: Annotated[
        bool,
        typer.Option(
            "--one-row-per-datagram", help="A datagram for each row, not all in one.", rich_help_panel=_NETWORK
        ),
    ] = False,
    delay_ms: Annotated[
        float, typer.Option(min=0.0, max=10000.0, help="Delay put on each direction, in ms.", rich_help_panel=_NETWORK)
    ] = 0.0,
    jitter_ms: Annotated[
        float,
        typer.Option(min=0.0, max=10000.0, help="Random further delay up to this, in ms.", rich_help_panel=_NETWORK),
    ] = 0.0,
    loss: Annotated[
        float,
        typer.Option(
            min=0.0, max=1.0, help="Share of datagrams lost in each direction, 0..1.", rich_help_panel=_NETWORK
        ),
    ] = 0.0,
    rate: Annotated[
        int,
        typer.Option(
            min=LOWEST_RATE_HZ, max=HIGHEST_RATE_HZ, help="Frames per simulated second.", rich_help_panel=_TIME
        ),
    ] = 50,
    speed_up: Annotated[
        float, typer.Option(min=0.1, max=100.0, help="Simulated seconds per second.", rich_help_panel=_TIME)
    ] = 1.0,
    lockstep: Annotated[
        bool,
        typer.Option(
            "--lockstep",
            help="After each frame wait for a command (the rows are sent again every second until one comes). "
            "Deterministic, and as fast as the station answers.",
            rich_help_panel=_TIME,
        ),
    ] = False,
    duration: Annotated[
        float | None,
        typer.Option(
            min=0.0, help="Stop after so many simulated seconds.", show_default="never", rich_help_panel=_TIME
        ),
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and end.")
    ] = False,
) -> None:
    """Fly an aircraft with JSBSim's dynamics and speak X-Plane's UDP.

    Sends rows 3, 4, 6, 8, 11, 16, 17, 18, 20 and 25. Takes rows 8 (stick),
    11 (surfaces) and 25 (throttle), where -999 gives an axis back to the pilot.
    The pilot's stick is neutral and trimmed: left alone, the aircraft flies on.
    After a crash it is put back to its start. The ground is flat, 78 ft high.

    \b
    Examples:
      epf-sim
      epf-sim --start runway --wind 330/20 --turbulence moderate
      epf-sim --send-to 192.168.1.20:49003 --listen 0.0.0.0:49000
    """
    options = SimulationOptions(
        aircraft=aircraft.value,
        situation=Situation(start, lat, lon, heading, _wind(wind), turbulence, seed),
        throttle=throttle,
        profile=profile.value,
        rate_hz=rate,
        one_row_per_datagram=one_row_per_datagram,
        link=LinkQuality(delay_ms, jitter_ms, loss),
    )
    station = _address(send_to, "--send-to")
    place = _address(listen, "--listen")
    pace = Pace(1.0 / rate, speed_up, lockstep, duration)
    try:
        simulation = Simulation(options, _warn)
    except AirframeError as error:
        _fail(f"{error}.")
    with _open(place) as sock:
        stop = _StopRequest()
        server = Server(simulation, sock, station, pace, lambda: stop.heard)
        print(_introduction(options, station, place, pace), flush=True)
        server.run()
    print(_summary(simulation, server), flush=True)


class _StopRequest:
    """Remembers that Ctrl-C or SIGTERM came."""

    def __init__(self) -> None:
        self.heard = False
        for number in POLITE:
            signal.signal(number, self._hear)

    def _hear(self, _number: int, _frame: FrameType | None) -> None:
        self.heard = True


def _wind(text: str) -> Wind:
    try:
        return parse_wind(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="--wind") from None


def _address(text: str, option: str) -> Address:
    host, _, port = text.rpartition(":")
    if not port.isdecimal() or not 0 < int(port) < 65536:
        raise typer.BadParameter(f"{text!r} is not HOST:PORT, as in 127.0.0.1:49000", param_hint=option)
    return host or LOOPBACK, int(port)


def _open(place: Address) -> socket.socket:
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        sock.bind(place)
    except OSError as error:
        sock.close()
        _fail(
            f"UDP {place[0]}:{place[1]} cannot be opened ({error.strerror}). If X-Plane or another epf-sim has it, "
            "stop that one or choose another port with --listen (and the same one in the station)."
        )
    sock.setblocking(False)
    return sock


def _introduction(options: SimulationOptions, station: Address, place: Address, pace: Pace) -> str:
    situation = options.situation
    where = {
        Start.AIR: "trimmed in the air over",
        Start.RUNWAY: "standing on the runway at",
        Start.FINAL: "on final to",
    }[situation.start]
    time = "in lock-step with the station" if pace.lockstep else f"at {pace.speed_up:g} times real time"
    return (
        f"{options.aircraft} {where} {situation.latitude_deg:.4f} {situation.longitude_deg:.4f}, "
        f"heading {situation.heading_deg:.0f}; {options.rate_hz} Hz {time}; "
        f"rows to {station[0]}:{station[1]} ({options.profile}), commands taken on {place[0]}:{place[1]}."
    )


def _summary(simulation: Simulation, server: Server) -> str:
    counts = simulation.inputs.counts
    return (
        f"Flown {simulation.time_s:.1f} s, {simulation.crashes} crashes, {server.stalls} stalls; "
        f"sent {server.datagrams_sent} datagrams ({server.send_failures} failed), took {counts.datagrams} "
        f"({counts.bad_datagrams} damaged, {counts.unknown_rows} unknown rows, {counts.bad_values} values not finite)."
    )


def _warn(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _fail(text: str) -> NoReturn:
    _warn(text)
    raise typer.Exit(1)


def main() -> None:
    """Entry point of `epf-sim`."""
    write_private_files()
    app()


if __name__ == "__main__":
    main()
