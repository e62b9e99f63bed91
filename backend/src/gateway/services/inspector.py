"""What goes over the lines, counted and measured: made when somebody asks, from counters kept on the way."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any, Final

from gateway.codec.messages_gen import TELEMETRY, TELEMETRY_BY_NAME, XPLANE_ROWS
from gateway.services.simulator import CHANNEL_BYTES_PER_S
from gateway.services.station import Station
from gateway.vehicle.advice import Advice, MissingRow, Observed, Stream, advice
from gateway.vehicle.arrivals import Arrivals
from gateway.vehicle.health import TASK_OF_TOPIC
from gateway.vehicle.wanted import RATE_COMMANDS, STREAM_FLAGS
from gateway.xplane.datagram import Eight
from gateway.xplane.mapping import NEEDED_ROWS, TRACK_ROW

_EXPECTED_ROWS: Final = NEEDED_ROWS | {TRACK_ROW}
_SERVO_STREAMS: Final = ("servos_in", "fly_by_wire")
_FRAME_BYTES: Final = 16  # header, type, checksum and end
_LOOP_ALIVE_S: Final = 1.0
_SILENT_S: Final = 3.0
_STRANGERS_S: Final = 10.0


def build_inspector(station: Station) -> dict[str, Any]:
    """Plain values, ready for JSON; its shape is `gateway.api.inspector_schemas.Inspector`."""
    board = _board(station)
    link = _link(station)
    return {
        "t_s": station.clock.now_s(),
        "board": board,
        "rows": _rows(station),
        "link": link,
        "advice": [asdict(one) for one in _advice(station, board, link)],
    }


def _board(station: Station) -> list[dict[str, Any]]:
    now_s = station.clock.now_s()
    books = station.board.books
    known = [
        {
            "id": type_id,
            "name": message.name,
            "damaged": books.damaged[message.name],
            "stale_after_s": station.telemetry.stale_after_s(message.name) if message.topic else None,
            "values": books.heard[message.name].values,
            **_measured(books.heard[message.name], now_s),
        }
        for type_id, message in TELEMETRY.items()
    ]
    unknown = [
        {
            "id": type_id,
            "name": f"unknown_0x{type_id:x}",
            "damaged": books.unknown_damaged[type_id],
            "stale_after_s": None,
            "values": None,
            **_measured(arrivals, now_s),
        }
        for type_id, arrivals in sorted(books.unknown.items())
    ]
    return known + unknown


def _rows(station: Station) -> list[dict[str, Any]]:
    now_s = station.clock.steady_s()
    definitions = XPLANE_ROWS[station.hil.profile]
    heard = station.hil.arrivals
    return [
        {
            "row": row,
            "name": definitions[row].name if row in definitions else f"row_{row}",
            "expected": row in _EXPECTED_ROWS,
            "values": _finite(heard[row].values) if row in heard else None,
            **_measured(heard[row] if row in heard else Arrivals(), now_s),
        }
        for row in sorted({*definitions, *heard})
    ]


def _link(station: Station) -> dict[str, Any]:
    rates, board = station.rates, station.board
    capacity = board.baud / 10.0 if board.link is not None else None
    rx, tx, simulator = rates.board_in.per_s(), rates.board_out.per_s(), rates.simulator_in.per_s()
    return {
        "rx_bytes_per_s": round(rx, 1),
        "tx_bytes_per_s": round(tx, 1),
        "capacity_bytes_per_s": capacity,
        "rx_percent": _percent(rx, capacity),
        "tx_percent": _percent(tx, capacity),
        "simulator_bytes_per_s": round(simulator, 1),
        "simulator_percent": _percent(simulator, CHANNEL_BYTES_PER_S),
        "round_trip_ms": asdict(station.hil.round_trip.summary()),
        "round_trips": station.hil.round_trip.answers,
    }


def _advice(station: Station, board: list[dict[str, Any]], link: dict[str, Any]) -> list[Advice]:
    rate_hz: dict[str, float] = {frame["name"]: frame["rate_hz"] for frame in board}
    hil = station.hil
    wanted = station.memory.now.wanted
    is_open = station.board.is_open
    surfaces_s = hil.last_surfaces_s
    alive = surfaces_s is not None and station.clock.steady_s() - surfaces_s < _LOOP_ALIVE_S
    return advice(
        Observed(
            silent_target=_silent_target(station),
            rubbish_at_baud=_rubbish_at_baud(station),
            rx_percent=link["rx_percent"],
            tx_percent=link["tx_percent"],
            servos_percent=_percent(_servo_bytes_per_s(rate_hz), link["capacity_bytes_per_s"]),
            servos_ms=round(1000.0 * wanted.period_s(RATE_COMMANDS[2])),
            damaged_percent=station.watch.damaged_percent,
            damaged_limit_percent=station.alarms.thresholds["frames_damaged_percent"],
            streams=_streams(station, rate_hz) if is_open else (),
            silent_port=_silent_port(station),
            missing_rows=_missing_rows(station) if station.simulator.state == "open" else (),
            strangers=_strangers(station),
            round_trip_p99_ms=hil.round_trip.summary().p99 if alive else None,
        )
    )


def _silent_target(station: Station) -> str | None:
    address = station.supervisor.address
    if address is None:
        return None
    age_s = station.board.heartbeat_age_s()
    is_heard = station.board.link is not None and age_s is not None
    limit_s = max(_SILENT_S, station.telemetry.stale_after_s("heartbeat") or 0.0)
    return None if is_heard and age_s is not None and age_s <= limit_s else address.target


def _rubbish_at_baud(station: Station) -> int | None:
    address = station.supervisor.address
    is_rubbish = address is not None and address.scheme == "serial" and station.board.hears_only_rubbish
    return station.board.baud if is_rubbish else None


def _silent_port(station: Station) -> int | None:
    address = station.simulator.address
    is_silent = address is not None and station.simulator.state in ("opening", "lost")
    return address.receive_port if address is not None and is_silent else None


def _missing_rows(station: Station) -> list[MissingRow]:
    definitions = XPLANE_ROWS[station.hil.profile]
    return [MissingRow(row, definitions[row].name) for row in sorted(_EXPECTED_ROWS - set(station.hil.rows))]


def _strangers(station: Station) -> int:
    """How many datagrams of others came so far, as long as they keep coming."""
    last_s = station.simulator.last_stranger_s
    is_recent = last_s is not None and station.clock.steady_s() - last_s < _STRANGERS_S
    return station.simulator.dropped["stranger"] if is_recent else 0


def _streams(station: Station, rate_hz: dict[str, float]) -> list[Stream]:
    """The streams that the board says, or we asked, to be on, and what they should reach."""
    heartbeat = station.telemetry.newest("heartbeat") or {}
    wanted = station.memory.now.wanted.streams
    found: list[Stream] = []
    for topic in TASK_OF_TOPIC:
        flag = STREAM_FLAGS.get(topic)
        is_on = topic == "heartbeat" or (topic in wanted if flag is None else heartbeat.get(flag) is True)
        period_s = station.telemetry.commanded_s(topic)
        if is_on and period_s:
            found.append(Stream(topic, rate_hz[topic], 1.0 / period_s))
    return found


def _servo_bytes_per_s(rate_hz: dict[str, float]) -> float:
    return sum(rate_hz[name] * (TELEMETRY_BY_NAME[name].size + _FRAME_BYTES) for name in _SERVO_STREAMS)


def _measured(arrivals: Arrivals, now_s: float) -> dict[str, Any]:
    summary = arrivals.summary(now_s)
    return {
        "count": summary.count,
        "rate_hz": round(summary.rate_hz, 2),
        "jitter_ms": None if summary.jitter_ms is None else round(summary.jitter_ms, 3),
        "age_s": None if summary.age_s is None else round(summary.age_s, 3),
    }


def _finite(eight: Eight) -> list[float | None]:
    return [value if abs(value) < float("inf") else None for value in eight]


def _percent(bytes_per_s: float, full: float | None) -> float | None:
    return round(100.0 * bytes_per_s / full, 1) if full else None
