# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""How Sphinx makes the site of the pages that stage.py gathers. scripts/docs runs both."""

import inspect
import os
import re

project = "Vändplan"
author = "the Vändplan authors"
copyright = "2026, the Vändplan authors"  # noqa: A001
release = os.environ["VANDPLAN_VERSION"]
version = release

extensions = ["myst_parser", "sphinx_copybutton", "sphinx_inline_tabs"]
if os.environ.get("VANDPLAN_PYTHON"):
    extensions.append("sphinx.ext.autodoc")
    autodoc_docstring_signature = False  # signature_of reads those of several lines, too

# Pages are plain Markdown; what goes beyond it stands on the front page alone.
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
highlight_language = "none"
copybutton_prompt_text = r"\$ |>>> "
copybutton_prompt_is_regexp = True

# What a page names exists, but for names of the standard library and of private types.
nitpicky = True
nitpick_ignore_regex = [("cpp:.*", "std|std::.*|.*collision|.*collision::.*|.*ompl|.*ompl::.*|T|vandplan|search|search::Milestones|sites|sites::SiteData|base|base::Derived|(Dubins|ReedsShepp)Path"), ("py:.*", ".*")]
primary_domain = None
cpp_index_common_prefix = ["vandplan::", "vandplan::search::", "vandplan::evaluation::"]
toc_object_entries_show_parents = "hide"
add_function_parentheses = True

html_theme = "furo"
html_title = f"Vändplan {release}"
html_static_path = ["_static"]
html_css_files = ["style.css"]
html_favicon = "_static/icon.svg"
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#0072b2",
        "color-brand-content": "#0068a3",
        "color-accent": "#c24e00",
        "color-card": "#f6f8fa",
    },
    "dark_css_variables": {
        "color-brand-primary": "#56b4e9",
        "color-brand-content": "#6cc0f0",
        "color-accent": "#f0a060",
        "color-card": "#1c2126",
    },
}


def first_paragraph(name, thing):
    """The signature that a docstring of the module begins with; none if it begins with words."""
    head = (inspect.getdoc(thing) or "").split("\n\n")[0]
    return re.fullmatch(rf"{name.rpartition('.')[2]}(\(.*\))(?: -> (.*))?", head, re.S)


def signature_of(app, what, name, thing, options, signature, returned):
    found = first_paragraph(name, thing)
    return (" ".join(found[1].split()), found[2]) if found else None


def plain_docstring(app, what, name, thing, options, lines):
    """Docstrings are plain text with `names` and indented code; here they become reStructuredText."""
    text = "\n".join(lines).strip("\n")
    if first_paragraph(name, thing) or text.startswith("-> "):
        text = text.partition("\n\n")[2]
    paragraphs, in_code = [], False
    for paragraph in text.split("\n\n"):
        is_code = paragraph.startswith("    ")
        if is_code:
            paragraphs += [paragraph] if in_code else ["::", paragraph]
        else:
            parts = re.split(r"`([^`]*)`", paragraph)
            quoted = (f"``{part}``" if i % 2 else re.sub(r"([\\*|_]|(?<=\w):(?=\w))", r"\\\1", part) for i, part in enumerate(parts))
            paragraphs.append("".join(quoted))
        in_code = is_code
    lines[:] = "\n\n".join(paragraphs).split("\n") + [""]


def setup(app):
    if os.environ.get("VANDPLAN_PYTHON"):
        app.connect("autodoc-process-signature", signature_of)
        app.connect("autodoc-process-docstring", plain_docstring)
