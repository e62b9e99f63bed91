"""Online sources of tiles: their addresses, and how long their tiles may be cached."""

from __future__ import annotations

import email.utils
import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final
from urllib.parse import urlsplit

import orjson

from epf_gcs.errors import InvalidInputError

DEFAULT_LIMIT_BYTES: Final = 500_000_000
MAX_LIMIT_BYTES: Final = 100_000_000_000

_DAY_S: Final = 86400.0
# The least caching time that OpenStreetMap's tile usage policy demands.
_OSM_LEAST_S: Final = 7 * _DAY_S
_OSM_HOST: Final = "openstreetmap.org"
_UNSAID_S: Final = 7 * _DAY_S
_LONGEST_S: Final = 365 * _DAY_S
_MAX_AGE: Final = re.compile(r"(?:^|[\s,])max-age\s*=\s*\"?([0-9]{1,10})", re.IGNORECASE)
_PLACEHOLDERS: Final = ("{z}", "{x}", "{y}")


@dataclass(frozen=True, slots=True)
class Source:
    """One source. Its URL has {z}, {x} and {y}, rows from the north; {s} is for servers with several names."""

    id: str
    name: str
    url: str
    attribution: str
    maximum_zoom: int = 19

    @property
    def key(self) -> str:
        """The key of its tiles in the cache: another URL is another map."""
        return hashlib.blake2s(self.url.encode(), digest_size=8).hexdigest()

    @property
    def host(self) -> str:
        """The server that is requested."""
        return urlsplit(self.url).netloc.lower()

    def address(self, zoom: int, column: int, row: int) -> str:
        """The URL of one tile."""
        values = {"{z}": zoom, "{x}": column, "{y}": row, "{s}": "a"}
        return re.sub(r"\{[zxys]\}", lambda match: str(values[match[0]]), self.url)


OPENSTREETMAP: Final = Source(
    id="openstreetmap",
    name="OpenStreetMap",
    url="https://tile.openstreetmap.org/{z}/{x}/{y}.png",
    attribution="© OpenStreetMap contributors",
)


@dataclass(frozen=True, slots=True)
class OnlineChoice:
    """The operator's choice. Off by default: the station makes no requests to the internet unless told to."""

    enabled: bool = False
    limit_bytes: int = DEFAULT_LIMIT_BYTES
    sources: tuple[Source, ...] = field(default=(OPENSTREETMAP,))

    @classmethod
    def from_json(cls, text: bytes) -> OnlineChoice:
        """Read it. People can edit the file: invalid values are replaced by defaults. Raises ValueError if it is no
        JSON object."""
        values = dict(orjson.loads(text))
        try:
            sources = tuple(checked(Source(**source)) for source in values["sources"])
            limit_bytes = min(max(0, int(values["limit_bytes"])), MAX_LIMIT_BYTES)
            return cls(values["enabled"] is True, limit_bytes, sources)
        except (KeyError, TypeError, ValueError, InvalidInputError):
            return cls()


def checked(source: Source) -> Source:
    """Return the source if its URL is valid. Raises InvalidInputError."""
    try:
        parts = urlsplit(source.url)
        is_address = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
    except ValueError:
        is_address = False
    if not is_address or any(source.url.count(one) != 1 for one in _PLACEHOLDERS):
        raise InvalidInputError(
            "map_source_invalid",
            f"The address of '{source.name}' is none of a map: it begins with https:// or http:// and has "
            "{z}, {x} and {y} in it, each once.",
            name=source.name,
        )
    return source


def local(source: Source) -> InvalidInputError:
    """The error for a source in the local network that GCS_LOCAL_MAPS does not name."""
    return InvalidInputError(
        "map_source_local",
        f"'{source.name}' is a server in this network ({source.host}): name it in GCS_LOCAL_MAPS when the station is "
        "started, or choose one on the internet.",
        name=source.name,
        host=source.host,
    )


def expiry_s(source: Source, headers: Mapping[str, str], now_s: float) -> float | None:
    """Until when (Unix time) an answer may be used; None if the source forbids caching it."""
    control = headers.get("cache-control", "")
    hostname = urlsplit(source.url).hostname or ""
    is_osm = hostname == _OSM_HOST or hostname.endswith(f".{_OSM_HOST}")
    if "no-store" in control.lower():
        return None
    age = _MAX_AGE.search(control)
    if age is not None:
        lasts_s = float(age[1])
    elif "no-cache" in control.lower():
        lasts_s = 0.0
    else:
        lasts_s = _until_expires_s(headers, now_s)
    if is_osm:
        lasts_s = max(lasts_s, _OSM_LEAST_S)
    return now_s + min(lasts_s, _LONGEST_S)


def _until_expires_s(headers: Mapping[str, str], now_s: float) -> float:
    try:
        return max(0.0, email.utils.parsedate_to_datetime(headers["expires"]).timestamp() - now_s)
    except (KeyError, ValueError, TypeError):
        return _UNSAID_S
