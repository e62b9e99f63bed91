"""Fail when Dockerfile and compose files no longer fit the tree. No container engine is needed.

Usage: containers.py ROOT

What is held against what: every path that is copied or mounted against the tree and .dockerignore; every stage, service
and volume against its definition; every setting against those of the gateway, the page and the journeys; every port
against the program that has it; every program against those that are installed; the image's labels against the
project. The shape of the compose files is held against the public schema by `make check-workflows`.

Why a program of ours: of eleven planted faults hadolint 2.15.1 found one (a stage that is not there) and the public
schema one (a key that no service has). Both passed the nine that concern the tree, its settings, ports and programs.
`docker compose config` needs an engine.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, Final

import yaml

from epf_gcs.codec.messages_gen import RECEIVE_PORT, SEND_PORT
from epf_gcs.web.serving.settings import Settings

COMPOSE: Final = ("docker-compose.yml", "docker-compose.use.yml")
DEVELOPMENT: Final = COMPOSE[0]
_VARIABLE: Final = re.compile(r"\$\{(\w+)(?::-([^}]*))?\}")
# Settings of programs other than the gateway, and the file that reads each.
_READ_BY: Final = {
    "GCS_DEV_GATEWAY": "frontend/vite.config.ts",
    "GCS_STATION": "e2e/support/there.ts",
    "GCS_STATION_KEY_FILE": "e2e/support/there.ts",
}
# Programs of the base images, beside those of the wheel.
_SYSTEM: Final = frozenset({"python", "sh", "grep", "node", "npx", "watchfiles", "epf-board"})
_LABELS: Final = "org.opencontainers.image."
_INSTALLED_SCRIPTS: Final = "/usr/local/lib/epf-gcs/"


class _Loader(yaml.SafeLoader):
    """Takes compose's `!override`, which says how two files are joined and is no value."""


def _overriding(loader: _Loader, node: yaml.Node) -> Any:
    if isinstance(node, yaml.SequenceNode):
        return loader.construct_sequence(node, deep=True)
    return loader.construct_mapping(node, deep=True) if isinstance(node, yaml.MappingNode) else None


_Loader.add_constructor("!override", _overriding)


@dataclass(frozen=True)
class Tree:
    """What the files are held against."""

    root: Path
    tracked: tuple[str, ...]
    ignored: tuple[str, ...]

    @classmethod
    def at(cls, root: Path) -> Tree:
        """Of the files that git knows, as a clone has them."""
        listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=True)
        lines = (root / ".dockerignore").read_text(encoding="utf-8").splitlines()
        return cls(root, tuple(listed.stdout.split("\0")), tuple(line for line in lines if line and line[0] != "#"))

    def has(self, path: str) -> bool:
        """Whether a clone has this file or folder."""
        path = path.removeprefix("./").rstrip("/")
        return any(name == path or name.startswith(path + "/") for name in self.tracked)

    def reaches_the_engine(self, path: str) -> bool:
        """Whether .dockerignore lets it through: the last line that matches it, or a folder above it, decides."""
        path = path.removeprefix("./").rstrip("/")
        parts = Path(path).parts
        above = ["/".join(parts[: count + 1]) for count in range(len(parts))]
        sent = True
        for line in self.ignored:
            pattern = line.removeprefix("!").removeprefix("**/")
            if line == "**" or any(fnmatch(name, pattern) for name in above):
                sent = line.startswith("!")
        return sent


@dataclass(frozen=True)
class Image:
    """What the Dockerfile says."""

    stages: tuple[str, ...]
    copied: tuple[str, ...]
    copied_from: tuple[str, ...]
    settings: tuple[str, ...]
    ports: tuple[str, ...]
    base_images: tuple[str, ...]
    labels: Mapping[str, str]

    @classmethod
    def read(cls, text: str) -> Image:
        """From the text of a Dockerfile."""
        joined = re.sub(r"\\\n\s*", " ", "\n".join(line for line in text.splitlines() if not line.startswith("#")))
        lines = [line.split() for line in joined.splitlines() if line.strip()]
        stages = [words[3] for words in lines if words[0] == "FROM" and len(words) > 3]
        bases = [words[1] for words in lines if words[0] == "FROM" and words[1] not in (*stages, "scratch")]
        local, others = [], []
        for words in lines:
            if words[0] != "COPY":
                continue
            given = [word for word in words[1:] if word.startswith("--")]
            sources = [word for word in words[1:-1] if not word.startswith("--")]
            stage = next((word.removeprefix("--from=") for word in given if word.startswith("--from=")), None)
            if stage is None:
                local += sources
            else:
                others.append(stage)
        settings = [word for words in lines if words[0] == "ENV" for word in words if re.match(r"\w+=", word)]
        ports = [word.partition("/")[0] for words in lines if words[0] == "EXPOSE" for word in words[1:]]
        return cls(
            tuple(stages),
            tuple(local),
            tuple(others),
            tuple(w.partition("=")[0] for w in settings),
            tuple(ports),
            tuple(bases),
            {name: value for words in lines if words[0] == "LABEL" for name, value in _pairs(words[1:])},
        )


def _pairs(words: list[str]) -> Iterator[tuple[str, str]]:
    """Names and values of a LABEL's words."""
    for word in shlex.split(" ".join(words)):
        name, _, value = word.partition("=")
        yield name, value


def of_image(tree: Tree, image: Image) -> Iterator[str]:
    """Yield a sentence for each thing of the Dockerfile that is not there."""
    for path in image.copied:
        if not tree.has(path):
            yield f"Dockerfile copies {path}, which is not in the tree"
        elif not tree.reaches_the_engine(path):
            yield f"Dockerfile copies {path}, which .dockerignore keeps back"
    for stage in image.copied_from:
        if stage not in image.stages:
            yield f"Dockerfile copies from {stage}, which is no stage"
    for base in image.base_images:
        if not re.fullmatch(r"[a-z0-9.]+/[\w/-]+:[\w.-]+", base):
            yield f"Dockerfile starts from {base}: name the registry and the release"
    for name in image.settings:
        if name.startswith("GCS_") and not _is_setting(tree, name):
            yield f"Dockerfile sets {name}, which nothing reads"
    yield from _of_ports("Dockerfile", image.ports)


def of_labels(tree: Tree, image: Image) -> Iterator[str]:
    """What a registry shows of the image: complete, of this tree, and without the address of anybody."""
    project = tomllib.loads((tree.root / "backend/pyproject.toml").read_text(encoding="utf-8"))["project"]
    make = (tree.root / "Makefile").read_text(encoding="utf-8")
    wanted = {"title": "EPF GCS", "licenses": project["license"], "version": "${VERSION}", "revision": "${REVISION}"}
    for name, value in wanted.items():
        if image.labels.get(_LABELS + name) != value:
            yield f"Dockerfile labels no {name}, which is {value}"
    for name in ("VERSION", "REVISION"):
        if f"--build-arg {name}=" not in make:
            yield f"`make container` does not say {name}, which a label names"
    for name, value in image.labels.items():
        if "://" in value:
            yield f"Dockerfile's label {name} names an address, and the tree has none"
    base = image.labels.get(_LABELS + "base.name")
    if base not in image.base_images:
        yield f"Dockerfile's label of its base says {base}, from which nothing starts"


def of_services(
    tree: Tree, image: Image, name: str, document: Mapping[str, Any], all_of: Mapping[str, Any]
) -> Iterator[str]:
    """Yield a sentence for each thing of a compose file that is not there. `all_of`: all files' services, joined."""
    for key in document:
        if key not in ("services", "volumes") and not key.startswith("x-"):
            yield f"{name} has {key}, which is not looked at here"
    volumes = frozenset(document.get("volumes", {})) or None
    for service, told in document["services"].items():
        where = f"{name}: {service}"
        if (target := told.get("build", {}).get("target")) and target not in image.stages:
            yield f"{where} is built from {target}, which is no stage of the Dockerfile"
        yield from _of_order(where, told, all_of)
        yield from _of_volumes(tree, where, told, volumes)
        yield from _of_programs(tree, where, told)
        for setting in told.get("environment", {}):
            if not _is_setting(tree, setting):
                yield f"{where} sets {setting}, which nothing reads"
        yield from _of_ports(where, [port.removesuffix("/udp").rpartition(":")[2] for port in told.get("ports", ())])


def _of_order(where: str, told: Mapping[str, Any], all_of: Mapping[str, Any]) -> Iterator[str]:
    waits = told.get("depends_on", {})
    conditions = (
        dict.fromkeys(waits, "service_started")
        if isinstance(waits, list)
        else {other: condition["condition"] for other, condition in waits.items()}
    )
    shared = told.get("network_mode", "").removeprefix("service:")
    for other in [*conditions, *([shared] if shared else [])]:
        if other not in all_of:
            yield f"{where} needs {other}, which is no service"
    for other, condition in conditions.items():
        if condition == "service_healthy" and "healthcheck" not in all_of.get(other, {}):
            yield f"{where} waits until {other} is healthy, which nothing looks at"
        if condition == "service_completed_successfully" and all_of.get(other, {}).get("restart") != "no":
            yield f"{where} waits until {other} has ended, which is started again each time"


def _of_volumes(tree: Tree, where: str, told: Mapping[str, Any], volumes: frozenset[str] | None) -> Iterator[str]:
    for volume in told.get("volumes", ()):
        source = volume.partition(":")[0]
        if source.startswith("."):
            if not tree.has(source):
                yield f"{where} mounts {source}, which is not in the tree"
        elif volumes is not None and source not in volumes:
            yield f"{where} mounts the volume {source}, which is not declared"


def _of_programs(tree: Tree, where: str, told: Mapping[str, Any]) -> Iterator[str]:
    project = tomllib.loads((tree.root / "backend/pyproject.toml").read_text(encoding="utf-8"))["project"]
    known = _SYSTEM | frozenset(project["scripts"])
    for words in (told.get("command", []), told.get("healthcheck", {}).get("test", ["CMD"])[1:]):
        # The first one, and what watchfiles starts.
        for word in [*words[:1], *(word for word in words[1:] if word.startswith("epf-"))]:
            if word not in known:
                yield f"{where} runs {word}, which no image has"
        for word in words:
            if word.startswith(_INSTALLED_SCRIPTS) and not tree.has(f"packaging/container/{Path(word).name}"):
                yield f"{where} runs {word}, which is not in packaging/container"
            if word.startswith("/station/") and not tree.has(word.removeprefix("/station/")):
                yield f"{where} looks at {word}, which is not in the tree"


def _of_ports(where: str, ports: list[str] | tuple[str, ...]) -> Iterator[str]:
    known = {str(Settings.model_fields["port"].default), str(RECEIVE_PORT), "5173"}
    for port in ports:
        if port not in known:
            yield f"{where} opens port {port}, where no program listens"


def _is_setting(tree: Tree, name: str) -> bool:
    if (reader := _READ_BY.get(name)) is not None:
        return name in (tree.root / reader).read_text(encoding="utf-8")
    return name.removeprefix("GCS_").lower() in Settings.model_fields if name.startswith("GCS_") else True


def of_health(all_of: Mapping[str, Any]) -> Iterator[str]:
    """The ports that health checks look up in hexadecimal are those of the programs beside them."""
    wanted = {"board": _after(all_of["board"]["command"], "--tcp"), "simulator": str(SEND_PORT)}
    for service, port in wanted.items():
        told = " ".join(all_of[service]["healthcheck"]["test"])
        if f":{int(port):04X} " not in told:
            yield f"{service} listens on port {port} ({int(port):04X}), and its health check looks for another one"
    url = _after(all_of["circuit"]["command"], "--board")
    if not url.endswith(f":{wanted['board']}"):
        yield f"circuit connects to {url}, the board listens on {wanted['board']}"


def _after(words: list[str], option: str) -> str:
    return words[words.index(option) + 1]


def of_variables(root: Path) -> Iterator[str]:
    """A variable that the user may set has a default, and stands in the words at the head of a file."""
    heads = ""
    texts = {name: (root / name).read_text(encoding="utf-8") for name in COMPOSE}
    for text in texts.values():
        heads += "\n".join(line for line in text.splitlines() if line.lstrip().startswith("#"))
    # Those of the same name as a setting explain themselves.
    for name, text in texts.items():
        for variable, default in _VARIABLE.findall(text):
            if default is None:
                yield f"{name}: ${{{variable}}} has no default"
            if variable not in heads and variable.removeprefix("GCS_").lower() not in Settings.model_fields:
                yield f"{name}: ${{{variable}}} is explained nowhere in the file"


def faults(root: Path) -> list[str]:
    """Everything that does not fit."""
    tree = Tree.at(root)
    image = Image.read((root / "Dockerfile").read_text(encoding="utf-8"))
    documents = {name: yaml.load((root / name).read_text(encoding="utf-8"), _Loader) for name in COMPOSE}  # noqa: S506
    all_of: dict[str, dict[str, Any]] = {}
    for document in documents.values():
        for service, told in document["services"].items():
            all_of[service] = {**told, **all_of.get(service, {})}
    found = [*of_image(tree, image), *of_labels(tree, image), *of_health(all_of), *of_variables(root)]
    for name, document in documents.items():
        found += of_services(tree, image, name, document, all_of)
    return found


def main() -> int:
    """Look at all of it; returns the exit code."""
    found = faults(Path(sys.argv[1]).resolve())
    print(
        "\n".join(f"containers: {sentence}." for sentence in found)
        or "containers: Dockerfile and compose files fit the tree."
    )
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
