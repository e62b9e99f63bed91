"""The config file `epf-gcs.toml`: the options of `epf-gcs` under the same names, for those who start it often.

The command line goes before a GCS_... variable, and that before the file. What the file gets wrong is told with its
line; nothing is started then.
"""

from __future__ import annotations

import difflib
import json
import os
import re
import tomllib
from collections.abc import Callable, Mapping, MutableMapping
from dataclasses import dataclass
from pathlib import Path
from types import NoneType
from typing import Any, Final, get_args, get_type_hints

import typer
from platformdirs import user_config_path
from typer.models import OptionInfo

from epf_gcs.launcher.errors import LaunchError
from epf_gcs.product import source_tree

NAME: Final = "epf-gcs.toml"
_LISTS: Final = ("allowed_hosts", "allowed_origins", "local_maps")
"""Settings of the web process that are lists of texts; it takes them from variables."""
_NUMBERS: Final = ("max_body_bytes",)
_TEXTS: Final = ("reached_at",)
_NOT_SETTINGS: Final = frozenset({"config", "print_openapi", "version"})
_MOST_BYTES: Final = 100_000
_KEY: Final = r"""^\s*["']?{key}["']?\s*="""
_AT_LINE: Final = re.compile(r"\(at line (\d+), column \d+\)|\(at end of document\)")


def default_file() -> Path | None:
    """Where it is looked for: the user's place for settings. None in a source tree: it takes nothing from outside."""
    return None if source_tree() is not None else user_config_path("epf-gcs", appauthor=False) / NAME


Entries = dict[str, Any]
"""What a config file says; each value is checked by `_check`."""


@dataclass(frozen=True, slots=True)
class Entry:
    """What one entry may be: `kind` is bool, int or str; the bounds are those of a number."""

    kind: type
    least: float | None = None
    most: float | None = None


def entries_of(program: Callable[..., None]) -> dict[str, Entry]:
    """Every entry that the options of a program make, by name."""
    found = {}
    for name, hint in get_type_hints(program, include_extras=True).items():
        option = next((one for one in getattr(hint, "__metadata__", ()) if isinstance(one, OptionInfo)), None)
        if option is None or name in _NOT_SETTINGS:
            continue
        kinds = [one for one in (get_args(hint.__origin__) or (hint.__origin__,)) if one is not NoneType]
        found[name] = Entry(kinds[0] if kinds[0] in (bool, int) else str, option.min, option.max)
    return found


def load_config(
    context: typer.Context,
    path: Path | None,
    entries: Mapping[str, Entry],
    environment: MutableMapping[str, str] = os.environ,
) -> Path | None:
    """Make the file's entries the defaults of a program's options; returns the file, None if there is none.

    `path` None: the default file, if it is there. Settings that only the web process has become variables, unless they
    are there already. Raises LaunchError with the line that is wrong.
    """
    file = path or default_file()
    if file is None:
        return None
    try:
        text = _read(file)
    except FileNotFoundError:
        if path is None:
            return None
        raise LaunchError(f"There is no config file {file}: correct --config.") from None
    except OSError as error:
        raise LaunchError(f"The config file {file} cannot be read ({error.strerror}).") from None
    taken: Entries = {}
    for key, value in _parsed(file, text).items():
        where = f"{file}, line {_line_of(text, key)}"
        if key in entries:
            _check(entries[key], key, value, where)
            taken[key] = value
        elif key in _LISTS:
            _check_texts(value, where, key)
            environment.setdefault(f"GCS_{key.upper()}", json.dumps(value))
        elif key in _NUMBERS:
            _check(Entry(int, least=1), key, value, where)
            environment.setdefault(f"GCS_{key.upper()}", str(value))
        elif key in _TEXTS:
            _check(Entry(str), key, value, where)
            environment.setdefault(f"GCS_{key.upper()}", value)
        else:
            raise LaunchError(f"{where}: {_unknown(key, [*entries, *_LISTS, *_NUMBERS, *_TEXTS])}")
    # The commands of `epf-gcs` have some of the same options.
    commands = getattr(context.command, "commands", {})
    # A command without any of them must not stand there: it may have the name of an option (`version`).
    own = {name: found for name, command in commands.items() if (found := _of(command, taken))}
    context.default_map = {**taken, **own}
    return file


def _of(command: Any, taken: Entries) -> Entries:
    own = {one.name for one in command.params}
    return {name: value for name, value in taken.items() if name in own}


def _read(file: Path) -> str:
    with file.open("rb") as opened:
        data = opened.read(_MOST_BYTES + 1)
    if len(data) > _MOST_BYTES:
        raise LaunchError(f"{file} is too long for a config file.")
    try:
        return data.decode()
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise LaunchError(f"{file}, line {line}: it is no text in UTF-8.") from None


def _parsed(file: Path, text: str) -> Entries:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        said = str(error)
        found = _AT_LINE.search(said)
        line = found[1] if found is not None and found[1] else len(text.splitlines())
        why = _AT_LINE.sub("", said).strip().rstrip(":")
        raise LaunchError(
            f'{file}, line {line}: it is no TOML ({why}). An entry looks like this: board = "tcp://192.168.1.5:4000"'
        ) from None


def _line_of(text: str, key: str) -> int:
    """The line of an entry; of a table where it is one."""
    pattern = re.compile(_KEY.format(key=re.escape(key)) + rf"|^\s*\[+\s*{re.escape(key)}\b")
    return next((number for number, line in enumerate(text.splitlines(), 1) if pattern.match(line)), 1)


def _check(entry: Entry, name: str, value: Any, where: str) -> None:
    """Raises LaunchError unless the entry may have this value."""
    if type(value) is not entry.kind:
        asked = {bool: "true or false", int: "a whole number"}
        raise LaunchError(f"{where}: {name} has to be {asked.get(entry.kind, 'a text in quotes')}.")
    if isinstance(value, int) and entry.kind is int and not (entry.least or 0) <= value <= (entry.most or float("inf")):
        upper = "" if entry.most is None else f" to {entry.most}"
        raise LaunchError(f"{where}: {name} is {value}; it has to be {entry.least or 0}{upper or ' or more'}.")


def _check_texts(value: Any, where: str, key: str) -> None:
    if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
        raise LaunchError(f'{where}: {key} has to be a list of texts, as in {key} = ["station.example"].')


def _unknown(key: str, known: list[str]) -> str:
    near = difflib.get_close_matches(key.replace("-", "_"), known, 1)
    meant = f"did you mean {near[0]}?" if near else f"there are {', '.join(sorted(known))}."
    return f"'{key}' is no setting; {meant}"
