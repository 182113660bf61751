// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What is an estimate worth in each search, and what does the literature say of it?

const ratio = (v) => `\u00d7${v.toFixed(3)}`;
const searchMeasures = {
  first: {label: 'First path', value: (c) => c.first_solution, text: milliseconds,
    note: 'Time to the first path [ms].'},
  work: {label: 'Iterations to it', value: (c) => c.first_iterations, text: count,
    note: 'Iterations to the first path: expansions or samples.'},
  soon: {label: 'Cost at 10 ms', value: (c) => c.cost_ratio_at_10ms, text: ratio,
    note: 'Cost at 10 ms over the least one that any run found.'},
  later: {label: 'Cost at 100 ms', value: (c) => c.cost_ratio_at_100ms, text: ratio,
    note: 'Cost at 100 ms over the least one that any run found.'},
  late: {label: 'Cost at 1 s', value: (c) => c.cost_ratio_at_1s, text: ratio,
    note: 'Cost at 1 s over the least one that any run found.'},
};

function renderSearches() {
  const cells = data.searches.filter((c) => c.region === state.region);
  $('searches-section').hidden = cells.length === 0;
  if (cells.length === 0) return;
  switcher($('search-measures'), Object.entries(searchMeasures).map(([key, m]) => [key, m.label]), 'search');
  const measure = searchMeasures[state.search];
  const estimates = [...new Set(cells.map((c) => c.estimate))];
  const at = (search, estimate) => cells.find((c) => c.search === search && c.estimate === estimate);
  const value = (search) => (estimate) => (at(search, estimate) ? measure.value(at(search, estimate)).median : null);
  const columns = [...new Set(cells.map((c) => c.search))].map((search) => ({title: search, best: 'low',
    value: value(search),
    show: (estimate) => {
      const found = at(search, estimate);
      if (!found) return none;
      const shown = element('span', {}, withInterval(measure.value(found), measure.text));
      if (found.solved < found.runs) shown.append(` (${found.solved}/${found.runs})`);
      return shown;
    }}));
  columns.unshift({title: 'estimate', text: true, value: (e) => estimates.indexOf(e), show: (e) => e});
  $('searches').replaceChildren(table(columns, estimates));
  $('searches-note').textContent = `${measure.note} Medians over all runs of all scenarios with their intervals, an ` +
    'unsolved run counting as infinite; in brackets the runs solved if not all. Bold: best estimate of its search.';
  renderLiterature();
}

function renderLiterature() {
  const rows = data.literature.filter((c) => c.region === state.region);
  const column = (title, key) => ({title, value: (row) => row[key].ratio,
    show: (row) => withInterval({median: row[key].ratio, interval: row[key].interval}, ratio)});
  $('literature').replaceChildren(...(rows.length ? [table([
    {title: 'the literature says', text: true, value: (row) => rows.indexOf(row), show: (row) => row.claim},
    {title: 'compared', text: true, value: (row) => row.planner, show: (row) => `${row.planner} against ${row.rival}`},
    {title: 'pairs', value: (row) => row.cost.pairs, show: (row) => count(row.cost.pairs)},
    column('first path, time', 'first_solution'), column('iterations to it', 'first_iterations'), column('cost', 'cost'),
    {title: 'solved', value: (row) => row.solved, show: (row) => `${row.solved} against ${row.rival_solved}`},
  ], rows)] : []));
}
