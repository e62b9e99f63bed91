"""Hold the firmware's import rules: which folder of src may include which, and no circle between modules.

Usage: check_layers.py SRC TESTS [FOLDER...]

Pure code knows no RTOS, no vendor and no hardware header; only `records` sees the storage interface, only `volume`
the file system behind it, and only `app` sees everything. Each pure source has a test of its own name. No module of
any of the folders may depend on itself by way of others (`cycles.py`). Fails, too, when it saw no files, because it
would then have checked nothing.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

from cycles import circle, depend

# folder -> what its files may include besides their own folder
RULES: dict[str, tuple[str, ...]] = {
    "common": (),
    "comms": ("common/",),
    "control": ("common/",),
    "estimation": ("common/",),
    "navigation": ("common/",),
    "params": ("common/",),
    "records": ("common/", "hal/storage.h", "navigation/", "params/"),
    "volume": ("hal/block_device.h", "hal/storage.h"),
    "sdcard": ("hal/block_device.h", "hal/spi.h"),
    "flight": ("common/", "comms/", "control/", "navigation/", "params/", "records/"),
    "hal": ("common/", "comms/protocol_gen.h"),
}
FREE = {"app"}
# libraries that only one folder may use
LIBRARIES = {"volume": {"lfs.h"}}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD = {
    "assert.h",
    "float.h",
    "limits.h",
    "math.h",
    "stdarg.h",
    "stdatomic.h",
    "stdbool.h",
    "stddef.h",
    "stdint.h",
    "string.h",
}


def faults(path: Path, folder: str) -> Iterator[str]:
    """Yield one sentence for each include that the rules forbid."""
    for bracket, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        if bracket == "<":
            if name not in STANDARD | LIBRARIES.get(folder, set()):
                yield f"{path}: <{name}> is no header of freestanding C that pure code may use"
        elif "/" not in name:
            if not (path.parent / name).is_file():
                yield f'{path}: "{name}" is not in its folder'
        elif not name.startswith((f"{folder}/", *RULES[folder])):
            yield f'{path}: folder {folder} may not include "{name}"'


def untested(source: Path, tests: Path) -> Iterator[str]:
    """Yield a sentence when a source has no test program of its name."""
    if source.suffix == ".c" and not source.stem.endswith("_gen"):
        partner = tests / source.parent.name / f"test_{source.stem}.c"
        if not partner.is_file():
            yield f"{source}: there is no {partner}"


def main(src: Path, tests: Path, others: list[Path]) -> int:
    """Check the layers of every file below `src` and the circles in all folders; return the exit code."""
    seen = 0
    found: list[str] = []
    for path in sorted(src.glob("*/*.[ch]")):
        folder = path.parent.name
        if folder in FREE:
            continue
        if folder not in RULES:
            found.append(f"{path}: folder {folder} has no rule in {Path(__file__).name}")
            continue
        seen += 1
        found += faults(path, folder)
        found += untested(path, tests)
    if seen < len(RULES):
        found.append(f"only {seen} files were seen below {src}")
    edges = depend(sorted(path for folder in (src, tests, *others) for path in folder.rglob("*.[ch]")))
    found += [f"circle: {reason}" for reason in circle(edges)]
    print("\n".join(found) if found else f"layers: {seen} files keep the rules; no circle among {len(edges)} modules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), Path(sys.argv[2]), [Path(name) for name in sys.argv[3:]]))
