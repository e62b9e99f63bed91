"""Tells whether two files hold the same recording, however they are packed."""

from __future__ import annotations

import hashlib

from epf_gcs.recordings.parts import Messages


class Fingerprint:
    """Of channel, time (to the nanosecond) and length of every message, in the order of the file.

    Two recordings with the same times of all messages are one; the bytes themselves need not be read for that.
    """

    def __init__(self) -> None:
        self._parts = [hashlib.sha256() for _ in range(3)]

    def add(self, messages: Messages) -> None:
        """Take the next messages of the file; how it is cut into parts makes no difference."""
        arrays = (messages.channel.astype("<u2"), messages.t_ns.astype("<i8"), messages.length.astype("<i8"))
        for part, array in zip(self._parts, arrays, strict=True):
            part.update(array.tobytes())

    def text(self) -> str:
        """The fingerprint of all that was added."""
        return hashlib.sha256(b"".join(part.digest() for part in self._parts)).hexdigest()
