"""Tells whether two files hold the same recording, however they are packed."""

from __future__ import annotations

import hashlib

import numpy as np

from epf_gcs.recordings.parts import Messages
from epf_gcs.recordings.topics import LOG_TABLE


class Fingerprint:
    """Of channel, time (to the nanosecond) and length of every message, in the order of the file.

    Two recordings with the same times of all messages are one; the bytes themselves need not be read for that. Of a log
    of another program they are: a few messages hold all of it, and two logs may have the same times.
    """

    def __init__(self) -> None:
        self._parts = [hashlib.sha256() for _ in range(3)]
        self._rows = hashlib.sha256()
        self._has_rows = False

    def add(self, messages: Messages) -> None:
        """Take the next messages of the file; how it is cut into parts makes no difference."""
        arrays = (messages.channel.astype("<u2"), messages.t_ns.astype("<i8"), messages.length.astype("<i8"))
        for part, array in zip(self._parts, arrays, strict=True):
            part.update(array.tobytes())
        for place in np.flatnonzero(messages.channel == LOG_TABLE).tolist():
            start = int(messages.start[place])
            self._rows.update(messages.data.data[start : start + int(messages.length[place])])
            self._has_rows = True

    def text(self) -> str:
        """The fingerprint of all that was added."""
        parts = [*self._parts, self._rows] if self._has_rows else self._parts
        return hashlib.sha256(b"".join(part.digest() for part in parts)).hexdigest()
