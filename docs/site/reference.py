# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""What does each public header offer, as pages?

Doxygen reads the declarations and their docstrings, Sphinx shows them and links their names. Between
the two stands this: one page for each header, in the order of the header, under its question.
"""

import itertools
import re
import subprocess
import textwrap
import xml.etree.ElementTree as ElementTree
from pathlib import Path

DOXYFILE = """
INPUT = include/vandplan
OUTPUT_DIRECTORY = {output}
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
WARN_AS_ERROR = FAIL_ON_WARNINGS
QUIET = YES
"""
CLASSES = ("class", "struct")


def escaped(text):
    return re.sub(r"([\\*`_|]|(?<=\w):(?=\w))", r"\\\1", text)


def spaced(code):
    """C++ as Doxygen writes it, with the spaces where they belong."""
    code = re.sub(r"\s+", " ", code).strip()
    code = re.sub(r"< ", "<", code)
    code = re.sub(r" >", ">", code)
    return re.sub(r"(?<![<>=!])=(?!=)\s*", " = ", code).replace("  ", " ").strip()


def read_declarations(xml):
    """All that is declared: (header, line, scope, XML), and every name with what it is."""
    found, kinds = [], {}
    for file in sorted(xml.glob("*.xml")):
        compound = ElementTree.parse(file).getroot().find("compounddef")
        if compound is None or compound.get("kind") not in (*CLASSES, "namespace"):
            continue
        scope = compound.findtext("compoundname")
        if compound.get("kind") in CLASSES:
            kinds[scope] = compound
            place = compound.find("location")
            outer = scope.rpartition("::")[0]
            found.append((Path(place.get("file")).name, int(place.get("line")), outer, compound))
        for member in compound.iter("memberdef"):
            kinds.setdefault(f"{scope}::{member.findtext('name')}", member)
            if compound.get("kind") == "namespace":
                place = member.find("location")
                found.append((Path(place.get("file")).name, int(place.get("line")), scope, member))
    return found, kinds


class Page:
    """One header as reStructuredText."""

    def __init__(self, kinds, link_of):
        self.kinds = kinds
        self.link_of = link_of
        self.lines = []

    def write(self, text="", depth=0):
        self.lines.append(textwrap.indent(text, "   " * depth) if text else "")

    # ---- Docstrings ----

    def code(self, text, scope, in_backquotes=True):
        """A name, linked where it is one of ours."""
        while scope and re.fullmatch(r"[\w:]+", text):
            name = f"{scope}::{text}"
            if name in self.kinds:
                return f":cpp:any:`{text} <{name}>`"
            scope = scope.rpartition("::")[0]
        return f"``{text}``" if in_backquotes else escaped(text)

    def plain(self, text):
        """Text in which the pages that it names are links."""
        parts = re.split(r"((?:docs/[\w/-]+\.md)|(?:\b[a-z_]+\.h\b))", text or "")
        return "".join(self.link_of(part) or escaped(part) for part in parts)

    def inline(self, node, scope):
        text = self.plain(node.text)
        for child in node:
            if child.tag == "computeroutput":
                text += self.code("".join(child.itertext()), scope)
            elif child.tag == "ref":
                text += self.code("".join(child.itertext()), scope, in_backquotes=False)
            elif child.tag in ("orderedlist", "itemizedlist"):
                mark = "#. " if child.tag == "orderedlist" else "- "
                for item in child:
                    text += "\n\n" + mark + " ".join(self.inline(para, scope) for para in item)
                text += "\n\n"
            else:
                text += self.inline(child, scope)
            text += self.plain(child.tail)
        return re.sub(r"[ \t]+", " ", text).strip(" ") if node.tag == "para" else text

    def docstring(self, node, scope, depth):
        for part in ("briefdescription", "detaileddescription"):
            for para in node.findall(f"{part}/para"):
                for line in (self.inline(para, scope) + "\n").split("\n"):
                    self.write(line, depth)

    def paragraphs(self, paragraphs):
        """The comment at the head of a header or of one of its sections."""
        for paragraph in paragraphs:
            if paragraph.startswith(" "):
                language = "text" if "-->" in paragraph else "cpp"
                self.write(f".. code-block:: {language}\n   :force:\n\n{textwrap.indent(textwrap.dedent(paragraph), '   ')}\n")
            else:
                codes = re.split(r"`([^`]*)`", paragraph.replace("\n", " "))
                self.write("".join(self.code(t, "vandplan") if i % 2 else self.plain(t) for i, t in enumerate(codes)) + "\n")

    # ---- Declarations ----

    def directive(self, kind, signatures, depth, options=()):
        lines = [f".. cpp:{kind}:: {signatures[0]}"]
        lines += [" " * len(lines[0][: lines[0].index(":: ") + 3]) + more for more in signatures[1:]]
        for line in [*lines, *(f"   {option}" for option in options), ""]:
            self.write(line, depth)

    def signature(self, member):
        kind, name = member.get("kind"), member.findtext("name")
        if kind == "typedef":
            return f"{name} = {spaced(''.join(member.find('type').itertext()))}"
        type_text = spaced("".join(member.find("type").itertext()))
        if kind == "variable":
            value = spaced("".join(member.find("initializer").itertext())) if member.find("initializer") is not None else ""
            if value in ("= {}", "{}") or "{." in value:
                value = ""  # says nothing, or more than Sphinx can read
            tail = member.findtext("argsstring") or ""
            if tail:  # a pointer to a function
                return f"{type_text}{name}{spaced(tail)}"
            if "@" in type_text:  # of a struct without a name
                type_text = "constexpr auto"
            return re.sub(" +", " ", f"{type_text} {name} {value}").strip()
        static = "static " if member.get("static") == "yes" and "static" not in type_text else ""
        arguments = re.sub(r"\s*=\s*default$", "", member.findtext("argsstring"))
        parameters = [parameter_of(parameter) for parameter in member.iterfind("templateparamlist/param")]
        template = f"template <{', '.join(parameters)}> " if parameters else ""
        return f"{template}{static}{type_text} {name}{spaced(arguments)}".strip()

    def members(self, group, scope, depth):
        """One entry for neighbours of which the first alone has a docstring."""
        first = group[0]
        kind = {"typedef": "type", "variable": "member", "enum": "enum-class"}.get(first.get("kind"), "function")
        options = [":nocontentsentry:"] if depth else []
        if kind == "enum-class":
            self.directive(kind, [first.findtext("name")], depth, options)
        else:
            self.directive(kind, [self.signature(member) for member in group], depth, options)
        self.docstring(first, scope, depth + 1)
        for value in first.findall("enumvalue"):
            self.directive("enumerator", [value.findtext("name")], depth + 1, [":nocontentsentry:"])
            self.docstring(value, scope, depth + 2)

    def names(self, here):
        """What the page holds, in one paragraph of links."""
        links = {}
        for _, scope, node in here:
            name = (node.findtext("name") or node.findtext("compoundname")).rpartition("::")[2]
            links.setdefault(f":cpp:any:`{name} <{scope}::{name}>`")
        self.write(".. rst-class:: names\n\n" + ", ".join(links) + "\n")

    def compound(self, node, depth):
        name = node.findtext("compoundname")
        self.directive(node.get("kind"), [name.rpartition("::")[2]], depth, [":nocontentsentry:"] if depth else [])
        self.docstring(node, name, depth + 1)
        inner = [self.kinds[ref.text] for ref in node.findall("innerclass") if ref.get("prot") == "public"]
        members = [member for member in node.iter("memberdef") if is_shown(member)]
        self.entries([*inner, *members], name, depth + 1)

    def entries(self, nodes, scope, depth):
        group = []
        for node in sorted(nodes, key=line_of):
            if group and not goes_on(group[0], node):
                self.members(group, scope, depth)
                group = []
            if node.tag == "compounddef":
                self.compound(node, depth)
            else:
                group.append(node)
        if group:
            self.members(group, scope, depth)


def parameter_of(template):
    """A parameter of a template; one that a concept restrains is any type to readers."""
    kind, name = "".join(template.find("type").itertext()), template.findtext("declname")
    return kind if name is None else f"typename {name}"


def line_of(node):
    return int(node.find("location").get("line"))


def is_documented(node):
    return any(node.find(f"{part}/para") is not None for part in ("briefdescription", "detaileddescription"))


def is_shown(member):
    """Neither private nor what every value has: comparison, copies."""
    name, arguments = member.findtext("name"), member.findtext("argsstring") or ""
    if member.get("prot") != "public" or member.get("kind") == "friend" or "=delete" in arguments:
        return False
    is_copy = re.match(rf"\((const )?{re.escape(name)} &&?\w*\)", arguments)
    return is_documented(member) or not (is_copy or re.match(r"operator=|~", name))


def goes_on(before, node):
    """Whether a function without docstring stands right under its twin: the docstring is of both."""
    if before.tag != "memberdef" or node.tag != "memberdef" or is_documented(node) or not is_documented(before):
        return False
    types = [["".join(part.itertext()) for part in function.iter("type")] for function in (before, node)]
    near = line_of(node) - line_of(before) <= 3
    return before.get("kind") == node.get("kind") == "function" and types[0] == types[1] and near


def read_head(header):
    """Question, further paragraphs and sections (by line) of a header."""
    lines = header.read_text().split("\n")
    begin = lines.index("#pragma once") + 1
    end = next(i for i in range(begin, len(lines)) if not lines[i].startswith("//"))
    text = "\n".join(line[3:] for line in lines[begin:end])
    question, _, rest = text.partition("\n\n")
    sections = {}
    for i, line in enumerate(lines, 1):
        if m := re.match(r"// ---- (.*) ----", line):
            more = itertools.takewhile(lambda below: below.startswith("//"), lines[i:])
            sections[i] = m[1], paragraphs_of("\n".join(below[3:] for below in more))
    return question.replace("\n", " "), paragraphs_of(rest), sections


def paragraphs_of(text):
    return [part for part in text.strip("\n").split("\n\n") if part]


def header_page(header, found, kinds, link_of):
    question, paragraphs, sections = read_head(header)
    page = Page(kinds, link_of)
    title = escaped(question)
    page.write(f"{title}\n{'=' * len(title)}\n")
    page.write(f".. code-block:: cpp\n\n   #include <vandplan/{header.name}>\n")
    page.paragraphs(paragraphs)
    here = [(line, scope, node) for file, line, scope, node in found if file == header.name and top(node, scope)]
    here.sort(key=lambda row: row[0])
    page.names(here)
    runs = [[]]
    for line, scope, node in here:
        passed = [at for at in sections if at < line]
        key = (scope, max(passed, default=0))
        if not runs[-1] or runs[-1][0][0] != key:
            runs.append([])
        runs[-1].append((key, node))
    section = 0
    for run in filter(None, runs):
        scope, at = run[0][0]
        if at != section:
            heading, below = sections[at]
            page.write(f"{escaped(heading)}\n{'-' * (len(heading) + 8)}\n")
            page.paragraphs(below)
            section = at
        page.write(f".. cpp:namespace:: {scope}\n")
        page.entries([node for _, node in run], scope, 0)
    page.write(f"The header itself: {link_of(f'include/vandplan/{header.name}')}.")
    return question, "\n".join(page.lines) + "\n"


def top(node, scope):
    """Declared in a namespace of ours, and with a name."""
    name = node.findtext("name") or node.findtext("compoundname")
    is_ours = scope == "vandplan" or scope.startswith("vandplan::")
    is_member = node.tag == "compounddef" and scope.rpartition("::")[2][:1].isupper()
    return is_ours and not is_member and "@" not in name and "__" not in name


def run_doxygen(repository, output):
    output.mkdir(parents=True, exist_ok=True)
    settings = DOXYFILE.format(output=output)
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=repository, check=True)
    return output / "xml"


def read_rooms(repository):
    """(folder, headers, question) of each folder that has public headers."""
    command = [repository / "tools/check_includes", "--headers"]
    rows = subprocess.run(command, text=True, capture_output=True, check=True).stdout.splitlines()
    return [(room, headers.split(), question) for room, headers, question in (row.split("|") for row in rows)]


def write_reference(repository, work, write, link_of):
    """Writes cpp/index.rst and a page for each header with `write(file, text)`."""
    found, kinds = read_declarations(run_doxygen(repository, work))
    index = [(repository / "docs/site/reference.rst").read_text()]
    for room, headers, answers in read_rooms(repository):
        index.append(f"{escaped(answers)}\n{'-' * len(escaped(answers))}\n")
        index += [".. list-table::", "   :class: headers", "   :widths: 30 70", ""]
        for name in headers:
            header = repository / f"include/vandplan/{name}.h"
            question, text = header_page(header, found, kinds, link_of(f"cpp/{name}"))
            write(f"cpp/{name}.rst", text)
            index += [f"   * - :doc:`{name}.h <{name}>`", f"     - {escaped(question)}"]
        index += ["", ".. toctree::", "   :hidden:", "", *(f"   {name}.h <{name}>" for name in headers), ""]
    write("cpp/index.rst", "\n".join(index))
