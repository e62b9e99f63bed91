"""The gateway's OpenAPI document as pages to read: one for each subject, and one of all shapes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

METHODS: Final = ("get", "post", "put", "patch", "delete")
SHAPES: Final = "shapes.md"
_Document = Mapping[str, Any]


def pages(document: _Document) -> dict[str, str]:
    """File name -> Markdown. `index.md` has what holds for all, and the stream."""
    subjects: dict[str, list[str]] = {}
    for path, methods in document["paths"].items():
        for method in METHODS:
            if method in methods:
                route = methods[method]
                subjects.setdefault(route["tags"][0], []).append("\n".join(_route(path, method, route)))
    made = {f"{subject}.md": f"# {subject}\n\n" + "\n".join(routes) for subject, routes in sorted(subjects.items())}
    listed = "\n".join(f"- [{name.removesuffix('.md')}]({name})" for name in made)
    index = f"# The interface\n\n{document['info']['description']}\n\n## Subjects\n\n{listed}\n- [Shapes]({SHAPES})\n"
    return {"index.md": index, **made, SHAPES: "\n".join(_shapes(document["components"]["schemas"]))}


def roles(document: _Document, words: _Document, role_words: _Document) -> str:
    """The table of what each role may do, as the page's guide shows it; the words are of one language."""
    table, order = words["roleTable"], ("anyone", "viewer", "operator", "owner")

    def word(role: str) -> str:
        told: str = table["anyone"] if role == "anyone" else role_words[role]
        return told

    seen: dict[str, set[str]] = {}
    changed: dict[str, set[tuple[str, bool]]] = {}
    for methods in document["paths"].values():
        for method in METHODS:
            route = methods.get(method)
            if route is None:
                continue
            subject, least = route["tags"][0], route["x-least-role"]
            seen.setdefault(subject, set())
            if method == "get":
                seen[subject] |= {least} - {"anyone"}
            else:
                changed.setdefault(subject, set()).add((least, route["x-needs-control"]))
    lines = [f"| {table['what']} | {table['sees']} | {table['changes']} |", "|---|---|---|"]
    for subject in sorted(seen):
        sees = min(seen[subject], key=order.index, default=None)
        changes = [
            table["withControl"].replace("{{role}}", word(least)) if control else word(least)
            for least, control in sorted(changed.get(subject, ()), key=lambda one: (order.index(one[0]), one[1]))
        ]
        name = words["roleSubject"].get(subject, subject)
        lines.append(
            f"| {name} | {word(sees) if sees else table['nobody']} | {'; '.join(changes) or table['nobody']} |"
        )
    return "\n".join(lines)


def _route(path: str, method: str, route: _Document) -> Iterator[str]:
    yield f"## {method.upper()} {path}\n"
    if told := route.get("description"):
        yield f"{told}\n"
    control = ", with control" if route["x-needs-control"] else ""
    yield f"Least role: **{route['x-least-role']}**{control}.\n"
    if parameters := route.get("parameters"):
        yield "| parameter | in | type | meaning |\n|---|---|---|---|"
        for one in parameters:
            needed = "" if one.get("required") else " (optional)"
            meaning = _cell(one.get("description", ""))
            yield f"| `{one['name']}`{needed} | {one['in']} | {kind(one['schema'])} | {meaning} |"
        yield ""
    for content, told in route.get("requestBody", {}).get("content", {}).items():
        yield f"Body ({content}): {kind(told.get('schema', {}))}\n"
    yield "| answer | shape | |\n|---|---|---|"
    for status, answer in route["responses"].items():
        shapes = [kind(told.get("schema", {})) for told in answer.get("content", {}).values()]
        yield f"| {status} | {', '.join(dict.fromkeys(shapes))} | {_cell(answer['description'])} |"
    yield ""


def _shapes(schemas: _Document) -> Iterator[str]:
    yield "# Shapes\n"
    yield "What requests and answers are made of.\n"
    for name in sorted(schemas):
        schema = schemas[name]
        yield f"## {name}\n"
        if told := schema.get("description"):
            yield f"{told}\n"
        if "properties" not in schema:
            yield f"{kind(schema)}\n"
            continue
        yield "| field | type | meaning |\n|---|---|---|"
        needed = schema.get("required", ())
        for field, told in schema["properties"].items():
            optional = "" if field in needed else " (optional)"
            yield f"| `{field}`{optional} | {kind(told)} | {_cell(told.get('description', ''))} |"
        yield ""


def kind(schema: _Document) -> str:
    """A type in words, with a link to each shape that it names."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return f"[{name}]({SHAPES}#{name.lower()})"
    for joined in ("anyOf", "oneOf", "allOf"):
        if joined in schema:
            return " or ".join(kind(one) for one in schema[joined])
    if "enum" in schema:
        return _cell(", ".join(f"`{value}`" for value in schema["enum"]))
    if "const" in schema:
        return f"`{schema['const']}`"
    if schema.get("type") == "array":
        return f"list of {kind(schema.get('items', {}))}"
    if schema.get("type") == "object" and isinstance(schema.get("additionalProperties"), dict):
        return f"by name: {kind(schema['additionalProperties'])}"
    told = str(schema.get("type", "any"))
    least, most = schema.get("minimum"), schema.get("maximum")
    return (
        f"{told} {'' if least is None else least}..{'' if most is None else most}"
        if (least, most) != (None, None)
        else told
    )


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")
