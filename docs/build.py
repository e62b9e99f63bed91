"""Build the documents: the guide in both languages, the references, and how things are made.

Usage: build.py ROOT OUT. Nothing is written twice: pages come from the files that the product itself shows and checks.
The site lies in OUT, in a folder for each language, and needs no network. A link that leads nowhere fails.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

sys.path.insert(0, str(Path(__file__).parent))

import interface
import links

LANGUAGES: Final = ("es", "en")
NAMES: Final = {"es": "Español", "en": "English"}
# Which file of the tree is which page. Other files that they name are told by their path.
PAGES: Final = {
    "docs/install.md": "install.md",
    "packaging/linux/README.md": "linux-service.md",
    "protocol/README.md": "reference/wire.md",
    "protocol/REFERENCE.md": "reference/messages.md",
    "firmware/README.md": "inside/firmware.md",
    "backend/README.md": "inside/gateway.md",
    "frontend/README.md": "inside/page.md",
    "e2e/README.md": "inside/journeys.md",
    "ARCHITECTURE.md": "inside/architecture.md",
    "LIBRARIES.md": "inside/libraries.md",
    "CONTRIBUTING.md": "inside/contributing.md",
    "SECURITY.md": "inside/security.md",
    "CHANGELOG.md": "changes.md",
    "decisions/README.md": "decisions/index.md",
}
_GUIDE: Final = "frontend/src/features/guide"
_PICTURES: Final = "frontend/public/guide"
_PICTURE: Final = re.compile(r"^!\[(.+)\]\(([a-z-]+)\)$", re.MULTILINE)
# For the search in pages that are opened without a server, from the internet; the search of a served site needs it not.
_SHIM: Final = re.compile(r'<script src="?https://unpkg\.com/iframe-worker/shim"?[^>]*></script>')
_REFERENCES: Final = ("formats", "lab", "line", "programs", "mavlink")
_WORDS: Final[Mapping[str, Mapping[str, str]]] = {
    "es": {
        "guide": "Guía del piloto",
        "use": "Instalar y usar",
        "reference": "Referencia",
        "inside": "Por dentro",
        "english": "!!! note\n    Esta página está en inglés, como el código y los nombres de los mensajes.\n\n",
    },
    "en": {
        "guide": "Guide for pilots",
        "use": "Install and use",
        "reference": "Reference",
        "inside": "Inside",
        "english": "",
    },
}


def gather(root: Path, language: str, folder: Path, openapi: Mapping[str, Any]) -> list[str]:
    """Write all pages of one language below `folder`; returns a sentence for each link that leads nowhere."""
    words = _WORDS[language]
    for name, page in _sources(root).items():
        text, found = moved((root / name).read_text(encoding="utf-8"), root, name)
        if found:
            return found
        _write(folder / page, words["english"] + text)
    shutil.copytree(root / "frontend" / "docs", folder / "pictures")
    for name, text in interface.pages(openapi).items():
        _write(folder / "reference" / "interface" / name, words["english"] + text)
    for name in _REFERENCES:
        text = (root / "docs" / language / f"{name}.md").read_text(encoding="utf-8")
        _write(folder / "reference" / f"{name}.md", text)
    _write(folder / "index.md", (root / "docs" / language / "index.md").read_text(encoding="utf-8"))
    for name, text in chapters(root, language, openapi).items():
        _write(folder / "guide" / name, text)
    shutil.copytree(root / _PICTURES / language, folder / "guide" / "pictures")
    return []


def chapters(root: Path, language: str, openapi: Mapping[str, Any]) -> dict[str, str]:
    """The guide that the page shows, a page for each chapter: file name -> Markdown."""
    guide = root / _GUIDE
    words = json.loads((guide / f"guide.{language}.json").read_text(encoding="utf-8"))
    access = root / "frontend" / "src" / "features" / "access" / f"access.{language}.json"
    role_words = json.loads(access.read_text(encoding="utf-8"))["role"]
    text = (guide / f"{language}.md").read_text(encoding="utf-8")
    text = text.replace("{{roles}}", interface.roles(openapi, words, role_words))
    text = _PICTURE.sub(r"![\1](pictures/\2.webp)", text)
    pieces = re.split(r"^## (.+)\n", text, flags=re.MULTILINE)[1:]
    return {
        # In both languages the same name, so that the other language is one click away.
        f"{number:02}.md": f"# {title}\n{body.replace('### ', '## ')}"
        for number, (title, body) in enumerate(zip(pieces[::2], pieces[1::2], strict=True), 1)
    }


def moved(text: str, root: Path, name: str) -> tuple[str, list[str]]:
    """A file's text with its links as they are in the site, and a sentence for each that leads nowhere."""
    sources, faults = _sources(root), list(links.in_markdown(root, [name]))
    at = Path(sources[name]).parent

    def link(found: re.Match[str]) -> str:
        mark, words, target = found.groups()
        if "://" in target or target.startswith("#"):
            return found[0]
        path, hash_, anchor = target.partition("#")
        file = (root / name).parent / path
        known = file.resolve().relative_to(root.resolve()).as_posix() if file.exists() else path
        up = "../" * len(at.parts)
        if known in sources:
            return f"[{words}]({up}{sources[known]}{hash_}{anchor})"
        if mark:
            return f"![{words}]({up}pictures/{file.name})"
        return f"{words} (`{known}`)" if words.strip("`") != known else f"`{known}`"

    return links.LINK.sub(link, text), faults


def config(language: str, docs: Path) -> str:
    """What Zensical is told, as TOML."""
    words = _WORDS[language]
    guide = [f"guide/{path.name}" for path in sorted((docs / "guide").glob("*.md"))]
    shown = sorted(path.name for path in (docs / "reference" / "interface").glob("*.md") if path.name != "index.md")
    decided = sorted(path.relative_to(docs).as_posix() for path in (docs / "decisions").rglob("*.md"))
    nav = [
        "index.md",
        {words["guide"]: guide},
        {words["use"]: ["install.md", "linux-service.md", "changes.md"]},
        {
            words["reference"]: [
                *(
                    "reference/wire.md",
                    "reference/messages.md",
                    *(f"reference/{name}.md" for name in _REFERENCES),
                    "reference/interface/index.md",
                ),
                *(f"reference/interface/{name}" for name in shown),
            ]
        },
        {words["inside"]: [*sorted(page for page in PAGES.values() if page.startswith("inside/")), *decided]},
    ]
    alternate = [{"name": NAMES[other], "link": f"../{other}/index.html", "lang": other} for other in LANGUAGES]
    return "\n".join(
        (
            "[project]",
            'site_name = "EPF GCS"',
            'docs_dir = "docs"',
            'site_dir = "site"',
            "use_directory_urls = false",
            f"nav = {_toml(nav)}",
            "[project.theme]",
            f'language = "{language}"',
            # The system's own type: nothing is loaded from elsewhere.
            "font = false",
            'features = ["navigation.footer", "navigation.top", "content.code.copy", "toc.follow"]',
            *("[[project.theme.palette]]", 'media = "(prefers-color-scheme: light)"', 'scheme = "default"'),
            *("[[project.theme.palette]]", 'media = "(prefers-color-scheme: dark)"', 'scheme = "slate"'),
            "[project.plugins.offline]",
            "[project.extra]",
            "generator = false",
            f"alternate = {_toml(alternate)}",
            "[project.markdown_extensions]",
            *("admonition = {}", "tables = {}", "attr_list = {}", "sane_lists = {}"),
            *("toc.permalink = true", "pymdownx.superfences = {}", ""),
        )
    )


def main() -> int:
    """Build it; returns the exit code."""
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    asked = subprocess.run(
        [sys.executable, "-m", "epf_gcs.web", "--print-openapi"], check=True, stdout=subprocess.PIPE, text=True
    )
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as folder:
        for language in LANGUAGES:
            docs, site = Path(folder) / language / "docs", Path(folder) / language / "site"
            found = gather(root, language, docs, json.loads(asked.stdout))
            if found:
                print("\n".join(f"docs: {sentence}." for sentence in found), file=sys.stderr)
                return 1
            told = docs.parent / "zensical.toml"
            told.write_text(config(language, docs), encoding="utf-8")
            zensical = Path(sys.executable).with_name("zensical")
            built = subprocess.run([zensical, "build", "--strict", "--config-file", told], cwd=docs.parent, check=False)
            if built.returncode:
                return built.returncode
            for page in site.rglob("*.html"):
                page.write_text(_SHIM.sub("", page.read_text(encoding="utf-8")), encoding="utf-8")
            shutil.move(site, out / language)
    (out / "index.html").write_text(_CHOICE, encoding="utf-8")
    return subprocess.run([sys.executable, Path(__file__).with_name("links.py"), "--site", out], check=False).returncode


_CHOICE: Final = """<!doctype html>
<html lang="es">
<meta charset="utf-8">
<title>EPF GCS</title>
<h1>EPF GCS</h1>
<p><a href="es/index.html">Español</a></p>
<p><a href="en/index.html" lang="en">English</a></p>
</html>
"""


def _sources(root: Path) -> dict[str, str]:
    decided = (path.relative_to(root).as_posix() for path in sorted((root / "decisions").glob("*/*.md")))
    return {**PAGES, **{name: name for name in decided}}


def _toml(value: object) -> str:
    """Lists, texts and tables of one entry or more, as TOML writes them in a line."""
    if isinstance(value, dict):
        return (
            "{ "
            + ", ".join(f"{json.dumps(key, ensure_ascii=False)} = {_toml(one)}" for key, one in value.items())
            + " }"
        )
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
