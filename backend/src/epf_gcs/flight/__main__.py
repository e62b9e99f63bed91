"""`epf-flight`: the flight process alone, headless."""

from __future__ import annotations

import argparse
import asyncio
import gc
import os
import signal
import sys
import threading
import time
from pathlib import Path
from typing import Final

import structlog

from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.flight.data_folder import DataFolder
from epf_gcs.flight.flight import Flight
from epf_gcs.flight.priority import Priority, go_first, stay_in_memory
from epf_gcs.link.address import parse_address
from epf_gcs.logs import set_up_logging
from epf_gcs.watchdog import feed

# How long another thread (the recorder's) may hold the interpreter while the event loop waits for it.
_SWITCH_INTERVAL_S: Final = 0.0002
_FOLDER_S: Final = 3.0
_LOOK_AGAIN_S: Final = 0.05
_POLITE: Final = (signal.SIGTERM, signal.SIGINT, getattr(signal, "SIGHUP", signal.SIGTERM))

log = structlog.get_logger("flight")


def main() -> None:
    """Entry point of `epf-flight`. Ends with 0 on SIGTERM, SIGINT or SIGHUP."""
    options = _options()
    set_up_logging(verbose=options.verbose)
    sys.setswitchinterval(_SWITCH_INTERVAL_S)
    priority = go_first()
    stay_in_memory()
    if options.board is not None:
        try:
            parse_address(options.board)
        except GatewayError as error:
            print(f"epf-flight: {error.detail}", file=sys.stderr)
            sys.exit(2)
    try:
        with asyncio.Runner(loop_factory=_loop_factory()) as runner:
            runner.run(_fly(options, priority))
    except GatewayError as error:
        sys.exit(f"epf-flight: {error.detail}")
    except OSError as error:
        sys.exit(f"epf-flight: {options.data_dir} cannot be used ({error.strerror or error}): correct its permissions.")


async def _fly(options: argparse.Namespace, priority: Priority) -> None:
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    for name in set(_POLITE):
        try:
            loop.add_signal_handler(name, ended.set)
        except NotImplementedError:
            signal.signal(name, lambda *_: loop.call_soon_threadsafe(ended.set))
    if options.with_parent:
        # A daemon thread, not the loop's executor: the loop would wait at its end for a read that blocks.
        threading.Thread(target=_wait_for_parent, args=(loop, ended), daemon=True).start()
    with await _held(options.data_dir):
        await _fly_until(ended, options, priority)


async def _fly_until(ended: asyncio.Event, options: argparse.Namespace, priority: Priority) -> None:
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


async def _held(data_dir: Path) -> DataFolder:
    """The data folder, locked. A process that is ending may still hold the lock: retry for a short time."""
    give_up_s = time.monotonic() + _FOLDER_S
    while True:
        try:
            return DataFolder(data_dir)
        except ConflictError:
            if time.monotonic() > give_up_s:
                raise
        await asyncio.sleep(_LOOK_AGAIN_S)


def _wait_for_parent(loop: asyncio.AbstractEventLoop, ended: asyncio.Event) -> None:
    """Set `ended` when the parent dies, even if it was killed: it holds the other end of our standard input."""
    while os.read(0, 1):
        pass
    loop.call_soon_threadsafe(ended.set)


def _loop_factory() -> type[asyncio.AbstractEventLoop] | None:
    try:
        import uvloop  # noqa: PLC0415 - not there on every system
    except ImportError:
        return None
    return uvloop.Loop


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="epf-flight",
        description="The flight process of EPF GCS: board and simulator, HIL, recorder. Flies without any page; "
        "stations find it in its data folder.",
    )
    parser.add_argument("--data-dir", type=Path, default=Path(os.environ.get("GCS_DATA_DIR", "data")))
    parser.add_argument(
        "--board", default=os.environ.get("GCS_BOARD"), help="serial:///dev/..., tcp://host:port, pty:///path"
    )
    parser.add_argument("--recording", action=argparse.BooleanOptionalAction, default=True)
    parser.add_argument("--with-parent", action="store_true", help="End when standard input closes.")
    parser.add_argument("--watchdog", type=int, help="Pipe on which the parent expects signs of life.")
    parser.add_argument("--verbose", action="store_true")
    return parser.parse_args()


if __name__ == "__main__":
    main()
