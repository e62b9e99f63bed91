"""What is on its way into the maps' folder, as events tell it and as the interface answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from epf_gcs.contract.base import ParamValue, Shape, numbers_of
from epf_gcs.errors import ErrorCode, GatewayError

FieldKind = Literal["heights", "imagery", "vector"]
FieldStep = Literal["waiting", "fetching", "making", "proving", "done"]
ImportState = Literal["receiving", "converting", "done", "failed"]


@dataclass(frozen=True, slots=True)
class MapProblem(Shape):
    """`problem`: one English sentence, None where all is well; code and values are for a sentence in other words."""

    problem: str | None
    problem_code: ErrorCode | None
    problem_params: Mapping[str, ParamValue]


def problem_parts(problem: GatewayError | None) -> tuple[str | None, ErrorCode | None, Mapping[str, ParamValue]]:
    """The three values of a MapProblem."""
    return (None, None, {}) if problem is None else (problem.detail, problem.code, numbers_of(problem.params))


@dataclass(frozen=True, slots=True)
class MapImport(MapProblem):
    """A file on its way into the folder. `percent` of the receiving, then of the converting; `layer`: its id in the
    list once it is there."""

    id: str
    name: str
    state: ImportState
    bytes: int
    total_bytes: int | None
    percent: int | None
    layer: str | None


@dataclass(frozen=True, slots=True)
class FieldProof(Shape):
    """What a whole file holds: tiles, their bytes, and the digest of its manifest."""

    tiles: int
    bytes: int
    sha256: str


@dataclass(frozen=True, slots=True)
class FieldSourceName(Shape):
    """Which source a kind comes from."""

    kind: FieldKind
    name: str


@dataclass(frozen=True, slots=True)
class PreparedField(MapProblem):
    """A field on its way. `percent`: of what is made of the heights. `waits_s`: the source is asked again then;
    `problem` says why. `layer`: one of its layers once it is done."""

    id: str
    name: str
    state: Literal["running", "paused", "failed", "done", "removed"]
    doing: FieldStep
    percent: int | None
    layer: str | None
    sources: list[FieldSourceName]
    tiles: int
    tiles_total: int
    tiles_missing: int
    bytes: int
    bytes_total: int
    bytes_per_s: int
    left_s: int | None
    retries: int
    waits_s: float | None
