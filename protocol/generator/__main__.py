"""Write every generated file, or with --check fail when one is out of date or a released frame changed.

Run as `python3 -m generator` in protocol/. `--release` records the present frames as the released ones.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from . import emit_c, emit_json_schema, emit_markdown, emit_python, emit_python_samples, emit_typescript, released
from .load import load
from .model import Definition, DefinitionError

ROOT = Path(__file__).resolve().parent.parent.parent


def outputs(definition: Definition) -> dict[str, str]:
    """All generated files: path from the root of the tree -> text."""
    return {
        "backend/src/epf_gcs/codec/messages_gen.py": emit_python.messages(definition),
        "backend/src/epf_gcs/client/samples_gen.py": emit_python_samples.samples(definition),
        "firmware/src/comms/protocol_gen.h": emit_c.protocol_header(definition),
        "firmware/src/comms/protocol_gen.c": emit_c.protocol_source(definition),
        "firmware/src/params/parameters_gen.h": emit_c.parameters_header(definition),
        "firmware/src/params/parameters_gen.c": emit_c.parameters_source(definition),
        "firmware/src/navigation/routes_gen.h": emit_c.routes_header(definition),
        "firmware/src/navigation/routes_gen.c": emit_c.routes_source(definition),
        "frontend/src/protocol/messages.gen.ts": emit_typescript.messages(definition),
        "protocol/REFERENCE.md": emit_markdown.reference(definition),
        "protocol/telemetry.schema.json": emit_json_schema.schema(definition),
    }


def main(arguments: list[str], root: Path = ROOT) -> int:
    """Run the command line on the tree at `root`; returns the exit code."""
    parser = argparse.ArgumentParser(prog="generator", description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; fail when a file is out of date")
    parser.add_argument("--release", action="store_true", help="make the present wire the released one")
    chosen = parser.parse_args(arguments)
    try:
        definition = load(root / "protocol" / "definition")
    except DefinitionError as error:
        print(f"protocol/definition: {error}", file=sys.stderr)
        return 1
    last_release = root / "protocol" / "released.json"
    if chosen.release:
        last_release.write_text(released.text(definition), "utf-8")
    made = outputs(definition)
    faults = _broken(definition, last_release)
    if chosen.check:
        faults += _stale(root, made)
    else:
        _write(root, made)
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


def _write(root: Path, made: dict[str, str]) -> None:
    for name, text in made.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
            print(f"wrote {name}")


def _stale(root: Path, made: dict[str, str]) -> list[str]:
    return [
        f"{name} is out of date: run `make generate`"
        for name, text in made.items()
        if not (root / name).exists() or (root / name).read_text("utf-8") != text
    ]


def _broken(definition: Definition, last_release: Path) -> list[str]:
    """Changes of released frames, which deployed stations and boards would no longer understand."""
    if not last_release.exists():
        return ["protocol/released.json is missing: nothing would notice a changed frame"]
    return released.breaks(definition, json.loads(last_release.read_text("utf-8")))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
