"""Find links that lead nowhere: in the Markdown of the tree, and in the built site.

Usage: links.py ROOT (the Markdown that git knows), or links.py --site FOLDER. Addresses of the internet are not asked.
A built page may load nothing from the internet: it has to be readable without one.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from html.parser import HTMLParser
from pathlib import Path
from typing import Final
from urllib.parse import unquote, urlsplit

LINK: Final = re.compile(r"(!?)\[([^\]]*)\]\(([^()\s]+)\)")
FENCE: Final = re.compile(r"^(```|~~~).*?^\1", re.MULTILINE | re.DOTALL)
_CODE: Final = re.compile(r"`[^`\n]*`")
_HEADING: Final = re.compile(r"^#+ +(.+?) *#*$", re.MULTILINE)
# Kept as others have made it; the guide, whose pictures are names that its own tests hold; and pages that link pages of
# the site, which is looked at when it is built.
_NOT_OURS: Final = ("firmware/third_party/", "frontend/src/features/guide/", "docs/es/", "docs/en/")
_IN_STYLE: Final = re.compile(r"url\(\s*['\"]?((?:https?:)?//[^)'\"]+)")
# What a browser fetches by itself; a link is followed by people.
_LOADED: Final = {"img": "src", "script": "src", "iframe": "src", "source": "src", "video": "src", "audio": "src"}
_LOADED_RELATIONS: Final = frozenset({"stylesheet", "icon", "preload", "modulepreload", "preconnect", "dns-prefetch"})


def prose(text: str) -> str:
    """Markdown without its code, in which brackets are no links."""
    return _CODE.sub("", FENCE.sub("", text))


def anchors(text: str) -> frozenset[str]:
    """The names by which headings of a Markdown text are reached."""
    plain = [re.sub(r"[`*\[\]]|\([^)]*\)", "", heading) for heading in _HEADING.findall(FENCE.sub("", text))]
    return frozenset(re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", heading.strip().lower())) for heading in plain)


def in_markdown(root: Path, names: list[str]) -> Iterator[str]:
    """A sentence for each link of these files that leads nowhere in the tree."""
    known = {name: anchors((root / name).read_text(encoding="utf-8")) for name in names}
    for name in names:
        for _, _, target in LINK.findall(prose((root / name).read_text(encoding="utf-8"))):
            split = urlsplit(target)
            if split.scheme:
                continue
            path = (root / name).parent / unquote(split.path) if split.path else root / name
            if not path.exists():
                yield f"{name}: {target} does not exist"
                continue
            other = path.resolve().relative_to(root.resolve()).as_posix()
            if split.fragment and other in known and split.fragment not in known[other]:
                yield f"{name}: {target}: {other} has no such heading"


class _Page(HTMLParser):
    """What a built page links, loads, and can be reached at."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.names: set[str] = set()
        self.linked: list[str] = []
        self.loaded: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = {name: value or "" for name, value in attrs}
        self.names |= {found[name] for name in ("id", "name") if name in found}
        if tag in _LOADED and found.get(_LOADED[tag]):
            self.loaded.append(found[_LOADED[tag]])
        elif tag == "link" and _LOADED_RELATIONS & set(found.get("rel", "").split()):
            self.loaded.append(found.get("href", ""))
        elif tag == "a" and "href" in found:
            self.linked.append(found["href"])


def in_site(folder: Path) -> Iterator[str]:
    """A sentence for each link of a built site that leads nowhere, and for all that is loaded from elsewhere."""
    folder = folder.resolve()
    pages = {path: _Page(path.read_text(encoding="utf-8")) for path in folder.rglob("*.html")}
    for path, page in pages.items():
        name = path.relative_to(folder)
        # Its addresses begin at the server's root, which a folder on a disk has not; nothing links to it.
        if name.name == "404.html":
            continue
        for target in page.loaded:
            if urlsplit(target).scheme or target.startswith("//"):
                yield f"{name} loads {target} from the internet"
        for target in (*page.loaded, *page.linked):
            if fault := _leads_nowhere(path, target, pages):
                yield f"{name}: {target}{fault}"
    for style in folder.rglob("*.css"):
        for target in _IN_STYLE.findall(style.read_text(encoding="utf-8")):
            yield f"{style.relative_to(folder)} loads {target} from the internet"


def _leads_nowhere(path: Path, target: str, pages: Mapping[Path, _Page]) -> str:
    """What is wrong with a link of the page at `path`, or ""."""
    split = urlsplit(target)
    if split.scheme or split.netloc:
        return ""
    other = (path.parent / unquote(split.path)).resolve() if split.path else path
    if other.is_dir():
        other /= "index.html"
    if not other.is_file():
        return " does not exist"
    is_there = not split.fragment or other not in pages or unquote(split.fragment) in pages[other].names
    return "" if is_there else ": no such place in that page"


def main() -> int:
    """Look at all of them; returns the exit code."""
    if sys.argv[1] == "--site":
        folder = Path(sys.argv[2])
        found = list(in_site(folder))
        told = f"{len(list(folder.rglob('*.html')))} pages"
    else:
        root = Path(sys.argv[1])
        listed = subprocess.run(["git", "-C", root, "ls-files", "*.md"], capture_output=True, text=True, check=True)
        names = [
            name for name in listed.stdout.splitlines() if not name.startswith(_NOT_OURS) and (root / name).exists()
        ]
        found = list(in_markdown(root, names))
        told = f"{len(names)} files of Markdown"
    print("\n".join(f"links: {sentence}." for sentence in found) or f"links: {told}, every link leads somewhere.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
