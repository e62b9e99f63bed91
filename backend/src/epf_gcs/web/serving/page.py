"""The built page, served from the same address as its interface."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from fastapi import FastAPI, Request
from fastapi.responses import FileResponse, PlainTextResponse, Response

from epf_gcs.web.serving.problems import problem_response

_NOT_BUILT: Final = "The page is not built: `make run` builds it. The interface is at /api/docs.\n"
# Vite puts a hash of the content into these file names, so they may be cached forever.
_HASHED: Final = "assets"
_MOST_SAID: Final = 200


def install_page(app: FastAPI, folder: Path) -> None:
    """Serve `folder` below /. The page itself is only at /: it has no client-side routes."""
    root = folder.resolve()

    @app.get("/{path:path}", include_in_schema=False)
    async def page(path: str, request: Request) -> Response:
        index = root / "index.html"
        file = index if path == "" else _file_below(root, path)
        if file is None or not file.is_relative_to(root):
            if path in ("", "index.html"):
                return PlainTextResponse(_NOT_BUILT, 404)
            detail = f"{request.url.path[:_MOST_SAID]} is no address of this station: /api/docs lists all of them."
            return problem_response(404, "no_such_address", detail)
        if not file.is_file():
            return PlainTextResponse(_NOT_BUILT, 404)
        hashed = path.startswith(f"{_HASHED}/")
        cache = "public, max-age=31536000, immutable" if hashed else "no-cache"
        return FileResponse(file, headers={"Cache-Control": cache})


def _file_below(root: Path, path: str) -> Path | None:
    """The file at this path; None if there is none, or if it is not a valid file name."""
    try:
        file = (root / path).resolve()
        return file if file.is_file() else None
    except (OSError, ValueError):
        return None
