// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What was every run, and how is it repeated?

const allRuns = data.runs.rows.map((row) =>
  Object.fromEntries(data.runs.columns.map((name, i) => [name, row[i]])));
const runsOf = (c, planner) => allRuns.filter((r) =>
  r.scenario === c.scenario && r.region === c.region && (!planner || r.planner === planner));

function renderRuns(c) {
  const {row, goals} = scenarioOf(c);
  const columns = [
    {title: 'planner', text: true, value: (r) => r.planner, show: (r) => named(r.planner)},
    {title: 'seed', value: (r) => r.seed, show: (r) => String(r.seed)},
    {title: 'status', value: (r) => r.status, show: (r) => r.status.replace(/_/g, ' ') + (r.profile ? ', profiled' : '') +
      (r.reason ? `: ${r.reason}` : '')},
    {title: 'cost [m]', value: (r) => r.cost, show: (r) => costText(r.cost)},
    {title: 'first [ms]', value: (r) => r.first, show: (r) => milliseconds(r.first)},
    {title: 'time [ms]', value: (r) => r.total, show: (r) => milliseconds(r.total)},
    {title: 'iterations', value: (r) => r.iterations, show: (r) => count(r.iterations)},
    {title: 'nodes', value: (r) => r.nodes, show: (r) => count(r.nodes)},
  ];
  if (row) columns.splice(1, 0, {title: 'distance [m]', value: (r) => goals[r.goal].distance,
    show: (r) => String(goals[r.goal].distance)});
  $('command').textContent = '';
  $('runs').replaceChildren(table(columns, runsOf(c), {
    sorted: {column: columns.length - 5, up: true},
    chosen: (run, line) => {
      $('command').textContent = run.command;
      for (const other of $('runs').querySelectorAll('.chosen')) other.classList.remove('chosen');
      line.classList.add('chosen');
    },
  }));
}
