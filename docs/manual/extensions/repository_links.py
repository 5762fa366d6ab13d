# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Links of pages that Sphinx does not resolve: to folders and files of the repository that are no pages, and to anchors
that are written in HTML. What they name must exist. A folder is shown by its name alone, as there is nothing to open."""

import pathlib

from docutils import nodes


def resolve(app, env, node, contnode):
    """The node for a link to what exists, or None: then Sphinx warns."""
    if node.get("reftype") not in ("myst", "any"):
        return None
    source = pathlib.Path(env.doc2path(node["refdoc"]))
    name, _, anchor = node["reftarget"].partition("#")
    target = source.parent / name if name else source
    if not target.exists():
        return None
    if not anchor:
        return nodes.inline("", "", *contnode.children)
    if target.suffix != ".md" or f'id="{anchor}"' not in target.read_text(encoding="utf-8"):
        return None
    page = env.path2doc(str(target))
    address = app.builder.get_relative_uri(node["refdoc"], page) if name else ""
    return nodes.reference("", "", *contnode.children, refuri=f"{address}#{anchor}", internal=True)


def setup(app):
    app.connect("missing-reference", resolve)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
