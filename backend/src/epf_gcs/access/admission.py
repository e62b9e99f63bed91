"""Who comes in: puts sessions, programs, invitations, the store and the log together.

`resolve` and `admit` answer for a request or a handshake from memory alone; what needs the disk is awaited.
"""

from __future__ import annotations

import asyncio
import base64
import binascii
import contextlib
import time
from collections.abc import AsyncIterator, Callable
from dataclasses import dataclass
from functools import partial
from math import ceil
from pathlib import Path
from typing import Final

from epf_gcs.access.caller import ANYONE, LOCAL, LOCAL_SESSION, Caller, Credentials, is_loopback
from epf_gcs.access.guessing import GuessLimiter
from epf_gcs.access.invitations import Invitations
from epf_gcs.access.log import DeedLog
from epf_gcs.access.moment import Moment
from epf_gcs.access.programs import Programs
from epf_gcs.access.roles import Role
from epf_gcs.access.sessions import LASTS_S, Sessions
from epf_gcs.access.store import AccessStore, Person, Program, Session
from epf_gcs.access.store_thread import StoreThread
from epf_gcs.clock import Clock
from epf_gcs.errors import GatewayError, NotAdmittedError, NotKeptError, TooManyError
from epf_gcs.repeating import repeat
from epf_gcs.shares.holder import Holder, Standing
from epf_gcs.shares.known_hosts import KnownHosts
from epf_gcs.shares.rates import Meter
from epf_gcs.shares.table import SHARES, Shares

_LAUNCHER: Final = Caller("program", "launcher", "epf-run", Role.owner, LOCAL_SESSION)
_WRITTEN_EVERY_S: Final = 60.0


@dataclass(frozen=True, slots=True)
class Policy:
    """What the settings say of strangers."""

    trusts_this_computer: bool
    anyone_may_fly: bool
    host: str
    launcher_key: str | None = None
    reached_at: str | None = None

    @property
    def is_reached_by_others(self) -> bool:
        """Whether this station listens beyond this computer."""
        return not is_this_computers(self.host)


def is_this_computers(host: str) -> bool:
    """Whether what listens there is reached from this computer alone."""
    return host == "localhost" or is_loopback(host)


class Admission:
    """Owned by the event loop. Empty until `running`, so that the interface can be described without a data folder."""

    def __init__(
        self,
        policy: Policy,
        data_dir: Path,
        report: Callable[[GatewayError], None],
        clock: Clock,
        *,
        hosts: KnownHosts | None = None,
        shares: Shares = SHARES,
    ) -> None:
        """`hosts`: where somebody has shown a key; who was in before a restart makes known where from."""
        self.policy = policy
        self._data_dir = data_dir
        self._report = report
        self.clock = clock
        self._hosts = hosts or KnownHosts()
        self._shares = shares
        self._asks = Meter(shares.asks)
        self.port = 0
        self.is_secure = False
        self._opened = False
        self.on_ended: Callable[[frozenset[str]], None] = _nobody_listens
        """Told the ids of sessions that have ended, of people and programs."""
        self.on_changed: Callable[[frozenset[str]], None] = _nobody_listens
        """Told the ids of sessions whose role or name has changed."""

    def listen_at(self, port: int, *, secure: bool = False) -> None:
        """Where this station listens: cookies are named by it, for all ports of a host share them."""
        self.port = port
        self.is_secure = secure

    @property
    def cookie_name(self) -> str:
        """The name of the session's cookie. `__Host-` is believed by browsers only with Secure and the path /."""
        return "__Host-epf" if self.is_secure else f"epf_{self.port}"

    @contextlib.asynccontextmanager
    async def running(self) -> AsyncIterator[None]:
        """Read who may come in, and write when they were last heard, inside."""
        self.store = self._open_store()
        self.thread = StoreThread()
        self.guessing = GuessLimiter()
        self.sessions = Sessions(self.store.all(Person), self.store.all(Session), self._shares, self._host)
        for session in self.sessions.all():
            if (caller := self.sessions.current(session.id)) is not None:
                self._hosts.note(session.address, Standing(caller.role), time.monotonic())
        self.sessions.on_ended = self._tell_ended
        self.sessions.on_changed = self._tell_changed
        self.programs = Programs(self.store.all(Program))
        self.invitations = Invitations(self.store, self.thread)
        self.log = DeedLog(self._data_dir, self.clock.now_s, self._report)
        if self.policy.launcher_key is not None:
            self.programs.add_caller(self.policy.launcher_key, _LAUNCHER)
        self._opened = True
        writing = asyncio.create_task(repeat(_WRITTEN_EVERY_S, "who was here last", self._write_last_heard))
        try:
            yield
        finally:
            self._opened = False
            writing.cancel()
            self._write_all(self.sessions.take_gone(), self.sessions.take_unwritten(), self.programs.take_unwritten())
            self.thread.close()
            self.log.close()
            self.store.close()

    def _open_store(self) -> AccessStore:
        """On a disk that takes nothing the station starts all the same, and who was in is: they may be flying."""
        try:
            return AccessStore(self._data_dir)
        except NotKeptError as error:
            self._report(error)
            return AccessStore.copied(self._data_dir)

    def resolve(self, shown: Credentials) -> Caller | None:
        """Who this is; None for a stranger."""
        if not self._opened:
            return None
        now_s = self.clock.now_s()
        if shown.authorization is not None:
            key = bearer_key(shown.authorization)
            return None if key is None else self.programs.caller(key, now_s)
        if self.policy.trusts_this_computer and not shown.proxied and shown.peer.is_ours:
            return LOCAL
        cookie = self.cookie(shown)
        caller = None if cookie is None else self.sessions.caller(cookie, now_s)
        if caller is None and self.policy.anyone_may_fly:
            return Caller("person", ANYONE, "", Role.operator, f"{ANYONE}@{shown.peer.host}")
        return caller

    def admit(self, shown: Credentials) -> Caller | None:
        """As `resolve`. A key that nobody has is counted: raises TooManyError where this address, or all together,
        showed too many."""
        caller = self.resolve(shown)
        if caller is None and shown.authorization is not None and self._opened:
            self._count_failure(shown.peer.host)
            self.log.note(None, shown.peer.host, "refused", "key of a program", "wrong")
        return caller

    def _count_failure(self, address: str) -> None:
        wait_s = ceil(self.guessing.failed(address, time.monotonic()))
        if wait_s > 0:
            raise TooManyError(
                "access_too_many_tries",
                f"Too many wrong keys were tried: try again in {wait_s} s.",
                retry_after_s=wait_s,
            )

    def current(self, session_id: str) -> Caller | None:
        """Whose session this is now, with the role of now; None once it has ended."""
        if session_id == LOCAL_SESSION:
            return LOCAL
        if session_id.startswith(ANYONE + "@"):
            return Caller("person", ANYONE, "", Role.operator, session_id) if self.policy.anyone_may_fly else None
        return self.sessions.current(session_id) or self.programs.current(session_id)

    def cookie(self, shown: Credentials) -> str | None:
        """The session's cookie, if one was sent."""
        name = self.cookie_name + "="
        for part in shown.cookies.split(";"):
            text = part.strip()
            if text.startswith(name):
                return text[len(name) :]
        return None

    def set_cookie(self, value: str) -> str:
        """The header Set-Cookie of a session; an empty value ends it in the browser."""
        secure = "; Secure" if self.is_secure else ""
        lasts = int(LASTS_S) if value else 0
        return f"{self.cookie_name}={value}; Max-Age={lasts}; Path=/; HttpOnly; SameSite=Strict{secure}"

    def find(self, shown: Credentials) -> tuple[Session, Person] | None:
        """The session of the cookie, of somebody admitted, waiting or ended."""
        cookie = self.cookie(shown)
        return None if cookie is None else self.sessions.find(cookie, self.clock.now_s())

    async def enter(self, key: str, name: str, place: str, shown: Credentials) -> tuple[str, Person, Session]:
        """Use up a one-time key: a new person with a new session, and its cookie.

        The session that this browser had before, if any, ends: a cookie that somebody else planted is worth nothing.
        Raises NotAdmittedError if the key is wrong, TooManyError, ConflictError.
        """
        address = shown.peer.host
        role = await self.invitations.use(key, self.moment())
        if role is None:
            self._count_failure(address)
            self.log.note(None, address, "entered", "", "wrong key")
            raise NotAdmittedError(
                "access_key_wrong",
                "This key is not right, was used already or has ended: ask for a new one.",
            )
        before = self.find(shown)
        entered = self.sessions.come_in(name, place, "in", role, address, self.clock.now_s())
        _, person, session = entered
        await self._write_new(person, session)
        if before is not None:
            await self.forget(before[1].id)
        self.log.note(self.sessions.current(session.id), address, "entered", role.name, "done")
        return entered

    async def ask(self, name: str, place: str, shown: Credentials) -> tuple[str, Person, Session]:
        """Somebody without a key waits to be let in. Raises TooManyError, ConflictError."""
        address = shown.peer.host
        host = self._host(address)
        if not self._asks.take(host, time.monotonic()):
            wait_s = ceil(1.0 / self._asks.row.each[host.standing].per_s)
            raise TooManyError(
                "access_too_many_requests",
                f"More was asked than this station answers: try again in {wait_s} s.",
                retry_after_s=wait_s,
            )
        before = self.find(shown)
        if before is not None:
            await self.forget(before[1].id)
        entered = self.sessions.come_in(name, place, "waiting", Role.viewer, address, self.clock.now_s())
        await self._write_new(entered[1], entered[2])
        self.log.note(None, address, "asked", f"{name} · {place}" if place else name, "waiting")
        return entered

    async def forget(self, person_id: str) -> None:
        """Forget a person with all sessions. Raises NotFoundError."""
        self.sessions.remove(person_id)
        await self.write(partial(self.store.remove, Person, person_id))

    async def end_session(self, session_id: str) -> Session:
        """End the session of one browser. Raises NotFoundError."""
        session = self.sessions.end(session_id)
        await self.write(partial(self.store.remove, Session, session_id))
        return session

    async def end_program(self, program_id: str) -> Program:
        """A program's key is worth nothing from now on. Raises NotFoundError."""
        program = self.programs.end(program_id)
        self.on_ended(frozenset((program_id,)))
        await self.write(partial(self.store.remove, Program, program_id))
        return program

    async def make_program(self, name: str, role: Role) -> tuple[str, Program]:
        """A new program and its key, which is kept nowhere. Raises ConflictError, NotKeptError."""
        key, program = self.programs.make(name, role, self.clock.now_s())
        try:
            await self.write(partial(self.store.put, program))
        except NotKeptError:
            self.programs.end(program.id)
            raise
        return key, program

    def moment(self) -> Moment:
        """Now, by the station's clock."""
        return Moment.now(self.clock.now_s())

    async def write(self, work: Callable[[], object]) -> None:
        """Change the store. Raises NotKeptError where the disk does not take it."""
        await self.thread.run(work)

    async def _write_new(self, person: Person, session: Session) -> None:
        """Somebody whom the disk does not take has not come in."""
        try:
            await self.write(partial(self.store.put, person, session))
        except NotKeptError:
            self.sessions.remove(person.id)
            raise

    def _host(self, address: str) -> Holder:
        return self._hosts.holder(address, time.monotonic())

    def _tell_ended(self, ids: frozenset[str]) -> None:
        self.on_ended(ids)

    def _tell_changed(self, ids: frozenset[str]) -> None:
        self.on_changed(ids)

    async def _write_last_heard(self) -> None:
        self.sessions.forget_waiting(self.clock.now_s())
        gone = self.sessions.take_gone()
        heard = self.sessions.take_unwritten(), self.programs.take_unwritten()
        await self.thread.run(partial(self._write_all, gone, *heard))

    def _write_all(self, gone: list[str], sessions: dict[str, float], programs: dict[str, float]) -> None:
        """Where the disk does not take it, nothing but the list of who was here when suffers."""
        with contextlib.suppress(NotKeptError):
            for person_id in gone:
                self.store.remove(Person, person_id)
            if sessions:
                self.store.seen(Session, sessions)
            if programs:
                self.store.seen(Program, programs)


def _nobody_listens(_ids: frozenset[str]) -> None:
    """Until the stream's endpoint does."""


def bearer_key(authorization: str) -> str | None:
    """The key of `Bearer KEY`, or of `Basic` with the key as the password, for programs that know no other way."""
    scheme, _, rest = authorization.partition(" ")
    if scheme.lower() == "bearer":
        return rest.strip() or None
    if scheme.lower() == "basic":
        try:
            text = base64.b64decode(rest.strip(), validate=True).decode()
        except (binascii.Error, ValueError):
            return None
        return text.partition(":")[2] or None
    return None
