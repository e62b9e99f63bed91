"""One port for both: the first byte decides. Connections that never finish their handshake hurt nobody."""

from __future__ import annotations

import gc
import socket
import ssl
from collections.abc import Iterator
from contextlib import ExitStack, closing
from dataclasses import replace
from pathlib import Path

import pytest

from epf_gcs.shares.holder import Standing
from epf_gcs.shares.rates import Flow, Rate
from epf_gcs.shares.table import SHARES, by_host
from epf_gcs.tls.context import make_context
from epf_gcs.web.serving.visitors import Limits
from tests.support.listening import everything
from tests.support.tls import LOOPS, Door, careless, open_door, self_signed
from tests.support.waiting import eventually

HELLO = b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc"
"""The beginning of a handshake."""


@pytest.fixture
def context(tmp_path: Path) -> ssl.SSLContext:
    return make_context(*self_signed(tmp_path))


@pytest.fixture(params=LOOPS)
def kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def door(kind: str, context: ssl.SSLContext) -> Iterator[Door]:
    with open_door(kind, context) as opened:
        yield opened


def test_the_first_byte_says_which_of_both_is_spoken(door: Door) -> None:
    with closing(door.connect()) as plain, closing(door.connect_tls(careless())) as encrypted:
        plain.sendall(b"GET /")
        encrypted.sendall(b"GET /")
        assert plain.recv(100) == b"plain GET /"
        assert encrypted.recv(100) == b"encrypted GET /"


def test_a_handshake_that_comes_byte_by_byte_is_finished(door: Door) -> None:
    with closing(door.connect()) as raw:
        raw.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        incoming, outgoing = ssl.MemoryBIO(), ssl.MemoryBIO()
        ours = careless().wrap_bio(incoming, outgoing)
        while True:
            try:
                ours.do_handshake()
                break
            except ssl.SSLWantReadError:
                for byte in outgoing.read():
                    raw.sendall(bytes([byte]))
                incoming.write(raw.recv(65536))
        ours.write(b"!")
        raw.sendall(outgoing.read())
        data = b""
        while not data:
            incoming.write(raw.recv(65536))
            try:
                data = ours.read()
            except ssl.SSLWantReadError:
                continue
        assert data == b"encrypted !"


def test_many_come_at_once_and_each_is_served(door: Door) -> None:
    with ExitStack() as opened:
        waiting = [opened.enter_context(closing(door.connect())) for _ in range(100)]
        for number, made in enumerate(waiting):
            made.sendall(b"%d" % number)
        assert [made.recv(100) for made in waiting] == [b"plain %d" % number for number in range(100)]
    eventually(lambda: len(door.visitors) == 0, "no place is held")


@pytest.mark.parametrize("first", [b"", HELLO])
def test_one_that_never_finishes_its_handshake_is_ended(kind: str, context: ssl.SSLContext, first: bytes) -> None:
    with open_door(kind, context, limits=Limits(handshake_s=0.2)) as door, closing(door.connect()) as made:
        made.sendall(first)
        everything(made)
        eventually(lambda: len(door.visitors) == 0, "its place is free")


def test_after_the_handshake_the_time_for_it_does_not_count(kind: str, context: ssl.SSLContext) -> None:
    with (
        open_door(kind, context, limits=Limits(handshake_s=0.5)) as door,
        closing(door.connect_tls(careless())) as made,
        closing(door.connect()) as silent,
    ):
        everything(silent)  # the same time is over for one that came later
        made.sendall(b"still here")
        assert made.recv(100) == b"encrypted still here"


def test_one_that_hangs_up_frees_its_place_at_once(door: Door) -> None:
    for first in (b"", HELLO, b"\x16"):
        door.connect().close()
        with closing(door.connect()) as made:
            made.sendall(first)
    eventually(lambda: len(door.visitors) == 0, "their places are free")


@pytest.mark.parametrize("nonsense", [b"\x16" + bytes(100), b"\x16\x03\x01\x00\x05hello", HELLO + b"\xff" * 600])
def test_nonsense_that_begins_like_a_handshake_is_ended_and_counted(door: Door, nonsense: bytes) -> None:
    with closing(door.connect()) as made:
        made.sendall(nonsense)
        assert b"plain" not in everything(made)
    eventually(lambda: door.visitors.refused["handshake"] == 1, "it is counted")


def test_a_client_that_does_not_trust_the_certificate_is_counted_and_others_come_in(door: Door) -> None:
    with pytest.raises(ssl.SSLCertVerificationError):
        door.connect_tls(ssl.create_default_context())
    eventually(lambda: len(door.visitors) == 0, "its place is free")
    with closing(door.connect_tls(careless())) as made:
        made.sendall(b"!")
        assert made.recv(100) == b"encrypted !"


def test_500_half_open_handshakes_lock_nobody_out(kind: str, context: ssl.SSLContext) -> None:
    shares = replace(SHARES, connections=by_host(each=200, strangers=800, others=1000, own=100))
    with open_door(kind, context, shares=shares) as door, ExitStack() as opened:
        for number in range(500):
            made = opened.enter_context(closing(door.connect()))
            made.sendall(HELLO if number % 2 else b"")
        with closing(door.connect_tls(careless())) as honest:
            honest.sendall(b"!")
            assert honest.recv(100) == b"encrypted !"
        assert len(door.visitors) <= 100
    eventually(lambda: len(door.visitors) == 0, "their places are free")


def test_at_the_limit_the_longest_waiting_one_makes_room(kind: str, context: ssl.SSLContext) -> None:
    shares = replace(SHARES, connections=by_host(each=200, strangers=800, others=1000, own=2))
    with (
        open_door(kind, context, shares=shares) as door,
        closing(door.connect()) as first,
        closing(door.connect()) as second,
    ):
        eventually(lambda: len(door.visitors) == 2, "both are in")
        first.sendall(HELLO)
        with closing(door.connect()) as third:
            everything(first)
            third.sendall(b"third")
            assert third.recv(100) == b"plain third"
        second.sendall(b"second")
        assert second.recv(100) == b"plain second"


def test_each_connection_gets_the_certificate_of_its_time(kind: str, tmp_path: Path) -> None:
    contexts = [make_context(*self_signed(tmp_path, name=name)) for name in ("first", "second")]
    now = contexts[:1]
    with open_door(kind, lambda: now[0]) as door, closing(door.connect_tls(careless())) as early:
        now[0] = contexts[1]
        with closing(door.connect_tls(careless())) as late:
            assert early.getpeercert(binary_form=True) != late.getpeercert(binary_form=True)
            for made in (early, late):
                made.sendall(b"!")
                assert made.recv(100) == b"encrypted !"


def test_the_listening_socket_outlives_the_doorway(kind: str, context: ssl.SSLContext) -> None:
    """As `epf-gcs` does it: a browser that comes while the web process starts again waits, and is served."""
    with closing(socket.create_server(("127.0.0.1", 0))) as listener:
        with open_door(kind, context, listener=listener.dup()) as door, closing(door.connect()) as made:
            made.sendall(b"1")
            assert made.recv(100) == b"plain 1"
        waiting = socket.create_connection(listener.getsockname())
        waiting.sendall(b"2")
        with open_door(kind, context, listener=listener.dup()), closing(waiting):
            assert waiting.recv(100) == b"plain 2"


def test_nothing_is_left_of_those_that_were_ended(kind: str, context: ssl.SSLContext) -> None:
    """No descriptor is closed twice or left open: both would show here, or as a warning."""
    shares = replace(SHARES, connections=by_host(each=200, strangers=800, others=1000, own=5))
    with open_door(kind, context, limits=Limits(handshake_s=0.3), shares=shares) as door:
        for number in range(40):
            with closing(door.connect()) as made:
                made.sendall((b"", HELLO, b"plain")[number % 3])
        eventually(lambda: len(door.visitors) == 0, "all are gone")
        with closing(door.connect_tls(careless())) as made:
            made.sendall(b"!")
            assert made.recv(100) == b"encrypted !"
    gc.collect()


def test_one_handshake_too_many_is_ended_before_it_costs_anything_and_plain_text_is_answered(
    kind: str, context: ssl.SSLContext
) -> None:
    shares = replace(SHARES, handshakes=Flow(each={Standing.own: Rate(0, 2)}, together={}))
    with open_door(kind, context, shares=shares) as door:
        for _ in range(2):
            with closing(door.connect_tls(careless())) as made:
                made.sendall(b"!")
                assert made.recv(100) == b"encrypted !"
        with pytest.raises((ssl.SSLError, OSError)):
            door.connect_tls(careless())
        eventually(lambda: door.visitors.refused["handshake"] == 1, "it is counted")
        with closing(door.connect()) as plain:
            plain.sendall(b"?")
            assert plain.recv(100) == b"plain ?"
