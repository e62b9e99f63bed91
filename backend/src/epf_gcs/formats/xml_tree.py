"""XML from untrusted files: document types and entities, by which a file can attack its reader, are refused."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final
from xml.etree.ElementTree import Element, ParseError, SubElement, tostring

from defusedxml import DefusedXmlException
from defusedxml.ElementTree import fromstring

from epf_gcs.formats.mission_file import FileFault

KML: Final = "http://www.opengis.net/kml/2.2"
GPX: Final = "http://www.topografix.com/GPX/1/1"
EPF: Final = "urn:epf-gcs:mission:1"


def parse_xml(data: bytes) -> Element:
    """The root element. Raises FileFault with the line of the error."""
    try:
        root: Element = fromstring(data, forbid_dtd=True)
    except DefusedXmlException as error:
        raise FileFault(
            "mission_file_forbidden", "it declares a document type or entities, which no plan needs", format="xml"
        ) from error
    except ParseError as error:
        line = error.position[0]
        raise FileFault(
            "mission_file_damaged", f"it is no whole XML at line {line}", format="xml", line=line
        ) from error
    except (ValueError, LookupError) as error:
        raise FileFault(
            "mission_file_damaged", "it is no whole XML at line 1 (encoding unknown)", format="xml", line=1
        ) from error
    return root


def local(element: Element) -> str:
    """The name without its namespace, which differs between versions of a format."""
    return element.tag.rpartition("}")[2]


def every(root: Element, name: str) -> Iterator[Element]:
    """All elements of this name below `root`, in the order of the file."""
    return (element for element in root.iter() if local(element) == name)


def child(element: Element, name: str) -> Element | None:
    """The first child of this name."""
    return next((found for found in element if local(found) == name), None)


def child_text(element: Element, name: str) -> str | None:
    """The text of the first child of this name."""
    found = child(element, name)
    return None if found is None else found.text


def add(parent: Element, name: str, text: str | None = None, /, **attributes: str) -> Element:
    """Append a child and return it."""
    made = SubElement(parent, name, attributes)
    made.text = text
    return made


def xml_bytes(root: Element) -> bytes:
    """A whole document. Namespaces are plain attributes of the root, so that the library invents no prefixes."""
    return bytes(tostring(root, encoding="UTF-8", xml_declaration=True))


def decimal(value: float) -> str:
    """The number as an XML decimal: without an exponent (1e-05 is not allowed), at most a double's digits."""
    text = f"{value:.12f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def plain(text: str) -> str:
    """The text with only those characters that XML and file names can hold: printable ones."""
    return "".join(letter for letter in text if letter.isprintable()).strip()
