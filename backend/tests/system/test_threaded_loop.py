"""Programs that are started on the loop of Windows: what they say, what they are told, how they end."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import Any, TypeVar

import pytest

from epf_gcs.system.threaded_loop import ThreadedLoop
from tests.support.waiting import DEADLINE_S

Answer = TypeVar("Answer")
PIPE = asyncio.subprocess.PIPE
MUCH = 4_000_000


def on_loop(work: Callable[[], Awaitable[Answer]]) -> Answer:
    async def within_time() -> Answer:
        async with asyncio.timeout(DEADLINE_S):
            return await work()

    with asyncio.Runner(loop_factory=ThreadedLoop) as runner:
        return runner.run(within_time())


@asynccontextmanager
async def program(code: str, **options: Any) -> AsyncIterator[asyncio.subprocess.Process]:
    process = await asyncio.create_subprocess_exec(sys.executable, "-c", code, **options)
    try:
        yield process
    finally:
        if process.returncode is None:
            process.kill()
        await process.wait()


def test_what_a_program_says_comes_line_by_line_and_then_its_exit_status() -> None:
    async def work() -> tuple[list[bytes], int]:
        code = "import sys; print('one', flush=True); print('two'); sys.exit(3)"
        async with program(code, stdout=PIPE) as process:
            assert process.stdout is not None
            return [line.strip() async for line in process.stdout], await process.wait()

    assert on_loop(work) == ([b"one", b"two"], 3)


def test_more_than_pipes_and_readers_hold_arrives_whole_in_both_directions() -> None:
    async def work() -> tuple[bytes, bytes | None]:
        code = "import sys; data = sys.stdin.buffer.read(); sys.stdout.buffer.write(data[::-1])"
        async with program(code, stdin=PIPE, stdout=PIPE, limit=1000) as process:
            return await process.communicate(bytes(range(200)) * (MUCH // 200))

    said, _ = on_loop(work)
    assert said == (bytes(range(200)) * (MUCH // 200))[::-1]


def test_whoever_writes_waits_for_a_program_that_does_not_read() -> None:
    async def work() -> bool:
        async with program("import time; time.sleep(1000)", stdin=PIPE) as process:
            assert process.stdin is not None
            process.stdin.write(bytes(MUCH))
            draining = asyncio.ensure_future(process.stdin.drain())
            done, _ = await asyncio.wait({draining}, timeout=0.2)
            process.kill()
            await process.wait()
            await asyncio.wait({draining})
            draining.exception()
            return bool(done)

    assert not on_loop(work)


def test_the_end_of_its_input_reaches_a_program() -> None:
    async def work() -> int:
        async with program("import sys; sys.exit(len(sys.stdin.read()))", stdin=PIPE) as process:
            assert process.stdin is not None
            process.stdin.write(b"seven..")
            process.stdin.close()
            return await process.wait()

    assert on_loop(work) == 7


def test_one_that_is_killed_is_noticed_while_others_still_hold_its_output() -> None:
    async def work() -> int:
        code = (
            "import subprocess, sys, time\n"
            "other = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(1000)'])\n"
            "print(other.pid, flush=True); time.sleep(1000)"
        )
        async with program(code, stdout=PIPE) as process:
            assert process.stdout is not None
            other = int(await process.stdout.readline())
            try:
                process.kill()
                return await process.wait()
            finally:
                os.kill(other, signal.SIGKILL)
                await process.stdout.read()  # its pipe is closed too

    assert on_loop(work) == -9


def test_a_program_that_is_not_there_is_told() -> None:
    async def work() -> None:
        await asyncio.create_subprocess_exec("/nowhere/at/all", stdout=PIPE)

    with pytest.raises(FileNotFoundError):
        on_loop(work)


def test_sockets_are_watched_on_the_same_loop() -> None:
    async def work() -> bytes:
        server = await asyncio.start_server(lambda _, writer: writer.close(), "127.0.0.1", 0)
        async with server, program("print('x')", stdout=PIPE) as process:
            reader, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
            assert await reader.read() == b""
            writer.close()
            assert process.stdout is not None
            return await process.stdout.read()

    assert on_loop(work).strip() == b"x"
