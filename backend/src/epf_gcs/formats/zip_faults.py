"""What Python's `zipfile` raises when an archive is damaged, cut or packed in a way that is not known."""

from __future__ import annotations

import lzma
import struct
import zipfile
import zlib
from typing import Final

ZIP_FAULTS: Final = (
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    EOFError,
    OSError,
    RuntimeError,
    NotImplementedError,
    ValueError,
)
"""Found by damaging archives at random, and from `zipfile`'s source; a file that was cut ends with EOFError."""
