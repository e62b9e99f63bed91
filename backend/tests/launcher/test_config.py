"""The config file has the options' names; mistakes are told with their line; option, then variable, then file."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import pytest
import typer
from typer.testing import CliRunner

from epf_gcs.launcher import config, gateway
from epf_gcs.launcher.config import entries_of, load_config
from epf_gcs.launcher.errors import LaunchError
from tests.support.waiting import DEADLINE_S

app = typer.Typer()
seen: dict[str, Any] = {}
variables: dict[str, str] = {}


def _load(context: typer.Context, path: Path | None) -> Path | None:
    return load_config(context, path, entries_of(main), variables)


@app.callback(invoke_without_command=True)
def main(
    *,
    port: Annotated[int, typer.Option(envvar="TRIED_PORT", min=0, max=65535)] = 8000,
    board: Annotated[str | None, typer.Option()] = None,
    data_dir: Annotated[Path, typer.Option()] = Path("/nowhere"),
    tls: Annotated[bool, typer.Option("--tls")] = False,
    recording: Annotated[bool, typer.Option()] = True,
    trust_this_computer: Annotated[bool | None, typer.Option()] = None,
    config: Annotated[Path | None, typer.Option(callback=_load, is_eager=True)] = None,
) -> None:
    seen.update(locals())


@app.command()
def doctor(
    data_dir: Annotated[Path, typer.Option()] = Path("/nowhere"), port: Annotated[int, typer.Option()] = 8000
) -> None:
    seen["doctor"] = (data_dir, port)


@pytest.fixture(autouse=True)
def _fresh() -> None:
    seen.clear()
    variables.clear()


def start(file: Path, *arguments: str, **environment: str) -> None:
    result = CliRunner().invoke(app, ["--config", str(file), *arguments], env=environment)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert result.exit_code == 0, result.output


def written(folder: Path, text: str) -> Path:
    file = folder / "epf-gcs.toml"
    file.write_text(text)
    return file


WHOLE = """\
# the club's station
port = 8001
board = "tcp://192.168.1.5:4000"
data_dir = "/srv/flights"
tls = true
recording = false
trust_this_computer = false
allowed_hosts = ["station.club.example"]
max_body_bytes = 100000
"""


def test_every_kind_of_entry_is_taken(tmp_path: Path) -> None:
    start(written(tmp_path, WHOLE))
    assert (seen["port"], seen["board"], seen["data_dir"]) == (8001, "tcp://192.168.1.5:4000", Path("/srv/flights"))
    assert (seen["tls"], seen["recording"], seen["trust_this_computer"]) == (True, False, False)
    assert variables == {"GCS_ALLOWED_HOSTS": '["station.club.example"]', "GCS_MAX_BODY_BYTES": "100000"}


def test_an_option_goes_before_a_variable_and_that_before_the_file(tmp_path: Path) -> None:
    file = written(tmp_path, "port = 8001\n")
    start(file)
    assert seen["port"] == 8001
    start(file, TRIED_PORT="8002")
    assert seen["port"] == 8002
    start(file, "--port", "8003", TRIED_PORT="8002")
    assert seen["port"] == 8003


def test_a_variable_of_the_web_process_goes_before_the_file(tmp_path: Path) -> None:
    variables["GCS_ALLOWED_HOSTS"] = '["mine"]'
    start(written(tmp_path, WHOLE))
    assert variables["GCS_ALLOWED_HOSTS"] == '["mine"]'


def test_the_commands_take_the_same_entries(tmp_path: Path) -> None:
    start(written(tmp_path, WHOLE), "doctor")
    assert seen["doctor"] == (Path("/srv/flights"), 8001)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("\nprot = 8001\n", "line 2: 'prot' is no setting; did you mean port?"),
        ("data-dir = 'x'\n", "line 1: 'data-dir' is no setting; did you mean data_dir?"),
        ("wings = 2\n", "line 1: 'wings' is no setting; there are allowed_hosts, "),
        ("# a comment\n[board]\nurl = 'x'\n", "line 2: board has to be a text in quotes."),
        ("port = 8000\n[links]\nx = 1\n", "line 2: 'links' is no setting"),
        ('port = "8000"\n', "line 1: port has to be a whole number."),
        ("port = true\n", "line 1: port has to be a whole number."),
        ("\n\nport = 70000\n", "line 3: port is 70000; it has to be 0 to 65535."),
        ("tls = 1\n", "line 1: tls has to be true or false."),
        ("board = 5\n", "line 1: board has to be a text in quotes."),
        ('allowed_hosts = "a"\n', "line 1: allowed_hosts has to be a list of texts"),
        ("max_body_bytes = 1.5\n", "line 1: max_body_bytes has to be a whole number"),
        ("port = 8000\nboard = tcp://x\n", "line 2: it is no TOML"),
        ("port = 1\nport = 2\n", "line 2: it is no TOML"),
        ('board = "x', "line 1: it is no TOML"),
        ("config = 'x'\n", "line 1: 'config' is no setting"),
    ],
)
def test_what_is_wrong_is_told_with_its_line(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(LaunchError) as told:
        start(written(tmp_path, text))
    assert words in str(told.value)
    assert str(tmp_path / "epf-gcs.toml") in str(told.value)
    assert seen == {}


def test_a_file_that_is_no_text_is_told(tmp_path: Path) -> None:
    (tmp_path / "epf-gcs.toml").write_bytes(b"port = 8000\nboard = '\xff'\n")
    with pytest.raises(LaunchError, match="line 2: it is no text"):
        start(tmp_path / "epf-gcs.toml")


def test_a_named_file_that_is_not_there_is_told_and_the_usual_one_may_be_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(LaunchError, match="There is no config file"):
        start(tmp_path / "gone.toml")
    monkeypatch.setattr(config, "default_file", lambda: tmp_path / "gone.toml")
    assert CliRunner().invoke(app, []).exit_code == 0


def test_the_usual_file_is_taken_where_it_is_installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(config, "default_file", lambda: written(tmp_path, "port = 8009\n"))
    assert CliRunner().invoke(app, []).exit_code == 0
    assert seen["port"] == 8009


def test_a_source_tree_takes_nothing_from_the_user_s_settings(monkeypatch: pytest.MonkeyPatch) -> None:
    assert config.default_file() is None
    monkeypatch.setattr(config, "source_tree", lambda: None)
    found = config.default_file()
    assert found is not None
    assert (found.name, found.parent.name) == ("epf-gcs.toml", "epf-gcs")


def test_every_option_of_the_gateway_is_a_variable_of_the_same_name_and_an_entry() -> None:
    known = entries_of(gateway.run)
    hints = get_type_hints(gateway.run, include_extras=True)
    for name in known:
        assert hints[name].__metadata__[0].envvar == f"GCS_{name.upper()}"
    assert {"host", "port", "board", "data_dir", "tls", "tls_cert", "verbose", "print_key"} <= set(known)
    assert {one.kind for one in known.values()} == {bool, int, str}


def test_the_program_itself_says_what_is_wrong_and_ends_with_2(tmp_path: Path) -> None:
    file = written(tmp_path, "prot = 1\n")
    answer = subprocess.run(
        [sys.executable, "-m", "epf_gcs.launcher.gateway", "--config", str(file)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 2
    assert answer.stderr == f"epf-gcs: {file}, line 1: 'prot' is no setting; did you mean port?\n"


def test_the_shell_completes_options() -> None:
    answer = subprocess.run(
        [sys.executable, "-c", "from epf_gcs.launcher.gateway import app; app(prog_name='epf-gcs')"],
        capture_output=True,
        text=True,
        check=False,
        timeout=DEADLINE_S,
        env={
            **os.environ,
            "_EPF_GCS_COMPLETE": "complete_bash",
            "COMP_WORDS": "epf-gcs --da",
            "COMP_CWORD": "1",
        },
    )
    assert "--data-dir" in answer.stdout


def test_a_command_that_is_named_like_an_option_still_runs(tmp_path: Path) -> None:
    answer = subprocess.run(
        [sys.executable, "-m", "epf_gcs.launcher.gateway", "--config", str(written(tmp_path, "")), "version"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (answer.returncode, answer.stdout.startswith("epf-gcs ")) == (0, True)
