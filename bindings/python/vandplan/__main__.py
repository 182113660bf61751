# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""The command line that a wheel brings: `vandplan`, or `python3 -m vandplan`."""

from __future__ import annotations

import os
import pathlib
import sys


def main() -> None:
    """Becomes the program `vandplan`, with the arguments of this one."""
    program = pathlib.Path(__file__).with_name("bin") / "vandplan"
    if not program.exists():
        sys.exit("vandplan: this package holds no command line; that of Debian is in the package vandplan")
    os.execv(program, ["vandplan", *sys.argv[1:]])


if __name__ == "__main__":
    main()
