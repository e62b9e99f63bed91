"""One-time keys: made by an owner, or by `epf-gcs invite` straight into the store; used up by entering."""

from __future__ import annotations

import secrets
from functools import partial
from typing import Final

from epf_gcs.access.keys import Parts, digest_of, fits, new_one_time_key, one_time_key
from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.access.store import AccessStore, Invitation
from epf_gcs.access.store_thread import StoreThread
from epf_gcs.errors import ConflictError, NotFoundError

MOST_INVITATIONS: Final = 500


class Invitations:
    """Kept in the store alone, because another program may have put one there a moment ago."""

    def __init__(self, store: AccessStore, thread: StoreThread) -> None:
        self._store = store
        self._thread = thread

    async def make(self, role: Role, minutes: float, now: Moment) -> tuple[str, Invitation]:
        """A new key, which is kept nowhere, and its invitation. Raises ConflictError if there are too many."""
        return await self._thread.run(partial(new_invitation, self._store, role, minutes, now))

    async def use(self, key: str, now: Moment) -> Role | None:
        """The role that this key gives, once; None if it is wrong, used or ended."""
        parts = one_time_key(key)
        return None if parts is None else await self._thread.run(partial(self._use, parts, now))

    async def all(self, now: Moment) -> list[Invitation]:
        """Those that can still be used."""
        return await self._thread.run(partial(self._all, now))

    async def end(self, invitation_id: str) -> None:
        """Its key is worth nothing from now on. Raises NotFoundError."""
        if not await self._thread.run(partial(self._store.remove, Invitation, invitation_id)):
            raise NotFoundError(
                "access_unknown", "There is no such invitation any more: load the list again.", what="invitation"
            )

    def _use(self, parts: Parts, now: Moment) -> Role | None:
        found = self._store.invitation(parts.lookup)
        if found is None or found.left_s(now) <= 0 or not fits(found.hash, parts.secret):
            return None
        # Removing it is what uses it up: of two at the same moment one comes in.
        return Role(found.role) if self._store.remove(Invitation, found.id) else None

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
    """Make one and write it: not on the event loop. Raises ConflictError if there are too many."""
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
        digest_of(parts.secret),
        now.unix_s,
        until.unix_s,
        until.boot,
        until.steady_s,
    )
    store.put(invitation)
    return key, invitation
