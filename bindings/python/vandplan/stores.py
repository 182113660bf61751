# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""Reads result stores of comparisons as data frames."""

from __future__ import annotations

TYPE_CHECKING = False  # importing typing takes longer than everything else
if TYPE_CHECKING:
    import os

    import pandas

_RUNS = """
SELECT scenarios.name AS scenario, runs.goal, configurations.planner, runs.region, runs.seed,
       runs.status, runs.reason, runs.cost,
       (SELECT sum(abs(length)) FROM segments WHERE run = runs.id) AS length,
       (SELECT time FROM costs WHERE run = runs.id ORDER BY number LIMIT 1) AS first_time,
       (SELECT cost FROM costs WHERE run = runs.id ORDER BY number LIMIT 1) AS first_cost,
       runs.time_total, runs.iterations, runs.nodes, runs.exact_solves, runs.edge_checks,
       runs.started, configurations.options
FROM runs JOIN scenarios ON scenarios.id = runs.scenario
          JOIN configurations ON configurations.id = runs.configuration
ORDER BY runs.id
"""


def refusal(where: object, problem: str) -> Exception:
    from vandplan._core import InputError

    error = InputError(f"{where}: {problem}")
    error.where, error.problem = str(where), problem
    return error


def read_store(file: str | os.PathLike[str]) -> pandas.DataFrame:
    """Every run of a result store (SQLite) as a row of a pandas data frame.

    Stores come from `compare` and from `vandplan evaluate`. Columns:

    - scenario, goal (its number in a row of goals), planner, region, seed, status, reason
    - cost and length of the path [m], NaN without a path
    - first_time [s] and first_cost [m] of the first path
    - time_total [s], iterations, nodes, exact_solves, edge_checks
    - started, options (JSON)

    Raises InputError naming the file if it is missing or no result store.
    """
    import pathlib
    import sqlite3

    import pandas

    path = pathlib.Path(file)
    if not path.is_file():
        raise refusal(path, "there is no such file")
    connection = sqlite3.connect(path.resolve().as_uri() + "?mode=ro", uri=True)
    try:
        return pandas.read_sql_query(_RUNS, connection)
    except (sqlite3.DatabaseError, pandas.errors.DatabaseError):
        raise refusal(path, "is not a result store of vandplan") from None
    finally:
        connection.close()
