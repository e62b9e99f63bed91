"""Hashes cost the event loop nothing, and only so many wait for their thread."""

from __future__ import annotations

import asyncio
import threading

import pytest

from epf_gcs.access.proving import MOST_WAITING, KeyVerifier
from epf_gcs.errors import TooManyError
from tests.support.waiting import DEADLINE_S

pytestmark = pytest.mark.anyio


async def test_no_hash_is_computed_on_the_event_loop() -> None:
    proving = KeyVerifier(lambda: 0.0)
    try:
        assert await proving.run(threading.get_ident) != threading.get_ident()
        assert await proving.attempt("10.0.0.1", threading.get_ident) != threading.get_ident()
    finally:
        proving.close()


async def test_a_full_queue_refuses_at_once_and_takes_more_once_there_is_room() -> None:
    proving = KeyVerifier(lambda: 0.0)
    may_go_on = threading.Event()
    tries = [asyncio.create_task(proving.attempt(f"10.0.0.{host}", may_go_on.wait)) for host in range(MOST_WAITING)]
    try:
        await asyncio.sleep(0)  # each has begun
        with pytest.raises(TooManyError) as refused:
            await asyncio.wait_for(proving.attempt("10.0.1.1", may_go_on.wait), DEADLINE_S)
        assert int(str(refused.value.params["retry_after_s"])) > 0
        may_go_on.set()
        assert await asyncio.gather(*tries) == [True] * MOST_WAITING
        assert await proving.attempt("10.0.1.1", may_go_on.wait)
    finally:
        may_go_on.set()
        proving.close()
