"""The built page, served from the same address as its interface."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from fastapi import FastAPI, Request
from fastapi.responses import FileResponse, PlainTextResponse, Response

from epf_gcs.web.problems import problem_response

_NOT_BUILT: Final = "The page is not built: run `npm run build` in frontend/. The interface is at /api/docs.\n"
# Vite puts a hash of the content into the names of what lies here.
_HASHED: Final = "assets"


def install_page(app: FastAPI, folder: Path) -> None:
    """Serve `folder` below /; what is no file there is the page itself, for its own addresses."""
    root = folder.resolve()

    @app.get("/{path:path}", include_in_schema=False)
    async def page(path: str, request: Request) -> Response:
        if path == "api" or path.startswith("api/"):
            detail = f"{request.url.path} is no address of this interface: /api/docs lists all of them."
            return problem_response(404, "no_such_address", detail)
        index = root / "index.html"
        file = (root / path).resolve()
        if file.is_file() and file.is_relative_to(root):
            hashed = path.startswith(f"{_HASHED}/")
            cache = "public, max-age=31536000, immutable" if hashed else "no-cache"
            return FileResponse(file, headers={"Cache-Control": cache})
        if path.startswith(f"{_HASHED}/") or not index.is_file():
            return PlainTextResponse(_NOT_BUILT, 404)
        return FileResponse(index, headers={"Cache-Control": "no-cache"})
