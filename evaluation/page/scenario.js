// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do the planners do in one scenario?

function renderMethods(c) {
  const row = scenarioOf(c).row;
  const cost = (value) => costText(value, row);
  const columns = [
    {title: 'planner', text: true, value: (m) => c.methods.indexOf(m), show: (m) => named(m.planner)},
    {title: 'solved', best: 'high', value: (m) => m.solved / m.runs,
      show: (m) => element('span', {}, `${m.solved}/${m.runs} `, element('small', {},
        `[${percent(m.solved_interval[0])}, ${percent(m.solved_interval[1])}]` +
          (m.rejected ? `, ${m.rejected} rejected` : '') +
          (m.no_path ? `, ${m.no_path} proved no path` : '')))},
    {title: 'first solution [ms]', best: 'low', value: (m) => m.first_solution.median,
      show: (m) => withInterval(m.first_solution, milliseconds)},
    {title: 'cost at 10 ms', best: 'low', value: (m) => m.cost_at_10ms.median, show: (m) => cost(m.cost_at_10ms.median)},
    {title: 'at 100 ms', best: 'low', value: (m) => m.cost_at_100ms.median, show: (m) => cost(m.cost_at_100ms.median)},
    {title: 'tree full', hint: 'Median cost of the runs that reached the limit on nodes, and how many did',
      value: (m) => (m.full > 0 ? m.cost_when_full.median : null),
      show: (m) => (m.full === 0 ? none : element('span', {}, `${cost(m.cost_when_full.median)} `,
        element('small', {}, `(${m.full})`)))},
    {title: 'at the end', best: 'low', value: (m) => m.cost_at_end.median, show: (m) => withInterval(m.cost_at_end, cost)},
    {title: 'nodes', value: (m) => m.nodes, show: (m) => count(m.nodes)},
    {title: 'iterations', value: (m) => m.iterations, show: (m) => count(m.iterations)},
    {title: 'time [ms]', value: (m) => m.time, show: (m) => milliseconds(m.time)},
    {title: 'rank / steer / check', hint: 'Shares of the time, from one profiled run',
      value: (m) => (m.phases ? m.phases[0] : null),
      show: (m) => (m.phases ? m.phases.map((p) => Math.round(100 * p)).join(' / ') + ' %' : none)},
  ];
  if (row) columns.splice(1, 0, {title: 'furthest [m]', best: 'high', value: (m) => m.furthest,
    show: (m) => count(m.furthest)});
  $('methods').replaceChildren(table(columns, c.methods));
  $('methods-note').textContent = row
    ? 'A row of goals: the furthest distance that more than half of the runs reach; costs per metre of distance.'
    : 'Medians with 95 % intervals; costs are lengths of paths [m].';
  renderGoals(c, row);
}

function renderGoals(c, row) {
  if (!row) return $('goals').replaceChildren();
  const columns = [{title: 'cost at distance [m]', text: true, value: (m) => c.methods.indexOf(m),
    show: (m) => named(m.planner)}];
  c.methods[0].goals.forEach(([distance], i) => columns.push({
    title: String(distance), best: 'low', value: (m) => m.goals[i][3],
    show: (m) => costText(m.goals[i][3])}));
  $('goals').replaceChildren(table(columns, c.methods));
}

function renderTwins(c) {
  const column = (title, key) => ({title, value: (t) => t[key].ratio, show: (t) => {
    const {verdict, text, between, bounded} = t[key];
    if (verdict === 'nothing searched') return verdict;
    return element('span', {}, element('span', {class: verdict === 'no difference' ? null : verdict}, verdict),
      ` ${text} `, element('small', {}, bounded ? `[${between.join(', ')}]` : ''));
  }});
  $('twins').replaceChildren(...(c.twins.length ? [table([
    {title: 'planner', text: true, value: (t) => c.twins.indexOf(t), show: (t) => named(t.planner)},
    column('cost at the end', 'cost'), column('first solution', 'first_solution'), column('whole run', 'time'),
  ], c.twins)] : []));
}
