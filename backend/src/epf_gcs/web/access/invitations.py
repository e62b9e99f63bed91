"""One-time keys: made by an owner, or by `epf-gcs invite` straight into the store; used up by entering."""

from __future__ import annotations

import secrets
from functools import partial

from epf_gcs.errors import NotFoundError
from epf_gcs.web.access.keys import NO_HASH, Parts, fits, hash_of, new_one_time_key, one_time_key
from epf_gcs.web.access.proving import Proving
from epf_gcs.web.access.roles import Role
from epf_gcs.web.access.store import AccessStore, Invitation


class Invitations:
    """Kept in the store alone, because another program may have put one there a moment ago."""

    def __init__(self, store: AccessStore, proving: Proving) -> None:
        self._store = store
        self._proving = proving

    async def make(self, role: Role, minutes: float, now_s: float) -> tuple[str, Invitation]:
        """A new key, which is kept nowhere, and its invitation."""
        return await self._proving.run(partial(new_invitation, self._store, role, minutes, now_s))

    async def use(self, key: str, address: str, now_s: float) -> Role | None:
        """The role that this key gives, once; None if it is wrong, used or ended. Raises TooManyError."""
        return await self._proving.attempt(address, partial(self._use, one_time_key(key), now_s))

    async def all(self, now_s: float) -> list[Invitation]:
        """Those that can still be used."""
        return await self._proving.run(partial(self._all, now_s))

    async def end(self, invitation_id: str) -> None:
        """Its key is worth nothing from now on. Raises NotFoundError."""
        if not await self._proving.run(partial(self._store.remove, Invitation, invitation_id)):
            raise NotFoundError(
                "access_unknown", "There is no such invitation any more: load the list again.", what="invitation"
            )

    def _use(self, parts: Parts | None, now_s: float) -> Role | None:
        found = None if parts is None else self._store.invitation(parts.lookup, now_s)
        kept = NO_HASH if found is None else found.hash
        right = fits(kept, "" if parts is None else parts.secret)
        # Removing it is what uses it up: of two at the same moment one comes in.
        if not right or found is None or not self._store.remove(Invitation, found.id):
            return None
        return Role(found.role)

    def _all(self, now_s: float) -> list[Invitation]:
        self._store.forget_invitations(now_s)
        return self._store.all(Invitation)


def new_invitation(store: AccessStore, role: Role, minutes: float, now_s: float) -> tuple[str, Invitation]:
    """Make one and write it. Takes long: not on the event loop."""
    store.forget_invitations(now_s)
    taken = {invitation.lookup for invitation in store.all(Invitation)}
    while True:
        key, parts = new_one_time_key()
        if parts.lookup not in taken:
            break
    invitation = Invitation(
        secrets.token_hex(8), parts.lookup, int(role), hash_of(parts.secret), now_s, now_s + minutes * 60.0
    )
    store.put(invitation)
    return key, invitation
