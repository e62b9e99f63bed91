"""Command line -> settings -> server."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import orjson
import typer
from pydantic import ValidationError

from epf_gcs.errors import GatewayError
from epf_gcs.link.address import parse_address
from epf_gcs.logs import set_up_logging
from epf_gcs.web.app import create_app
from epf_gcs.web.server import Server
from epf_gcs.web.settings import Settings

app = typer.Typer(add_completion=False, context_settings={"help_option_names": ["-h", "--help"]})


@app.command()
def run(
    *,
    host: Annotated[
        str | None, typer.Option(help="Address to listen on. Beyond 127.0.0.1 anybody there can fly the aircraft.")
    ] = None,
    port: Annotated[int | None, typer.Option(help="TCP port of page and interface; 0 takes any free one.")] = None,
    board: Annotated[
        str | None,
        typer.Option(
            help="Board to connect to: serial:///dev/ttyUSB0?baud=115200, tcp://host:port or pty:///path; "
            "emulation: plays example values without one."
        ),
    ] = None,
    data_dir: Annotated[Path | None, typer.Option(help="Folder of the recordings and the remembered links.")] = None,
    page_dir: Annotated[Path | None, typer.Option(help="Folder of the built page.")] = None,
    recording: Annotated[bool | None, typer.Option(help="Record every byte of the lines.")] = None,
    verbose: Annotated[bool, typer.Option(help="Log more.")] = False,
    print_openapi: Annotated[bool, typer.Option(help="Print the OpenAPI document and end.")] = False,
) -> None:
    """The gateway of EPF GCS: connects a board and a flight simulator with browsers.

    Without --board it opens the links of its last run. Every option is also a variable: GCS_HOST, GCS_PORT,
    GCS_BOARD, GCS_DATA_DIR, GCS_PAGE_DIR, GCS_RECORDING; GCS_ALLOWED_HOSTS and GCS_ALLOWED_ORIGINS (JSON lists) let
    more names and pages in; GCS_LOCAL_MAPS (a JSON list of host:port) names servers of map tiles in the own network.
    """
    given: dict[str, Any] = {
        "host": host,
        "port": port,
        "board": board,
        "data_dir": data_dir,
        "page_dir": page_dir,
        "recording": recording,
    }
    try:
        settings = Settings(**{name: value for name, value in given.items() if value is not None})
    except ValueError as error:
        raise typer.BadParameter(_first_fault(error)) from error
    if print_openapi:
        _print_openapi(settings)
        return
    if settings.board is not None:
        try:
            parse_address(settings.board)
        except GatewayError as error:
            raise typer.BadParameter(error.detail, param_hint="--board") from error
    set_up_logging(verbose=verbose)
    try:
        Server(settings).fly()
    except GatewayError as error:
        print(f"epf-gcs: {error.detail}", file=sys.stderr)
        raise typer.Exit(1) from error


def main() -> None:
    """Entry point of `epf-gcs`."""
    app()


def _first_fault(error: ValueError) -> str:
    if not isinstance(error, ValidationError):
        return str(error)
    fault = error.errors()[0]
    return f"{'.'.join(map(str, fault['loc']))}: {fault['msg']}"


def _print_openapi(settings: Settings) -> None:
    document = create_app(settings).openapi()
    sys.stdout.buffer.write(orjson.dumps(document, option=orjson.OPT_INDENT_2 | orjson.OPT_SORT_KEYS) + b"\n")


if __name__ == "__main__":
    main()
