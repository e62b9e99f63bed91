"""Who shakes hands over and over is turned away before it costs us anything, and nobody else is."""

from __future__ import annotations

import ssl
from contextlib import closing
from pathlib import Path

import pytest

from epf_gcs.tls.context import make_context
from epf_gcs.web.serving.handshakes import ALL_AT_ONCE, AT_ONCE, MOST_REMEMBERED, PER_S, Handshakes
from tests.support.tls import LOOPS, careless, open_door, self_signed
from tests.support.waiting import eventually


def begun(handshakes: Handshakes, host: str, tries: int, now_s: float = 0.0) -> int:
    return sum(handshakes.begin(host, now_s) for _ in range(tries))


def test_a_host_that_goes_on_and_on_is_slowed_down_and_a_class_is_not() -> None:
    handshakes = Handshakes()
    assert begun(handshakes, "10.0.0.1", 120) == 120
    assert begun(handshakes, "10.0.0.2", 2000) == AT_ONCE
    assert begun(handshakes, "10.0.0.2", 2000, 1.0) == PER_S
    assert begun(handshakes, "10.0.0.3", 6, 1.0) == 6


def test_a_network_of_addresses_is_one_host() -> None:
    handshakes = Handshakes()
    assert sum(handshakes.begin(f"2001:db8::{number:x}", 0.0) for number in range(1000)) == AT_ONCE


def test_all_together_have_a_limit_and_take_bounded_room() -> None:
    handshakes = Handshakes()
    tried = MOST_REMEMBERED + 100
    hosts = [f"10.{number >> 16}.{number >> 8 & 255}.{number & 255}" for number in range(tried)]
    assert sum(handshakes.begin(host, 0.0) for host in hosts) == ALL_AT_ONCE
    assert len(handshakes._of) == MOST_REMEMBERED


def test_this_computer_is_not_limited() -> None:
    assert begun(Handshakes(), "127.0.0.1", 5000) == 5000


@pytest.mark.parametrize("kind", LOOPS)
def test_one_too_many_is_ended_before_its_handshake_and_plain_text_is_answered(kind: str, tmp_path: Path) -> None:
    class Two(Handshakes):
        left = 2

        def begin(self, host: str, now_s: float) -> bool:
            self.left -= 1
            return self.left >= 0

    with open_door(kind, make_context(*self_signed(tmp_path)), handshakes=Two()) as door:
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
