"""Write the World Magnetic Model's coefficients as a C table: `magnetic_model.py [--check]`.

The board has no calendar, so the table holds the field in the middle of the model's five years; from there the
declination moves by up to 1.2 deg either way where the horizontal field is above 10,000 nT. The coefficients (NOAA,
public domain) come out of the pinned package `pygeomag`, and the next model comes with its next release.
"""

import sys
from pathlib import Path

import pygeomag

MODEL = "WMM_2025.COF"
VALID_YEARS = 5.0
DEGREE = 12
OUTPUT = Path(__file__).parent.parent / "src" / "estimation" / "wmm_gen.h"

HEAD = """\
// Made by firmware/tools/magnetic_model.py from {name} (NOAA, public domain). Do not edit: run `make generate`.
#ifndef ESTIMATION_WMM_GEN_H
#define ESTIMATION_WMM_GEN_H

#define WMM_DEGREE {degree}

/// Gauss coefficients of one degree and order, Schmidt semi-normalised, in nT at {year}.
typedef struct
{{
    float g;
    float h;
}} wmm_coefficients_t;

/// By order 0..{degree}; within an order by degree, from the order itself (from 1 in order 0).
static const wmm_coefficients_t wmm_coefficients[] = {{
"""
TAIL = "};\n\n#endif\n"


def table() -> str:
    """The header's text."""
    first, *rows = (Path(pygeomag.__file__).parent / "wmm" / MODEL).read_text().splitlines()
    epoch, name, *_ = first.split()
    elapsed_years = VALID_YEARS / 2.0
    coefficients = {}
    for row in rows:
        words = row.split()
        if len(words) == 6:
            g, h, g_per_year, h_per_year = (float(word) for word in words[2:])
            coefficients[int(words[1]), int(words[0])] = (g + elapsed_years * g_per_year, h + elapsed_years * h_per_year)
    assert len(coefficients) == DEGREE * (DEGREE + 3) // 2, f"{MODEL} has {len(coefficients)} coefficients"
    lines = [
        f"    {{{g:.3f}F, {h:.3f}F}}, // {degree} {order}\n" for (order, degree), (g, h) in sorted(coefficients.items())
    ]
    return HEAD.format(name=name, degree=DEGREE, year=float(epoch) + elapsed_years) + "".join(lines) + TAIL


def main() -> int:
    """0 where the file is as it has to be, or was written."""
    if sys.argv[1:] != ["--check"]:
        OUTPUT.write_text(table())
        return 0
    if OUTPUT.read_text() == table():
        return 0
    print(f"{OUTPUT} is out of date: run `make generate`")
    return 1


if __name__ == "__main__":
    raise SystemExit(main())
