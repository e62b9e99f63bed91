"""`epf-replay`: one recording as a vehicle, once for each viewer; nothing can be commanded through it."""

# ruff: noqa: E402 - what must be known before the imports stands before them
from __future__ import annotations

import argparse
import asyncio
import contextlib
import gc
import os
import sys
import threading
from pathlib import Path
from typing import Final

# Before numpy comes with the reader: its threads would cost memory, and nothing here uses them.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# The log's library would load it for tracebacks in colour: a fifth of the time until a viewer sees the flight.
sys.modules["rich"] = None  # type: ignore[assignment]

import orjson

from epf_gcs import __version__
from epf_gcs.errors import GatewayError
from epf_gcs.logs import set_up_logging
from epf_gcs.replay.making_keys import make_keys
from epf_gcs.replay.vehicle_process import VehicleProcess
from epf_gcs.system.limits import limit_memory
from epf_gcs.system.loops import new_loop
from epf_gcs.system.priority import WAITED_FOR, be_nice
from epf_gcs.system.private_files import write_private_files
from epf_gcs.system.signals import on_polite_end

_MEMORY_BYTES: Final = 2 << 30


def main() -> None:
    """Entry point of `epf-replay`. Ends with 0 on SIGTERM, SIGINT, or the end of standard input (`--with-parent`)."""
    write_private_files()
    options = _options()
    set_up_logging(verbose=False)
    _be_modest(options)
    if options.make_keys:
        sys.exit(make_keys(options.recording, options.keys))
    try:
        with asyncio.Runner(loop_factory=new_loop) as runner:
            runner.run(_replay(options))
    except GatewayError as error:
        sys.exit(f"epf-replay: {error.detail}")
    except (OSError, MemoryError) as error:
        sys.exit(f"epf-replay: {options.recording} cannot be replayed ({error}).")


async def _replay(options: argparse.Namespace) -> None:
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    on_polite_end(ended.set, loop)
    process = VehicleProcess(options.recording, options.keys)
    if options.folder is not None:
        process.open(options.folder, options.at)
    if options.with_parent:
        threading.Thread(target=_listen_to_parent, args=(loop, process, ended), daemon=True).start()
    try:
        gc.collect()
        gc.freeze()
        # What is decoded has no cycles: look for some now and then, not all the time.
        gc.set_threshold(50_000, 20, 50)
        running = asyncio.ensure_future(process.run())
        waiting = asyncio.ensure_future(ended.wait())
        await asyncio.wait({running, waiting}, return_when=asyncio.FIRST_COMPLETED)
        for task in (running, waiting):
            task.cancel()
        with contextlib.suppress(asyncio.CancelledError):
            await running
    finally:
        process.close()


def _be_modest(options: argparse.Namespace) -> None:
    """A low priority, and a limit of memory: no flight is slower for it, no file can take the machine.

    Key frames are made at the lowest; a viewer waits for what he sought, so a replay comes before the background.
    """
    if options.make_keys:
        be_nice()
    else:
        be_nice(WAITED_FOR)
    limit_memory(_MEMORY_BYTES)


def _listen_to_parent(loop: asyncio.AbstractEventLoop, process: VehicleProcess, ended: asyncio.Event) -> None:
    """Open a replay for each line of standard input, `{"folder": ..., "at_s": ...}`.

    Set `ended` when the parent dies, even if it was killed: it holds the other end.
    """
    held = b""
    while more := os.read(0, 65536):
        *lines, held = (held + more).split(b"\n")
        for line in lines:
            asked = orjson.loads(line)
            loop.call_soon_threadsafe(process.open, Path(asked["folder"]), float(asked["at_s"]))
    loop.call_soon_threadsafe(ended.set)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="epf-replay",
        description="A recording of EPF GCS as a vehicle, for any number of viewers: a station finds it in a folder, "
        "and plays, pauses and seeks by notices of the stream.",
    )
    parser.add_argument("--version", action="version", version=f"%(prog)s {__version__}")
    parser.add_argument("--recording", type=Path, required=True, help="The MCAP file; it may still be growing.")
    parser.add_argument("--folder", type=Path, default=None, help="Where a viewer's socket is made.")
    parser.add_argument("--at", type=float, default=0.0, help="Seconds after the start of the flight, for that viewer.")
    parser.add_argument("--keys", type=Path, default=None, help="File of key frames, shared by replays of a recording.")
    parser.add_argument(
        "--with-parent",
        action="store_true",
        help="Open a replay for each line of standard input, and end when it closes.",
    )
    parser.add_argument(
        "--make-keys",
        action="store_true",
        help="Make the key frames of a finished recording (with --keys), say how far it is, and end.",
    )
    options = parser.parse_args()
    if options.make_keys and options.keys is None:
        parser.error("--make-keys needs --keys: where to put them")
    return options


if __name__ == "__main__":
    main()
