"""The packages that the gateway runs with, and what their licences are called."""

from __future__ import annotations

import re
from email.message import Message
from importlib.metadata import version
from pathlib import Path
from typing import Any, cast

import pytest

from epf_gcs.web.interface.about.packages import licence_of, needed_by, packages

LOCK = Path(__file__).parents[4] / "requirements.lock"
# Needed to install us, not to run; and for other systems than those that have it.
NOT_AT_RUN_TIME = {"setuptools", "colorama", "tzdata"}


def test_they_are_those_of_the_lock_file() -> None:
    locked = set(re.findall(r"(?m)^([a-z0-9][a-z0-9._-]*)==", LOCK.read_text()))
    named = {package.name.lower().replace("_", "-") for package in packages()}
    assert named <= locked
    assert locked - named <= NOT_AT_RUN_TIME


def test_each_has_its_version_and_its_licence() -> None:
    for package in packages():
        assert package.version == version(package.name)
        assert package.licence, package.name
        assert len(package.licence) < 200
        assert "\n" not in package.licence


@pytest.mark.parametrize(
    ("line", "extras", "needed"),
    [
        ("orjson==3.13.0", frozenset(), ("orjson", frozenset())),
        ("uvicorn[standard,x]>=0.1 ; python_version >= '3.9'", frozenset(), ("uvicorn", frozenset({"standard", "x"}))),
        ('pytest ; extra == "dev"', frozenset(), None),
        ('pytest ; extra == "dev"', frozenset({"dev"}), ("pytest", frozenset())),
        ("typing-extensions (>=4)", frozenset(), ("typing-extensions", frozenset())),
        ("importlib-metadata>=3.6 ; python_version < '3.10'", frozenset(), None),
        ("", frozenset(), None),
    ],
)
def test_what_a_requirement_asks_for(
    line: str, extras: frozenset[str], needed: tuple[str, frozenset[str]] | None
) -> None:
    assert needed_by(line, extras) == needed


class Packed:
    """A distribution with this metadata."""

    def __init__(self, *headers: tuple[str, str]) -> None:
        self.metadata = Message()
        for name, value in headers:
            self.metadata[name] = value


@pytest.mark.parametrize(
    ("headers", "licence"),
    [
        ([("License-Expression", "MIT OR Apache-2.0"), ("License", "see the file")], "MIT OR Apache-2.0"),
        ([("License", "BSD")], "BSD"),
        (
            [("License", "long\ntext " * 50), ("Classifier", "License :: OSI Approved :: MIT License")],
            "MIT License",
        ),
        ([("Classifier", "License :: OSI Approved"), ("Classifier", "Topic :: Internet")], None),
        ([], None),
    ],
)
def test_a_licence_is_called_what_the_package_calls_it(headers: list[tuple[str, str]], licence: str | None) -> None:
    assert licence_of(cast(Any, Packed(*headers))) == licence
