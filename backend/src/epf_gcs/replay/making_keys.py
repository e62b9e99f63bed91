"""`--make-keys`: makes the key frames of a finished recording, so that its first replay goes to any moment at once."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from pathlib import Path
from typing import Final

from epf_gcs.errors import GatewayError
from epf_gcs.replay.keys import Keys
from epf_gcs.replay.scout import Scout
from epf_gcs.replay.timeline import Timeline
from epf_gcs.workers.lines import tell, tell_fault

_STEP: Final = 0.01


def make_keys(recording: Path, file: Path) -> int:
    """Say how far it is as the workers of `flights` do, in JSON lines; returns the exit code.

    It ends with its parent, which holds the other end of standard input, and when it is told to: what it made so far
    stays, and is gone on with by whoever replays the recording.
    """
    for name in (signal.SIGTERM, signal.SIGINT):
        signal.signal(name, signal.SIG_DFL)
    threading.Thread(target=_wait_for_parent, name="parent", daemon=True).start()
    try:
        tell({"done": {"bytes": _make(recording, file)}})
    except (GatewayError, OSError) as error:
        # The recording was indexed before: if it cannot be read now, whoever opens it is told so.
        why = error.detail if isinstance(error, GatewayError) else str(error)
        tell_fault(GatewayError("job_failed", why, why=why))
        return 1
    return 0


def _make(recording: Path, file: Path) -> int:
    timeline = Timeline(recording)
    starts_ns = timeline.starts_ns
    if starts_ns is None:
        return 0
    keys = Keys(file, recording.stem, starts_ns)
    try:
        scout, told = Scout(timeline, keys), 0.0
        tell({"progress": 0.0, "doing": "keys"})
        while scout.has_work:
            scout.work()
            share = ((keys.latest_ns or starts_ns) - starts_ns) / max(1, timeline.edge_ns - starts_ns)
            if share - told >= _STEP:
                told = share
                tell({"progress": share, "doing": "keys"})
    finally:
        keys.close()
    with contextlib.suppress(OSError):
        return file.stat().st_size
    return 0


def _wait_for_parent() -> None:
    with contextlib.suppress(OSError):
        while os.read(0, 1):
            pass
    os._exit(1)
