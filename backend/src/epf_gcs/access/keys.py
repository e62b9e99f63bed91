"""Keys: how they look, how they are made, and what is kept of them.

A program's key is `epf_<8 hex digits>_<43 letters>`, 256 random bits; a one-time key `XXXX-XXXX-XXXX-XXXX` is for
people to type, 80 random bits. Nobody guesses them, so a digest is kept of them and a right one is known at once: a
slow hash would make those who have it wait for the guesses of others.
"""

from __future__ import annotations

import hashlib
import hmac
import re
import secrets
from typing import Final, NamedTuple

# Crockford's base 32: without letters that are taken for digits.
_LETTERS: Final = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
_ONE_TIME_KEY: Final = re.compile(f"[{_LETTERS}]{{16}}")
_MISREAD: Final = str.maketrans({"O": "0", "I": "1", "L": "1", "U": "V", "-": None, " ": None, "\t": None, "\n": None})
_GROUP: Final = 4
MAX_KEY: Final = 200
"""Longest text that is looked at as a key."""


class Parts(NamedTuple):
    """What finds the digest of a one-time key, and what is held against it."""

    lookup: str
    secret: str


def new_program_key() -> tuple[str, str]:
    """A key, and the id of its program, which is no secret."""
    program_id = secrets.token_hex(4)
    return f"epf_{program_id}_{secrets.token_urlsafe(32)}", program_id


def new_one_time_key() -> tuple[str, Parts]:
    """A key of 80 bits as people type it, and its parts."""
    letters = "".join(secrets.choice(_LETTERS) for _ in range(4 * _GROUP))
    groups = [letters[start : start + _GROUP] for start in range(0, len(letters), _GROUP)]
    return "-".join(groups), Parts(groups[0], letters[_GROUP:])


def one_time_key(text: str) -> Parts | None:
    """The parts of a one-time key, also if it was typed in small letters or without dashes; None if it is none."""
    letters = text[:MAX_KEY].upper().translate(_MISREAD)
    return Parts(letters[:_GROUP], letters[_GROUP:]) if _ONE_TIME_KEY.fullmatch(letters) else None


def fits(kept: str, secret: str) -> bool:
    """Whether this secret has this digest. The time tells nothing of either."""
    return hmac.compare_digest(kept, digest_of(secret))


def new_cookie() -> str:
    """256 random bits for a session's cookie."""
    return secrets.token_urlsafe(32)


def digest_of(text: str) -> str:
    """SHA-256 in hex, for texts that cannot be guessed. The time of a look-up by it tells nothing of the text."""
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
