"""In which language a file is made: what the address says, otherwise what the browser asks for."""

from __future__ import annotations

from typing import Annotated, Final, get_args

from fastapi import Depends, Header, Query

from epf_gcs.formats.kml_words import Language

_KNOWN: Final[dict[str, Language]] = {language: language for language in get_args(Language)}
_FOR_OTHERS: Final[Language] = "en"
_MOST_READ: Final = 1000


def preferred_language(accept_language: str | None) -> Language:
    """The first language of ours in an `Accept-Language` header; English for everybody else, and for no header."""
    weights: dict[Language, float] = {}
    for part in (accept_language or "")[:_MOST_READ].split(","):
        tag, _, weight = part.partition(";")
        language = _KNOWN.get(tag.strip().partition("-")[0].lower())
        if language is not None:
            weights.setdefault(language, _weight(weight))
    wanted = max(weights, key=lambda language: weights[language], default=_FOR_OTHERS)
    return wanted if weights.get(wanted, 0.0) > 0.0 else _FOR_OTHERS


async def _of_browser(accept_language: Annotated[str | None, Header(include_in_schema=False)] = None) -> Language:
    return preferred_language(accept_language)


BrowserLanguageDep = Annotated[Language, Depends(_of_browser)]


async def _asked_for(
    browser: BrowserLanguageDep,
    lang: Annotated[Language | None, Query(description="Language of its words; by default the browser's.")] = None,
) -> Language:
    return lang or browser


LanguageDep = Annotated[Language, Depends(_asked_for)]


def _weight(text: str) -> float:
    """Of `q=0.8`: 0.8. 1 where there is none, 0 where it is no weight."""
    name, _, value = text.strip().partition("=")
    if name.strip().lower() != "q":
        return 1.0
    try:
        return min(max(float(value), 0.0), 1.0)
    except ValueError:
        return 0.0
