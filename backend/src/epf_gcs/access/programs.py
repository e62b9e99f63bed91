"""Programs and their keys, in memory: a key is one look-up in a dictionary."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from epf_gcs.access.caller import Caller
from epf_gcs.access.keys import digest_of, new_program_key
from epf_gcs.access.roles import Role
from epf_gcs.access.store import Program
from epf_gcs.errors import ConflictError, NotFoundError

MOST_PROGRAMS: Final = 200


class Programs:
    """Owned by the event loop."""

    def __init__(self, programs: Iterable[Program]) -> None:
        self._programs: dict[str, Program] = {}
        # Digest of a key -> id.
        self._ids: dict[str, str] = {}
        self._callers: dict[str, Caller] = {}
        self._seen_s: dict[str, float] = {}
        self._unwritten: set[str] = set()
        for program in programs:
            self._add(program)

    def add_caller(self, key: str, caller: Caller) -> None:
        """A key that this run was given: nothing is kept of it."""
        self._ids[digest_of(key)] = caller.id
        self._callers[caller.id] = caller

    def all(self) -> list[tuple[Program, float]]:
        """Every program and when it was last heard, oldest first."""
        programs = sorted(self._programs.values(), key=lambda program: program.made_s)
        return [(program, self._seen_s[program.id]) for program in programs]

    def caller(self, key: str, now_s: float) -> Caller | None:
        """The program that has this key."""
        program_id = self._ids.get(digest_of(key))
        if program_id is None:
            return None
        if program_id in self._seen_s:
            self._seen_s[program_id] = now_s
            self._unwritten.add(program_id)
        return self._callers[program_id]

    def current(self, session_id: str) -> Caller | None:
        """The program with this session; None once it has ended."""
        return self._callers.get(session_id)

    def make(self, name: str, role: Role, now_s: float) -> tuple[str, Program]:
        """A new program and its key, which is kept nowhere. Raises ConflictError if there are too many."""
        if len(self._programs) >= MOST_PROGRAMS:
            raise ConflictError(
                "access_too_many_programs",
                f"{MOST_PROGRAMS} programs have a key already: end one first.",
                limit=MOST_PROGRAMS,
            )
        key, program_id = self._new_key()
        program = Program(program_id, name, int(role), digest_of(key), now_s, 0.0)
        self._add(program)
        return key, program

    def end(self, program_id: str) -> Program:
        """Its key is worth nothing from now on. Raises NotFoundError."""
        program = self._programs.pop(program_id, None)
        if program is None:
            raise NotFoundError(
                "access_unknown", "There is no such program any more: load the list again.", what="program"
            )
        self._ids.pop(program.hash, None)
        self._callers.pop(program_id, None)
        self._seen_s.pop(program_id, None)
        self._unwritten.discard(program_id)
        return program

    def take_unwritten(self) -> dict[str, float]:
        """When which program was last heard, of those heard since the last call."""
        times = {program_id: self._seen_s[program_id] for program_id in self._unwritten}
        self._unwritten.clear()
        return times

    def _add(self, program: Program) -> None:
        self._programs[program.id] = program
        self._ids[program.hash] = program.id
        self._callers[program.id] = Caller("program", program.id, program.name, Role(program.role), program.id)
        self._seen_s[program.id] = program.seen_s

    def _new_key(self) -> tuple[str, str]:
        while True:
            key, program_id = new_program_key()
            if program_id not in self._programs:
                return key, program_id
