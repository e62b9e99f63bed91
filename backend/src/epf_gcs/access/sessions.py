"""People and their sessions, in memory: a request's cookie is one look-up in a dictionary. The disk follows.

A session is one browser of a person. It ends when the person leaves, when an owner ends it, or unused for `LASTS_S`.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Final

from epf_gcs.access.caller import Caller
from epf_gcs.access.keys import digest_of, new_cookie
from epf_gcs.access.roles import Role
from epf_gcs.access.store import Person, PersonState, Session
from epf_gcs.errors import ConflictError, NotFoundError
from epf_gcs.shares.holder import Holder, Standing, host_of
from epf_gcs.shares.places import Holdings
from epf_gcs.shares.table import SHARES, Shares

LASTS_S: Final = 30 * 86400.0
"""How long a session lasts without being used."""
WAITS_S: Final = 3600.0
"""How long somebody who asked to be let in is remembered."""
MOST_SESSIONS: Final = 2000


class Sessions:
    """Owned by the event loop. Gives back what has to be written; `Admission` writes it.

    `on_ended` is told the ids of sessions that have ended, `on_changed` of those whose role or name has changed.
    """

    def __init__(
        self,
        people: Iterable[Person],
        sessions: Iterable[Session],
        shares: Shares = SHARES,
        host: Callable[[str], Holder] = lambda address: Holder(host_of(address), Standing.stranger),
    ) -> None:
        """`host`: the holder of an address."""
        self.people: dict[str, Person] = {person.id: person for person in people}
        self._by_digest: dict[str, Session] = {session.digest: session for session in sessions}
        self._by_id: dict[str, Session] = {session.id: session for session in self._by_digest.values()}
        self._callers: dict[str, Caller] = {}
        self._seen_s: dict[str, float] = {}
        self._unwritten: set[str] = set()
        self._gone: list[str] = []
        self._host = host
        # By the ids of people: who has waited longest of the host with most makes room.
        self._waiting: Holdings[str] = Holdings(
            shares.waiting, lambda person_id: self.people[person_id].made_s, self._forget_waiting
        )
        self.on_ended: Callable[[frozenset[str]], None] = _nothing
        self.on_changed: Callable[[frozenset[str]], None] = _nothing
        for session in self._by_id.values():
            self._seen_s[session.id] = session.seen_s
            self._admit(session)
        for person in tuple(self.people.values()):
            if person.state == "waiting" and self._waiting.take(person.id, self._host(person.address)) is not None:
                self._forget_waiting(person.id)

    def find(self, cookie: str, now_s: float) -> tuple[Session, Person] | None:
        """The session of a cookie and its person, who may be waiting or ended; None for any other text."""
        session = self._by_digest.get(digest_of(cookie))
        if session is None or now_s - self._seen_s[session.id] > LASTS_S:
            return None
        person = self.people.get(session.person)
        return None if person is None else (session, person)

    def caller(self, cookie: str, now_s: float) -> Caller | None:
        """Who has this cookie, if admitted."""
        session = self._by_digest.get(digest_of(cookie))
        if session is None:
            return None
        seen_s = self._seen_s[session.id]
        if now_s - seen_s > LASTS_S:
            return None
        caller = self._callers.get(session.id)
        if caller is not None and now_s > seen_s:
            self._seen_s[session.id] = now_s
            self._unwritten.add(session.id)
        return caller

    def current(self, session_id: str) -> Caller | None:
        """Whose session this is now; None once it has ended."""
        return self._callers.get(session_id)

    def seen_s(self, session: Session) -> float:
        """When this session was last heard."""
        return self._seen_s[session.id]

    def of_person(self, person_id: str) -> list[Session]:
        """The sessions of a person."""
        return [session for session in self._by_id.values() if session.person == person_id]

    def all(self) -> list[Session]:
        """Every session, oldest first."""
        return sorted(self._by_id.values(), key=lambda session: session.made_s)

    def come_in(
        self, name: str, place: str, state: PersonState, role: Role, address: str, now_s: float
    ) -> tuple[str, Person, Session]:
        """A new person with a session of a new cookie, which is returned and kept nowhere.

        Raises ConflictError if too many wait, or too many are in.
        """
        if len(self._by_id) >= MOST_SESSIONS:
            raise ConflictError(
                "access_too_many_sessions",
                f"{MOST_SESSIONS} browsers are known already: an owner of this station has to end some.",
                limit=MOST_SESSIONS,
            )
        person = Person(secrets.token_hex(8), name, place, int(role), state, now_s, now_s, address)
        if state == "waiting":
            self.forget_waiting(now_s)
            if (shortage := self._waiting.take(person.id, self._host(address))) is not None:
                raise ConflictError(
                    "access_too_many_waiting",
                    f"{shortage.most} people are waiting to be let in already: ask an owner of this station for a key.",
                    limit=shortage.most,
                )
        cookie = new_cookie()
        session = Session(secrets.token_hex(8), person.id, digest_of(cookie), now_s, now_s, address)
        self.people[person.id] = person
        self._by_digest[session.digest] = session
        self._by_id[session.id] = session
        self._seen_s[session.id] = now_s
        self._admit(session)
        return cookie, person, session

    def change(self, person_id: str, *, name: str | None, role: Role | None, state: PersonState | None) -> Person:
        """Change a person: let in, end, another role or name. Raises NotFoundError."""
        before = self._person(person_id)
        person = replace(
            before,
            name=before.name if name is None else name,
            role=before.role if role is None else int(role),
            state=before.state if state is None else state,
        )
        self.people[person_id] = person
        if state is not None and state != "waiting":
            self._waiting.leave(person_id)
        ids = frozenset(session.id for session in self.of_person(person_id))
        if state == "ended":
            self._end(ids)
        else:
            for session_id in ids:
                self._admit(self._by_id[session_id])
            if ids and person != before:
                self.on_changed(ids)
        return person

    def remove(self, person_id: str) -> None:
        """Forget a person with all sessions. Raises NotFoundError."""
        self._person(person_id)
        self._end(frozenset(session.id for session in self.of_person(person_id)))
        self._waiting.leave(person_id)
        del self.people[person_id]

    def end(self, session_id: str) -> Session:
        """End one session. Raises NotFoundError."""
        session = self._by_id.get(session_id)
        if session is None:
            raise NotFoundError(
                "access_unknown", "There is no such session any more: load the list again.", what="session"
            )
        self._end(frozenset((session_id,)))
        return session

    def forget_waiting(self, now_s: float) -> None:
        """Forget those who have waited too long."""
        for person in tuple(self.people.values()):
            if person.state == "waiting" and now_s - person.made_s > WAITS_S:
                self._forget_waiting(person.id)

    def _forget_waiting(self, person_id: str) -> None:
        self.remove(person_id)
        self._gone.append(person_id)

    def take_gone(self) -> list[str]:
        """The ids of people who waited and were forgotten since the last call."""
        gone, self._gone = self._gone, []
        return gone

    def take_unwritten(self) -> dict[str, float]:
        """When which session was last heard, of those heard since the last call."""
        times = {session_id: self._seen_s[session_id] for session_id in self._unwritten if session_id in self._seen_s}
        self._unwritten.clear()
        return times

    def owners(self) -> int:
        """How many owners are admitted."""
        return sum(person.state == "in" and person.role == Role.owner for person in self.people.values())

    def _person(self, person_id: str) -> Person:
        person = self.people.get(person_id)
        if person is None:
            raise NotFoundError(
                "access_unknown", "There is no such person any more: load the list again.", what="person"
            )
        return person

    def _admit(self, session: Session) -> None:
        person = self.people.get(session.person)
        if person is not None and person.state == "in":
            self._callers[session.id] = Caller("person", person.id, _shown(person), Role(person.role), session.id)
        else:
            self._callers.pop(session.id, None)

    def _end(self, ids: frozenset[str]) -> None:
        for session_id in ids:
            session = self._by_id.pop(session_id, None)
            if session is not None:
                del self._by_digest[session.digest]
                self._callers.pop(session_id, None)
                self._seen_s.pop(session_id, None)
        if ids:
            self.on_ended(ids)


def _shown(person: Person) -> str:
    """A person's name as others see it, with the place if one was given."""
    return f"{person.name} · {person.place}" if person.place else person.name


def _nothing(_ids: frozenset[str]) -> None:
    """Nobody listens yet."""
