"""Write the shared vectors as a C header for the firmware's tests.

Usage: make_vectors.py VECTORS_FOLDER OUTPUT

The tests read the same bytes as the other languages; only the notation changes here. Fails when a file holds nothing,
so that an empty folder cannot pass for agreement.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

KINDS = {
    "bad_type_bits": "frame_damage_type_bits",
    "unknown_type": "frame_damage_unknown_type",
    "bad_checksum": "frame_damage_checksum",
    "bad_end": "frame_damage_end",
}
DIALECTS = {"to_pc": "&frame_from_board", "to_board": "&frame_to_board"}


def rows(path: Path) -> list[dict[str, Any]]:
    """Return the JSON objects of a file, one a line."""
    found = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line]
    if not found:
        raise SystemExit(f"{path} holds no vector")
    return found


def text(value: str) -> str:
    """Return a C string literal."""
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\r", "\\r") + '"'


def data(value: str) -> str:
    """Return bytes in hexadecimal as pointer and size."""
    octets = bytes.fromhex(value)
    literal = "".join(f"\\x{octet:02x}" for octet in octets)
    return f'(const uint8_t*)"{literal}", {len(octets)}'


def telemetry_lines(folder: Path) -> Iterator[str]:
    """Yield the table of single frames."""
    yield "static const telemetry_vector_t telemetry_vectors[] = {"
    for row in rows(folder / "telemetry.jsonl"):
        kind = f"(int){KINDS[row['refused']]}" if "refused" in row else "-1"
        yield f"    {{{text(row['case'] + ': ' + row['sent'])}, {data(row['hex'])}, {kind}}},"
    yield "};"


def command_lines(folder: Path) -> Iterator[str]:
    """Yield the table of captured uses of the station's controls, with how many commands each of them sent."""
    yield "static const command_vector_t command_vectors[] = {"
    for row in rows(folder / "commands.jsonl"):
        commands = sum("command" in sent for sent in row["sends"])
        yield f"    {{{text(row['action'])}, {data(row['hex'])}, {commands}}},"
    yield "};"


def stream_lines(folder: Path) -> Iterator[str]:
    """Yield the table of damaged streams; the expected frames as one byte string: type, payload, type, ..."""
    streams = rows(folder / "stream.jsonl")
    for number, row in enumerate(streams):
        frames = "".join(f"    {{{f['type']}, {data(f['payload'])}}},\n" for f in row["frames"])
        yield f"static const expected_frame_t stream_{number}_frames[] = {{\n{frames}}};"
    yield "static const stream_vector_t stream_vectors[] = {"
    for number, row in enumerate(streams):
        failed = ", ".join(f"[{KINDS[kind]}] = {count}" for kind, count in row["failed"].items()) or "0"
        whole = "".join(part["hex"] for part in row["parts"])
        yield (
            f"    {{{text(row['case'])}, {DIALECTS[row['direction']]}, {data(whole)}, stream_{number}_frames, "
            f"{len(row['frames'])}, {{{failed}}}, {row['dropped']}}},"
        )
    yield "};"


def main(folder: Path, output: Path) -> None:
    """Write the header."""
    lines = ["// Made by tests/support/make_vectors.py from protocol/vectors.", '#include "support/vectors.h"', ""]
    lines += [*telemetry_lines(folder), *command_lines(folder), *stream_lines(folder)]
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
