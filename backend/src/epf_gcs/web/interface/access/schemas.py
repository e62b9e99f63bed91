"""Shapes of the people, programs, invitations and the log."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from epf_gcs.access.keys import MAX_KEY
from epf_gcs.access.roles import RoleName
from epf_gcs.contract.shapes import Input, Output

# What is shown to others, short enough for a button: no controls, nothing that nobody sees or that turns the direction
# of what stands beside it (of two people who look the same one could ask for the other's control), no half characters.
_SEEN = (
    r"^[^\x00-\x1f\x7f-\x9f\u00ad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180e\u200b\u200c\u200e\u200f"
    r"\u2028-\u202e\u2060-\u206f\u3164\ufeff\uffa0\ufff0-\uffff]*$"
)
Name = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=40, pattern=_SEEN)]
Place = Annotated[str, StringConstraints(strip_whitespace=True, max_length=40, pattern=_SEEN)]
Tab = Annotated[str, StringConstraints(pattern=r"^[a-z0-9-]{1,20}$")]


class Me(Output):
    """Who the station takes the caller for; `kind`, `role` and `name` are null for a stranger."""

    state: Literal["stranger", "waiting", "in"]
    kind: Literal["local", "person", "program", "anyone"] | None
    role: RoleName | None
    name: str | None
    anyone_may_fly: bool = Field(description="Everybody on the network may command without a key.")


class EnterInput(Input):
    """A one-time key, and who comes with it."""

    key: str = Field(min_length=1, max_length=MAX_KEY)
    name: Name
    place: Place = ""


class AskInput(Input):
    """Who asks to be let in."""

    name: Name
    place: Place = ""


class PersonState(Output):
    """Somebody who came in, waits to, or was ended."""

    id: str
    name: str
    place: str
    role: RoleName
    state: Literal["waiting", "in", "ended"]
    since_s: float = Field(description="Unix time.")
    seen_s: float = Field(description="Unix time of the last request.")
    address: str = Field(description="Where the person came from.")
    is_you: bool
    sessions: int


class People(Output):
    """All people, oldest first."""

    people: list[PersonState]


class PersonInput(Input):
    """What shall change: let somebody in, end somebody, another role or name."""

    role: RoleName | None = None
    name: Name | None = None
    state: Literal["in", "ended"] | None = None


class SessionState(Output):
    """One browser of a person."""

    id: str
    person: str
    name: str
    since_s: float
    seen_s: float
    address: str
    is_you: bool


class SessionList(Output):
    """All sessions, oldest first."""

    sessions: list[SessionState]


class ProgramState(Output):
    """A program with a key; `seen_s` null: never used."""

    id: str
    name: str
    role: RoleName
    since_s: float
    seen_s: float | None


class ProgramList(Output):
    """All programs, oldest first."""

    programs: list[ProgramState]


class ProgramInput(Input):
    """A new program."""

    name: Name
    role: RoleName = "viewer"


class NewProgram(Output):
    """Its key, which is shown this once."""

    program: ProgramState
    key: str


class InvitationState(Output):
    """A one-time key that can still be used."""

    id: str
    role: RoleName
    since_s: float
    until_s: float


class InvitationList(Output):
    """All of them, oldest first."""

    invitations: list[InvitationState]


class InvitationInput(Input):
    """A new one-time key, for somebody who opens the page at `tab`."""

    role: RoleName = "viewer"
    minutes: int = Field(default=60, ge=1, le=10080)
    tab: Tab | None = None
    address: str | None = Field(
        default=None,
        max_length=200,
        description="One of `GET /access/addresses`, for the QR code; by default the first of them.",
    )


class NewInvitation(Output):
    """Its key, which is shown this once; `address` has the key in it, and `qr_svg` is a picture of it; null where the
    address is of use on the station's own computer alone."""

    invitation: InvitationState
    key: str
    address: str
    qr_svg: str | None


class Addresses(Output):
    """Where browsers of other machines reach this station; empty where it listens on this computer alone."""

    addresses: list[str]
    tls: bool


class DeedState(Output):
    """Something that somebody did; `role` null: a stranger. `at`: where it stands in the log."""

    at: int
    t_s: float
    name: str
    kind: Literal["local", "person", "program", "stranger"]
    role: RoleName | None
    address: str
    deed: str
    what: str
    result: str


class Deeds(Output):
    """Newest first."""

    deeds: list[DeedState]
