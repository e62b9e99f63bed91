"""The commands of `epf-gcs` for the time between flights: version, doctor, backup, restore."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Final

import typer

from epf_gcs import __version__
from epf_gcs.backup.archive import backup as write_backup
from epf_gcs.backup.archive import is_encrypted
from epf_gcs.backup.archive import restore as read_backup
from epf_gcs.backup.errors import BackupError
from epf_gcs.backup.password import check_password, password_in
from epf_gcs.data_folder.lock import is_in_use
from epf_gcs.data_folder.place import DEFAULT, data_folder
from epf_gcs.data_folder.upgrade import downgrade as put_back
from epf_gcs.data_folder.version import FormatError
from epf_gcs.data_folder.whereabouts import folder_meant
from epf_gcs.errors import GatewayError
from epf_gcs.launcher.doctor import findings, report
from epf_gcs.launcher.errors import LaunchError
from epf_gcs.launcher.findings import Language

_Folder = Annotated[
    Path,
    typer.Option(show_envvar=False, envvar="GCS_DATA_DIR", help="The station's data folder."),
]
FolderMeant = Annotated[
    Path,
    typer.Option(
        show_envvar=False,
        envvar="GCS_DATA_DIR",
        help="The station's data folder.",
        default_factory=folder_meant,
        show_default=DEFAULT,
    ),
]
"""Of a command that looks at a station or asks it: who names none may mean the demonstration's."""
_PasswordFile = Annotated[
    Path | None, typer.Option(help="Its first line is the password: nobody is asked.", show_default=False)
]
_DATA: Final = data_folder()


def add_commands(app: typer.Typer) -> None:
    """Add them to a program."""
    for command in (version, doctor, backup, restore, downgrade):
        app.command()(command)


def print_version(asked: bool) -> None:  # noqa: FBT001 - how an option's callback is called
    """For `--version` of a program."""
    if asked:
        version()
        raise typer.Exit


def version() -> None:
    """Print the version."""
    print(f"epf-gcs {__version__}")


def doctor(
    *,
    data_dir: FolderMeant,
    port: Annotated[int, typer.Option(show_envvar=False, envvar="GCS_PORT", help="The page's TCP port.")] = 8000,
    language: Annotated[Language, typer.Option(help="Of what it says.")] = "en",
    as_json: Annotated[bool, typer.Option("--json", help="For programs.")] = False,
) -> None:
    """Look for what keeps the station from working here, and say what mends it. Ends with 1 if something does."""
    found = [replace(one, language=language) for one in findings(data_dir, port)]
    if as_json:
        print(json.dumps([{"state": one.state, "what": one.what, "mend": one.mend} for one in found]))
    else:
        print(report(found, language))
    raise typer.Exit(any(one.state == "fault" for one in found))


def backup(
    file: Annotated[Path, typer.Argument(help="The new file, for example station.tar, encrypted station.tar.age.")],
    *,
    encrypt: Annotated[bool, typer.Option("--encrypt", help="Ask for a password, twice.")] = False,
    password_file: _PasswordFile = None,
    data_dir: _Folder = _DATA,
) -> None:
    """Keep everything of the data folder that cannot be made again in one file. The station may run meanwhile.

    With a password the file is encrypted in the format of age: `age -d` opens it too.
    """
    try:
        password = None
        if encrypt or password_file is not None:
            password = _new_password() if password_file is None else password_in(password_file)
        count = write_backup(data_dir, file, _say, password)
    except (BackupError, OSError) as error:
        raise _failed(error) from error
    who = "only you can read it; keep it so" if password is None else "nobody can read it without its password"
    print(
        f"{count} files are in {file} ({file.stat().st_size / 1e6:.1f} MB), among them the station's private keys and "
        f"who may come in: {who}."
    )


def restore(
    file: Annotated[Path, typer.Argument(help="A file made by `epf-gcs backup` or in the page.")],
    *,
    password_file: _PasswordFile = None,
    data_dir: _Folder = _DATA,
) -> None:
    """Make the data folder what it was. The folder that is there now is kept beside it. Asks for a file's password."""
    try:
        if is_in_use(data_dir):
            raise LaunchError(f"A station is running with {data_dir}: stop it first.")
        password = None
        if is_encrypted(file):
            password = _asked("Password") if password_file is None else password_in(password_file)
        kept = read_backup(file, data_dir, _say, password)
    except (LaunchError, BackupError, OSError) as error:
        raise _failed(error) from error
    print(f"{data_dir} is as it was." + ("" if kept is None else f" What was there before is in {kept}."))


def downgrade(*, data_dir: _Folder = _DATA) -> None:
    """Put back what the last change of the data folder's format changed, for an earlier version of epf-gcs.

    Recordings made since then stay; settings made since then are kept beside.
    """
    try:
        number, written_by = put_back(data_dir)
    except (FormatError, GatewayError, OSError) as error:
        raise _failed(error) from error
    who = f"epf-gcs {written_by}" if written_by else "epf-gcs 1.0.0 or older"
    print(
        f"{data_dir} is of format {number} again, as {who} had it: install that now. This version would change it back."
    )


def _new_password() -> str:
    """Raises BackupError."""
    password = check_password(_asked("Password"))
    if password != _asked("The same again"):
        raise BackupError("The two passwords differ: nothing was made.")
    return password


def _asked(what: str) -> str:
    said: str = typer.prompt(what, hide_input=True, err=True)
    return said


def _say(name: str) -> None:
    if sys.stderr.isatty():
        print(f"\r\x1b[K{name}", end="", file=sys.stderr, flush=True)


def _failed(error: Exception) -> typer.Exit:
    print(f"epf-gcs: {error}", file=sys.stderr)
    return typer.Exit(1)
