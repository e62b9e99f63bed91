"""Serial ports and pseudo-terminals, opened in the way of this system."""

from __future__ import annotations

try:
    from epf_gcs.link.serial_posix import open_pty, open_serial
except ImportError:  # Windows has no terminals
    from epf_gcs.link.serial_threads import open_pty, open_serial

__all__ = ["open_pty", "open_serial"]
