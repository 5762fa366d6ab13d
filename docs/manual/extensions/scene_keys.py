# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""The directive `scene-keys`: a table of keys for each object of scene files, from the JSON Schema that
`meniscus schema` prints. A key without a description is an error."""

import json
import os
import pathlib

from docutils import nodes
from docutils.parsers.rst import Directive
from docutils.statemachine import StringList
from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
LIMITS = (("minimum", "≥"), ("exclusiveMinimum", ">"), ("maximum", "≤"), ("exclusiveMaximum", "<"))


def text(value):
    return "`" + json.dumps(value, ensure_ascii=False) + "`"


def choices(schema):
    return schema.get("oneOf", schema.get("anyOf", []))


def form(schema):
    """What a value is, in words."""
    if "const" in schema:
        return text(schema["const"])
    if "enum" in schema:
        return ", ".join(map(text, schema["enum"]))
    if choices(schema):
        return " or ".join(dict.fromkeys(form(choice) for choice in choices(schema)))
    kind = schema["type"]
    if kind == "array":
        count = schema.get("minItems")
        fixed = count is not None and count == schema.get("maxItems")
        return f"{count} × {form(schema['items'])}" if fixed else f"list of {form(schema['items'])}"
    limits = [f"{word} {schema[key]:g}" for key, word in LIMITS if key in schema]
    return ", ".join([kind, *limits])


def meaning(schema):
    """The description without the unit, which has a column of its own."""
    return schema.get("description", "").removesuffix(f" ({schema.get('unit', '')})")


def objects(path, schema, description):
    """Each object of the schema that has keys: its path, itself and what it is, before those that it contains."""
    for choice in choices(schema):
        name = choice.get("properties", {}).get("type", {}).get("const")
        yield from objects(f"{path} ({name})" if name else path, choice, choice.get("description", description))
    if schema.get("type") == "array":
        yield from objects(f"{path}[]", schema["items"], description)
    if "properties" in schema:
        yield path, schema, description
        for key, value in schema["properties"].items():
            yield from objects(f"{path}.{key}".lstrip("."), value, meaning(value))


def table(path, schema):
    """The lines of a table."""
    yield "| key | value | unit | default | meaning |"
    yield "|---|---|---|---|---|"
    needed = set(schema.get("required", []))
    for key, value in schema["properties"].items():
        if not meaning(value) and "const" not in value:
            LOGGER.warning("the key %s of %s has no description", key, path)
        default = "needed" if key in needed else text(value["default"]) if "default" in value else ""
        cells = [f"`{key}`", form(value), value.get("unit", ""), default, meaning(value)]
        yield "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


class SceneKeys(Directive):
    """Reads the file that MENISCUS_SCHEMA names."""

    def run(self):
        path = pathlib.Path(os.environ["MENISCUS_SCHEMA"])
        self.state.document.settings.env.note_dependency(str(path))
        schema = json.loads(path.read_text(encoding="utf-8"))
        lines, seen = [], set()
        for place, part, description in objects("", schema, schema["description"]):
            keys = json.dumps(part["properties"])
            if keys not in seen:
                seen.add(keys)
                title = place or "the scene"
                lines += [f"## `{title}`", "", description, "", *table(title, part), ""]
        section = nodes.section()
        section.document = self.state.document
        self.state.nested_parse(StringList(lines, "scene keys"), self.content_offset, section, match_titles=True)
        return section.children


def setup(app):
    app.add_directive("scene-keys", SceneKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
