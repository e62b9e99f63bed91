"""Keys: how they look, how they are made, and what is kept of them.

A program's key is `epf_<8 hex digits>_<43 letters>`; a one-time key `XXXX-XXXX-XXXX-XXXX` is for people to type. The
part before the secret is no secret: it says which hash the rest is held against.
"""

from __future__ import annotations

import hashlib
import re
import secrets
from typing import Final, NamedTuple

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

_PROGRAM_KEY: Final = re.compile(r"epf_([0-9a-f]{8})_([A-Za-z0-9_-]{43})")
# Crockford's base 32: without letters that are taken for digits.
_LETTERS: Final = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
_ONE_TIME_KEY: Final = re.compile(f"[{_LETTERS}]{{16}}")
_MISREAD: Final = str.maketrans({"O": "0", "I": "1", "L": "1", "U": "V", "-": None, " ": None, "\t": None, "\n": None})
_GROUP: Final = 4
MAX_KEY: Final = 200
"""Longest text that is looked at as a key."""

# 19 MiB and two passes: what OWASP recommends for argon2id with one lane. About 30 ms of a core.
_HASHER: Final = PasswordHasher(time_cost=2, memory_cost=19456, parallelism=1)


class Parts(NamedTuple):
    """What finds the hash, and what is held against it."""

    lookup: str
    secret: str


def new_program_key() -> tuple[str, Parts]:
    """A key and its parts."""
    parts = Parts(secrets.token_hex(4), secrets.token_urlsafe(32))
    return f"epf_{parts.lookup}_{parts.secret}", parts


def program_key(text: str) -> Parts | None:
    """The parts of a program's key; None if the text has not that form."""
    found = _PROGRAM_KEY.fullmatch(text)
    return None if found is None else Parts(found[1], found[2])


def new_one_time_key() -> tuple[str, Parts]:
    """A key of 80 bits as people type it, and its parts."""
    letters = "".join(secrets.choice(_LETTERS) for _ in range(4 * _GROUP))
    groups = [letters[start : start + _GROUP] for start in range(0, len(letters), _GROUP)]
    return "-".join(groups), Parts(groups[0], letters[_GROUP:])


def one_time_key(text: str) -> Parts | None:
    """The parts of a one-time key, also if it was typed in small letters or without dashes; None if it is none."""
    letters = text[:MAX_KEY].upper().translate(_MISREAD)
    return Parts(letters[:_GROUP], letters[_GROUP:]) if _ONE_TIME_KEY.fullmatch(letters) else None


def hash_of(secret: str) -> str:
    """What is kept of a secret. Takes long: not on the event loop."""
    return _HASHER.hash(secret)


NO_HASH: Final = "$argon2id$v=19$m=19456,t=2,p=1$AAAAAAAAAAAAAAAAAAAAAA$AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
"""No secret has it. Held against where there is no hash, so that the time says nothing of what exists."""


def fits(kept: str, secret: str) -> bool:
    """Whether this secret has this hash, in the same time either way. Takes long: not on the event loop."""
    try:
        return _HASHER.verify(kept, secret)
    except (VerificationError, InvalidHashError):
        return False


def new_cookie() -> str:
    """256 random bits for a session's cookie."""
    return secrets.token_urlsafe(32)


def digest_of(text: str) -> str:
    """SHA-256 in hex, for texts that cannot be guessed. The time of a look-up by it tells nothing of the text."""
    return hashlib.sha256(text.encode("utf-8", "surrogateescape")).hexdigest()
