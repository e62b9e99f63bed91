"""The simulator's datagrams of a recording -> the topics that live gives: `simulator`, `xplane_info`, `xplane_rows`.

A simulator sends the same rows in each datagram, so the datagrams of one length with the same row numbers are read
together. Where every one of a stretch is a whole frame, its values are the live ones; any other goes one by one
through the live gatherer.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from epf_gcs.codec.messages_gen import DATAGRAM_MAGIC, NO_VALUE, VALUES_PER_ROW, XPLANE_ROWS
from epf_gcs.flights.convert import T_NS
from epf_gcs.recordings.parts import Messages
from epf_gcs.xplane.datagram import Eight, parse
from epf_gcs.xplane.gather import Gatherer
from epf_gcs.xplane.mapping import INFO_SOURCES, XplaneInfo, in_our_unit, row_meaning
from epf_gcs.xplane.whole import WholeFrames

_PREFIX: Final = len(DATAGRAM_MAGIC) + 1
_RECORD: Final = np.dtype([("row", "<i4"), ("values", "<f4", (VALUES_PER_ROW,))])
_ROW_AGE_NS: Final = 1_000_000_000
_SHOW_EVERY_NS: Final = 20_000_000
_RAW_EVERY_NS: Final = 200_000_000
_MOST_ROWS: Final = 256
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
SIMULATOR: Final = pa.schema([T_NS, *(pa.field(name, pa.float64(), metadata={"unit": u}) for name, u in UNITS.items())])
INFO: Final = pa.schema(
    [T_NS, *(pa.field(name, pa.float64(), metadata={"unit": unit}) for name, unit in INFO_UNITS.items())]
)
ROWS: Final = pa.schema(
    [T_NS, pa.field("row", pa.int32(), nullable=False)]
    + [pa.field(f"value_{index}", pa.float32()) for index in range(VALUES_PER_ROW)]
)


class Shown(NamedTuple):
    """The tables of some datagrams, by topic."""

    tables: dict[str, pa.Table]
    datagrams: int


class Datagrams:
    """Takes the datagrams of a recording in order; `begin` when another simulator is opened."""

    def __init__(self) -> None:
        self.begin("xp10")

    def begin(self, profile: str) -> None:
        """A simulator of this profile begins: forget the earlier one's rows."""
        self._profile = profile if profile in XPLANE_ROWS else "xp10"
        self._gatherer = Gatherer(self._profile)
        self._whole = WholeFrames(self._profile)
        self._rows: dict[int, tuple[int, Eight]] = {}
        self._shown_ns = self._raw_shown_ns = -(1 << 62)

    def take(self, messages: Messages) -> Shown:
        """Read datagrams (all of the simulator's channel). Never raises, whatever they hold."""
        pieces: dict[str, list[pa.Table]] = {"simulator": [], "xplane_info": [], "xplane_rows": []}
        lengths = messages.length
        edges = np.flatnonzero(np.diff(lengths)) + 1
        for begin, end in zip([0, *edges.tolist()], [*edges.tolist(), len(lengths)], strict=True):
            if begin < end:
                self._stretch(messages, begin, end, pieces)
        return Shown({topic: pa.concat_tables(some) for topic, some in pieces.items() if some}, len(lengths))

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
            if usual.all() and self._bulk(messages.t_ns[begin:end], records, pieces):
                return
        self._one_by_one(messages, begin, end, pieces)

    def _bulk(self, t_ns: NDArray[np.int64], records: NDArray[Any], pieces: dict[str, list[pa.Table]]) -> bool:
        """Read datagrams with the same rows together; False if one of them is no whole frame."""
        numbers = records["row"][0].tolist()
        infos = [self._whole.read(_datagram(records[index])) for index in (0, -1)]
        known = set(numbers)
        if None in infos or len(known) < len(numbers) or self._remains_of_others(known, int(t_ns[0])):
            return False
        columns: dict[str, Floats] = {}
        nulls: dict[str, NDArray[np.bool_]] = {}
        for place, number in enumerate(numbers):
            self._read_row(number, records["values"][:, place], columns, nulls)
        whole = {
            field: ("horizontal_path_deg" if field == "yaw_deg" else name) for field, (_, name) in INFO_SOURCES.items()
        }
        if any(name not in columns or nulls[name].any() for name in whole.values()):
            return False
        inside = self._inside(numbers, records)
        if not inside:
            return False
        none = np.zeros(len(t_ns))
        missing = np.ones(len(t_ns), dtype=bool)
        arrays = [pa.array(columns.get(name, none), mask=nulls.get(name, missing)) for name in UNITS]
        pieces["simulator"].append(pa.Table.from_arrays([pa.array(t_ns), *arrays], schema=SIMULATOR))
        info = [pa.array(columns[name]) for name in whole.values()]
        pieces["xplane_info"].append(pa.Table.from_arrays([pa.array(t_ns), *info], schema=INFO))
        self._show_raw(t_ns, numbers, records, pieces)
        self._shown_ns = int(t_ns[-1])
        self._rows = {
            number: (int(t_ns[-1]), tuple(records["values"][-1, place].tolist()))
            for place, number in enumerate(numbers)
        }
        return True

    def _remains_of_others(self, numbers: set[int], now_ns: int) -> bool:
        """Whether rows that these datagrams do not have were heard just before, and are shown with them."""
        return any(now_ns - t_ns <= _ROW_AGE_NS for number, (t_ns, _) in self._rows.items() if number not in numbers)

    def _inside(self, numbers: list[int], records: NDArray[Any]) -> bool:
        """Whether all values that a whole frame needs are within the simulator's limits, as `WholeFrames` asks."""
        sources = {(18, "horizontal_path_deg"), *(INFO_SOURCES[field] for field in INFO_SOURCES if field != "yaw_deg")}
        for number, name in sources:
            for wanted in XPLANE_ROWS[self._profile][number].values:
                if in_our_unit(wanted)[0] == name:
                    raw = records["values"][:, numbers.index(number), wanted.index]
                    if not ((raw >= wanted.minimum) & (raw <= wanted.maximum) & (raw != NO_VALUE)).all():
                        return False
        return True

    def _read_row(
        self, number: int, eight: NDArray[np.float32], columns: dict[str, Floats], nulls: dict[str, NDArray[np.bool_]]
    ) -> None:
        """As `row_meaning`, for many."""
        definition = XPLANE_ROWS[self._profile].get(number)
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
    ) -> None:
        chosen: list[int] = []
        index = int(np.searchsorted(t_ns, self._raw_shown_ns + _RAW_EVERY_NS))
        while index < len(t_ns):
            chosen.append(index)
            self._raw_shown_ns = int(t_ns[index])
            index = max(index + 1, int(np.searchsorted(t_ns, self._raw_shown_ns + _RAW_EVERY_NS)))
        if not chosen:
            return
        order = np.argsort(numbers)
        values = records["values"][chosen][:, order].reshape(-1, VALUES_PER_ROW)
        arrays = [
            pa.array(np.repeat(t_ns[chosen], len(numbers))),
            pa.array(np.tile(np.array(numbers, dtype=np.int32)[order], len(chosen))),
            *(pa.array(np.ascontiguousarray(values[:, index])) for index in range(VALUES_PER_ROW)),
        ]
        pieces["xplane_rows"].append(pa.Table.from_arrays(arrays, schema=ROWS))

    def _one_by_one(self, messages: Messages, begin: int, end: int, pieces: dict[str, list[pa.Table]]) -> None:
        simulator: list[dict[str, Any]] = []
        infos: list[dict[str, Any]] = []
        raw: list[dict[str, Any]] = []
        view = messages.data.data
        for index in range(begin, end):
            start, t_ns = int(messages.start[index]), int(messages.t_ns[index])
            self._one(bytes(view[start : start + int(messages.length[index])]), t_ns, simulator, infos, raw)
        for topic, rows, shape in (
            ("simulator", simulator, SIMULATOR),
            ("xplane_info", infos, INFO),
            ("xplane_rows", raw, ROWS),
        ):
            if rows:
                pieces[topic].append(pa.Table.from_pylist(rows, schema=shape))

    def _one(
        self, datagram: bytes, t_ns: int, simulator: list[dict[str, Any]], infos: list[dict[str, Any]], raw: list[Any]
    ) -> None:
        """One datagram as live takes it; what a loop of events would show together is shown one by one."""
        records = parse(datagram)
        if records is None:
            return
        info: XplaneInfo | None = self._whole.read(datagram) or self._gatherer.take(records, t_ns * 1e-9)
        for number, values in records:
            if number in self._rows or len(self._rows) < _MOST_ROWS:
                self._rows[number] = (t_ns, values)
        if info is None and t_ns - self._shown_ns < _SHOW_EVERY_NS:
            return
        self._shown_ns = t_ns
        live = {number: values for number, (heard_ns, values) in self._rows.items() if t_ns - heard_ns <= _ROW_AGE_NS}
        named: dict[str, Any] = {"t_ns": t_ns}
        for number, values in live.items():
            named.update(row_meaning(number, values, self._profile).values)
        simulator.append(named)
        if info is not None:
            infos.append({"t_ns": t_ns, **info._asdict()})
        if t_ns - self._raw_shown_ns >= _RAW_EVERY_NS:
            self._raw_shown_ns = t_ns
            for number, values in sorted(live.items()):
                raw.append({"t_ns": t_ns, "row": number} | {f"value_{slot}": one for slot, one in enumerate(values)})


def _datagram(records: NDArray[Any]) -> bytes:
    return DATAGRAM_MAGIC + b"@" + records.tobytes()
