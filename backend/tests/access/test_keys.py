"""Keys as people type them and as programs send them."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.access.keys import (
    digest_of,
    fits,
    new_cookie,
    new_one_time_key,
    new_program_key,
    one_time_key,
)


def test_a_key_has_its_form_and_is_another_each_time() -> None:
    made = [new_one_time_key() for _ in range(100)]
    assert len({key for key, _ in made}) == 100
    for key, parts in made:
        assert re.fullmatch("([0-9A-HJKMNP-TV-Z]{4}-){3}[0-9A-HJKMNP-TV-Z]{4}", key)
        assert one_time_key(key) == parts
        assert parts.lookup + parts.secret == key.replace("-", "")
    key, program_id = new_program_key()
    assert re.fullmatch(f"epf_{program_id}_[A-Za-z0-9_-]{{43}}", key)
    assert len(new_cookie()) == 43


@pytest.mark.parametrize("typed", ["0o1i-l234-5678-9abc", "0O1IL23456789ABC", " 0o1i l234 5678 9abc "])
def test_letters_that_look_alike_are_the_same(typed: str) -> None:
    assert one_time_key(typed) == one_time_key("0011-1234-5678-9ABC")


@given(st.text())
def test_any_other_text_is_no_key(text: str) -> None:
    parts = one_time_key(text)
    assert parts is None or len(parts.lookup + parts.secret) == 16
    assert len(digest_of(text)) == 64


def test_what_is_kept_fits_its_secret_alone() -> None:
    kept = digest_of("secret")
    assert fits(kept, "secret")
    for wrong in ("Secret", "", "secret\0"):
        assert not fits(kept, wrong)
    assert not fits("rubbish", "secret")
