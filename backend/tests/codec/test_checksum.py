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
