"""The language of a file that names none: the browser's, English for everybody else."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from epf_gcs.web.interface.language import preferred_language


@pytest.mark.parametrize(
    ("header", "language"),
    [
        ("es-ES,es;q=0.9", "es"),
        ("en-US,en;q=0.9,es;q=0.8", "en"),
        ("en;q=0.3, ES-mx;q=0.7", "es"),
        ("ca-ES,es;q=0.9,en;q=0.8", "es"),
        ("de-DE,de;q=0.9", "en"),
        ("est", "en"),
        ("es;q=0", "en"),
        ("es;q=many", "en"),
        ("*", "en"),
        ("", "en"),
        (None, "en"),
    ],
)
def test_the_browsers_first_language_of_ours_is_taken(header: str | None, language: str) -> None:
    assert preferred_language(header) == language


@given(st.text(alphabet="enst-;,=q0.1 naif", max_size=60))
def test_no_header_raises(header: str) -> None:
    assert preferred_language(header) in ("es", "en")
