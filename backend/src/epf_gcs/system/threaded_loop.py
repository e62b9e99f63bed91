"""An event loop that watches sockets and starts programs too, on every system.

Windows' Python has one loop for each of the two. Here each pipe of a program, and its end, has a thread that waits.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import queue
import subprocess
import sys
import threading
from asyncio.base_subprocess import BaseSubprocessTransport
from collections.abc import Callable
from typing import IO, Any, Final

from epf_gcs.system.loops import new_loop

_READ_BYTES: Final = 65_536
# Bytes that wait for a program to read them, beyond which whoever writes is asked to wait.
_MUCH_UNREAD: Final = 65_536


def new_loop_with_programs() -> asyncio.AbstractEventLoop:
    """A loop for a process that starts others: the system's own where it can do both."""
    return ThreadedLoop() if sys.platform == "win32" else new_loop()


class ThreadedLoop(asyncio.SelectorEventLoop):
    """`asyncio.create_subprocess_exec` works on it, with pipes as asyncio tells them."""

    async def connect_read_pipe(self, protocol_factory: Callable[[], Any], pipe: Any) -> Any:
        """Read a pipe of a program."""
        protocol = protocol_factory()
        return _Reading(self, pipe, protocol), protocol

    async def connect_write_pipe(self, protocol_factory: Callable[[], Any], pipe: Any) -> Any:
        """Write to a pipe of a program."""
        protocol = protocol_factory()
        return _Writing(self, pipe, protocol), protocol

    async def _make_subprocess_transport(
        self,
        protocol: Any,
        args: Any,
        shell: bool,  # noqa: FBT001 - asyncio's own order
        stdin: Any,
        stdout: Any,
        stderr: Any,
        bufsize: int,
        extra: Any = None,
        **options: Any,
    ) -> _Program:
        """What `subprocess_exec` of every loop calls. Raises OSError."""
        waiter = self.create_future()
        program = _Program(
            self, protocol, args, shell, stdin, stdout, stderr, bufsize, waiter=waiter, extra=extra, **options
        )
        try:
            await waiter
        except BaseException:
            program.close()
            raise
        return program

    def tell(self, heard: Callable[..., None], *arguments: Any) -> None:
        """Call something on the loop, from a thread; nothing happens once the loop has ended."""
        with contextlib.suppress(RuntimeError):
            self.call_soon_threadsafe(heard, *arguments)


class _Program(BaseSubprocessTransport):
    """A program that was started."""

    def _start(
        self,
        args: Any,
        shell: bool,  # noqa: FBT001 - asyncio's own order
        stdin: Any,
        stdout: Any,
        stderr: Any,
        bufsize: int,
        **options: Any,
    ) -> None:
        self._proc = process = subprocess.Popen(
            args, shell=shell, stdin=stdin, stdout=stdout, stderr=stderr, bufsize=bufsize, **options
        )
        threading.Thread(target=self._wait_for_end, args=(process,), name="program", daemon=True).start()

    def _process_exited(self, returncode: int) -> None:
        # Some versions of Python tell whoever waits only once its pipes are closed, which its own children may hold.
        waiting: list[asyncio.Future[int]] = self._exit_waiters
        self._exit_waiters = []
        super()._process_exited(returncode)
        for waiter in waiting:
            if not waiter.done():
                waiter.set_result(returncode)

    def _wait_for_end(self, process: subprocess.Popen[bytes]) -> None:
        loop: Any = self._loop
        loop.tell(self._process_exited, process.wait())


class _Pipe(asyncio.Transport):
    """What reading and writing have in common: the thread owns the pipe, and closes it at its end."""

    def __init__(self, loop: ThreadedLoop, pipe: IO[bytes], protocol: Any) -> None:
        super().__init__({"pipe": pipe})
        self._loop = loop
        self._pipe = pipe
        self._protocol = protocol
        self._is_closing = False
        loop.call_soon(protocol.connection_made, self)
        threading.Thread(target=self._run, name="pipe", daemon=True).start()

    def is_closing(self) -> bool:
        """Whether it is closed, or will be."""
        return self._is_closing

    def _run(self) -> None:
        fault: OSError | None = None
        try:
            self._carry()
        except OSError as error:
            fault = error
        with contextlib.suppress(OSError):
            self._pipe.close()
        self._loop.tell(self._lost, fault)

    def _carry(self) -> None:
        raise NotImplementedError

    def _lost(self, fault: OSError | None) -> None:
        self._is_closing = True
        self._protocol.connection_lost(fault)


class _Reading(_Pipe):
    def __init__(self, loop: ThreadedLoop, pipe: IO[bytes], protocol: Any) -> None:
        self._may_read = threading.Event()
        self._may_read.set()
        super().__init__(loop, pipe, protocol)

    def pause_reading(self) -> None:
        """Read no more for now; what was read is still told."""
        self._may_read.clear()

    def resume_reading(self) -> None:
        """Read on."""
        self._may_read.set()

    def close(self) -> None:
        """Tell nothing more. The thread ends with the program, which asyncio kills where it still runs."""
        self._is_closing = True
        self._may_read.set()

    def _carry(self) -> None:
        descriptor = self._pipe.fileno()
        while data := os.read(descriptor, _READ_BYTES):
            self._loop.tell(self._read, data)
            self._may_read.wait()
        self._loop.tell(self._protocol.eof_received)

    def _read(self, data: bytes) -> None:
        if not self._is_closing:
            self._protocol.data_received(data)


class _Writing(_Pipe):
    def __init__(self, loop: ThreadedLoop, pipe: IO[bytes], protocol: Any) -> None:
        self._said: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._unread_bytes = 0
        self._has_paused = False
        super().__init__(loop, pipe, protocol)

    def write(self, data: bytes | bytearray | memoryview[Any]) -> None:
        """Queue it."""
        if self._is_closing or not data:
            return
        self._unread_bytes += len(data)
        self._said.put(bytes(data))
        if self._unread_bytes > _MUCH_UNREAD and not self._has_paused:
            self._has_paused = True
            self._protocol.pause_writing()

    def can_write_eof(self) -> bool:
        """A pipe can be ended."""
        return True

    def write_eof(self) -> None:
        """Write what is queued, then end the pipe."""
        self.close()

    def close(self) -> None:
        """The same."""
        if not self._is_closing:
            self._is_closing = True
            self._said.put(None)

    def abort(self) -> None:
        """The same: a pipe that nobody reads ends with its program."""
        self.close()

    def get_write_buffer_size(self) -> int:
        """Bytes that wait."""
        return self._unread_bytes

    def _carry(self) -> None:
        descriptor = self._pipe.fileno()
        while (data := self._said.get()) is not None:
            rest = memoryview(data)
            while rest:
                rest = rest[os.write(descriptor, rest) :]
            self._loop.tell(self._wrote, len(data))

    def _wrote(self, count: int) -> None:
        self._unread_bytes -= count
        if self._has_paused and self._unread_bytes == 0:
            self._has_paused = False
            self._protocol.resume_writing()
