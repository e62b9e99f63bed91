"""Coming in: one-time keys, waiting, cookies, and what others could do with them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from epf_gcs.access.keys import new_one_time_key, new_program_key
from epf_gcs.access.roles import Role
from tests.support.callers import one_time_key, person, program, stranger, strict_gateway
from tests.support.gateway import Gateway
from tests.support.waiting import eventually


@pytest.fixture
def station(tmp_path: Path) -> Iterator[Gateway]:
    with strict_gateway(tmp_path / "data") as gateway:
        yield gateway


def test_a_one_time_key_lets_one_in_and_nobody_else(station: Gateway) -> None:
    key = one_time_key(station, Role.operator)
    with stranger(station) as ana, stranger(station) as other:
        typed = key.lower().replace("-", " ")
        assert ana.post("/access/enter", json={"key": typed, "name": "Ana", "place": "tableta"}).json() == {
            "state": "in",
            "kind": "person",
            "role": "operator",
            "name": "Ana · tableta",
            "anyone_may_fly": False,
        }
        assert ana.get("/status").status_code == 200
        again = other.post("/access/enter", json={"key": key, "name": "Eve"})
        assert (again.status_code, again.json()["code"]) == (401, "access_key_wrong")
        assert other.get("/status").status_code == 401


def test_a_key_that_has_ended_lets_nobody_in(station: Gateway) -> None:
    with person(station, Role.owner) as owner, stranger(station) as client:
        made = owner.post("/access/invitations", json={"role": "viewer"}).json()
        owner.delete(f"/access/invitations/{made['invitation']['id']}").raise_for_status()
        # Last, for those that have ended are forgotten when another is made.
        late = one_time_key(station, Role.owner, minutes=-1.0)
        for key in (late, made["key"], "0000-0000-0000-0000", "x"):
            assert client.post("/access/enter", json={"key": key, "name": "Eve"}).status_code == 401


def test_the_cookie_is_for_this_station_alone_and_no_script_reads_it(station: Gateway) -> None:
    with stranger(station) as client:
        body = {"key": one_time_key(station, Role.viewer), "name": "Ana"}
        cookie = client.post("/access/enter", json=body).headers["set-cookie"]
    value, *attributes = cookie.split("; ")
    assert re.fullmatch(rf"epf_{station.server.port}=[A-Za-z0-9_-]{{43}}", value)
    assert {"HttpOnly", "SameSite=Strict", "Path=/"} <= set(attributes)
    assert not [one for one in attributes if one.startswith("Domain")]


def test_under_tls_the_cookie_is_bound_to_the_host(station: Gateway) -> None:
    admission = station.web.admission
    admission.listen_at(443, secure=True)
    assert admission.set_cookie("x").startswith("__Host-epf=x; ")
    assert "; Secure" in admission.set_cookie("x")


def test_a_cookie_that_somebody_planted_is_worth_nothing_after_entering(station: Gateway) -> None:
    with person(station, Role.viewer, "Eve") as eve, stranger(station) as ana:
        planted = next(iter(eve.cookies.values()))
        name = f"epf_{station.server.port}"
        ana.headers["Cookie"] = f"{name}={planted}"
        body = {"key": one_time_key(station, Role.owner), "name": "Ana"}
        entered = ana.post("/access/enter", json=body).raise_for_status()
        assert planted not in entered.headers["set-cookie"]
        assert eve.get("/status").status_code == 401


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1"])
def test_another_page_cannot_use_the_cookie(station: Gateway, origin: str) -> None:
    with person(station, Role.owner) as ana:
        for path, body in (("/access/programs", {"name": "x", "role": "owner"}), ("/access/leave", {})):
            answer = ana.post(path, json=body, headers={"Origin": origin})
            assert (answer.status_code, answer.json()["code"]) == (403, "foreign_origin")
        form = {"Origin": origin, "Content-Type": "application/x-www-form-urlencoded"}
        assert ana.post("/commands/start", content=b"value=1", headers=form).status_code == 403
        assert ana.get("/access/programs").json() == {"programs": []}


def test_no_page_of_the_station_can_be_framed_or_read_by_others(station: Gateway) -> None:
    with person(station, Role.owner) as ana:
        for path in (f"{station.base}/", f"{station.base}/api/docs", "/access/people", "/status"):
            headers = ana.get(path, headers={"Origin": "http://evil.example"}).headers
            assert "frame-ancestors 'none'" in headers["content-security-policy"]
            assert headers["cross-origin-resource-policy"] == "same-origin"
            assert not [name for name in headers if name.startswith("access-control")]


@pytest.mark.parametrize("path", ["//evil.example/", "/%2F%2Fevil.example", "/\\evil.example", "/api/v1/access/me/"])
def test_nothing_sends_a_browser_elsewhere(station: Gateway, path: str) -> None:
    with person(station, Role.viewer) as ana:
        answer = ana.get(station.base + path, follow_redirects=False)
        assert answer.headers.get("location", station.base).startswith(station.base)


def test_who_asks_waits_until_an_owner_agrees(station: Gateway) -> None:
    with person(station, Role.owner) as owner, stranger(station) as ana:
        assert ana.get("/access/me").json()["state"] == "stranger"
        ana.post("/access/ask", json={"name": "Ana", "place": "sofá"}).raise_for_status()
        assert ana.get("/access/me").json()["state"] == "waiting"
        assert ana.get("/telemetry").status_code == 401
        waiting = next(one for one in owner.get("/access/people").json()["people"] if one["state"] == "waiting")
        assert (waiting["name"], waiting["place"], waiting["address"]) == ("Ana", "sofá", "127.0.0.1")
        owner.patch(f"/access/people/{waiting['id']}", json={"state": "in", "role": "viewer"}).raise_for_status()
        me = ana.get("/access/me").json()
        assert (me["state"], me["role"]) == ("in", "viewer")
        assert ana.get("/status").status_code == 200


def test_who_leaves_is_a_stranger(station: Gateway) -> None:
    with person(station, Role.viewer) as ana:
        kept = next(iter(ana.cookies.values()))
        left = ana.post("/access/leave", json={})
        assert left.json()["state"] == "stranger"
        assert "Max-Age=0" in left.headers["set-cookie"]
        ana.headers["Cookie"] = f"epf_{station.server.port}={kept}"
        assert ana.get("/status").status_code == 401


def test_a_role_changes_at_once(station: Gateway) -> None:
    with person(station, Role.owner) as owner, person(station, Role.operator, "Bo") as bo:
        person_id = next(one["id"] for one in owner.get("/access/people").json()["people"] if one["name"] == "Bo")
        assert bo.get("/access/people").status_code == 403
        owner.patch(f"/access/people/{person_id}", json={"role": "owner"}).raise_for_status()
        assert bo.get("/access/people").status_code == 200


def test_the_last_owner_stays(station: Gateway) -> None:
    with person(station, Role.owner) as owner:
        own = owner.get("/access/people").json()["people"][0]["id"]
        for answer in (
            owner.patch(f"/access/people/{own}", json={"role": "viewer"}),
            owner.patch(f"/access/people/{own}", json={"state": "ended"}),
            owner.delete(f"/access/people/{own}"),
        ):
            assert (answer.status_code, answer.json()["code"]) == (409, "access_last_owner")
        person(station, Role.owner).close()
        assert owner.delete(f"/access/people/{own}").status_code == 204


def test_people_and_programs_are_known_after_a_restart(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data") as first, person(first, Role.owner) as owner:
        cookie = next(iter(owner.cookies.values()))
        _, key, _ = program(first, Role.viewer, owner)
    with strict_gateway(tmp_path / "data") as second:
        with stranger(second, Cookie=f"epf_{second.server.port}={cookie}") as ana:
            assert ana.get("/access/me").json()["role"] == "owner"
            assert [one["name"] for one in ana.get("/access/programs").json()["programs"]] == ["logger"]
        with stranger(second, Authorization=f"Bearer {key}") as logger:
            assert logger.get("/status").status_code == 200


def test_wrong_keys_are_answered_ever_more_slowly(station: Gateway) -> None:
    with stranger(station) as eve:
        answers = [eve.post("/access/enter", json={"key": new_one_time_key()[0], "name": "Eve"}) for _ in range(8)]
        assert answers[0].json()["code"] == "access_key_wrong"
        assert answers[-1].json()["code"] == "access_too_many_tries"
        assert int(answers[-1].headers["retry-after"]) >= 1


def test_a_right_key_always_enters_whatever_others_behind_the_same_address_try(tmp_path: Path) -> None:
    with strict_gateway(tmp_path / "data") as first, person(first, Role.owner) as owner:
        _, key, _ = program(first, Role.viewer, owner)
    # After a restart the station has heard no program yet.
    with strict_gateway(tmp_path / "data") as second:
        right = one_time_key(second, Role.viewer)
        guesses = {"Authorization": f"Bearer {new_program_key()[0]}"}
        # All three ask from one address.
        bearer = {"Authorization": f"Bearer {key}"}
        with stranger(second) as guest, stranger(second, **bearer) as logger, stranger(second) as eve:
            while eve.get("/status", headers=guesses).status_code != 429:
                pass
            # Every address together has used up its tries.
            while second.web.admission.guessing.failed("192.0.2.7", 0.0) == 0.0:
                pass
            assert guest.post("/access/enter", json={"key": right, "name": "Ana"}).status_code == 200
            assert guest.get("/status").status_code == 200
            assert logger.get("/status").status_code == 200
            assert eve.get("/status", headers=guesses).status_code == 429


def all_bytes(folder: Path) -> bytes:
    """What stands in all files of a folder that is being written to."""
    while True:
        try:
            return b"".join(file.read_bytes() for file in folder.rglob("*") if file.is_file())
        except FileNotFoundError:
            continue  # a journal or a temporary file went away meanwhile


def test_no_key_stands_in_the_data_folder_or_in_a_log(station: Gateway, capfd: pytest.CaptureFixture[str]) -> None:
    with person(station, Role.owner) as owner:
        invited = one_time_key(station, Role.viewer)
        _, key, _ = program(station, Role.operator, owner)
        with stranger(station, Authorization=f"Bearer {key}") as logger:
            logger.post("/commands/start", json={})
            logger.post("/access/enter", json={"key": invited, "name": "Ana"}).raise_for_status()
        made = owner.post("/access/invitations", json={"role": "viewer"}).json()["key"]
        cookie = next(iter(owner.cookies.values()))
        again = one_time_key(station, Role.viewer)
        with person(station, Role.viewer, "Bo") as bo:  # who is in already is somebody whose deeds are logged
            bo.post("/access/enter", json={"key": again, "name": "Bo"}).raise_for_status()
        # A wrong key may be a right one of another station, or a right one with a slip.
        mistyped, wrong = new_one_time_key()[0], new_program_key()[0]
        with stranger(station) as eve, stranger(station, Authorization=f"Bearer {wrong}") as script:
            assert eve.post("/access/enter", json={"key": mistyped, "name": "Eve"}).status_code == 401
            assert script.get("/status").status_code == 401
    eventually(lambda: len(list(station.flight_thread.data_dir.rglob("*"))) > 2, "something is written")
    secrets = [
        *(text.split("_", 2)[2] for text in (key, wrong)),  # a secret may have an underscore in itself
        cookie,
        *(text[5:] for text in (invited, made, again, mistyped)),
    ]
    written = all_bytes(station.flight_thread.data_dir)
    said = "".join(capfd.readouterr())
    for secret in secrets:
        assert secret.encode() not in written
        assert secret not in said
    assert key.split("_")[1].encode() in written  # the part that is no secret is: we looked in the right place


def test_only_this_user_reads_the_lists(station: Gateway) -> None:
    person(station, Role.viewer).close()
    folder = station.flight_thread.data_dir
    eventually((folder / "people.jsonl").exists, "the log is written")
    assert {(folder / name).stat().st_mode & 0o777 for name in ("access.sqlite", "people.jsonl")} == {0o600}


def test_the_log_says_who_did_what_and_nothing_changes_it(station: Gateway) -> None:
    with person(station, Role.owner) as owner, person(station, Role.operator, "Bo") as bo:
        bo.post("/commands/start", json={})
        bo.patch("/parameters", json={"gains": {"P_roll": 1}})
        with stranger(station) as eve:
            eve.post("/access/enter", json={"key": "nonsense", "name": "Eve"})

        def deeds() -> list[dict[str, Any]]:
            found: list[dict[str, Any]] = owner.get("/access/log").json()["deeds"]
            return found

        eventually(lambda: len(deeds()) >= 5, "all is written")
        newest, gains, command = deeds()[:3]
        assert (newest["deed"], newest["kind"], newest["result"]) == ("entered", "stranger", "wrong key")
        assert (gains["deed"], gains["name"], gains["role"]) == ("gains", "Bo · tableta", "operator")
        assert "P_roll" in gains["what"]
        assert (command["deed"], command["what"], command["address"]) == (
            "command",
            "POST /commands/start {}",
            "127.0.0.1",
        )
        assert [one["deed"] for one in owner.get("/access/log?text=bo&limit=1").json()["deeds"]] == ["gains"]
        before = owner.get(f"/access/log?before={command['at']}").json()["deeds"]
        assert {one["deed"] for one in before} == {"entered"}
        for method in ("POST", "PUT", "PATCH", "DELETE"):
            assert owner.request(method, "/access/log").status_code == 405
        assert bo.get("/access/log").status_code == 403


def test_google_earth_is_asked_for_a_password_and_a_program_s_key_is_one(station: Gateway) -> None:
    with person(station, Role.owner) as owner, stranger(station) as earth:
        refused = earth.get("/earth.kml")
        assert (refused.status_code, refused.headers["www-authenticate"].split()[0]) == (401, "Basic")
        assert earth.get("/status").headers["www-authenticate"].split()[0] == "Bearer"
        _, key, _ = program(station, Role.viewer, owner)
        assert earth.get("/earth.kml", auth=("anything", key)).status_code == 200


def test_a_wrong_a_used_and_an_ended_key_are_told_apart_by_nothing(station: Gateway) -> None:
    used = one_time_key(station, Role.owner)
    with person(station, Role.owner, "Owner") as owner:
        with stranger(station) as ana:
            ana.post("/access/enter", json={"key": used, "name": "Ana"}).raise_for_status()
        revoked = owner.post("/access/invitations", json={}).json()
        owner.delete(f"/access/invitations/{revoked['invitation']['id']}").raise_for_status()
        open_one = owner.post("/access/invitations", json={}).json()["key"]
        # Last, for those that have ended are forgotten when another is made.
        late = one_time_key(station, Role.owner, minutes=-1.0)
        answers = []
        for key in (
            new_one_time_key()[0],
            used,
            late,
            revoked["key"],
            open_one[:-1] + ("0" if open_one[-1] != "0" else "1"),
            "x",
            "epf_00000000_" + "x" * 43,
        ):
            with stranger(station) as eve:
                answer = eve.post("/access/enter", json={"key": key, "name": "Eve"})
                answers.append((answer.status_code, answer.content))
        assert len(set(answers)) == 1


def test_a_key_of_no_program_is_told_from_a_wrong_one_of_a_program_by_nothing(station: Gateway) -> None:
    with person(station, Role.owner) as owner:
        client, key, _ = program(station, Role.owner, owner)
        ended_client, ended, ended_id = program(station, Role.owner, owner, "ended")
        owner.delete(f"/access/programs/{ended_id}").raise_for_status()
        client.close()
        ended_client.close()
    answers = []
    for shown in (key[:-1] + ("A" if key[-1] != "A" else "B"), ended, new_program_key()[0], "no key at all"):
        with stranger(station, Authorization=f"Bearer {shown}") as eve:
            answer = eve.get("/status")
            answers.append((answer.status_code, answer.content))
    assert len(set(answers)) == 1
    assert answers[0][0] == 401


@pytest.mark.parametrize(
    ("name", "status"),
    [
        ("Íñigo Ñandú", 200),
        ("👩‍✈️ Ana", 200),
        ("محمد", 200),
        ("Ana\u202eoperador", 422),
        ("A\u200bna", 422),
        ("\u2066Ana\u2069", 422),
        ("\u3164", 422),
        ("Ana\nLuis", 422),
        ("x" * 41, 422),
        ("   ", 422),
    ],
)
def test_a_name_is_what_others_see_and_nothing_else(station: Gateway, name: str, status: int) -> None:
    with stranger(station) as ana:
        body = {"key": one_time_key(station, Role.viewer), "name": name}
        answer = ana.post("/access/enter", json=body)
        assert answer.status_code == status
        if status == 200:
            assert answer.json()["name"] == name


def test_half_a_character_and_a_megabyte_are_no_names(station: Gateway) -> None:
    with stranger(station) as ana:
        headers = {"Content-Type": "application/json"}
        half = b'{"key": "0000-0000-0000-0000", "name": "\\ud800"}'
        assert ana.post("/access/enter", content=half, headers=headers).status_code == 422
        long = b'{"key": "0000-0000-0000-0000", "name": "' + b"x" * 1_000_000 + b'"}'
        assert ana.post("/access/enter", content=long, headers=headers).status_code == 413
