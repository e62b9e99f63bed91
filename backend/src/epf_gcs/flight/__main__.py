"""`epf-flight`: the flight process alone, headless."""

from __future__ import annotations

import argparse
import asyncio
import gc
import os
import sys
import threading
from pathlib import Path
from typing import Final

import structlog

from epf_gcs import __version__
from epf_gcs.data_folder.lock import held
from epf_gcs.data_folder.place import DEFAULT, data_folder
from epf_gcs.data_folder.upgrade import upgrade
from epf_gcs.data_folder.version import FormatError
from epf_gcs.errors import GatewayError
from epf_gcs.flight.flight import Flight
from epf_gcs.link.address import parse_address
from epf_gcs.logs import set_up_logging
from epf_gcs.system.loops import new_loop
from epf_gcs.system.priority import Priority, go_first, stay_in_memory, take_own_core
from epf_gcs.system.private_files import write_private_files
from epf_gcs.system.signals import on_polite_end
from epf_gcs.watchdog import REFUSED, feed

# How long another thread (the recorder's) may hold the interpreter while the event loop waits for it.
_SWITCH_INTERVAL_S: Final = 0.0002

log = structlog.get_logger("flight")


def main() -> None:
    """Entry point of `epf-flight`. Ends with 0 on SIGTERM, SIGINT or SIGHUP."""
    write_private_files()
    options = _options()
    set_up_logging(verbose=options.verbose)
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    priority = go_first()
    if priority == "real-time":
        # Otherwise the system finds the core where it waits least.
        take_own_core()
    stay_in_memory()
    if options.board is not None:
        try:
            parse_address(options.board)
        except GatewayError as error:
            print(f"epf-flight: {error.detail}", file=sys.stderr)
            sys.exit(2)
    try:
        with held(options.data_dir):
            # Other programs wait for it: the web process opens what the station's launcher has brought up to date.
            upgrade(options.data_dir, log.warning)
            with asyncio.Runner(loop_factory=new_loop) as runner:
                runner.run(_fly(options, priority))
    except GatewayError as error:
        sys.exit(f"epf-flight: {error.detail}")
    except FormatError as error:
        print(f"epf-flight: {error}", file=sys.stderr)
        sys.exit(REFUSED)
    except OSError as error:
        sys.exit(f"epf-flight: {options.data_dir} cannot be used ({error.strerror or error}): correct its permissions.")


async def _fly(options: argparse.Namespace, priority: Priority) -> None:
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    on_polite_end(ended.set, loop)
    if options.with_parent:
        # A daemon thread, not the loop's executor: the loop would wait at its end for a read that blocks.
        threading.Thread(target=_wait_for_parent, args=(loop, ended), daemon=True).start()
    flight = Flight(options.data_dir, record=options.recording, board_url=options.board)
    async with flight.running():
        # All objects made so far live as long as the process. Frozen, they are not scanned again, which would
        # stop the loop for milliseconds.
        gc.collect()
        gc.freeze()
        # Held until the process ends: a loop that hangs while it shuts down is noticed too.
        fed = None if options.watchdog is None else asyncio.create_task(feed(options.watchdog))
        await asyncio.sleep(0)  # its first sign of life comes before the log says that it flies
        log.info("flying", data=str(options.data_dir), pid=os.getpid(), priority=priority)
        await ended.wait()
    del fed


def _wait_for_parent(loop: asyncio.AbstractEventLoop, ended: asyncio.Event) -> None:
    """Set `ended` when the parent dies, even if it was killed: it holds the other end of our standard input."""
    while os.read(0, 1):
        pass
    loop.call_soon_threadsafe(ended.set)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="epf-flight",
        description="The flight process of EPF GCS: board and simulator, HIL, recorder. Flies without any page; "
        "stations find it in its data folder.",
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    parser.add_argument(
        "--data-dir",
        type=Path,
        default=Path(os.environ.get("GCS_DATA_DIR") or data_folder()),
        help=f"Folder of the recordings and the remembered links; GCS_DATA_DIR. Default: {DEFAULT}.",
    )
    parser.add_argument(
        "--board",
        default=os.environ.get("GCS_BOARD"),
        help="serial:///dev/ttyUSB0?baud=115200, tcp://host:port or pty:///path; GCS_BOARD. "
        "Default: that of the last run.",
    )
    parser.add_argument(
        "--recording", action=argparse.BooleanOptionalAction, default=True, help="Record every byte of the lines."
    )
    parser.add_argument("--with-parent", action="store_true", help="End when standard input closes.")
    parser.add_argument("--watchdog", type=int, help="Pipe on which the parent expects signs of life.")
    parser.add_argument("--verbose", action="store_true", help="Log more.")
    return parser.parse_args()


if __name__ == "__main__":
    main()
