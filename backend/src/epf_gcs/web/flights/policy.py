"""What happens when the disk fills, as the person chose it: by default nothing is deleted."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

import orjson

from epf_gcs.disk import replace_file

_KEEP_FREE_BYTES: Final = 5_000_000_000


@dataclass(frozen=True, slots=True)
class Policy:
    """With `delete_oldest`, the bin and then the oldest flights that are not pinned are deleted for good until
    `keep_free_bytes` are free."""

    delete_oldest: bool = False
    keep_free_bytes: int = _KEEP_FREE_BYTES


def read_policy(path: Path) -> Policy:
    """The choice; the default, which deletes nothing, where there is none or it cannot be read."""
    try:
        found = orjson.loads(path.read_bytes())
        delete_oldest, keep_free_bytes = found["delete_oldest"], found["keep_free_bytes"]
    except (OSError, ValueError, LookupError, TypeError):
        return Policy()
    is_right = isinstance(delete_oldest, bool) and type(keep_free_bytes) is int
    return Policy(delete_oldest, keep_free_bytes) if is_right else Policy()


def write_policy(path: Path, policy: Policy) -> None:
    """Keep the choice. Raises OSError."""
    path.parent.mkdir(parents=True, exist_ok=True)
    replace_file(path, orjson.dumps(asdict(policy)))
