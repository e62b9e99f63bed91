"""Take out of an installed environment what no station uses, and compile the rest so that each build gives the same.

Usage: slim.py ENVIRONMENT. Each pattern has to match: a package that changed its layout stops the build, and is looked at.
Licence texts stay. What is left is imported at the end, so that nothing is taken that is needed.
"""

from __future__ import annotations

import compileall
import os
import py_compile
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Final

# Below site-packages.
UNUSED: Final = (
    # what installed it
    "pip",
    "pip-*.dist-info",
    "setuptools",
    "setuptools-*.dist-info",
    "_distutils_hack",
    "distutils-precedence.pth",
    # Arrow's clients of remote storage and services, and its headers, for programs that are compiled against it
    "pyarrow/include",
    "pyarrow/includes",
    "pyarrow/src",
    "pyarrow/libarrow_flight.so*",
    "pyarrow/libarrow_python_flight.so*",
    "pyarrow/_flight.*",
    "pyarrow/libarrow_substrait.so*",
    "pyarrow/_substrait.*",
    "pyarrow/_pyarrow_cpp_tests.*",
    # the same library under three names: a wheel has no links, and the one with the soname is loaded
    "pyarrow/libarrow_python.so",
    "pyarrow/libarrow_python.so.*.*.*",
    # sources of compiled modules, and packages' own tests
    "pyarrow/*.px[di]",
    "pyarrow/*.pyx",
    "**/tests",
)
# What the station's parts load, each of which would miss a library that is not there.
NEEDED: Final = (
    "epf_gcs.web.app",
    "epf_gcs.flight.flight",
    "jsbsim",
    "duckdb",
    "pyarrow.compute",
    "pyarrow.csv",
    "pyarrow.parquet",
    "rasterio.warp",
    "rasterio.vrt",
    "zstandard",
)
_SCRIPTS: Final = ("pip*", "Activate.ps1", "activate*")


def main() -> int:
    """Slim the environment; returns the exit code."""
    environment = Path(sys.argv[1])
    (packages,) = environment.glob("lib/python3.*/site-packages")
    before = size(environment)
    for pattern in UNUSED:
        if not (found := list(packages.glob(pattern))):
            print(f"slim: nothing matches {pattern}: look at the package, then correct the list.", file=sys.stderr)
            return 1
        for path in found:
            remove(path)
    for pattern in _SCRIPTS:
        for path in (environment / "bin").glob(pattern):
            remove(path)
    # Unchecked: they hold no time of their sources, and a read-only image has none newer.
    compiled = compileall.compile_dir(
        str(packages), quiet=2, invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH
    )
    code = "".join(f"import {name}\n" for name in NEEDED)
    result = subprocess.run([str(environment / "bin" / "python"), "-B", "-c", code], check=False, cwd="/")
    print(f"slim: {before // 1_000_000} MB, now {size(environment) // 1_000_000} MB, compiled: {bool(compiled)}.")
    return result.returncode


def remove(path: Path) -> None:
    """A file, a link or a folder with all in it; what went with its folder is no error."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def size(folder: Path) -> int:
    """Bytes of all files below it."""
    return sum(os.lstat(path).st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink())


if __name__ == "__main__":
    sys.exit(main())
