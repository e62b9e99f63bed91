"""The simulator's datagrams of a recording -> the topics that live gives: `simulator`, `xplane_info`, `xplane_rows`.

A simulator sends the same rows in each datagram, so the datagrams of one length with the same row numbers are read
together. Where every one of a stretch is a whole frame, its values are the live ones; any other goes one by one
through what makes the live samples.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final, NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from epf_gcs.codec.messages_gen import DATAGRAM_MAGIC, NO_VALUE, VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.contract.base import Values
from epf_gcs.flights.convert import DESCRIPTION, T_NS
from epf_gcs.recordings.parts import Messages
from epf_gcs.vehicle.simulator_samples import SimulatorSamples
from epf_gcs.xplane.mapping import INFO_SOURCES, NEEDED_ROWS, TRACK_NAME, TRACK_ROW, in_our_unit

_PREFIX: Final = len(DATAGRAM_MAGIC) + 1
_RECORD: Final = np.dtype([("row", "<i4"), ("values", "<f4", (VALUES_PER_ROW,))])
_RAW_EVERY_S: Final = 0.2  # as in vehicle/simulator_samples.py
_LOOK_AHEAD: Final = 64
_MOST_ROWS: Final = 64  # as in xplane/whole.py
_CLAMPED: Final = (8, 11, 25)

Floats = NDArray[np.float64]


def _units() -> dict[str, str]:
    found: dict[str, str] = {}
    for row in XPLANE_ROWS["xp10"].values():
        for value in row.values:
            name, scale = in_our_unit(value)
            found[name] = value.unit if scale == 1.0 else "rad/s"
    return found


UNITS: Final = _units()
INFO_UNITS: Final = {
    field: next(
        "rad/s" if in_our_unit(value)[1] != 1.0 else value.unit
        for value in XPLANE_ROWS["xp10"][row].values
        if in_our_unit(value)[0] == name
    )
    for field, (row, name) in INFO_SOURCES.items()
}


def _schema(units: dict[str, str]) -> pa.Schema:
    """Values as they came, single floats; those that are converted to our unit need more."""
    kinds = {name: pa.float64() if unit == "rad/s" else pa.float32() for name, unit in units.items()}
    return pa.schema([T_NS, *(pa.field(name, kinds[name], metadata={"unit": unit}) for name, unit in units.items())])


SIMULATOR: Final = _schema(UNITS)
INFO: Final = _schema(INFO_UNITS)
ROWS: Final = pa.schema(
    [T_NS, pa.field("row", pa.int32(), nullable=False)]
    + [pa.field(f"value_{index}", pa.float32()) for index in range(VALUES_PER_ROW)],
    metadata={
        DESCRIPTION: "The simulator's rows as they came, thinned: those of one datagram every 0.2 s. The topic "
        "simulator has the values of every datagram."
    },
)
"""A value that the simulator did not have is -999, as it came, until `without_no_value`."""

_SCHEMAS: Final = {"simulator": SIMULATOR, "xplane_info": INFO, "xplane_rows": ROWS}


def without_no_value(rows: pa.Table) -> pa.Table:
    """A table of raw rows in which a value that the simulator did not have is null."""
    for index, field in enumerate(rows.schema):
        if field.name.startswith("value_"):
            column = rows.column(index)
            known = pc.if_else(pc.equal(column, pa.scalar(NO_VALUE, pa.float32())), None, column)
            rows = rows.set_column(index, field, known)
    return rows


class DatagramTables(NamedTuple):
    """The tables of some datagrams, by topic."""

    tables: dict[str, pa.Table]
    datagrams: int


class Datagrams:
    """Takes the datagrams of a recording in order; `begin` when another simulator is opened."""

    def __init__(self) -> None:
        self._collector = _Collector()
        self._samples = SimulatorSamples(self._collector)

    def begin(self, profile: str) -> None:
        """A simulator of this profile begins: forget the earlier one's rows."""
        self._samples.begin("xp12" if profile == "xp12" else "xp10")

    def take(self, messages: Messages) -> DatagramTables:
        """Read datagrams (all of the simulator's channel). Never raises, whatever they hold."""
        pieces: dict[str, list[pa.Table]] = {"simulator": [], "xplane_info": [], "xplane_rows": []}
        lengths = messages.length
        edges = np.flatnonzero(np.diff(lengths)) + 1
        for begin, end in zip([0, *edges.tolist()], [*edges.tolist(), len(lengths)], strict=True):
            if begin < end:
                self._stretch(messages, begin, end, pieces)
        return DatagramTables({topic: pa.concat_tables(some) for topic, some in pieces.items() if some}, len(lengths))

    def _stretch(self, messages: Messages, begin: int, end: int, pieces: dict[str, list[pa.Table]]) -> None:
        length = int(messages.length[begin])
        count, rest = divmod(length - _PREFIX, _RECORD.itemsize)
        if not rest and count > 0 and end - begin > 1:
            rows = np.ndarray((len(messages.data) - length + 1,), f"V{length}", messages.data, 0, (1,))[
                messages.start[begin:end]
            ]
            raw = rows.view(np.uint8).reshape(end - begin, length)
            records = np.ascontiguousarray(raw[:, _PREFIX:]).view(_RECORD).reshape(end - begin, count)
            usual = (raw[:, : len(DATAGRAM_MAGIC)] == np.frombuffer(DATAGRAM_MAGIC, np.uint8)).all(axis=1)
            usual &= (records["row"] == records["row"][0]).all(axis=1)
            numbers = records["row"][0].tolist()
            usual &= self._whole_frames(numbers, records)
            edges = (np.flatnonzero(np.diff(usual)) + 1).tolist()
            for first, after in zip([0, *edges], [*edges, end - begin], strict=True):
                last = first
                if usual[first] and after - first > 1:
                    # The last one goes the live way, so that what is kept for the next datagram is what live keeps.
                    last = after - 1
                    stretch = slice(begin + first, begin + last)
                    if not self._bulk(messages.t_ns[stretch], numbers, records[first:last], pieces):
                        last = first
                self._one_by_one(messages, begin + last, begin + after, pieces)
            return
        self._one_by_one(messages, begin, end, pieces)

    def _bulk(
        self,
        t_ns: NDArray[np.int64],
        numbers: list[int],
        records: NDArray[Any],
        pieces: dict[str, list[pa.Table]],
    ) -> bool:
        """Read whole frames with the same rows together; False if rows of others are shown with them."""
        # Rows that these datagrams do not have, but that were heard just before.
        if not set(self._samples.rows(int(t_ns[0]) * 1e-9)) <= set(numbers):
            return False
        columns: dict[str, Floats] = {}
        nulls: dict[str, NDArray[np.bool_]] = {}
        for place, number in enumerate(numbers):
            self._read_row(number, records["values"][:, place], columns, nulls)
        whole = {field: (TRACK_NAME if field == "yaw_deg" else name) for field, (_, name) in INFO_SOURCES.items()}
        none = np.zeros(len(t_ns))
        missing = np.ones(len(t_ns), dtype=bool)
        arrays = [
            pa.array(columns.get(field.name, none).astype(_numpy(field)), mask=nulls.get(field.name, missing))
            for field in SIMULATOR
            if field.name in UNITS
        ]
        pieces["simulator"].append(pa.Table.from_arrays([pa.array(t_ns), *arrays], schema=SIMULATOR))
        info = [pa.array(columns[name].astype(_numpy(INFO.field(field)))) for field, name in whole.items()]
        pieces["xplane_info"].append(pa.Table.from_arrays([pa.array(t_ns), *info], schema=INFO))
        raw_shown_s = self._show_raw(t_ns, numbers, records, pieces)
        self._samples.shown(float(t_ns[-1]) * 1e-9, raw_shown_s)
        return True

    def _whole_frames(self, numbers: list[int], records: NDArray[Any]) -> NDArray[np.bool_]:
        """Which datagrams have all that the board is told, within the simulator's limits, as `WholeFrames` asks."""
        good = np.zeros(len(records), dtype=bool)
        if (
            len(set(numbers)) < len(numbers)
            or not NEEDED_ROWS | {TRACK_ROW} <= set(numbers)
            or len(numbers) > _MOST_ROWS
        ):
            return good
        good[:] = True
        sources = {(TRACK_ROW, TRACK_NAME), *(source for field, source in INFO_SOURCES.items() if field != "yaw_deg")}
        for number, name in sources:
            for wanted in XPLANE_ROWS[self._samples.profile][number].values:
                if in_our_unit(wanted)[0] == name:
                    raw = records["values"][:, numbers.index(number), wanted.index]
                    good &= (raw >= wanted.minimum) & (raw <= wanted.maximum) & (raw != NO_VALUE)
        return good

    def _read_row(
        self, number: int, eight: NDArray[np.float32], columns: dict[str, Floats], nulls: dict[str, NDArray[np.bool_]]
    ) -> None:
        """As `row_meaning`, for many."""
        definition = XPLANE_ROWS[self._samples.profile].get(number)
        for wanted in definition.values if definition else ():
            name, scale = in_our_unit(wanted)
            raw = eight[:, wanted.index].astype(np.float64)
            none = raw == NO_VALUE
            if number in _CLAMPED:
                raw = np.where(np.isfinite(raw), np.clip(raw, wanted.minimum, wanted.maximum), raw)
            nulls[name] = none | ~((raw >= wanted.minimum) & (raw <= wanted.maximum))
            columns[name] = raw * scale if scale != 1.0 else raw

    def _show_raw(
        self, t_ns: NDArray[np.int64], numbers: list[int], records: NDArray[Any], pieces: dict[str, list[pa.Table]]
    ) -> float:
        """Add the raw rows as often as live shows them; returns when that was last (Unix s)."""
        shown_s = self._samples.raw_shown_s
        t_s = t_ns * 1e-9
        chosen: list[int] = []
        index = 0
        while True:
            late = np.flatnonzero(t_s[index : index + _LOOK_AHEAD] - shown_s >= _RAW_EVERY_S)
            if not len(late):
                index += _LOOK_AHEAD
                if index >= len(t_s):
                    break
                continue
            index += int(late[0])
            chosen.append(index)
            shown_s = float(t_s[index])
            index += 1
        if not chosen:
            return shown_s
        order = np.argsort(numbers)
        values = records["values"][chosen][:, order].reshape(-1, VALUES_PER_ROW)
        arrays = [
            pa.array(np.repeat(t_ns[chosen], len(numbers))),
            pa.array(np.tile(np.array(numbers, dtype=np.int32)[order], len(chosen))),
            *(pa.array(np.ascontiguousarray(values[:, index])) for index in range(VALUES_PER_ROW)),
        ]
        pieces["xplane_rows"].append(pa.Table.from_arrays(arrays, schema=ROWS))
        return shown_s

    def _one_by_one(self, messages: Messages, begin: int, end: int, pieces: dict[str, list[pa.Table]]) -> None:
        view = messages.data.data
        for index in range(begin, end):
            start = int(messages.start[index])
            self._collector.t_ns = int(messages.t_ns[index])
            datagram = bytes(view[start : start + int(messages.length[index])])
            reading = self._samples.read(datagram, self._collector.t_ns * 1e-9)
            if reading is not None:
                self._samples.show(reading)
        self._collector.move_to(pieces)


def _numpy(field: pa.Field) -> type[Any]:
    return np.float32 if pa.types.is_float32(field.type) else np.float64


class _Collector:
    """Takes the samples of datagrams that are read one by one; see `epf_gcs.vehicle.telemetry.Telemetry`."""

    def __init__(self) -> None:
        self.t_ns = 0
        self._rows: dict[str, list[dict[str, Any]]] = {topic: [] for topic in _SCHEMAS}

    def take(self, topic: str, _t_s: float, values: Values, _implausible: Iterable[str] = ()) -> None:
        if topic == "xplane_rows":
            for row, eight in values["rows"].items():
                named = {f"value_{slot}": one for slot, one in enumerate(eight)}
                self._rows[topic].append({"t_ns": self.t_ns, "row": int(row), **named})
        else:
            self._rows[topic].append({"t_ns": self.t_ns, **values})

    def move_to(self, pieces: dict[str, list[pa.Table]]) -> None:
        """Hand out what was collected as tables."""
        for topic, rows in self._rows.items():
            if rows:
                pieces[topic].append(pa.Table.from_pylist(rows, schema=_SCHEMAS[topic]))
                self._rows[topic] = []
