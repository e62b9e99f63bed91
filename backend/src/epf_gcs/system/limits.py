"""What a process may take: memory, processor time, open files. Windows has no such limits for a single process."""

from __future__ import annotations

import contextlib
import sys

_PLENTY: int = 1 << 20

if sys.platform == "win32":

    def limit_memory(_most_bytes: int) -> None:
        """Nothing there."""

    def limit_time(_most_s: int) -> None:
        """Nothing there."""

    def limit_time_from_now(_most_s: int) -> None:
        """Nothing there."""

    def raise_open_files() -> int:
        """How many files and sockets the process may open."""
        return _PLENTY

    def may_lock_memory() -> bool:
        """Whether nothing limits how much of its memory a process keeps out of the swap."""
        return False

else:
    import resource

    def limit_memory(most_bytes: int) -> None:
        """Limit this process's memory for good, where the system can."""
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))

    def limit_time(most_s: int) -> None:
        """Limit the processor time of this process for good."""
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_CPU, (most_s, most_s))

    def limit_time_from_now(most_s: int) -> None:
        """Limit the processor time that this process takes from now on; may be called again.

        The system then ends the process even if whoever would kill it is gone.
        """
        with contextlib.suppress(ValueError, OSError):
            used = resource.getrusage(resource.RUSAGE_SELF)
            until_s = int(used.ru_utime + used.ru_stime) + most_s
            resource.setrlimit(resource.RLIMIT_CPU, (until_s, resource.getrlimit(resource.RLIMIT_CPU)[1]))

    def raise_open_files() -> int:
        """Let this process open as many files and sockets as the system allows; returns how many."""
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
            soft = hard
        return _PLENTY if soft == resource.RLIM_INFINITY else soft

    def may_lock_memory() -> bool:
        """Whether nothing limits how much of its memory a process keeps out of the swap."""
        if sys.platform == "darwin":
            return False
        return resource.getrlimit(resource.RLIMIT_MEMLOCK)[0] == resource.RLIM_INFINITY
