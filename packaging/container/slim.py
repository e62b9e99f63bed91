"""Take out of an installed environment what no station uses, and compile the rest so that each build gives the same.

Usage: slim.py ENVIRONMENT. The standard library that it runs on is slimmed too. Each pattern of a package has to match:
one that changed its layout stops the build, and is looked at. Licence texts stay. What is left is imported at the end,
so that nothing is taken that is needed.
"""

from __future__ import annotations

import os
import py_compile
import shutil
import struct
import subprocess
import sys
from fnmatch import fnmatch
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
    "pyarrow/libarrow_s3.so*",
    "pyarrow/_s3fs.*",
    "pyarrow/_substrait.*",
    "pyarrow/_pyarrow_cpp_tests.*",
    # the same library under three names: a wheel has no links, and the one with the soname is loaded
    "pyarrow/libarrow_python.so",
    "pyarrow/libarrow_python.so.*.*.*",
    # sources of compiled modules, and packages' own tests
    "pyarrow/*.px[di]",
    "pyarrow/*.pyx",
    "adbc_driver_duckdb",
    "_duckdb-stubs",
    "duckdb/experimental",
    "**/tests",
    "test",
    "**/*.a",
    "**/*.pyi",
    "numpy/_core/include",
    "numpy/f2py",
)
# Below the standard library: installers, editors, tests, as far as the base image has them.
UNUSED_STANDARD: Final = (
    "ensurepip",
    "idlelib",
    "lib2to3",
    "pydoc_data",
    "turtledemo",
    "tkinter",
    "test",
    "site-packages/*",
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
# Loads every module of ours but the programs, and prints the sources of all that is loaded then: what is compiled.
_WALK: Final = """
import importlib, pkgutil, sys, epf_gcs
for found in pkgutil.walk_packages(epf_gcs.__path__, "epf_gcs."):
    if not found.name.endswith("__main__"):
        importlib.import_module(found.name)
files = {str(getattr(module, "__file__", "")) for module in list(sys.modules.values())}
print(*sorted(name for name in files if name.endswith(".py")), sep="\\n")
"""
_SCRIPTS: Final = ("pip*", "Activate.ps1", "activate*", "f2py", "numpy-config")
# Their symbols stay. jsbsim: its licence lets it be shipped unchanged. *.libs: what the wheels' makers moved into them
# has been patched, and cannot be loaded after `strip`.
_UNCHANGED: Final = ("jsbsim", "*.libs")
_PAGE_BYTES: Final = 4096


def main() -> int:
    """Slim the environment; returns the exit code."""
    environment = Path(sys.argv[1])
    (packages,) = environment.glob("lib/python3.*/site-packages")
    before = size(environment)
    standard = Path(os.__file__).parent
    for pattern in UNUSED:
        if not (found := list(packages.glob(pattern))):
            print(f"slim: nothing matches {pattern}: look at the package, then correct the list.", file=sys.stderr)
            return 1
        for path in found:
            remove(path)
    for path in (path for pattern in UNUSED_STANDARD for path in list(standard.glob(pattern))):
        remove(path)
    for path in [*packages.rglob("__pycache__"), *standard.rglob("__pycache__")]:
        remove(path)
    for pattern in _SCRIPTS:
        for path in (environment / "bin").glob(pattern):
            remove(path)
    strip(packages)
    code = "\n".join((*(f"import {name}" for name in NEEDED), _WALK))
    result = subprocess.run(
        [str(environment / "bin" / "python"), "-B", "-c", code], check=False, cwd="/", stdout=subprocess.PIPE, text=True
    )
    compiled = result.stdout.splitlines()
    for path in compiled:
        # Unchecked: they hold no time of their sources, and a read-only image has none newer.
        py_compile.compile(path, doraise=True, invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
    print(f"slim: {before // 1_000_000} MB, now {size(environment) // 1_000_000} MB, {len(compiled)} modules compiled.")
    return result.returncode


def strip(packages: Path) -> None:
    """Take the symbols for debuggers out of compiled modules: a fifth of all that there is."""
    found = [path for path in packages.rglob("*.so*") if path.is_file() and not path.is_symlink()]
    changed = [
        path for path in found if not any(fnmatch(path.relative_to(packages).parts[0], name) for name in _UNCHANGED)
    ]
    subprocess.run(["strip", "--strip-unneeded", *map(str, changed)], check=True)
    for path in changed:
        if not is_loadable(path):
            sys.exit(f"slim: {path} cannot be loaded after strip: put its package into _UNCHANGED.")


def is_loadable(path: Path) -> bool:
    """Whether each part that is loaded (PT_LOAD of a 64-bit ELF file) lies in the file as it will in memory."""
    data = path.read_bytes()
    (start,) = struct.unpack_from("<Q", data, 32)
    entry_bytes, count = struct.unpack_from("<HH", data, 54)
    for number in range(count):
        kind, _, offset, address = struct.unpack_from("<IIQQ", data, start + number * entry_bytes)
        if kind == 1 and (offset - address) % _PAGE_BYTES:
            return False
    return True


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
