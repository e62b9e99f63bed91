"""Put the pictures of `npm run moving` (e2e) together to the moving picture of the README.

Usage: moving.py PICTURES_FOLDER OUT.webp
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Final

from PIL import Image

_WIDTH: Final = 960
_PICTURE_MS: Final = 250


def main(folder: Path, out: Path) -> None:
    """Write `out`, an endless WebP of all pictures of `folder` in the order of their names."""
    pictures = [Image.open(file).convert("RGB") for file in sorted(folder.glob("*.webp"))]
    small = [one.resize((_WIDTH, one.height * _WIDTH // one.width), Image.Resampling.LANCZOS) for one in pictures]
    small[0].save(out, save_all=True, append_images=small[1:], duration=_PICTURE_MS, loop=0, quality=55, method=6)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
