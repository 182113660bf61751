# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Every public function and method of C++ is in Python, or bindings/python/README.md says why."""

import functools
import re

from conftest import REPOSITORY

import vandplan as vp

HEADERS = REPOSITORY / "include" / "vandplan"
METHODS = "## Which methods of C++ are here"


def functions_of(header):
    """Names of the functions that a header declares outside of classes."""
    text = re.sub(r"//.*|^#.*", "", header.read_text("utf-8"), flags=re.M)
    names, in_namespaces, statement = set(), [], ""
    for character in text:
        if character not in "{};":
            statement += character
            continue
        head = re.sub(r"\s+", " ", statement).strip()
        is_outside = all(in_namespaces)
        if character == "{":
            in_namespaces.append(re.match(r"(inline )?namespace ", head) is not None)
        elif character == "}":
            in_namespaces.pop()
        name = re.search(r"(\w+)\(", re.sub(r"^template <[^>]*> ?", "", head))
        is_other = re.match(r"(class|struct|enum|using|namespace|namespace \w+) |,|\[\[deprecated", head)  # "," goes on after {}
        if is_outside and character != "}" and name and not is_other and "=" not in head[: name.start()]:
            names.add(name.group(1))
        statement = ""
    return names


def methods_of(header):
    """Names of the public methods of each class that a header defines, but for operators."""
    text = re.sub(r"//.*|^#.*", "", header.read_text("utf-8"), flags=re.M)
    found, scopes, statement = {}, [], ""  # scopes: [kind, name, whether it is public now]
    for character in text:
        if character == ":" and re.fullmatch(r"\s*(public|private|protected)\s*", statement):
            scopes[-1][2] = statement.strip() == "public"
            statement = ""
            continue
        if character not in "{};":
            statement += character
            continue
        head = re.sub(r"\s+", " ", statement).strip()
        is_public = all(kind != "other" and public for kind, _, public in scopes)
        if is_public and scopes and scopes[-1][0] == "class" and character != "}":
            of = ".".join(name for kind, name, _ in scopes if kind == "class")
            for name in method_names(head):
                if name != scopes[-1][1]:  # a constructor
                    found.setdefault(of, set()).add(name)
        if character == "{":
            scopes.append(scope_of(head))
        elif character == "}":
            scopes.pop()
        statement = ""
    return found


def method_names(head):
    plain = head
    while plain != (plain := re.sub(r"<[^<>]*>", "", plain)):
        pass  # a template may stand in a template
    name = re.search(r"(?<!~)\b(\w+)\(", plain)
    is_other = re.match(r"(\[\[deprecated|class|struct|enum|using|friend|,)\b", plain)
    if not name or is_other or "operator" in plain or "=" in plain[: name.start()]:
        return []
    return [name.group(1)]


def scope_of(head):
    if re.match(r"(inline )?namespace\b", head):
        return ["namespace", "", True]
    defined = re.match(r"(?:template <[^>]*> ?)?(class|struct) (\w+)", head)
    if defined:
        return ["class", defined.group(2), defined.group(1) == "struct"]
    return ["other", "", False]


def rows(title="## Which functions of C++ are here"):
    """Header or class, verbs that are in Python (with their names there), verbs that are not."""
    page = (REPOSITORY / "bindings" / "python" / "README.md").read_text("utf-8")
    section = page.split(title)[1].split("\n## ")[0]
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `") and len(cells) == 3:
            there = {name: other or name for name, other in re.findall(r"`(\w+)`(?: as `([\w.]+)`)?", cells[1])}
            yield cells[0].strip("`"), there, cells[2]


def test_the_page_names_every_function_of_every_header():
    declared = {header.stem: functions_of(header) for header in HEADERS.glob("*.h")}
    assert "plan" in declared["planner"] and "drive_live" in declared["replanner"]
    left = dict(declared)
    for pattern, there, reasons in rows():
        stems = [stem for stem in declared if re.fullmatch(pattern.replace("*", ".*"), stem)]
        assert stems, f"{pattern}.h is no header"
        for stem in stems:
            excused = left.pop(stem)
            if not reasons.startswith("all: "):
                # A reason may name functions of Python, too.
                named = set(re.findall(r"`(\w+)`", reasons)) & declared[stem]
                assert set(there) | named == excused, f"{stem}.h"
    assert not {stem for stem, names in left.items() if names}, "headers that the page does not name"


def test_the_page_names_every_method_of_every_class():
    declared = {}
    for header in HEADERS.glob("*.h"):
        if not header.stem.startswith("ompl"):  # Python's OMPL has other objects
            declared.update(methods_of(header))
    assert {"nearest", "add", "remove", "size"} <= declared["NearestNodes"]
    assert {"tick", "patch", "answer", "set_goal", "set_moving"} == declared["Replanner"]
    for name, there, reasons in rows(METHODS):
        methods = declared.pop(name)
        if not reasons.startswith("all: "):
            named = set(re.findall(r"`(\w+)`", reasons)) & methods
            assert set(there) | named == methods, name
    assert not declared, "classes that the page does not name"


def test_what_the_page_names_is_there():
    for _, there, _ in [*rows(), *rows(METHODS)]:
        for name in there.values():
            assert functools.reduce(getattr, name.split("."), vp) is not None, name


def test_a_reason_is_given_for_what_is_not_there():
    for header, _, reasons in [*rows(), *rows(METHODS)]:
        for part in filter(None, re.split(r"; ", reasons)):
            assert ":" in part or part == "`name_of`", f"{header}: {part}"
