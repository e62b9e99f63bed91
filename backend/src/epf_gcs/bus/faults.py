"""Errors as JSON, so that the station raises the same error as the vehicle."""

from __future__ import annotations

from typing import Any, Final

from epf_gcs.errors import BoardError, ConflictError, GatewayError, InvalidInputError, LinkError, NotFoundError

_KINDS: Final[dict[str, type[GatewayError]]] = {
    "invalid": InvalidInputError,
    "not_found": NotFoundError,
    "conflict": ConflictError,
    "link": LinkError,
    "board": BoardError,
    "internal": GatewayError,
}
_NAMES: Final = {kind: name for name, kind in _KINDS.items()}


def fault_of(error: GatewayError) -> dict[str, Any]:
    """An error as JSON values."""
    return {
        "kind": _NAMES.get(type(error), "internal"),
        "code": error.code,
        "detail": error.detail,
        "params": error.params,
    }


def error_of(fault: dict[str, Any]) -> GatewayError:
    """The error that the other side raised."""
    kind = _KINDS.get(str(fault.get("kind")), GatewayError)
    error = kind(fault.get("code", "internal"), str(fault.get("detail", "It does not say why.")))
    error.params = dict(fault.get("params") or {})
    return error
