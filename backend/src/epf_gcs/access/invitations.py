"""One-time keys: made by an owner, or by `epf-gcs invite` straight into the store; used up by entering."""

from __future__ import annotations

import secrets
from functools import partial
from typing import Final

from epf_gcs.access.keys import NO_HASH, Parts, fits, hash_of, new_one_time_key, one_time_key
from epf_gcs.access.moment import Moment
from epf_gcs.access.proving import KeyVerifier
from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore, Invitation
from epf_gcs.errors import ConflictError, NotFoundError

MOST_INVITATIONS: Final = 500


class Invitations:
    """Kept in the store alone, because another program may have put one there a moment ago."""

    def __init__(self, store: AccessStore, proving: KeyVerifier) -> None:
        self._store = store
        self._proving = proving

    async def make(self, role: Role, minutes: float, now: Moment) -> tuple[str, Invitation]:
        """A new key, which is kept nowhere, and its invitation. Raises ConflictError if there are too many."""
        return await self._proving.run(partial(new_invitation, self._store, role, minutes, now))

    async def use(self, key: str, address: str, now: Moment) -> Role | None:
        """The role that this key gives, once; None if it is wrong, used or ended. Raises TooManyError."""
        return await self._proving.attempt(address, partial(self._use, one_time_key(key), now))

    async def all(self, now: Moment) -> list[Invitation]:
        """Those that can still be used."""
        return await self._proving.run(partial(self._all, now))

    async def end(self, invitation_id: str) -> None:
        """Its key is worth nothing from now on. Raises NotFoundError."""
        if not await self._proving.run(partial(self._store.remove, Invitation, invitation_id)):
            raise NotFoundError(
                "access_unknown", "There is no such invitation any more: load the list again.", what="invitation"
            )

    def _use(self, parts: Parts | None, now: Moment) -> Role | None:
        found = None if parts is None else self._store.invitation(parts.lookup)
        if found is not None and found.left_s(now) <= 0:
            found = None
        kept = NO_HASH if found is None else found.hash
        right = fits(kept, "" if parts is None else parts.secret)
        # Removing it is what uses it up: of two at the same moment one comes in.
        if not right or found is None or not self._store.remove(Invitation, found.id):
            return None
        return Role(found.role)

    def _all(self, now: Moment) -> list[Invitation]:
        return _open_ones(self._store, now)


def _open_ones(store: AccessStore, now: Moment) -> list[Invitation]:
    """Those that can still be used; the others are forgotten."""
    found = store.all(Invitation)
    ended = [one for one in found if one.left_s(now) <= 0]
    if ended:
        store.forget(ended)
    return [one for one in found if one not in ended]


def new_invitation(store: AccessStore, role: Role, minutes: float, now: Moment) -> tuple[str, Invitation]:
    """Make one and write it. Takes long: not on the event loop. Raises ConflictError if there are too many."""
    taken = {invitation.lookup for invitation in _open_ones(store, now)}
    if len(taken) >= MOST_INVITATIONS:
        raise ConflictError(
            "access_too_many_invitations",
            f"{MOST_INVITATIONS} one-time keys are waiting to be used already: end some first.",
            limit=MOST_INVITATIONS,
        )
    while True:
        key, parts = new_one_time_key()
        if parts.lookup not in taken:
            break
    until = now.later(minutes * 60.0)
    invitation = Invitation(
        secrets.token_hex(8),
        parts.lookup,
        int(role),
        hash_of(parts.secret),
        now.unix_s,
        until.unix_s,
        until.boot,
        until.steady_s,
    )
    store.put(invitation)
    return key, invitation
