"""The board's magnetic field all over the earth, against an implementation of the same model that is not its own."""

import ctypes
import math
from collections.abc import Iterator
from typing import Final

from board_tests.closed_loop.sensors import Vector, reference_field_nt
from epf_gcs.lab.laws import library as laws_library

# The horizontal field that a compass needs; the model's authors warn of less.
USABLE_NT: Final = 6000.0


class _Vector(ctypes.Structure):
    """`vector_t`."""

    _fields_ = (("x", ctypes.c_float), ("y", ctypes.c_float), ("z", ctypes.c_float))


def board_field_nt(latitude_deg: float, longitude_deg: float) -> Vector:
    """North, east and down as the board computes them."""
    library = ctypes.CDLL(str(laws_library()))
    library.epf_magnetic_field.argtypes = (ctypes.c_float, ctypes.c_float, ctypes.POINTER(_Vector))
    field = _Vector()
    library.epf_magnetic_field(latitude_deg, longitude_deg, ctypes.byref(field))
    return field.x, field.y, field.z


def places() -> Iterator[tuple[float, float]]:
    """Every 5 degrees of latitude and 10 of longitude with both poles and the date line, and the Canary Islands."""
    yield from (
        (float(latitude), float(longitude)) for latitude in range(-90, 91, 5) for longitude in range(-180, 181, 10)
    )
    yield from ((27.5 + north / 10.0, -18.5 + east / 5.0) for north in range(21) for east in range(26))


def declination_deg(field: Vector) -> float:
    return math.degrees(math.atan2(field[1], field[0]))


def test_the_boards_field_is_the_models_at_two_thousand_places() -> None:
    compared = 0
    for place in places():
        board, reference = board_field_nt(*place), reference_field_nt(*place)
        assert math.dist(board, reference) < 0.2, place
        if math.hypot(*reference[:2]) > USABLE_NT:
            difference = (declination_deg(board) - declination_deg(reference) + 180.0) % 360.0 - 180.0
            assert abs(difference) < 0.002, place
        compared += 1
    assert compared > 1900
