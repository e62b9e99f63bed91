"""Who may come in, on a disk that is damaged, full or read-only, and by a clock that is set."""

from __future__ import annotations

import contextlib
import errno
import os
import random
import sqlite3
from pathlib import Path

import pytest

from epf_gcs.access import invitations as invitations_module
from epf_gcs.access import moment as moment_module
from epf_gcs.access import store as store_module
from epf_gcs.access.guessing import GuessLimiter
from epf_gcs.access.invitations import new_invitation
from epf_gcs.access.moment import Moment
from epf_gcs.access.roles import Role
from epf_gcs.access.store import FILE, AccessStore, Invitation, Person, Program, Session
from epf_gcs.errors import NotKeptError
from tests.support.callers import person, program, stranger, strict_gateway

ANA = Person("00000000000000a1", "Ana", "", int(Role.viewer), "in", 1.0, 2.0, "10.0.0.2")
HER_TABLET = Session("00000000000000b1", ANA.id, "d" * 64, 1.0, 2.0, "10.0.0.2")


def filled(folder: Path) -> Path:
    """A file with somebody in it."""
    with contextlib.closing(AccessStore(folder)) as store:
        store.put(ANA, HER_TABLET)
        for number in range(40):
            store.put(Person(f"{number:016x}", "x" * 40, "y" * 40, 1, "ended", 1.0, 2.0, "10.0.0.3"))
    return folder / FILE


def fill_disk(store: AccessStore) -> None:
    """Not a page more."""
    pages = store._db.execute("PRAGMA page_count").fetchone()[0]
    store._db.execute(f"PRAGMA max_page_count = {pages}")
    with contextlib.suppress(NotKeptError):
        for number in range(1000):
            store.put(Session(f"{number:016x}", "x" * 500, f"{number}", 1.0, 2.0, "x"))


def test_a_flipped_bit_keeps_no_station_from_starting(tmp_path: Path) -> None:
    whole = filled(tmp_path).read_bytes()
    dice = random.Random(13)
    set_aside = 0
    for number in range(300):
        folder = tmp_path / str(number)
        folder.mkdir()
        damaged = bytearray(whole)
        damaged[dice.randrange(len(whole))] ^= 1 << dice.randrange(8)
        (folder / FILE).write_bytes(damaged)
        with contextlib.closing(AccessStore(folder)) as store:
            for one in store.all(Person):
                assert one.role in list(Role)
                assert one.state in ("waiting", "in", "ended")
            store.put(ANA)
        set_aside += len(list(folder.glob(f"{FILE}.damaged-*")))
    assert set_aside > 10, "some of it was found"


def test_a_role_that_there_is_not_is_damage(tmp_path: Path) -> None:
    file = filled(tmp_path)
    with contextlib.closing(sqlite3.connect(file)) as db, db:
        db.execute("UPDATE people SET role = 7 WHERE id = ?", (ANA.id,))
    with contextlib.closing(AccessStore(tmp_path)) as store:
        assert store.all(Person) == []
    assert len(list(tmp_path.glob(f"{FILE}.damaged-*"))) == 1


def test_those_who_are_in_stay_in_where_the_disk_became_read_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = tmp_path / "data"
    with strict_gateway(data) as first, person(first, Role.operator) as ana:
        cookie = next(iter(ana.cookies.values()))

    def refuse(*_: object) -> sqlite3.Connection:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS))

    monkeypatch.setattr(store_module, "_open", refuse)
    with strict_gateway(data) as second, stranger(second, Cookie=f"epf_{second.server.port}={cookie}") as ana:
        assert ana.get("/access/me").json()["role"] == "operator"
        assert ana.get("/status").json()["errors"]["access_not_written"] == 1


def test_on_a_full_disk_nobody_half_comes_in_and_each_is_told_why(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data") as gateway, person(gateway, Role.owner) as owner, stranger(gateway) as ana:
        key = owner.post("/access/invitations", json={"role": "viewer"}).json()["key"]
        logger, _, program_id = program(gateway, Role.viewer, owner)
        store = gateway.web.admission.store
        fill_disk(store)
        answers = []
        for client, path, body in (
            (ana, "/access/ask", {"name": "Ana", "place": "x" * 40}),
            (owner, "/access/programs", {"name": "x" * 40}),
            (owner, "/access/invitations", {}),
            (ana, "/access/enter", {"key": key, "name": "Ana"}),
        ):
            for _ in range(3):
                answer = client.post(path, json=body)
                answers.append((answer.status_code, answer.json().get("code", "")))
        assert (507, "access_not_written") in answers
        assert 500 not in {status for status, _ in answers}
        for kind, path in ((Person, "people"), (Program, "programs")):
            known = {one["id"] for one in owner.get(f"/access/{path}").json()[path]}
            assert known == {one.id for one in store.all(kind)}
        # What is taken away is taken away at once, whatever the disk says.
        owner.delete(f"/access/programs/{program_id}")
        gateway.web.admission.guessing = GuessLimiter()
        with logger:
            assert logger.get("/status").status_code == 401


def test_a_file_of_the_version_before_is_read_on(tmp_path: Path) -> None:
    file = filled(tmp_path)
    with contextlib.closing(sqlite3.connect(file)) as db, db:
        for column in ("boot", "until_steady_s"):
            db.execute(f"ALTER TABLE invitations DROP COLUMN {column}")
        db.execute("INSERT INTO invitations VALUES ('00000000000000c1', 'AAAA', 1, 'x', 1.0, 2.0)")
        db.execute("PRAGMA user_version = 1")
    with contextlib.closing(AccessStore(tmp_path)) as store:
        assert ANA in store.all(Person)
        assert store.all(Invitation) == [Invitation("00000000000000c1", "AAAA", 1, "x", 1.0, 2.0, "", 0.0)]


def test_keys_of_an_earlier_version_that_were_kept_slowly_end_and_the_others_stay(tmp_path: Path) -> None:
    file = filled(tmp_path)
    with contextlib.closing(AccessStore(tmp_path)) as store:
        before = store.all(Program)
    with contextlib.closing(sqlite3.connect(file)) as db, db:
        db.execute("INSERT INTO programs VALUES ('0badcafe', 'old', 1, '$argon2id$v=19$x', 1.0, 2.0)")
        db.execute("PRAGMA user_version = 2")
    with contextlib.closing(AccessStore(tmp_path)) as store:
        assert store.all(Program) == before
        assert ANA in store.all(Person)


def test_a_key_lasts_its_hour_however_the_clock_is_set(tmp_path: Path) -> None:
    now = Moment.now()
    month_s = 30 * 86400.0
    with contextlib.closing(AccessStore(tmp_path)) as store:
        _, made = new_invitation(store, Role.viewer, 60.0, now)
        for jump_s in (-month_s, month_s):
            # As between `epf-gcs invite` and a station that started before the time was set.
            assert made.left_s(now._replace(unix_s=now.unix_s + jump_s)) == pytest.approx(3600.0)
            assert made.left_s(now.later(3601.0)._replace(unix_s=now.unix_s + jump_s)) < 0


def test_after_a_restart_of_the_computer_the_system_s_time_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    now = Moment(1000.0, 5000.0, "one boot")
    until = now.later(60.0)
    assert until.left_s(Moment(1030.0, 3.0, "another boot")) == 30.0
    monkeypatch.setattr(moment_module, "_BOOT", Path("/nowhere"))
    moment_module._boot.cache_clear()
    assert Moment.now().boot == ""
    moment_module._boot.cache_clear()
    assert Moment(1060.0, 0.0, "").left_s(Moment(1000.0, 9.0, "")) == 60.0


def test_there_is_an_end_of_keys_that_nobody_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(invitations_module, "MOST_INVITATIONS", 3)
    with strict_gateway(tmp_path / "data") as gateway, person(gateway, Role.owner) as owner:
        answers = [owner.post("/access/invitations", json={}) for _ in range(4)]
        assert [answer.status_code for answer in answers] == [201, 201, 201, 409]
        assert answers[-1].json()["code"] == "access_too_many_invitations"
        owner.delete(f"/access/invitations/{answers[0].json()['invitation']['id']}").raise_for_status()
        assert owner.post("/access/invitations", json={}).status_code == 201
