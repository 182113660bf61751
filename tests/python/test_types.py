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
    files = [str(HERE / "typed_use.py"), *(str(PACKAGE / f"{name}.py") for name in ("plotting", "shapes", "stores"))]
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


def test_all_that_is_public_is_exported():
    public = {name for name in vars(vandplan._core) if not name.startswith("_")}
    assert set(vandplan.__all__) == public | {"__version__", "plot", "read_store"}
