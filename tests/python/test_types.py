# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""The type stubs say what is there, and what users write is checked by them."""

import pathlib
import subprocess
import sys

import pytest

import vandplan

pytest.importorskip("mypy")
HERE = pathlib.Path(__file__).parent
PACKAGE = pathlib.Path(vandplan.__file__).parent


def mypy(module, *arguments, folder):
    command = [sys.executable, "-m", module, *arguments]
    return subprocess.run(command, capture_output=True, text=True, cwd=folder)


def test_package_and_users_pass_mypy(tmp_path):
    # As an installed package is found, by its py.typed.
    config = f"--config-file={HERE / 'mypy.ini'}"
    files = [str(HERE / "typed_use.py"), *(str(PACKAGE / f"{name}.py") for name in ("__main__", "plotting", "shapes", "stores"))]
    environment = ["--cache-dir", str(tmp_path / "cache")]
    checked = mypy("mypy", config, *environment, *files, folder=PACKAGE.parent)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_stubs_are_those_of_the_module():
    """Every name of the stub is there, and every public name that is there is in the stub."""
    import ast

    stub = ast.parse((PACKAGE / "_core.pyi").read_text("utf-8"))
    kinds = (ast.ClassDef, ast.FunctionDef)

    def names(body):
        return {item.name for item in body if isinstance(item, kinds) and not item.name.startswith("_")}

    def public(thing):
        return {name for name in vars(thing) if not name.startswith("_")}

    assert names(stub.body) == public(vandplan._core)
    for item in stub.body:
        if isinstance(item, ast.ClassDef) and item.name != "InputError" and item.name[0] != "_":
            assert names(item.body) == public(getattr(vandplan._core, item.name)), item.name


def test_the_stub_describes_what_it_declares():
    """Editors show what help() says."""
    import ast
    import inspect

    stub = ast.parse((PACKAGE / "_core.pyi").read_text("utf-8"))
    for item in stub.body:
        if isinstance(item, (ast.ClassDef, ast.FunctionDef)) and not item.name.startswith("_"):
            thing = getattr(vandplan, item.name)
            assert inspect.getdoc(thing) and ast.get_docstring(item) == inspect.getdoc(thing), item.name
    assert "Plans a path" in ast.get_docstring(next(item for item in stub.body if getattr(item, "name", "") == "plan"))


def test_the_stub_has_every_option(yard):
    import ast

    stub = ast.parse((PACKAGE / "_core.pyi").read_text("utf-8"))
    fields = next(item for item in stub.body if getattr(item, "name", "") == "_Options").body
    types = {field.target.id: ast.unparse(field.annotation) for field in fields}
    own = {name for planner in vandplan.planners() for name in planner.options}
    common = set(vandplan.plan(yard, max_iterations=0).options) - {"seed", "time_limit", "max_iterations", "threads"}
    assert own | common | {"style"} == set(types)
    assert types["style"] == "Literal['driver', 'shortest']" and types["cost"] == "Literal['prices', 'time']"
    assert types["margin"] == "float" and types["keep_tree"] == "bool" and types["max_nodes"] == "int"
    for name, kind in types.items():
        if kind.startswith("Literal") and name in common:
            for word in ast.literal_eval(kind.removeprefix("Literal")):
                vandplan.plan(yard, max_iterations=0, **{name: word})


def test_all_that_is_public_is_exported():
    public = {name for name in vars(vandplan._core) if not name.startswith("_")}
    assert set(vandplan.__all__) == public | {"__version__", "plot", "read_store"}
