"""What is told to a viewer who needs a part of the program that is not installed here."""

from __future__ import annotations

from epf_gcs.errors import ConflictError
from epf_gcs.extras import Extra


def missing(extra: Extra) -> ConflictError:
    """The error that says what is missing, and the command that installs it."""
    return ConflictError("extra_missing", extra.sentence(), extra=extra.name, command=extra.command())


def require(extra: Extra) -> None:
    """Raises that error unless the part is there."""
    if not extra.is_here:
        raise missing(extra)
