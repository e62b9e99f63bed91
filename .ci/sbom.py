"""Write the bill of materials of the product as CycloneDX 1.6: what it is made of, its licences, and what needs what.

Usage: sbom.py ROOT OUT. The same sources give the same bytes: no time stands in it, and its serial number is made from
its contents, for the image that holds it is the same each time it is built.
"""

from __future__ import annotations

import json
import sys
import uuid
from pathlib import Path
from typing import Any, Final

sys.path.insert(0, str(Path(__file__).parent))

import shipped

_KINDS: Final = {"gateway": "library", "page": "library", "board": "firmware", "map": "data"}
# Names of licences as SPDX lists them, by how packages write them. What is not here is told in the package's own words.
_SPDX: Final = {
    "0bsd": "0BSD",
    "apache-2.0": "Apache-2.0",
    "bsd-2-clause": "BSD-2-Clause",
    "bsd-3-clause": "BSD-3-Clause",
    "cc-by-4.0": "CC-BY-4.0",
    "isc": "ISC",
    "lgpl-3.0-or-later": "LGPL-3.0-or-later",
    "mit": "MIT",
    "mit-0": "MIT-0",
    "mpl-2.0": "MPL-2.0",
    "ofl-1.1": "OFL-1.1",
    "psf-2.0": "PSF-2.0",
    "zlib": "Zlib",
    "gnu lesser general public license v2 or later (lgplv2+)": "LGPL-2.0-or-later",
}


def bill(root: Path) -> dict[str, Any]:
    """The document."""
    found = shipped.components(root)
    version = shipped.version(root)
    product = f"pkg:pypi/epf-gcs@{version}"
    needed = {purl for component in found for purl in component.needs}
    document = {
        "$schema": "http://cyclonedx.org/schema/bom-1.6.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": product,
                "name": "epf-gcs",
                "version": version,
                "purl": product,
                "licenses": [{"license": {"id": "MIT"}}],
            }
        },
        "components": [_component(component) for component in found],
        "dependencies": [
            # What nothing else needs, the product needs itself.
            {"ref": product, "dependsOn": sorted({one.purl for one in found} - needed)},
            *({"ref": component.purl, "dependsOn": list(component.needs)} for component in found),
        ],
    }
    serial = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(document, sort_keys=True))
    return {**document, "serialNumber": f"urn:uuid:{serial}"}


def text(root: Path) -> str:
    """The document as it is written."""
    return json.dumps(bill(root), indent=2, ensure_ascii=False) + "\n"


def _component(component: shipped.Component) -> dict[str, Any]:
    told: dict[str, Any] = {
        "type": _KINDS[component.part],
        "bom-ref": component.purl,
        "name": component.name,
        "scope": "optional" if component.is_optional else "required",
        "purl": component.purl,
        "properties": [{"name": "epf-gcs:part", "value": component.part}],
    }
    if component.version:
        told["version"] = component.version
    if component.licence is not None:
        told["licenses"] = [_licence(component.licence)]
    if component.sha512 is not None:
        told["hashes"] = [{"alg": "SHA-512", "content": component.sha512}]
    return told


def _licence(said: str) -> dict[str, Any]:
    known = _SPDX.get(said.strip().lower())
    if known is not None:
        return {"license": {"id": known}}
    if " OR " in said or " AND " in said or " WITH " in said:
        return {"expression": said}
    return {"license": {"name": said}}


def main() -> int:
    """Write it; returns the exit code."""
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    out.write_text(text(root), encoding="utf-8")
    print(f"sbom: {len(bill(root)['components'])} components in {out}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
