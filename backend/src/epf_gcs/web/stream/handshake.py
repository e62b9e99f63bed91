"""The beginning of a WebSocket: its address, its headers, and why it is refused."""

from __future__ import annotations

from http import HTTPStatus
from urllib.parse import SplitResult, urlsplit


class Refusal(Exception):  # noqa: N818 - an answer to the handshake, not a fault
    """The handshake is refused with this status and sentence."""

    def __init__(self, status: HTTPStatus, text: str) -> None:
        super().__init__(text)
        self.status = status
        self.text = text


def address_parts(address: str) -> SplitResult:
    """Path and query. Raises Refusal if this is not a URL."""
    try:
        return urlsplit(address)
    except ValueError as error:
        raise Refusal(HTTPStatus.BAD_REQUEST, "This is no address.") from error
