"""`epf-lab`: flies a board's laws in the simulator, once or a thousand times, and says what came of it."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Final, NoReturn

import typer

from epf_gcs import __version__
from epf_gcs.lab import campaign as campaigns
from epf_gcs.lab import table as tables
from epf_gcs.lab.campaign import Campaign
from epf_gcs.lab.conditions import GAIN, Conditions, gains_of
from epf_gcs.lab.errors import LabError
from epf_gcs.lab.faults import read as read_faults
from epf_gcs.lab.flight import Flight
from epf_gcs.lab.flight import fly as fly_one
from epf_gcs.lab.flying import fly_all
from epf_gcs.lab.keeping import keep, keep_worst, kept_worst
from epf_gcs.lab.proving import SUITES, conformance_of, run_suites
from epf_gcs.lab.routes import route
from epf_gcs.lab.rows import WORST, Results, Row
from epf_gcs.system.private_files import write_private_files

app = typer.Typer(
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Fly a board's laws in the simulator, once or a thousand times, and say what came of it.",
)

_INTERRUPTED: Final = 130

Laws = Annotated[Path | None, typer.Option("--laws", help="Shared library of the laws to fly. Usual: this board's.")]
Folder = Annotated[Path, typer.Argument(help="Folder of a campaign's results.")]


def _print_version(asked: bool) -> None:  # noqa: FBT001 - how an option's callback is called
    if asked:
        print(f"epf-lab {__version__}")
        raise typer.Exit


@app.callback()
def about(
    *,
    _version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Fly a board's laws in the simulator, once or a thousand times, and say what came of it."""


@app.command()
def fly(
    what: Annotated[str, typer.Argument(metavar="ROUTE", help="gando, vuelo, alternativa, ruta_isla, or a plan file.")],
    given: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME=VALUE]...", help="Conditions, gains and faults, as seed=7.")
    ] = None,
    laws: Laws = None,
    record: Annotated[
        Path | None,
        typer.Option("--record", metavar="FOLDER", help="A station's data folder, for a recording and a page of it."),
    ] = None,
) -> None:
    """Fly a route once.

    As in: epf-lab fly gando wind_kt=15 wind_from_deg=250 gains.k_roll=3 fault=gyro.drift@60+30=0.002
    """
    conditions, gains, faults = _read(given or [])
    flight = fly_one(route(what), conditions, gains, laws, read_faults(faults))
    print("\n".join(_lines(flight)))
    if record is not None:
        print("\n".join(keep(flight, record).lines()))
    if not flight.is_safe:
        raise typer.Exit(1)


@app.command()
def campaign(
    file: Annotated[Path, typer.Argument(help="What is flown, in which conditions: a TOML file.")],
    into: Annotated[Path, typer.Option("--into", help="Folder for the results; one that is begun goes on.")],
    workers: Annotated[
        int, typer.Option(min=1, max=256, help="Processes that fly. Usual: one for each core.")
    ] = os.cpu_count() or 1,
    laws: Laws = None,
    record: Annotated[
        int, typer.Option("--record", min=0, max=WORST, help="So many of the worst flights are recorded.")
    ] = WORST,
) -> None:
    """Fly a route many times, in conditions that are drawn; or a table of such campaigns, by each law."""
    rows = tables.read(file)
    if rows is None:
        wanted = campaigns.read(file)
        _fly_campaign(wanted, into, workers, laws)
        keep_worst(wanted, into, record, laws)
        report(into)
        return
    cells = []
    for row in rows:
        print(f"{row.name}, {row.law}:")
        cells.append(row.cells(_fly_campaign(row.campaign, row.folder(into), workers, laws)))
    print("\n".join(tables.lines(cells)))


def _fly_campaign(wanted: Campaign, into: Path, workers: int, laws: Path | None) -> list[Row]:
    with Results(into, wanted) as results:
        begun = len(results.rows)
        if begun:
            print(f"{begun} of {wanted.flights} flights are there already.")
        with typer.progressbar(length=wanted.flights - begun, label="Flying", show_pos=True, show_eta=True) as bar:
            fly_all(wanted, results, workers, laws, lambda _: bar.update(1))
        results.finish()
        return [results.rows[number] for number in sorted(results.rows)]


@app.command()
def report(folder: Folder) -> None:
    """Say what a campaign found."""
    from epf_gcs.lab.summary import read_rows, summary  # noqa: PLC0415 - loads pyarrow

    found = summary(read_rows(folder))
    low, high = found.safe.interval()
    print(f"{found.safe.count} of {found.safe.of} flights are safe: {_percent(found.safe.share)}")
    print(f"  all such flights, with 95 % certainty: {_percent(low)} to {_percent(high)}")
    if found.not_flown:
        print(f"  {found.not_flown} could not be flown; column `error` says why")
    if found.effects:
        print("What matters (rank correlation with the distance from the way; safe in its lowest and highest third):")
    for effect in found.effects:
        ends = f"{_percent(effect.low.share)} and {_percent(effect.high.share)}"
        print(f"  {effect.name:16} {effect.correlation:+.2f}   {ends}")
    print("The worst flights:")
    kept = kept_worst(folder)
    for row in found.worst:
        figure = "-" if row["near_rms_m"] is None else f"{row['near_rms_m']:.1f} m"
        end = row["lost_by"] or f"{row['captured_honestly']} of {row['waypoints']} waypoints"
        print(f"  number {row['number']:6}  {figure:>9} off the way   {end}")
        if row["number"] in kept:
            print("\n".join(kept[row["number"]].lines()))


@app.command()
def compare(before: Folder, after: Folder) -> None:
    """Hold two campaigns of the same flights against each other, as of two firmwares."""
    from epf_gcs.lab import summary  # noqa: PLC0415 - loads pyarrow

    found = summary.compare(summary.read_rows(before), summary.read_rows(after))
    print(f"{found.pairs} flights in the same conditions")
    print(f"  safe only after: {found.better}; safe only before: {found.worse} (by chance: {found.by_chance:.3f})")
    low, high = found.change_interval
    print(f"  distance from the way, rms: {found.change:+.1f} m ({low:+.1f} to {high:+.1f} with 95 % certainty)")


@app.command()
def refly(
    recording: Annotated[Path, typer.Argument(help="A recording of a flight with a simulator.")], laws: Laws = None
) -> None:
    """Tell another build of the laws what the recorded board was told, and compare what it answers."""
    from epf_gcs.lab.refly import refly as fly_again  # noqa: PLC0415 - few need it

    found = fly_again(recording, laws)
    print("\n".join(found.lines()))
    if found.first is not None:
        raise typer.Exit(1)


@app.command("test")
def run(
    suites: Annotated[
        list[str] | None, typer.Argument(metavar="[SUITE]...", help=f"{', '.join(SUITES)}. Usual: all.")
    ] = None,
    seeds: Annotated[int, typer.Option(min=1, help="How many are flown where chance has a part.")] = 3,
    junit: Annotated[Path | None, typer.Option(help="File for a report in JUnit's format.")] = None,
    laws: Laws = None,
) -> None:
    """Fly the suites that ship, and say each figure beside its bound."""
    raise typer.Exit(run_suites(suites or [], seeds, laws, junit))


@app.command("conform")
def hold_against_protocol(
    url: Annotated[str, typer.Argument(help="The board: tcp://host:port, serial:///dev/ttyUSB0, pty:///path.")],
    patience_s: Annotated[float, typer.Option(min=0.1, help="How long an answer may take.")] = 2.0,
) -> None:
    """Hold a board against its protocol, and list what it lacks. The board is moved and reset: no aircraft may fly."""
    outcomes = conformance_of(url, patience_s)
    for one in outcomes:
        print(f"ok     {one.name}" if one.lacks is None else f"LACKS  {one.name}\n       {one.lacks}")
    lacks = sum(one.lacks is not None for one in outcomes)
    print(f"{len(outcomes) - lacks} of {len(outcomes)} checks passed")
    if lacks:
        raise typer.Exit(1)


def _read(given: Sequence[str]) -> tuple[Conditions, dict[str, float], list[str]]:
    values: dict[str, str] = {}
    gains: dict[str, str] = {}
    faults: list[str] = []
    for one in given:
        name, sign, text = one.partition("=")
        if not sign:
            raise LabError(f"{one!r} is not NAME=VALUE, as wind_kt=15")
        if name == "fault":
            faults.append(text)
            continue
        is_gain = name.startswith(GAIN)
        (gains if is_gain else values)[name.removeprefix(GAIN) if is_gain else name] = text
    return Conditions.of(values, are_texts=True), gains_of(gains, are_texts=True), faults


def _lines(flight: Flight) -> list[str]:
    end = "safe" if flight.is_safe else "NOT SAFE"
    if flight.upset is not None:
        end = f"LOST after {flight.upset.time_s:.1f} s: {flight.upset.cause}"
    reached = f"{flight.captured_honestly} of {len(flight.route.waypoints)} waypoints"
    altitude = flight.altitude.settled
    return [
        f"{flight.route.name}: {end}; {reached}, {flight.time_s:.0f} s",
        f"  off the leg         {flight.leg.rms_m:6.1f} m rms, {flight.leg.largest_m:.1f} m largest",
        f"  off the way         {flight.near.rms_m:6.1f} m rms, turns included",
        f"  altitude            {altitude.rms_ft:6.1f} ft rms, {altitude.largest_ft:.1f} ft largest",
        f"  indicated airspeed  {flight.airspeed.settled.rms_kt:6.1f} kt rms",
        *(f"  {shown}" for shown in flight.evidence),
    ]


def _percent(share: float) -> str:
    return f"{100.0 * share:.1f} %"


def main() -> NoReturn:
    """Run; what cannot be done is one sentence."""
    write_private_files()
    try:
        code = app(standalone_mode=False)
    except LabError as error:
        print(f"epf-lab: {error}", file=sys.stderr)
        sys.exit(2)
    except (KeyboardInterrupt, typer.Abort):
        print("\nStopped. The same command goes on where it was.", file=sys.stderr)
        sys.exit(_INTERRUPTED)
    sys.exit(code or 0)


if __name__ == "__main__":
    main()
