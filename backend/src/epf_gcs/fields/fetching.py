"""Fetches the pieces of a part: two at a time, again after a cut, at the pace that the server asks for."""

from __future__ import annotations

import asyncio
import email.utils
import time
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final

import httpx

from epf_gcs import __version__
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.fields.order import MOST_DEGREE_BYTES, Part, Place
from epf_gcs.fields.whole import (
    begins_as_map,
    begins_as_vector,
    is_tiff,
    is_whole_picture,
    is_whole_terrarium,
    is_whole_vector,
)
from epf_gcs.maps.layer import MAX_TILE_BYTES
from epf_gcs.maps.outside import LocalAddressError
from epf_gcs.maps.sources import Source, local

USER_AGENT: Final = f"EPF-GCS/{__version__} (ground control station; prepares a field for offline use)"

_AT_ONCE: Final = 2
_LONGEST_TILE_S: Final = 180.0
_LONGEST_DEGREE_S: Final = 3600.0
_LONGEST_ASKED_S: Final = 3600.0
_MOST_WRONG: Final = 5
# A cut comes from the network and passes; a tile that is always cut is broken where it comes from.
_MOST_CUT: Final = 300
_NONE: Final = (httpx.codes.NOT_FOUND, httpx.codes.NO_CONTENT, httpx.codes.GONE)
_LATER: Final = (httpx.codes.TOO_MANY_REQUESTS, httpx.codes.SERVICE_UNAVAILABLE)
_GZIP: Final = b"\x1f\x8b"
_UNPACK_GZIP: Final = 16 + zlib.MAX_WBITS


@dataclass(frozen=True, slots=True)
class Pace:
    """Pauses after failures in a row: they double. Silence is waited for without end; answers that are no map end the
    work after a few, for somebody has to correct something."""

    first_pause_s: float = 1.0
    longest_pause_s: float = 60.0
    silence_s: float = 20.0


class _LaterError(Exception):
    """Try again; `wait_s`: as long as the server asked for, None: as long as the pace says."""

    def __init__(self, problem: GatewayError, wait_s: float | None = None, costs: float = 0.0) -> None:
        """`costs`: its share of what ends the work, if no whole piece comes between."""
        super().__init__(problem.detail)
        self.problem, self.wait_s, self.costs = problem, wait_s, costs


class Fetcher:
    """Of one part. `arrived(place, data)`: a whole piece, empty if the source has none. `waits(problem, seconds)`: why
    nothing comes now; None when something came again."""

    def __init__(
        self,
        part: Part,
        client: httpx.AsyncClient,
        arrived: Callable[[Place, bytes], None],
        waits: Callable[[GatewayError | None, float], None],
        pace: Pace,
    ) -> None:
        self._part = part
        self._client = client
        self._arrived = arrived
        self._waits = waits
        self._pace = pace
        self._pause_s = pace.first_pause_s
        self._quiet_until_s = 0.0
        self._spent = 0.0

    async def fetch(self, places: Iterator[Place]) -> None:
        """Bring all of them. Raises GatewayError if the source gives something else again and again."""
        try:
            async with asyncio.TaskGroup() as together:
                for _ in range(_AT_ONCE):
                    together.create_task(self._one_after_the_other(places))
        except BaseExceptionGroup as group:
            raise group.exceptions[0] from None

    async def _one_after_the_other(self, places: Iterator[Place]) -> None:
        for place in places:
            data: bytes | None = None
            while data is None:
                await self._until_allowed()
                try:
                    data = await self._once(place)
                except _LaterError as error:
                    self._fails(error)
            self._pause_s, self._spent = self._pace.first_pause_s, 0.0
            self._waits(None, 0.0)
            self._arrived(place, data)

    async def _until_allowed(self) -> None:
        # The other request may have been told to wait longer meanwhile.
        while (left_s := self._quiet_until_s - time.monotonic()) > 0:  # noqa: ASYNC110 - a time, no event
            await asyncio.sleep(left_s)

    def _fails(self, error: _LaterError) -> None:
        self._spent += error.costs
        if self._spent > 1.0 - 1e-9:
            raise error.problem
        wait_s = self._pause_s if error.wait_s is None else max(error.wait_s, self._pace.first_pause_s)
        self._pause_s = min(2 * self._pause_s, self._pace.longest_pause_s)
        self._quiet_until_s = max(self._quiet_until_s, time.monotonic() + wait_s)
        self._waits(error.problem, wait_s)

    async def _once(self, place: Place) -> bytes:
        """One piece; empty if the source has none there. Raises _LaterError, or GatewayError for good."""
        longest_s = _LONGEST_DEGREE_S if self._part.is_of_degrees else _LONGEST_TILE_S
        # A packed answer may be a bomb: plain ones are asked for, and gzip alone is unpacked, within its bound. Vector
        # tiles have no checksum of their own: gzip's is asked for.
        headers = {"Accept-Encoding": "gzip" if self._part.kind == "vector" else "identity"}
        try:
            async with (
                asyncio.timeout(longest_s),
                self._client.stream("GET", self._part.address(place), headers=headers) as answer,
            ):
                return await self._read(answer)
        except LocalAddressError:
            raise local(Source("field", self._part.name, self._part.address(place), self._part.attribution)) from None
        except (httpx.InvalidURL, httpx.UnsupportedProtocol):
            raise self._wrong_answer("address").problem from None
        except (TimeoutError, httpx.TimeoutException) as error:
            raise _LaterError(self._silent(f"{longest_s:.0f} s")) from error
        except (httpx.ConnectError, OSError) as error:
            raise _LaterError(self._unreachable()) from error
        except httpx.HTTPError as error:
            raise _LaterError(self._silent(type(error).__name__)) from error

    async def _read(self, answer: httpx.Response) -> bytes:
        status = answer.status_code
        if status in _NONE:
            return b""
        if status in _LATER or status >= 500:
            raise _LaterError(self._silent(str(status)), _asked_s(answer.headers))
        if status != httpx.codes.OK:
            raise self._wrong_answer(str(status))
        most_bytes = MOST_DEGREE_BYTES if self._part.is_of_degrees else MAX_TILE_BYTES
        length = answer.headers.get("content-length", "")
        if length.isdecimal() and int(length) > most_bytes:
            raise self._wrong_answer(f"{int(length)} bytes")
        data = bytearray()
        async for chunk in answer.aiter_raw():
            data += chunk
            if len(data) > most_bytes:
                raise self._wrong_answer(f"> {most_bytes} bytes")
        if not data and self._part.kind == "vector":
            return b""  # a tile without anything in it
        plain = self._unpacked(bytes(data), answer.headers.get("content-encoding", ""), most_bytes)
        if not self._is_whole(plain):
            # What begins as it should was cut under way, whatever length its sender said.
            is_vector = self._part.kind == "vector"
            is_cut = begins_as_vector(plain) if is_vector else begins_as_map(plain) and not is_whole_picture(plain)
            raise self._wrong_answer("not a whole tile", 1 / _MOST_CUT if is_cut else 1 / _MOST_WRONG)
        return plain

    def _unpacked(self, data: bytes, encoding: str, most_bytes: int) -> bytes:
        # Some servers have packed vector tiles and do not say so.
        is_packed = self._part.kind == "vector" and data.startswith(_GZIP)
        if encoding.strip().lower() in ("", "identity") and not is_packed:
            return data
        unpacking = zlib.decompressobj(_UNPACK_GZIP)
        try:
            plain = unpacking.decompress(data, most_bytes)
        except zlib.error:
            raise self._wrong_answer(f"content-encoding {encoding[:20]}") from None
        if not unpacking.eof:
            if not unpacking.unconsumed_tail:
                raise self._wrong_answer("not a whole tile", 1 / _MOST_CUT)
            raise self._wrong_answer(f"> {most_bytes} bytes")
        return plain

    def _is_whole(self, data: bytes) -> bool:
        if self._part.is_of_degrees:
            return is_tiff(data)
        if self._part.kind == "vector":
            return is_whole_vector(data)
        return is_whole_terrarium(data) if self._part.kind == "heights" else is_whole_picture(data)

    def _unreachable(self) -> GatewayError:
        return ConflictError(
            "field_source_unreachable",
            f"'{self._part.name}' cannot be reached: does this computer have internet? It is asked again by itself.",
            name=self._part.name,
        )

    def _silent(self, why: str) -> GatewayError:
        return ConflictError(
            "field_source_silent",
            f"'{self._part.name}' does not answer now ({why}): it is asked again by itself.",
            name=self._part.name,
            why=why,
        )

    def _wrong_answer(self, why: str, costs: float = 1 / _MOST_WRONG) -> _LaterError:
        problem = ConflictError(
            "field_source_wrong",
            f"'{self._part.name}' answers with something else than whole tiles ({why}): check its address and its "
            "terms, then go on.",
            name=self._part.name,
            why=why,
        )
        return _LaterError(problem, costs=costs)


def _asked_s(headers: Any) -> float | None:
    """How long a server asks to wait (Retry-After: seconds or a date); None if it does not say."""
    said = headers.get("retry-after", "").strip()
    if said.isdecimal():
        return min(float(said), _LONGEST_ASKED_S)
    try:
        until_s = email.utils.parsedate_to_datetime(said).timestamp()
    except (ValueError, TypeError):
        return None
    return min(max(0.0, until_s - time.time()), _LONGEST_ASKED_S)
