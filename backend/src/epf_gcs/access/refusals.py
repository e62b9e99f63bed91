"""Why control cannot be had, given or used: the errors of the rules."""

from __future__ import annotations

from epf_gcs.access.changes import Page
from epf_gcs.access.roles import Role
from epf_gcs.errors import ConflictError, NotFoundError, NotYoursError, RoleError


def held(holder: Page) -> ConflictError:
    """Another page has it."""
    return ConflictError(
        "control_held",
        f"{holder.name} has control: ask for it, or wait until it is given back.",
        client=holder.client,
        name=holder.name,
    )


def not_held() -> ConflictError:
    """Nobody has it."""
    return ConflictError("control_not_held", "Nobody has control: it can be taken.")


def unconfirmed(holder: Page) -> ConflictError:
    """An owner takes it from another page only on purpose."""
    return ConflictError(
        "control_unconfirmed",
        f"{holder.name} has control: to take it away send 'confirm': true.",
        client=holder.client,
        name=holder.name,
    )


def refused(holder: Page, wait_s: float) -> ConflictError:
    """It was asked for and refused just now."""
    return ConflictError(
        "control_refused",
        f"{holder.name} has just refused: ask again in {wait_s:.0f} s.",
        name=holder.name,
        wait_s=round(wait_s, 1),
    )


def not_asked(client: str) -> ConflictError:
    """There is no such request."""
    return ConflictError("control_not_asked", "That page does not ask for control any more.", client=client)


def only_watches(page: Page) -> ConflictError:
    """It cannot be given to a viewer."""
    return ConflictError(
        "client_may_not_command", f"{page.name} only watches: an owner can change that role.", name=page.name
    )


def silent(page: Page) -> ConflictError:
    """It cannot be given to a page that is not heard."""
    return ConflictError("client_silent", f"Nothing is heard of {page.name} at the moment: try again.", name=page.name)


def unknown(client: str) -> NotFoundError:
    """No page has this id."""
    return NotFoundError(
        "client_unknown",
        f"No page with the id '{client}' is on the stream: open the stream and use the id of its hello.",
        client=client,
    )


def not_yours(client: str) -> NotYoursError:
    """A page of another session has this id."""
    return NotYoursError(
        "client_not_yours",
        "This id is of somebody else's page: use the one of the hello of your own stream.",
        client=client,
    )


def too_low(page: Page) -> RoleError:
    """A viewer asks for it."""
    return RoleError(
        "role_too_low",
        f"This needs the role 'operator', and you are '{page.role.name}': ask an owner of this station.",
        least=Role.operator.name,
        role=page.role.name,
    )
