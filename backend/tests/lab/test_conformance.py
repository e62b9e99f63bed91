"""A board of another make, written from the page of the protocol alone, learns what it lacks."""

from __future__ import annotations

import socket
import struct
import threading
import zlib
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import pytest

from epf_gcs.codec.description import FieldRow, KnownRow, TopicRow, packed_rows
from epf_gcs.lab import checks_of_description
from epf_gcs.lab.checks_of_description import DESCRIBED
from epf_gcs.lab.conformance import conform
from epf_gcs.lab.peer import Lack, LawsWire, Peer, TcpWire, wire
from tests.support.fake_board import own_row

HEAD, END, TOP_BIT = b"\rQT,", b"\r\n\r\n", 0x80000000
SIZES = {50: 60, 55: 4, 58: 8, **dict.fromkeys((46, 47, 48), 4), **dict.fromkeys(range(60, 77), 4)}
STREAMS = {5: ("ahrs", 6, 1, 12), 7: ("inertial", 7, 2, 36), 22: ("analog", 8, 3, 40), 24: ("statistics", 5, 8, 4),
           26: ("gps", 4, 9, 32), 28: ("servos_in", 3, 4, 48), 30: ("fly_by_wire", 9, 5, 16)}  # fmt: skip
OFF = {6: 5, 21: 7, 23: 22, 25: 24, 27: 26, 29: 28, 31: 30}
DEFAULTS = [0.06, 0.06, 0.1, 2.0, 0.8, 2.0, 700.0, 0.5, 30.0, 0.2, 40.0, 0.1, 35.0, 0.6, 1.0, 0.6, 1.0]
# Where the gain of command 60, 61 ... stands in message 11.
PLACES = [14, 15, 16, 13, 7, 8, 9, 10, 11, 12, 6, 5, 4, 3, 2, 1, 0]


class Stranger:
    """A board without extensions and without plans; it splits the line at the end mark, as the page says not to."""

    def __init__(self) -> None:
        self.is_open = False
        self.on: set[int] = set()
        self.flags = [0] * 12
        self.gains = list(DEFAULTS)
        self.buffer = b""

    def take(self, data: bytes) -> bytes:
        self.buffer += data
        out = b""
        if b"#QT\n" in self.buffer:
            self.is_open = True
            self.buffer = self.buffer.replace(b"#QT\n", b"")
        while END in self.buffer:
            frame, _, self.buffer = self.buffer.partition(END)
            begin = frame.rfind(b"#QT,")
            if begin >= 0:
                out += self.handle(frame[begin + 4 :])
        return out

    def handle(self, body: bytes) -> bytes:
        if len(body) < 8 or len(body) % 4 or sum(struct.unpack(f"<{len(body) // 4}I", body)) % 2**32:
            return b""
        (kind,) = struct.unpack_from("<I", body)
        payload = body[4:-4]
        if len(payload) != SIZES.get(kind, 0):
            return b""
        return self.do(kind, payload)

    def do(self, kind: int, payload: bytes) -> bytes:
        if kind in STREAMS:
            self.on.add(kind)
        elif kind in OFF:
            self.on.discard(OFF[kind])
        elif kind in (1, 4):
            self.on.clear()
        elif kind == 2:
            self.on.update(STREAMS)
        elif kind == 3:
            return b"".join(self.stream(one) for one in STREAMS)
        elif kind == 49:
            self.is_open = False
        elif kind == 50:
            _, aileron, *_ = struct.unpack("<15f", payload)
            return frame(10, struct.pack("<4f", 0.0, aileron, 0.0, 0.5))
        elif kind == 59:
            return frame(11, struct.pack("<6fi10f", *self.gains[:6], round(self.gains[6]), *self.gains[7:]))
        else:
            self.set(kind, payload)
        return b""

    def set(self, kind: int, payload: bytes) -> None:
        if 60 <= kind <= 76:
            (value,) = struct.unpack("<i" if kind == 70 else "<f", payload)
            self.gains[PLACES[kind - 60]] = value
        elif kind == 55:
            self.flags[10] = self.flags[10] & 1 | payload[0] << 1

    def tick(self) -> bytes:
        if not self.is_open:
            return b""
        for kind, (_, flag, _, _) in STREAMS.items():
            self.flags[flag] = int(kind in self.on)
        return frame(0, bytes(self.flags)) + b"".join(self.stream(kind) for kind in self.on)

    @staticmethod
    def stream(kind: int) -> bytes:
        return frame(STREAMS[kind][2], bytes(STREAMS[kind][3]))


def frame(kind: int, payload: bytes) -> bytes:
    body = struct.pack("<I", TOP_BIT + kind) + payload
    total = -sum(struct.unpack(f"<{len(body) // 4}I", body)) % 2**32
    return HEAD + body + struct.pack("<I", total) + END


@pytest.fixture
def stranger() -> Iterator[str]:
    """Its address. It serves one station, and ticks whenever nothing comes for a moment."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            board = Stranger()
            with suppress(OSError), server.accept()[0] as line:
                line.settimeout(0.02)
                while True:
                    with suppress(TimeoutError):
                        data = line.recv(4096)
                        if not data:
                            return
                        line.sendall(board.take(data))
                    line.sendall(board.tick())

        served = threading.Thread(target=serve)
        served.start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}"
        served.join()


def test_a_board_of_another_make_learns_what_it_lacks(stranger: str) -> None:
    line = wire(stranger)
    assert isinstance(line, TcpWire)
    outcomes = {one.name: one.lacks for one in conform(line, patience_s=0.5)}
    line.close()
    lacks = {name: said for name, said in outcomes.items() if said is not None}
    assert set(lacks) == {
        "read all sends every stream once",
        "each route is loaded; waypoints go on and back",
        "control source, autopilot and autotrim show in the heartbeat",
        "values may look like a header or an end",
        "the rate of the parameter task is settable",
        "a reset starts it anew, with all streams off",
        "extensions: the capabilities are told, in version 1",
    }
    assert lacks["read all sends every stream once"] == "no fms_plan (type 0x6) came after command 3 (read all)"
    assert lacks["a reset starts it anew, with all streams off"].endswith("must be (0, 0), is (0, 2)")
    assert "without extensions it goes on as before it was asked for them" in outcomes


def test_the_laws_of_this_stations_board_lack_nothing_that_laws_do() -> None:
    line = LawsWire()
    assert [one for one in conform(line, is_program=False) if one.lacks is not None] == []
    line.close()


class Untrue(LawsWire):
    """A board whose answers of one type have another word than they should."""

    def __init__(self, kind: int, word: int) -> None:
        super().__init__()
        self._head = HEAD + struct.pack("<I", TOP_BIT + kind)
        self._word = word

    def receive(self, wait_s: float) -> bytes:
        data = bytearray(super().receive(wait_s))
        at = data.find(self._head)
        while at >= 0:
            first = at + len(HEAD)
            (word,) = struct.unpack_from("<I", data, first + 4 * self._word)
            struct.pack_into("<I", data, first + 4 * self._word, word ^ 0x20)
            end = data.index(END, first) - 4
            total = sum(struct.unpack_from(f"<{(end - first) // 4}I", data, first))
            struct.pack_into("<I", data, end, -total % 2**32)
            at = data.find(self._head, end)
        return bytes(data)


@pytest.mark.parametrize(
    ("check", "kind", "word", "said"),
    [
        pytest.param(0, 0x106, 2, "the CRC-32 in the description", id="another checksum"),
        pytest.param(0, 0x107, 1, "the numbers of the blocks", id="other blocks"),
        pytest.param(0, 0x107, 9, "the CRC-32 in the description", id="another table"),
        pytest.param(
            3, 0x1001, 5, "line_law with a value that cannot be.*is_slow", id="a topic with a value that cannot be"
        ),
        pytest.param(3, 0x1001, 0, "no frame of line_law", id="a topic that is not sent"),
        pytest.param(1, 0x108, 1, "the row in own_gain: must be 0, is 32", id="the value of another gain"),
        pytest.param(1, 0x108, 2, "the value of row 0 after it was set", id="another value"),
    ],
)
def test_a_board_that_describes_itself_wrongly_is_told_how(check: int, kind: int, word: int, said: str) -> None:
    line = Untrue(kind, word)
    peer = Peer(line, 0.5)
    peer.open()
    peer.command("capabilities")
    with pytest.raises(Lack, match=said):
        DESCRIBED[check][1](peer)
    line.close()


TOPIC = TopicRow(0, 0x1000, 500, "wind", "")
FIELD = FieldRow(0, 1, 1.0, 0.0, 360.0, "from_deg", "deg", "", "")


@pytest.mark.parametrize(
    ("check", "rows", "said"),
    [
        (0, [own_row(0, "Bad")], r"row 0 \(Bad\) of the description cannot be used: name"),
        (0, [own_row(0), own_row(1)], r"row 1 \(line_k_bank\) .*: name taken"),
        (0, [own_row(0, step=0.0)], r"row 0 \(line_k_bank\) .*: step"),
        (0, [own_row(0, type=6)], "type"),
        (0, [own_row(0, help="caf\xe9")], "text"),
        (2, [FIELD], r"row 0 \(from_deg\) .*: topic"),
        (2, [TOPIC], r"row 0 \(wind\) .*: fields"),
        (2, [replace(TOPIC, type_word=0xFFF), FIELD], "type word"),
        (2, [replace(TOPIC, period_ms=0), FIELD], "period"),
        (2, [TOPIC, FIELD, replace(TOPIC, name="more"), FIELD], "type word"),
        (2, [TOPIC, FIELD, replace(TOPIC, type_word=0x1001), FIELD], r"row 2 \(wind\) .*: name taken"),
        (2, [TOPIC, FIELD, FIELD], r"row 2 \(from_deg\) .*: name taken"),
        (2, [TOPIC, replace(FIELD, type=11)], r"row 1 \(from_deg\) .*: type"),
        (2, [TOPIC, replace(FIELD, scale=0.0)], "scale"),
        (2, [TOPIC, replace(FIELD, minimum=361.0)], "range"),
    ],
)
def test_a_table_that_breaks_a_rule_is_told_which(
    monkeypatch: pytest.MonkeyPatch, check: int, rows: list[KnownRow], said: str
) -> None:
    table = packed_rows(rows)
    monkeypatch.setattr(checks_of_description, "_table", lambda _: (table, b"", zlib.crc32(table)))
    line = LawsWire()
    with pytest.raises(Lack, match=said):
        DESCRIBED[check][1](Peer(line, 0.1))
    line.close()


def test_a_line_on_which_nobody_answers_is_told_once() -> None:
    class Silent(LawsWire):
        def send(self, data: bytes) -> None:
            pass

        def receive(self, wait_s: float) -> bytes:
            super().receive(wait_s)
            return b""

    line = Silent()
    (only,) = conform(line)
    assert only.lacks == "no heartbeat came after #QT and a line feed"
    with pytest.raises(Lack, match="was not acknowledged"):
        Peer(line, 0.1).result("ahrs_on")
    line.close()
