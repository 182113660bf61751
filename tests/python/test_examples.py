# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""The examples run, and the README quotes one of them."""

import json
import os
import subprocess
import sys

import pytest
from conftest import REPOSITORY

pytest.importorskip("matplotlib")
EXAMPLES = REPOSITORY / "examples" / "python"


def run(script, folder):
    return subprocess.run(
        [sys.executable, "-W", "error::UserWarning", "-c", script],
        capture_output=True, text=True, cwd=folder, env={**os.environ, "MPLBACKEND": "Agg"},
    )


def test_an_own_grid_is_planned_and_drawn(tmp_path):
    ran = run((EXAMPLES / "own_grid.py").read_text("utf-8"), tmp_path)
    assert ran.returncode == 0, ran.stderr
    assert "solved" in ran.stdout
    assert (tmp_path / "yard.png").read_bytes().startswith(b"\x89PNG")


def test_the_readme_quotes_the_example():
    code = (EXAMPLES / "own_grid.py").read_text("utf-8").split("\n\n", 1)[1]
    assert "```python\n" + code + "```" in (REPOSITORY / "README.md").read_text("utf-8")


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.ipynb")))
def test_notebooks_run_anywhere(name, tmp_path):
    """Packages put them where no scenario file is near."""
    notebook = json.loads((EXAMPLES / name).read_text("utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in cells), "clear it"
    ends = [f"plt.savefig({str(tmp_path / str(i))!r}); plt.close('all')" for i in range(len(cells))]
    script = "\n".join("".join(cell["source"]) + "\n" + end for cell, end in zip(cells, ends))
    ran = run(script, tmp_path)
    assert ran.returncode == 0, ran.stderr
