"""Tiles of online sources, only while switched on: each tile is fetched when requested, and cached."""

from __future__ import annotations

import asyncio
import sqlite3
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final
from urllib.parse import urlsplit

import httpx

from epf_gcs import __version__
from epf_gcs.errors import ConflictError, GatewayError
from epf_gcs.maps.folder import unknown
from epf_gcs.maps.layer import MAX_TILE_BYTES, Bounds, Description, Layer, Tile, picture
from epf_gcs.maps.open_files import Stamp
from epf_gcs.maps.outside import Consent, LocalAddressError, OutsideTransport, is_local_as_written
from epf_gcs.maps.sources import OnlineChoice, Source, checked, expiry_s, local
from epf_gcs.maps.terrain_jobs import T
from epf_gcs.maps.tile_cache import CachedTile, TileCache

PREFIX: Final = "online-"
USER_AGENT: Final = f"EPF-GCS/{__version__} (ground control station; tiles on demand, no bulk download)"

# The limits of the Web Mercator projection.
_WORLD: Final = Bounds(-180.0, -85.0511, 180.0, 85.0511)
_AT_ONCE_PER_HOST: Final = 2
_MOST_WAITING_PER_HOST: Final = 200
_TIMEOUT: Final = httpx.Timeout(10.0, connect=5.0)
_NO_TILE_S: Final = 86400.0
_FIRST_PAUSE_S: Final = 10.0
_LONGEST_PAUSE_S: Final = 300.0


@dataclass(slots=True)
class _Host:
    """One server: two requests at a time, and a pause that doubles while it does not answer."""

    turns: asyncio.Semaphore
    waiting: int = 0
    pause_s: float = _FIRST_PAUSE_S
    quiet_until_s: float = 0.0


class Online:
    """Owned by the event loop; one thread reads and writes the cached tiles."""

    def __init__(
        self,
        path: Path,
        choice: OnlineChoice,
        remember: Callable[[OnlineChoice], None],
        report: Callable[[GatewayError], None],
        now_s: Callable[[], float],
    ) -> None:
        self._loop = asyncio.get_running_loop()
        self._path = path
        self._remember = remember
        self._report = report
        self._now_s = now_s
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="online maps")
        self._cache: TileCache | None = None
        self._client: httpx.AsyncClient | None = None
        self._hosts: dict[str, _Host] = {}
        self._under_way: dict[tuple[str, int, int, int], asyncio.Future[CachedTile | None]] = {}
        self._problems: dict[str, GatewayError] = {}
        self.choice = choice
        self.consent = Consent()
        """Servers in the local network that may be requested."""

    def layers(self) -> list[Layer]:
        """The sources as layers; none while online maps are switched off."""
        return [self._layer(source) for source in self.choice.sources] if self.choice.enabled else []

    def problem_of(self, source_id: str) -> GatewayError | None:
        """Why a source delivers no tiles now."""
        return self._problems.get(source_id)

    def has(self, layer_id: str) -> bool:
        """Whether this layer is an online source."""
        return any(layer_id == PREFIX + source.id for source in self.choice.sources)

    async def cached_bytes(self) -> int:
        """Size of the cache in bytes."""
        return await self._in_thread(lambda: self._opened().size_bytes if self._path.exists() else 0)

    async def choose(self, choice: OnlineChoice) -> None:
        """Use these sources. Raises InvalidInputError if one is not allowed, and then changes nothing."""
        for source in choice.sources:
            parts = urlsplit(checked(source).url)
            host = parts.hostname or ""
            if not self.consent.covers(parts.scheme, host, parts.port) and is_local_as_written(host):
                raise local(source)
        self.choice = choice
        self._problems.clear()
        self._hosts.clear()
        await self._in_thread(lambda: self._remember(choice))
        if self._path.exists():
            await self._in_thread(lambda: self._opened().trim(choice.limit_bytes))

    async def clear(self) -> None:
        """Delete all cached tiles."""
        if self._path.exists():
            await self._in_thread(lambda: self._opened().clear())

    async def tile(self, layer_id: str, zoom: int, column: int, row: int) -> tuple[Tile | None, Stamp]:
        """A cached or fetched tile; None if there is none or the server does not answer. Raises NotFoundError."""
        source = next((one for one in self.choice.sources if PREFIX + one.id == layer_id), None)
        if source is None:
            raise unknown(layer_id)
        inside = zoom <= source.maximum_zoom and max(column, row) < 1 << zoom
        if not self.choice.enabled or not inside:
            return None, ()
        key = (source.key, zoom, column, row)
        kept = await self._kept(key)
        if kept is None or kept.expires_s <= self._now_s():
            kept = await self._fetched_once(source, key, kept)
        return (None if kept is None else picture(kept.data)), (int(kept.expires_s) if kept else 0,)

    async def close(self) -> None:
        """Close the HTTP client and the cache."""
        client, self._client = self._client, None
        if client is not None:
            await client.aclose()
        await asyncio.to_thread(self._thread.shutdown)
        if self._cache is not None:
            self._cache.close()

    async def _fetched_once(
        self, source: Source, key: tuple[str, int, int, int], kept: CachedTile | None
    ) -> CachedTile | None:
        """Fetch a tile; simultaneous calls for the same tile share one request."""
        under_way = self._under_way.get(key)
        if under_way is not None:
            return await asyncio.shield(under_way)
        mine: asyncio.Future[CachedTile | None] = self._loop.create_future()
        self._under_way[key] = mine
        found = kept
        try:
            found = await self._ask_in_turn(source, key, kept)
        finally:
            del self._under_way[key]
            mine.set_result(found)
        return found

    async def _ask_in_turn(
        self, source: Source, key: tuple[str, int, int, int], kept: CachedTile | None
    ) -> CachedTile | None:
        host = self._hosts.setdefault(source.host, _Host(asyncio.Semaphore(_AT_ONCE_PER_HOST)))
        if host.waiting >= _MOST_WAITING_PER_HOST or self._now_s() < host.quiet_until_s:
            return kept
        host.waiting += 1
        try:
            async with host.turns:
                # While this request waited, the server may have failed or the source been switched off.
                if self._now_s() < host.quiet_until_s or source not in self.choice.sources or not self.choice.enabled:
                    return kept
                return await self._ask(source, host, key, kept)
        finally:
            host.waiting -= 1

    async def _ask(
        self, source: Source, host: _Host, key: tuple[str, int, int, int], kept: CachedTile | None
    ) -> CachedTile | None:
        headers = {} if kept is None or kept.etag is None or not kept.data else {"If-None-Match": kept.etag}
        try:
            client = await self._asking()
            async with client.stream("GET", source.address(*key[1:]), headers=headers) as answer:
                data = await _body(answer)
        except LocalAddressError:
            self._fails(source, host, local(source))
            return kept
        except (httpx.HTTPError, httpx.InvalidURL, OSError) as error:
            self._fails(source, host, _silent(source, error))
            return kept
        if answer.status_code == httpx.codes.NOT_MODIFIED and kept is not None:
            return await self._keep(source, key, kept._replace(expires_s=0.0), answer.headers)
        is_missing = answer.status_code in (httpx.codes.NOT_FOUND, httpx.codes.NO_CONTENT, httpx.codes.GONE)
        if is_missing:
            self._answers(source, host)
            return await self._put(key, CachedTile(b"", None, self._now_s() + _NO_TILE_S))
        if answer.status_code != httpx.codes.OK or data is None or picture(data) is None:
            self._fails(source, host, _refused(source, answer.status_code))
            return kept
        self._answers(source, host)
        return await self._keep(source, key, CachedTile(data, answer.headers.get("etag"), 0.0), answer.headers)

    async def _keep(
        self, source: Source, key: tuple[str, int, int, int], tile: CachedTile, headers: httpx.Headers
    ) -> CachedTile:
        until_s = expiry_s(source, headers, self._now_s())
        return tile if until_s is None else await self._put(key, tile._replace(expires_s=until_s))

    async def _kept(self, key: tuple[str, int, int, int]) -> CachedTile | None:
        try:
            return await self._in_thread(lambda: self._opened().get(key))
        except (OSError, sqlite3.Error):
            return None

    async def _put(self, key: tuple[str, int, int, int], tile: CachedTile) -> CachedTile:
        try:
            await self._in_thread(lambda: self._opened().put(key, tile, self.choice.limit_bytes))
        except (OSError, sqlite3.Error) as error:
            self._report(
                ConflictError(
                    "map_cache_not_written",
                    f"Tiles cannot be kept in {self._path.parent} ({error}): free the disk or correct its permissions.",
                    path=str(self._path.parent),
                )
            )
        return tile

    async def _asking(self) -> httpx.AsyncClient:
        """The HTTP client, constructed at the first request in a thread: loading the certificates takes long."""
        if self._client is None:
            made = await self._in_thread(
                lambda: httpx.AsyncClient(
                    headers={"User-Agent": USER_AGENT},
                    timeout=_TIMEOUT,
                    follow_redirects=False,
                    transport=OutsideTransport(self.consent),
                )
            )
            if self._client is None:
                self._client = made
        return self._client

    def _opened(self) -> TileCache:
        """The cache, opened at the first use. Call it only in the thread."""
        if self._cache is None:
            self._cache = TileCache(self._path, self._now_s)
        return self._cache

    def _answers(self, source: Source, host: _Host) -> None:
        host.pause_s = _FIRST_PAUSE_S
        self._problems.pop(source.id, None)

    def _fails(self, source: Source, host: _Host, problem: GatewayError) -> None:
        host.quiet_until_s = self._now_s() + host.pause_s
        host.pause_s = min(2 * host.pause_s, _LONGEST_PAUSE_S)
        if source.id not in self._problems:
            self._report(problem)
        self._problems[source.id] = problem

    def _layer(self, source: Source) -> Layer:
        about = Description(source.name, "imagery", _WORLD, 0, source.maximum_zoom, source.attribution)
        return Layer(PREFIX + source.id, source.name, "online", about, 0, self._problems.get(source.id))

    def _in_thread(self, work: Callable[..., T], /, *values: Any) -> Awaitable[T]:
        return self._loop.run_in_executor(self._thread, work, *values)


async def _body(answer: httpx.Response) -> bytes | None:
    """The whole body; None if it is too long for a tile."""
    data = bytearray()
    async for chunk in answer.aiter_bytes():
        data += chunk
        if len(data) > MAX_TILE_BYTES:
            return None
    return bytes(data)


def _silent(source: Source, error: Exception) -> GatewayError:
    return ConflictError(
        "map_source_silent",
        f"'{source.name}' does not answer ({type(error).__name__}): what was kept is shown. "
        "Check the connection to the internet.",
        name=source.name,
    )


def _refused(source: Source, status: int) -> GatewayError:
    return ConflictError(
        "map_source_refused",
        f"'{source.name}' answered with status {status} and no picture: check its address and its terms.",
        name=source.name,
        status=status,
    )
