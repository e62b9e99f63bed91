"""Find modules that depend on each other in a circle, by what they include or by what they call.

A module is a source and the header of its name in the same folder. It depends on another one when one of its files
includes the other's header, or when its source uses a function or a table that the other's source defines. A name
that several sources define (ports implement the same header) is chosen by the linker and makes no dependency.
"""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\])*\"", re.DOTALL)
# at the beginning of a line: a type, a name, parameters; then the body
FUNCTION = re.compile(r"^(?!static\b|typedef\b|else\b)[A-Za-z_][\w \t*]*?\b(\w+)\([^;{}]*\)\s*\{", re.MULTILINE)
# a table or another constant that other sources see
DATA = re.compile(
    r"^(?!static\b|typedef\b|extern\b)[A-Za-z_][^;={}]*?\b(\w+)(?:\[[^\]]*\])*\)?(?:\([^)]*\))? = ", re.MULTILINE
)
WORD = re.compile(r"\b[A-Za-z_]\w*\b")

Module = str
Edges = dict[Module, dict[Module, str]]


def module_of(path: Path) -> Module:
    """Return the name that a source and its header share."""
    return str(path.with_suffix(""))


def included(path: Path, text: str, headers: dict[str, list[Path]]) -> list[Path]:
    """Return the headers of ours that a file includes: beside it, or by the end of their path."""
    found = []
    for name in INCLUDE.findall(text):
        beside = path.parent / name
        if beside.is_file():
            found.append(beside)
        else:
            found += [header for header in headers[Path(name).name] if str(header).endswith(f"/{name}")]
    return found


def depend(files: list[Path]) -> Edges:
    """Return for each module the modules that it depends on, each with the reason."""
    texts = {path: path.read_text(encoding="utf-8") for path in files}
    code = {path: COMMENT.sub(" ", INCLUDE.sub(" ", text)) for path, text in texts.items()}
    headers: dict[str, list[Path]] = defaultdict(list)
    defined: dict[str, set[Module]] = defaultdict(set)
    for path in files:
        if path.suffix == ".h":
            headers[path.name].append(path)
        else:
            for name in FUNCTION.findall(code[path]) + DATA.findall(code[path]):
                defined[name].add(module_of(path))
    edges: Edges = {module_of(path): {} for path in files}
    for path in files:
        own = module_of(path)
        for header in included(path, texts[path], headers):
            if module_of(header) != own:
                edges[own][module_of(header)] = f"{path} includes {header.name}"
        if path.suffix == ".c":
            for name in set(WORD.findall(code[path])) & defined.keys():
                # where several programs define a name, the linker chooses, and no source depends on one of them
                if len(defined[name]) == 1 and own not in defined[name]:
                    edges[own].setdefault(next(iter(defined[name])), f"{path} uses {name}")
    return edges


def circle(edges: Edges) -> list[str]:
    """Return the reasons that make one circle, in order, or nothing when there is no circle."""
    done: set[Module] = set()

    def walk(module: Module, way: list[Module]) -> list[Module]:
        if module in way:
            return way[way.index(module) :]
        if module in done:
            return []
        for other in sorted(edges[module]):
            found = walk(other, [*way, module])
            if found:
                return found
        done.add(module)
        return []

    for module in sorted(edges):
        found = walk(module, [])
        if found:
            return [edges[module][found[(i + 1) % len(found)]] for i, module in enumerate(found)]
    return []
