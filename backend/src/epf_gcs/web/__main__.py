"""`epf-web`: the web process. `epf-gcs` starts it beside the flight process."""

from __future__ import annotations

import argparse
import os
import sys
import threading
from pathlib import Path
from typing import Any, Final

import orjson

from epf_gcs import __version__
from epf_gcs.data_folder.lock import WEB, held
from epf_gcs.data_folder.upgrade import bring_up_to_date
from epf_gcs.data_folder.version import FormatError
from epf_gcs.errors import GatewayError
from epf_gcs.logs import set_up_logging
from epf_gcs.system.priority import leave_flight_core
from epf_gcs.system.private_files import write_private_files
from epf_gcs.watchdog import REFUSED
from epf_gcs.web.app import create_app
from epf_gcs.web.server import Server
from epf_gcs.web.serving.settings import Settings

_GIVEN: Final = (
    *("host", "port", "data_dir", "page_dir", "fd", "watchdog", "again"),
    *("trust_this_computer", "allow_anyone_to_fly", "control_by_silence", "tls", "tls_cert", "tls_key"),
)


def main() -> None:
    """Entry point of `epf-web`."""
    write_private_files()
    options = _options()
    given = {name: getattr(options, name) for name in _GIVEN}
    try:
        settings = Settings(**{name: value for name, value in given.items() if value is not None})
    except ValueError as error:
        print(f"epf-web: {error}", file=sys.stderr)
        sys.exit(2)
    if options.print_openapi:
        _print_openapi(settings)
        return
    set_up_logging(verbose=options.verbose)
    leave_flight_core()
    if options.with_parent:
        threading.Thread(target=_wait_for_parent, daemon=True).start()
    try:
        with held(settings.data_dir, name=WEB):
            bring_up_to_date(settings.data_dir, lambda said: print(f"epf-web: {said}", file=sys.stderr))
            Server(settings).serve_until_signal()
    except GatewayError as error:
        print(f"epf-web: {error.detail}", file=sys.stderr)
        sys.exit(REFUSED)
    except FormatError as error:
        print(f"epf-web: {error}", file=sys.stderr)
        sys.exit(REFUSED)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="epf-web",
        description="The web process of EPF GCS: page, interface and stream of the flight process of its data folder. "
        "The variables GCS_... of epf-gcs hold here too.",
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    parser.add_argument("--host", help="Address to listen on.")
    parser.add_argument("--port", type=int, help="TCP port; 0 takes any free one.")
    parser.add_argument("--fd", type=int, help="A listening socket that was inherited, in place of host and port.")
    parser.add_argument("--watchdog", type=int, help="Pipe on which the parent expects signs of life.")
    parser.add_argument("--data-dir", type=Path, help="Folder of the flight process, the recordings and the maps.")
    parser.add_argument("--page-dir", type=Path, help="Folder of the built page.")
    parser.add_argument("--tls", action="store_true", default=None, help="HTTPS with certificates of its own.")
    parser.add_argument("--tls-cert", type=Path, help="HTTPS with this certificate and its chain, in PEM.")
    parser.add_argument("--tls-key", type=Path, help="The certificate's key, in PEM.")
    parser.add_argument("--again", action="store_true", default=None, help="It ran before: show an expired one too.")
    parser.add_argument(
        "--trust-this-computer", action=argparse.BooleanOptionalAction, help="Whether this computer needs no key."
    )
    parser.add_argument(
        "--allow-anyone-to-fly", action="store_true", default=None, help="Nobody needs a key to command."
    )
    parser.add_argument(
        "--control-by-silence", action="store_true", default=None, help="An unanswered request for control is granted."
    )
    parser.add_argument("--with-parent", action="store_true", help="End when standard input closes.")
    parser.add_argument("--verbose", action="store_true", help="Log more.")
    parser.add_argument("--print-openapi", action="store_true", help="Print the OpenAPI document and end.")
    return parser.parse_args()


def _wait_for_parent() -> None:
    """End the process when the parent dies, which closes our standard input: the port must be free for the next start.

    Nothing of a flight is lost, for all of it is in the flight process.
    """
    while os.read(0, 1):
        pass
    os._exit(0)


def _print_openapi(settings: Settings) -> None:
    document: dict[str, Any] = create_app(settings).openapi()
    sys.stdout.buffer.write(orjson.dumps(document, option=orjson.OPT_INDENT_2 | orjson.OPT_SORT_KEYS) + b"\n")


if __name__ == "__main__":
    main()
