"""The station's figures in Prometheus' text format 0.0.4. A pure function of the status.

A value that is not known is left out, as the format has it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final, Literal, NamedTuple

from epf_gcs.contract.status import BoardStatus, RecordingState, SimulatorStatus, Status, TopicHealth
from epf_gcs.web.state.figures import Disk, WebFigures

MEDIA_TYPE: Final = "text/plain; version=0.0.4; charset=utf-8"
_STATES: Final = ("closed", "opening", "open", "lost")


class _Family(NamedTuple):
    name: str
    kind: Literal["counter", "gauge"]
    about: str
    samples: list[tuple[Mapping[str, str], float]]


def metrics(status: Status | None, disk: Disk | None, web: WebFigures) -> str:
    """`status` None: the flight process does not answer, and its figures are left out."""
    families = [
        _one("epf_flight_up", "gauge", "Whether the flight process answers.", float(status is not None)),
        *_of_web(web),
        *_of_disk(disk),
    ]
    if status is not None:
        families += [
            *_of_board(status.board),
            *_of_topics(status.topics),
            *_of_simulator(status.simulator),
            *_of_recording(status.recording),
            *_of_station(status),
        ]
    return "".join(_text(family) for family in families if family.samples)


def _of_board(board: BoardStatus) -> Iterable[_Family]:
    yield _states("epf_board_link", "State of the board's link.", board.state)
    yield _one("epf_board_link_reopened_total", "counter", "Times the board's link came back.", board.reopened)
    yield _one("epf_board_frames_total", "counter", "Whole frames of the board.", board.frames_received)
    yield _one("epf_board_frames_damaged_total", "counter", "Damaged frames of the board.", board.frames_damaged)
    yield _by("epf_board_damage_total", "counter", "Damage on the board's line by kind.", "kind", board.damage)
    yield _one("epf_board_received_bytes_total", "counter", "Bytes from the board.", board.bytes_in)
    yield _one("epf_board_sent_bytes_total", "counter", "Bytes to the board.", board.bytes_out)
    yield _one("epf_board_heartbeat_age_seconds", "gauge", "Age of the board's heartbeat.", board.heartbeat_age_s)


def _of_topics(topics: Mapping[str, TopicHealth]) -> Iterable[_Family]:
    counts = {topic: health.count for topic, health in topics.items()}
    ages_s = {topic: health.age_s for topic, health in topics.items()}
    rates_hz = {topic: health.rate_hz for topic, health in topics.items()}
    yield _by("epf_topic_samples_total", "counter", "Samples of each topic.", "topic", counts)
    yield _by("epf_topic_age_seconds", "gauge", "Age of each topic's newest sample.", "topic", ages_s)
    yield _by("epf_topic_rate_hertz", "gauge", "Samples a second of each topic.", "topic", rates_hz)


def _of_simulator(simulator: SimulatorStatus) -> Iterable[_Family]:
    yield _states("epf_simulator_link", "State of the simulator's socket.", simulator.state)
    received, dropped = simulator.datagrams_received, simulator.drop_reasons
    yield _one("epf_simulator_datagrams_total", "counter", "Datagrams of the simulator.", received)
    yield _by("epf_simulator_datagrams_dropped_total", "counter", "Datagrams dropped, by reason.", "reason", dropped)
    to_board, to_simulator = simulator.frames_to_board, simulator.frames_to_simulator
    yield _one("epf_hil_frames_to_board_total", "counter", "HIL frames to the board.", to_board)
    yield _one("epf_hil_frames_to_simulator_total", "counter", "HIL datagrams to the simulator.", to_simulator)
    skipped = simulator.frames_skipped
    yield _by("epf_hil_frames_skipped_total", "counter", "HIL frames that were not sent, by reason.", "reason", skipped)
    trip = simulator.hil_round_trip_ms
    seconds = {"0.5": _seconds(trip.p50), "0.99": _seconds(trip.p99)}
    yield _by("epf_hil_round_trip_seconds", "gauge", "HIL round trip of the last frames.", "quantile", seconds)


def _of_recording(recording: RecordingState) -> Iterable[_Family]:
    yield _one("epf_recording_active", "gauge", "Whether a recording is being written.", float(recording.active))
    yield _one("epf_recording_bytes_total", "counter", "Bytes of the recording being written.", recording.bytes)
    left = recording.hours_left
    yield _one("epf_recording_hours_left", "gauge", "Hours that the disk's room lasts at this rate.", left)
    lost = recording.bytes_lost
    yield _one("epf_recording_lost_bytes_total", "counter", "Bytes that could not be recorded.", lost)


def _of_station(status: Status) -> Iterable[_Family]:
    levels = {"warning": 0, "critical": 0}
    for alarm in status.alarms:
        levels[alarm.level] += 1
    yield _by("epf_alarms", "gauge", "Alarms that are active, by level.", "level", levels)
    yield _by("epf_errors_total", "counter", "Errors by code.", "code", status.errors)
    yield _one("epf_viewers", "gauge", "Browsers on the stream.", status.viewers)


def _of_web(web: WebFigures) -> Iterable[_Family]:
    answers = {str(status): count for status, count in web.answers.items()}
    yield _by("epf_http_requests_total", "counter", "Requests that were answered, by status.", "status", answers)
    yield _one("epf_http_connections", "gauge", "Connections, WebSockets among them.", web.connections)
    yield _one("epf_http_sockets", "gauge", "WebSockets.", web.sockets)
    yield _by("epf_http_refused_total", "counter", "What there was no place for.", "what", web.refused)


def _of_disk(disk: Disk | None) -> Iterable[_Family]:
    if disk is not None:
        yield _one("epf_disk_free_bytes", "gauge", "Free on the data folder's disk.", disk.free_bytes)
        yield _one("epf_disk_size_bytes", "gauge", "Size of the data folder's disk.", disk.total_bytes)


def _seconds(ms: float | None) -> float | None:
    return None if ms is None else ms / 1000.0


def _one(name: str, kind: Literal["counter", "gauge"], about: str, value: float | None) -> _Family:
    return _Family(name, kind, about, [] if value is None else [({}, value)])


def _by(
    name: str, kind: Literal["counter", "gauge"], about: str, label: str, values: Mapping[str, float | None]
) -> _Family:
    samples = [({label: key}, value) for key, value in sorted(values.items()) if value is not None]
    return _Family(name, kind, about, list(samples))


def _states(name: str, about: str, state: str) -> _Family:
    return _by(name, "gauge", about, "state", {one: float(one == state) for one in _STATES})


def _text(family: _Family) -> str:
    lines = [f"# HELP {family.name} {family.about}", f"# TYPE {family.name} {family.kind}"]
    for labels, value in family.samples:
        inside = ",".join(f'{key}="{_escaped(text)}"' for key, text in labels.items())
        lines.append(f"{family.name}{{{inside}}} {value:.17g}" if inside else f"{family.name} {value:.17g}")
    return "\n".join(lines) + "\n"


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace("\n", "\\n").replace('"', '\\"')
