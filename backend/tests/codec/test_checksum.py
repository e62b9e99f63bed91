"""The checksum makes all words of type, payload and checksum sum to zero."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.codec.checksum import checksum


def test_captured_checksums() -> None:
    assert checksum(bytes.fromhex("25000000")) == 0xFFFFFFDB
    assert checksum(bytes.fromhex("00000080" + "00" * 12)) == 0x80000000
    assert checksum(bytes.fromhex("010000800000c03f")) == (-(0x80000001 + 0x3FC00000)) & 0xFFFFFFFF


@given(st.lists(st.integers(0, 0xFFFFFFFF), min_size=1, max_size=60))
def test_all_words_sum_to_zero(words: list[int]) -> None:
    body = b"".join(word.to_bytes(4, "little") for word in words)
    assert (sum(words) + checksum(body)) % (1 << 32) == 0


def test_a_body_longer_than_any_message_sums_to_zero_too() -> None:
    for words in (31, 32, 33, 34, 35, 100, 1000):
        body = b"".join((0x01020304 * index & 0xFFFFFFFF).to_bytes(4, "little") for index in range(1, words + 1))
        total = sum(int.from_bytes(body[at : at + 4], "little") for at in range(0, len(body), 4))
        assert (total + checksum(body)) & 0xFFFFFFFF == 0
