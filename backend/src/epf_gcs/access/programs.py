"""Programs and their keys, in memory: a key that was proven once is one look-up in a dictionary after that."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Final

from epf_gcs.access.caller import Caller
from epf_gcs.access.keys import NO_HASH, Parts, digest_of, fits, hash_of, new_program_key, program_key
from epf_gcs.access.proving import KeyVerifier
from epf_gcs.access.roles import Role
from epf_gcs.access.store import Program
from epf_gcs.errors import ConflictError, NotFoundError

MOST_PROGRAMS: Final = 200


class Programs:
    """Owned by the event loop."""

    def __init__(self, programs: Iterable[Program], proving: KeyVerifier) -> None:
        self._proving = proving
        self._programs: dict[str, Program] = {program.id: program for program in programs}
        # SHA-256 of a proven key -> id.
        self._proven: dict[str, str] = {}
        self._callers: dict[str, Caller] = {}
        self._seen_s: dict[str, float] = {program.id: program.seen_s for program in self._programs.values()}
        self._unwritten: set[str] = set()

    def add_proven(self, key: str, caller: Caller) -> None:
        """A key that this run was given: nothing is kept of it."""
        self._proven[digest_of(key)] = caller.id
        self._callers[caller.id] = caller

    def all(self) -> list[tuple[Program, float]]:
        """Every program and when it was last heard, oldest first."""
        programs = sorted(self._programs.values(), key=lambda program: program.made_s)
        return [(program, self._seen_s[program.id]) for program in programs]

    def caller(self, key: str, now_s: float) -> Caller | None:
        """The program that has this key, if it was proven before."""
        program_id = self._proven.get(digest_of(key))
        if program_id is None:
            return None
        if program_id in self._seen_s:
            self._seen_s[program_id] = now_s
            self._unwritten.add(program_id)
        return self._callers[program_id]

    def current(self, session_id: str) -> Caller | None:
        """The program with this session; None once it has ended or while it was not heard in this run."""
        return self._callers.get(session_id)

    async def prove(self, key: str, address: str) -> bool:
        """Whether this is the key of a program. Raises TooManyError."""
        digest = digest_of(key)
        if digest in self._proven:
            return True
        parts = program_key(key)
        program = None if parts is None else self._programs.get(parts.lookup)
        kept, secret = NO_HASH if program is None else program.hash, key if parts is None else parts.secret
        proven = await self._proving.attempt(address, partial(_proof, kept, secret))
        # It may have been ended in the meantime.
        if proven is None or program is None or self._programs.get(program.id) is not program:
            return False
        self._proven[digest] = program.id
        self._callers[program.id] = Caller("program", program.id, program.name, Role(program.role), program.id)
        return True

    async def make(self, name: str, role: Role, now_s: float) -> tuple[str, Program]:
        """A new program and its key, which is kept nowhere. Raises ConflictError if there are too many."""
        if len(self._programs) >= MOST_PROGRAMS:
            raise ConflictError(
                "access_too_many_programs",
                f"{MOST_PROGRAMS} programs have a key already: end one first.",
                limit=MOST_PROGRAMS,
            )
        key, parts = self._new_key()
        kept = await self._proving.run(partial(hash_of, parts.secret))
        program = Program(parts.lookup, name, int(role), kept, now_s, 0.0)
        self._programs[program.id] = program
        self._seen_s[program.id] = 0.0
        return key, program

    def end(self, program_id: str) -> Program:
        """Its key is worth nothing from now on. Raises NotFoundError."""
        program = self._programs.pop(program_id, None)
        if program is None:
            raise NotFoundError(
                "access_unknown", "There is no such program any more: load the list again.", what="program"
            )
        self._proven = {digest: owner for digest, owner in self._proven.items() if owner != program_id}
        self._callers.pop(program_id, None)
        self._seen_s.pop(program_id, None)
        self._unwritten.discard(program_id)
        return program

    def take_unwritten(self) -> dict[str, float]:
        """When which program was last heard, of those heard since the last call."""
        times = {program_id: self._seen_s[program_id] for program_id in self._unwritten}
        self._unwritten.clear()
        return times

    def _new_key(self) -> tuple[str, Parts]:
        while True:
            key, parts = new_program_key()
            if parts.lookup not in self._programs:
                return key, parts


def _proof(kept: str, secret: str) -> bool | None:
    return True if fits(kept, secret) else None
