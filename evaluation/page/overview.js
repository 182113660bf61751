// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Who is best, all scenarios at a glance?

const measures = {
  end: {
    label: 'Cost at the end',
    value: (m, row) => (row ? m.furthest || null : m.cost_at_end.median),
    show: (m, row) => (row ? (m.furthest ? `${m.furthest} m` : none) : costText(m.cost_at_end.median)),
    best: (row) => (row ? 'high' : 'low'),
    twin: 'cost',
    note: 'Median length of the best path at the end of a run [m]; in a row of goals the furthest distance ' +
      'that more than half of the runs reach.',
  },
  solved: {
    label: 'Solved',
    value: (m) => m.solved / m.runs,
    show: (m) => percent(m.solved / m.runs),
    best: () => 'high',
    note: 'Share of runs that find a path.',
  },
  first: {
    label: 'First solution',
    value: (m) => m.first_solution.median,
    show: (m) => milliseconds(m.first_solution.median),
    best: () => 'low',
    twin: 'first_solution',
    note: 'Median time of the first path [ms].',
  },
  total: {
    label: 'Whole run',
    value: (m) => m.time,
    show: (m) => milliseconds(m.time),
    best: () => 'low',
    twin: 'time',
    note: 'Median time until the tree is full or the time is up [ms].',
  },
};

function arrow(comparison) {
  if (!comparison || !['better', 'worse'].includes(comparison.verdict)) return null;
  const better = comparison.verdict === 'better';
  return element('span', {class: better ? 'better' : 'worse',
    title: `against Euclid: ${comparison.text} (${comparison.between.join(' to ')})`},
  better ? ' \u25bc' : ' \u25b2');
}

// Planners down and scenarios across, or the other way round: the longer list goes down.
function renderMatrix() {
  const measure = measures[state.measure];
  const cells = data.cells.filter((c) => c.region === state.region);
  const rowOf = (c) => scenarioOf(c).row;
  const method = (c, p) => c.methods.find((m) => m.planner === p.name);
  const value = (c, p) => (method(c, p) ? measure.value(method(c, p), rowOf(c)) : null);
  const show = (c, p) => {
    if (!method(c, p)) return none;
    const twin = c.twins.find((t) => t.planner === p.name);
    const mark = measure.twin && twin ? arrow(twin[measure.twin]) : null;
    const text = measure.show(method(c, p), rowOf(c));
    return mark ? element('span', {}, text, mark) : text;
  };
  const best = (c) => bestOf(data.planners.map((p) => value(c, p)), measure.best(rowOf(c)));
  if (cells.length <= data.planners.length) {
    const columns = cells.map((c) => ({title: short(scenarioOf(c).name), value: (p) => value(c, p),
      show: (p) => show(c, p), isBest: (p) => value(c, p) === best(c)}));
    columns.unshift({title: 'planner', text: true, value: (p) => data.planners.indexOf(p), show: (p) => named(p.name)});
    $('matrix').replaceChildren(table(columns, data.planners));
  } else {
    const columns = data.planners.map((p) => ({title: p.name, value: (c) => value(c, p),
      show: (c) => show(c, p), isBest: (c) => value(c, p) === best(c)}));
    columns.unshift({title: 'scenario', text: true, value: (c) => cells.indexOf(c), show: (c) => short(scenarioOf(c).name)});
    $('matrix').replaceChildren(table(columns, cells));
  }
  $('matrix-note').replaceChildren(measure.note + ' Bold: best of its scenario.',
    ...(measure.twin ? [' ', element('span', {class: 'better'}, '\u25bc'), ' lower and ',
      element('span', {class: 'worse'}, '\u25b2'),
      ' higher than the twin that ranks by Euclid, beyond chance.'] : []));
}

function renderPooled() {
  const rows = data.pooled.filter((p) => p.region === state.region);
  $('pooled-section').hidden = rows.length === 0;
  const share = (part, whole) => (p) => part(p) / whole(p);
  const column = (title, value, best) => ({title, best, value, show: (p) => percent(value(p))});
  const word = {better: 'better', worse: 'worse'};
  $('pooled').replaceChildren(table([
    {title: 'planner', text: true, value: (p) => rows.indexOf(p), show: (p) => named(p.planner)},
    column('solved', share((p) => p.solved, (p) => p.runs)),
    column('Euclid solves', share((p) => p.twin_solved, (p) => p.twin_runs)),
    {title: 'pairs', value: (p) => p.pairs, show: (p) => count(p.pairs)},
    column('better', share((p) => p.better, (p) => p.pairs)),
    column('equal', share((p) => p.pairs - p.better - p.worse, (p) => p.pairs)),
    column('worse', share((p) => p.worse, (p) => p.pairs)),
    {title: 'exact lengths per iteration', value: (p) => p.exact_lengths_per_iteration,
      show: (p) => p.exact_lengths_per_iteration.toFixed(1)},
    {title: 'verdict', value: (p) => p.verdict,
      show: (p) => element('span', {class: word[p.verdict] || null}, p.verdict)},
  ], rows));
}
