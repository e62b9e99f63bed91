"""Entering, leaving, and what owners decide: people, sessions, programs, invitations; and the log of deeds."""

from __future__ import annotations

import asyncio
from functools import partial
from typing import Annotated, Final, Literal

from fastapi import APIRouter, Path, Query, Request, Response, status

from epf_gcs.access.addresses import addresses, is_of_this_computer_alone, qr_svg, qr_svg_of_plain, with_key
from epf_gcs.access.admission import Admission
from epf_gcs.access.caller import ANYONE, Caller, Credentials
from epf_gcs.access.roles import Role, name_of
from epf_gcs.access.store import Invitation, Person, Program, Session
from epf_gcs.errors import ConflictError, InvalidInputError
from epf_gcs.web.interface.access.schemas import (
    Addresses,
    AskInput,
    Deeds,
    DeedState,
    EnterInput,
    InvitationInput,
    InvitationList,
    InvitationState,
    Me,
    NewInvitation,
    NewProgram,
    People,
    PersonInput,
    PersonState,
    ProgramInput,
    ProgramList,
    ProgramState,
    SessionList,
    SessionState,
    Tab,
)
from epf_gcs.web.interface.deps import AdmissionDep, CallerDep, ShownDep
from epf_gcs.web.serving.access_table import API
from epf_gcs.web.serving.problems import problems, reading_problems

router = APIRouter(prefix="/access", tags=["access"])

Id = Annotated[str, Path(pattern="^[0-9a-f]{8,16}$", examples=["0123456789abcdef"])]
_MOST_DEEDS: Final = 500
# Whole in every language, and farther than a disk reaches.
_FARTHEST: Final = 2**53 - 1
SVG: Final = "image/svg+xml"


@router.get("/me", responses=reading_problems())
async def get_me(caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> Me:
    """Who the station takes you for."""
    return _me(admission, caller, shown)


@router.post("/enter", responses=problems(409, 507))
async def post_enter(body: EnterInput, response: Response, shown: ShownDep, admission: AdmissionDep) -> Me:
    """Come in with a one-time key. The answer sets the cookie of a new session; one from before ends."""
    cookie, _, session = await admission.enter(body.key, body.name, body.place, shown)
    response.headers["Set-Cookie"] = admission.set_cookie(cookie)
    return _me_of(admission, admission.current(session.id))


@router.post("/ask", responses=problems(409, 507))
async def post_ask(body: AskInput, response: Response, shown: ShownDep, admission: AdmissionDep) -> Me:
    """Wait to be let in by an owner. The answer sets a cookie that is worth something once an owner agrees."""
    cookie, _, _ = await admission.ask(body.name, body.place, shown)
    response.headers["Set-Cookie"] = admission.set_cookie(cookie)
    return Me(state="waiting", kind=None, role=None, name=body.name, anyone_may_fly=admission.policy.anyone_may_fly)


@router.post("/leave", responses=problems(507))
async def post_leave(response: Response, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> Me:
    """End one's own session, or stop waiting."""
    found = admission.find(shown)
    if found is not None:
        admission.log.note(caller, shown.peer.host, "left", "", "done")
        await admission.end_session(found[0].id)
        response.headers["Set-Cookie"] = admission.set_cookie("")
    return _me_of(admission, admission.resolve(shown))


@router.get("/people", responses=reading_problems())
async def get_people(caller: CallerDep, admission: AdmissionDep) -> People:
    """Everybody who came in, waits to, or was ended."""
    people = sorted(admission.sessions.people.values(), key=lambda person: person.made_s)
    return People(people=[_person(admission, caller, person) for person in people])


@router.patch("/people/{person_id}", responses=problems(404, 409, 507))
async def patch_person(
    person_id: Id, body: PersonInput, caller: CallerDep, shown: ShownDep, admission: AdmissionDep
) -> PersonState:
    """Let somebody in, end somebody, or change role or name."""
    role = None if body.role is None else Role[body.role]
    _keep_an_owner(admission, person_id, stays=body.state != "ended" and role in (None, Role.owner))
    person = admission.sessions.change(person_id, name=body.name, role=role, state=body.state)
    await admission.write(partial(admission.store.put, person))
    if person.state == "ended":
        await admission.write(partial(admission.store.remove_sessions, person.id))
    what = f"{person.name}: {person.state}, {Role(person.role).name}"
    admission.log.note(caller, shown.peer.host, "people", what, "done")
    return _person(admission, caller, person)


@router.delete("/people/{person_id}", status_code=status.HTTP_204_NO_CONTENT, responses=problems(404, 409, 507))
async def delete_person(person_id: Id, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> None:
    """Forget somebody; all sessions end."""
    _keep_an_owner(admission, person_id, stays=False)
    name = person.name if (person := admission.sessions.people.get(person_id)) is not None else ""
    await admission.forget(person_id)
    admission.log.note(caller, shown.peer.host, "people", f"{name}: forgotten", "done")


@router.get("/sessions", responses=reading_problems())
async def get_sessions(caller: CallerDep, admission: AdmissionDep) -> SessionList:
    """Every browser that is in."""
    return SessionList(sessions=[_session(admission, caller, session) for session in admission.sessions.all()])


@router.delete("/sessions/{session_id}", status_code=status.HTTP_204_NO_CONTENT, responses=problems(404, 507))
async def delete_session(session_id: Id, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> None:
    """End the session of one browser."""
    session = await admission.end_session(session_id)
    person = admission.sessions.people.get(session.person)
    admission.log.note(caller, shown.peer.host, "session_ended", "" if person is None else person.name, "done")


@router.get("/programs", responses=reading_problems())
async def get_programs(admission: AdmissionDep) -> ProgramList:
    """Every program that has a key."""
    return ProgramList(programs=[_program(program, seen_s) for program, seen_s in admission.programs.all()])


@router.post("/programs", status_code=status.HTTP_201_CREATED, responses=problems(409, 507))
async def post_program(body: ProgramInput, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> NewProgram:
    """Make a key for a program. It is shown this once."""
    key, program = await admission.make_program(body.name, Role[body.role])
    admission.log.note(caller, shown.peer.host, "program_made", f"{body.name}: {body.role}", "done")
    return NewProgram(program=_program(program, 0.0), key=key)


@router.delete("/programs/{program_id}", status_code=status.HTTP_204_NO_CONTENT, responses=problems(404, 507))
async def delete_program(program_id: Id, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> None:
    """End a program's key."""
    program = await admission.end_program(program_id)
    admission.log.note(caller, shown.peer.host, "program_ended", program.name, "done")


@router.get("/invitations", responses=reading_problems(507))
async def get_invitations(admission: AdmissionDep) -> InvitationList:
    """The one-time keys that can still be used."""
    found = await admission.invitations.all(admission.moment())
    return InvitationList(invitations=[_invitation(admission, invitation) for invitation in found])


@router.post("/invitations", status_code=status.HTTP_201_CREATED, responses=problems(409, 507))
async def post_invitation(
    body: InvitationInput, request: Request, caller: CallerDep, shown: ShownDep, admission: AdmissionDep
) -> NewInvitation:
    """Make a one-time key, with the address and the QR code that bring somebody in. It is shown this once."""
    known = _addresses(admission)
    if body.address is not None and body.address not in known:
        raise InvalidInputError(
            "invalid_request", "'address' is none of this station's: see GET /access/addresses.", field="address"
        )
    base = body.address or (known[0] if known else str(request.base_url).rstrip("/"))
    key, made = await admission.invitations.make(Role[body.role], body.minutes, admission.moment())
    admission.log.note(caller, shown.peer.host, "invited", f"{body.role}, {body.minutes} min", "done")
    address = with_key(base, key, body.tab)
    code = None if is_of_this_computer_alone(base) else await asyncio.to_thread(qr_svg, address)
    return NewInvitation(invitation=_invitation(admission, made), key=key, address=address, qr_svg=code)


@router.delete("/invitations/{invitation_id}", status_code=status.HTTP_204_NO_CONTENT, responses=problems(404, 507))
async def delete_invitation(invitation_id: Id, caller: CallerDep, shown: ShownDep, admission: AdmissionDep) -> None:
    """End a one-time key before it is used."""
    await admission.invitations.end(invitation_id)
    admission.log.note(caller, shown.peer.host, "invitation_ended", "", "done")


@router.get("/addresses", responses=reading_problems())
async def get_addresses(admission: AdmissionDep) -> Addresses:
    """Where browsers of other machines reach this station."""
    return Addresses(addresses=_addresses(admission), tls=admission.is_secure)


@router.get(
    "/code",
    responses={200: {"content": {SVG: {"schema": {"type": "string"}}}}, **reading_problems()},
    response_class=Response,
)
async def get_code(
    request: Request,
    admission: AdmissionDep,
    address: Annotated[str, Query(max_length=200, description="Of `GET /access/addresses`, or the one asked at.")],
    to: Annotated[Literal["page", "authority"], Query(description="What it leads to.")] = "page",
    tab: Annotated[Tab | None, Query(description="The tab that is opened.")] = None,
) -> Response:
    """A QR code of an address of this station, without a key in it (SVG)."""
    if address not in (*_addresses(admission), str(request.base_url).rstrip("/")):
        raise InvalidInputError(
            "invalid_request", "'address' is none of this station's: see GET /access/addresses.", field="address"
        )
    if is_of_this_computer_alone(address):
        raise InvalidInputError(
            "invalid_request", "'address' is of use on the station's computer alone.", field="address"
        )
    text = f"{address}{API}/access/authority" if to == "authority" else f"{address}/" + (f"#tab={tab}" if tab else "")
    return Response(await asyncio.to_thread(qr_svg_of_plain, text), media_type=SVG)


@router.get("/log", responses=reading_problems())
async def get_log(
    admission: AdmissionDep,
    before: Annotated[int | None, Query(ge=0, le=_FARTHEST, description="`at` of the last deed that was read.")] = None,
    limit: Annotated[int, Query(ge=1, le=_MOST_DEEDS)] = 100,
    text: Annotated[str, Query(max_length=100, description="Only lines that have this in them.")] = "",
) -> Deeds:
    """What people did, newest first."""
    found = await admission.log.newest(before, limit, text)
    return Deeds(deeds=[DeedState.model_validate(deed) for deed in found])


def _me(admission: Admission, caller: Caller | None, shown: Credentials) -> Me:
    found = admission.find(shown) if caller is None else None
    if found is not None and found[1].state == "waiting":
        anyone = admission.policy.anyone_may_fly
        return Me(state="waiting", kind=None, role=None, name=found[1].name, anyone_may_fly=anyone)
    return _me_of(admission, caller)


def _me_of(admission: Admission, caller: Caller | None) -> Me:
    anyone = admission.policy.anyone_may_fly
    if caller is None:
        return Me(state="stranger", kind=None, role=None, name=None, anyone_may_fly=anyone)
    return Me(
        state="in",
        kind="anyone" if caller.id == ANYONE else caller.kind,
        role=name_of(caller.role),
        name=caller.name,
        anyone_may_fly=anyone,
    )


def _keep_an_owner(admission: Admission, person_id: str, *, stays: bool) -> None:
    """Raise ConflictError where nobody could change anything any more."""
    person = admission.sessions.people.get(person_id)
    is_owner = person is not None and person.state == "in" and person.role == Role.owner
    if is_owner and not stays and not admission.policy.trusts_this_computer and admission.sessions.owners() == 1:
        raise ConflictError("access_last_owner", "This is the last owner: make somebody else an owner first.")


def _addresses(admission: Admission) -> list[str]:
    policy = admission.policy
    return addresses(policy.host, admission.port, secure=admission.is_secure, reached_at=policy.reached_at)


def _person(admission: Admission, caller: Caller | None, person: Person) -> PersonState:
    sessions = admission.sessions.of_person(person.id)
    return PersonState(
        id=person.id,
        name=person.name,
        place=person.place,
        role=name_of(person.role),
        state=person.state,
        since_s=person.made_s,
        seen_s=max((admission.sessions.seen_s(session) for session in sessions), default=person.seen_s),
        address=person.address,
        is_you=caller is not None and caller.kind == "person" and caller.id == person.id,
        sessions=len(sessions),
    )


def _session(admission: Admission, caller: Caller | None, session: Session) -> SessionState:
    person = admission.sessions.people.get(session.person)
    return SessionState(
        id=session.id,
        person=session.person,
        name="" if person is None else person.name,
        since_s=session.made_s,
        seen_s=admission.sessions.seen_s(session),
        address=session.address,
        is_you=caller is not None and caller.session == session.id,
    )


def _program(program: Program, seen_s: float) -> ProgramState:
    return ProgramState(
        id=program.id,
        name=program.name,
        role=name_of(program.role),
        since_s=program.made_s,
        seen_s=seen_s or None,
    )


def _invitation(admission: Admission, invitation: Invitation) -> InvitationState:
    """By the station's clock, also where the system's time was set since another program made it."""
    now = admission.moment()
    until_s = now.unix_s + invitation.left_s(now)
    return InvitationState(
        id=invitation.id,
        role=name_of(invitation.role),
        since_s=until_s - (invitation.until_s - invitation.made_s),
        until_s=until_s,
    )
