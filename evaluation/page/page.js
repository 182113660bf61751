// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Shows the data of a comparison: tables that sort, charts, pictures of paths.
(function () {
  'use strict';

  const data = JSON.parse(document.getElementById('data').textContent);
  const state = {
    region: data.cells[0].region,
    scenario: data.cells[0].scenario,
    measure: 'end',
    example: 'typical',
  };
  const $ = (id) => document.getElementById(id);

  // ---- small helpers ----

  function element(tag, attributes, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (name === 'on') made.addEventListener('click', value);
      else if (value !== null && value !== undefined) made.setAttribute(name, value);
    }
    for (const child of children) if (child !== null) made.append(child);
    return made;
  }

  const none = '\u2013';
  const short = (name) => name.replace(/^thesis-/, '');
  const count = (value) => Math.round(value).toLocaleString('en').replace(/,/g, '\u2009');
  const percent = (value) => `${Math.round(100 * value)} %`;
  const milliseconds = (s) => (s === null ? none : trimmed(1000 * s));
  const trimmed = (v) => (v >= 100 ? v.toFixed(0) : v >= 10 ? v.toFixed(1) : v >= 0.1 || v === 0 ? v.toFixed(2) : v.toFixed(3));
  const cell = (scenario, region) =>
    data.cells.find((c) => c.scenario === scenario && c.region === region);
  const scenarioOf = (c) => data.scenarios[c.scenario];
  const costText = (value, row) =>
    value === null ? none : row ? `\u00d7${value.toFixed(2)}` : value.toFixed(1);

  // A median with its interval; nothing is known of it where there are too few runs.
  function withInterval(estimate, text) {
    const {median, interval: [low, high]} = estimate;
    if (median === null) return none;
    const made = element('span', {}, text(median));
    if (low !== null)
      made.append(' ', element('small', {}, `[${text(low)}, ${high === null ? '\u221e' : text(high)}]`));
    return made;
  }

  // ---- methods: colour by estimate, family by strategy ----

  const colours = {euc: '#7f7f7f', 'hlut-1': '#56b4e9', 'hlut-2': '#009e73', 'hlut-3': '#cc79a7',
    'hlut-4': '#0072b2', rs: '#d55e00', bound: '#7b4ab5'};
  const spare = ['#e69f00', '#8c564b', '#9467bd', '#17becf'];
  const families = [
    {prefix: 'rrt-bsc-', title: 'BSC: parent is the nearest node'},
    {prefix: 'rrt-opt-', title: 'OPT: parent gives the least total cost'},
    {prefix: '', title: 'Others'},
  ];
  const familyOf = (planner) => families.find((f) => planner.startsWith(f.prefix));
  const others = data.planners.map((p) => p.name).filter((n) => familyOf(n).prefix === '');
  function colourOf(planner) {
    const estimate = planner.slice(familyOf(planner).prefix.length);
    return colours[estimate] || spare[others.indexOf(planner) % spare.length];
  }
  const named = (planner) => {
    const dot = element('span', {class: 'dot'});
    dot.style.background = colourOf(planner);
    return element('span', {}, dot, planner);
  };
  // A few others are shown beside every family, many get a place of their own.
  function inFamilies(methods) {
    const groups = families.map((f) => ({title: f.title, methods: methods.filter((m) => familyOf(m.planner) === f)}));
    const rest = groups.pop();
    const full = groups.filter((f) => f.methods.length > 0);
    if (full.length === 0 || rest.methods.length > 2) return full.concat(rest.methods.length ? [rest] : []);
    return full.map((f) => ({title: f.title, methods: f.methods.concat(rest.methods)}));
  }

  // ---- tables ----

  function bestOf(values, best) {
    const known = values.filter((v) => v !== null && v !== undefined);
    return known.length ? (best === 'low' ? Math.min : Math.max)(...known) : null;
  }

  // columns: {title, value(row) for sorting, show(row), best: 'low' | 'high' or isBest(row), text, hint}
  function table(columns, rows, options) {
    const {sorted, chosen} = options || {};
    const order = sorted || {column: -1, up: true};
    const body = element('tbody');
    const heads = columns.map((column, i) => {
      const head = element('th', {scope: 'col', title: column.hint || null},
        element('button', {on: () => sort(i)}, column.title));
      return head;
    });
    const bests = columns.map((column) => (column.best ? bestOf(rows.map(column.value), column.best) : null));
    const isBest = (column, i, row) => column.value(row) !== null &&
      (column.isBest ? column.isBest(row) : column.value(row) === bests[i]);
    function sort(i) {
      order.up = order.column === i ? !order.up : true;
      order.column = i;
      fill();
    }
    function fill() {
      heads.forEach((head, i) => {
        if (i === order.column) head.setAttribute('aria-sort', order.up ? 'ascending' : 'descending');
        else head.removeAttribute('aria-sort');
      });
      const shown = rows.slice();
      if (order.column >= 0) {
        const value = columns[order.column].value;
        const sign = order.up ? 1 : -1;
        shown.sort((a, b) => {
          const [x, y] = [value(a), value(b)];
          if (x === y) return 0;
          if (x === null || x === undefined) return 1;  // what is missing comes last
          if (y === null || y === undefined) return -1;
          return (x < y ? -1 : 1) * sign;
        });
      }
      body.replaceChildren(...shown.map((row) => {
        const line = element('tr', chosen ? {on: () => chosen(row, line)} : {},
          ...columns.map((column, i) => {
            const content = column.show(row);
            const best = isBest(column, i, row) ? 'best' : '';
            const kind = content === none ? 'none' : column.text ? 'text' : '';
            return element('td', {class: `${best} ${kind}`.trim() || null}, content);
          }));
        return line;
      }));
    }
    fill();
    return element('table', {}, element('thead', {}, element('tr', {}, ...heads)), body);
  }

  function switcher(container, choices, key) {
    container.replaceChildren(...choices.map(([value, label]) =>
      element('button', {'aria-pressed': String(state[key] === value), type: 'button', on: () => {
        state[key] = value;
        render();
      }}, label)));
  }

  // ---- the matrix of all scenarios ----

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
    if (!comparison || comparison.verdict === 'no difference') return null;
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

  // ---- one scenario ----

  function renderMethods(c) {
    const row = scenarioOf(c).row;
    const cost = (value) => costText(value, row);
    const columns = [
      {title: 'planner', text: true, value: (m) => c.methods.indexOf(m), show: (m) => named(m.planner)},
      {title: 'solved', best: 'high', value: (m) => m.solved / m.runs,
        show: (m) => element('span', {}, `${m.solved}/${m.runs} `, element('small', {},
          `[${percent(m.solved_interval[0])}, ${percent(m.solved_interval[1])}]`))},
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
      return element('span', {}, element('span', {class: verdict === 'no difference' ? null : verdict}, verdict),
        ` ${text} `, element('small', {}, bounded ? `[${between.join(', ')}]` : ''));
    }});
    $('twins').replaceChildren(...(c.twins.length ? [table([
      {title: 'planner', text: true, value: (t) => c.twins.indexOf(t), show: (t) => named(t.planner)},
      column('cost at the end', 'cost'), column('first solution', 'first_solution'), column('whole run', 'time'),
    ], c.twins)] : []));
  }

  // ---- charts ----

  // On a phone a chart is drawn smaller, so that its text stays as large.
  const size = {width: window.innerWidth < 560 ? 340 : 480, height: 270, left: 46, right: 10, top: 10, bottom: 34};

  function frame(container, title, methods, height) {
    const legend = element('div', {class: 'legend'}, ...methods.map((m) => {
      const line = element('i');
      line.style.background = colourOf(m.planner);
      return element('span', {}, line, m.planner.replace(familyOf(m.planner).prefix, ''));
    }));
    const box = element('div', {class: 'chart'}, element('h4', {}, title), height ? '' : legend);
    container.append(box);
    return d3.select(box).append('svg')
      .attr('viewBox', `0 0 ${size.width} ${height || size.height}`).attr('role', 'img')
      .attr('aria-label', title);
  }

  function axis(svg, scale, orient, format, values, label, height) {
    const bottom = (height || size.height) - size.bottom;
    const made = d3.svg.axis().scale(scale).orient(orient).tickFormat(format).tickValues(values)
      .innerTickSize(orient === 'bottom' ? -(bottom - size.top) : -(size.width - size.left - size.right))
      .tickPadding(6);
    const shift = orient === 'bottom' ? `translate(0,${bottom})` : `translate(${size.left},0)`;
    svg.append('g').attr('class', 'axis').attr('transform', shift).call(made);
    if (label)
      svg.append('text').attr('x', size.width - size.right).attr('y', bottom + 30)
        .attr('text-anchor', 'end').text(label);
  }

  // Round numbers in the range of a logarithmic scale, at most about eight.
  function logTicks([low, high]) {
    for (const steps of [[1, 1.5, 2, 3, 5, 7], [1, 2, 5], [1]]) {
      const ticks = [];
      for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
        for (const step of steps) {
          const tick = step * Math.pow(10, power);
          if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(+tick.toPrecision(3));
        }
      if (ticks.length < 3) return d3.scale.linear().domain([low, high]).ticks(4).filter((tick) => tick > 0);
      if (ticks.length <= 8) return ticks;
    }
    return null;
  }

  const inMilliseconds = (s) => String(+(1000 * s).toPrecision(3));

  function timeScale() {
    return d3.scale.log().domain([data.times[0], data.times[data.times.length - 1]])
      .range([size.left, size.width - size.right]);
  }

  function lines(svg, methods, x, y, pointsOf, top) {
    const clip = (v) => (v === null ? top : v);
    for (const m of methods) {
      const points = pointsOf(m);
      const colour = colourOf(m.planner);
      svg.append('path').attr('fill', colour).attr('opacity', 0.13)
        .attr('d', d3.svg.area().interpolate('step-after').defined((p) => p.low !== null)
          .x((p) => x(p.time)).y0((p) => y(clip(p.low))).y1((p) => y(clip(p.high)))(points));
    }
    for (const m of methods)
      svg.append('path').attr('fill', 'none').attr('stroke', colourOf(m.planner)).attr('stroke-width', 2)
        .attr('d', d3.svg.line().interpolate('step-after').defined((p) => p.value !== null)
          .x((p) => x(p.time)).y((p) => y(p.value))(pointsOf(m)));
  }

  function renderCostCharts(c) {
    const pointsOf = (m) => m.curve.cost.map(([value, low, high], i) =>
      ({time: data.times[i], value, low: value === null ? null : low, high}));
    const values = c.methods.flatMap((m) => pointsOf(m).flatMap((p) => [p.value, p.low, p.high]))
      .filter((v) => v !== null);
    const container = $('cost-charts');
    container.replaceChildren();
    for (const family of inFamilies(c.methods)) {
      const svg = frame(container, family.title, family.methods);
      if (values.length === 0) {
        svg.append('text').attr('x', size.width / 2).attr('y', size.height / 2).attr('text-anchor', 'middle')
          .text('No median is finite: fewer than half of the runs are solved.');
        continue;
      }
      const domain = [0.97 * d3.min(values), 1.05 * d3.max(values)];
      const x = timeScale();
      const y = d3.scale.log().domain(domain).range([size.height - size.bottom, size.top]);
      axis(svg, x, 'bottom', inMilliseconds, logTicks(x.domain()), 'time [ms]');
      axis(svg, y, 'left', (v) => String(v), logTicks(domain));
      lines(svg, family.methods, x, y, pointsOf, domain[1]);
    }
  }

  function renderSuccessCharts(c) {
    const container = $('success-charts');
    container.replaceChildren();
    for (const family of inFamilies(c.methods)) {
      const svg = frame(container, family.title, family.methods);
      const x = timeScale();
      const y = d3.scale.linear().domain([0, 1]).range([size.height - size.bottom, size.top]);
      axis(svg, x, 'bottom', inMilliseconds, logTicks(x.domain()), 'time [ms]');
      axis(svg, y, 'left', (v) => `${Math.round(100 * v)} %`, [0, 0.25, 0.5, 0.75, 1]);
      lines(svg, family.methods, x, y, (m) => m.curve.solved.map(([value, low, high], i) =>
        ({time: data.times[i], value, low, high})), 1);
    }
  }

  function renderBoxCharts(c) {
    const {row, goals} = scenarioOf(c);
    const unit = (run) => (row ? goals[run.goal].distance : 1);
    const costsOf = (m) => runsOf(c, m.planner).filter((r) => !r.profile && r.cost !== null)
      .map((r) => r.cost / unit(r));
    const all = c.methods.flatMap(costsOf);
    const container = $('box-charts');
    container.replaceChildren();
    if (all.length === 0) return;
    const domain = [0.97 * d3.min(all), 1.05 * d3.max(all)];
    for (const family of inFamilies(c.methods)) {
      const height = 26 * family.methods.length + size.top + size.bottom;
      const svg = frame(container, family.title, family.methods, height);
      const right = size.width - size.right - 58;
      const left = size.left + 30;
      const x = d3.scale.log().domain(domain).range([left, right]);
      const bottom = height - size.bottom;
      svg.append('g').attr('class', 'axis').attr('transform', `translate(0,${bottom})`)
        .call(d3.svg.axis().scale(x).orient('bottom').tickFormat(String).tickValues(logTicks(domain))
          .innerTickSize(-(bottom - size.top)).tickPadding(6));
      svg.append('text').attr('x', right).attr('y', bottom + 30).attr('text-anchor', 'end')
        .text(row ? 'cost per metre of distance' : 'cost [m]');
      family.methods.forEach((m, i) => drawBox(svg, m, costsOf(m), x, size.top + 26 * i + 13, left, right));
    }
  }

  function drawBox(svg, m, costs, x, y, left, right) {
    const colour = colourOf(m.planner);
    const at = (v) => (v === null ? right : x(v));
    const [, low, middle, high] = m.quantiles;
    const line = (x1, x2, y1, y2, width) => svg.append('line').attr('x1', x1).attr('x2', x2)
      .attr('y1', y1).attr('y2', y2).attr('stroke', colour).attr('stroke-width', width);
    svg.append('text').attr('x', left - 8).attr('y', y + 4).attr('text-anchor', 'end')
      .text(m.planner.replace(familyOf(m.planner).prefix, ''));
    if (m.solved < m.runs)
      svg.append('text').attr('x', right + 6).attr('y', y + 4).text(`${m.runs - m.solved} failed`);
    if (costs.length === 0) return;
    line(x(d3.min(costs)), x(d3.max(costs)), y, y, 1);
    if (low !== null) {
      svg.append('rect').attr('x', at(low)).attr('width', Math.max(1, at(high) - at(low)))
        .attr('y', y - 7).attr('height', 14).attr('fill', colour).attr('fill-opacity', 0.25)
        .attr('stroke', colour);
      if (middle !== null) line(at(middle), at(middle), y - 7, y + 7, 2.5);
    }
    costs.forEach((v, i) => svg.append('circle').attr('cx', x(v)).attr('cy', y - 4 + 8 * ((i * 0.618) % 1))
      .attr('r', 1.6).attr('fill', colour).attr('opacity', 0.75));
  }

  // ---- paths ----

  // Where an arc leads.
  function advance([x, y, h], curvature, length) {
    const turn = curvature * length;
    const chord = Math.abs(turn) < 1e-9 ? length : Math.sin(turn / 2) / (curvature / 2);
    return [x + chord * Math.cos(h + turn / 2), y + chord * Math.sin(h + turn / 2), h + turn];
  }

  // A part of a clothoid as arcs of at most 10 cm: good enough to be drawn.
  function advanceClothoid(pose, [curvature, length, rate], begin, end) {
    const count = Math.ceil((end - begin) / 0.1);
    const part = (end - begin) / count;
    for (let i = 0; i < count; ++i) {
      pose = advance(pose, curvature + rate * (begin + (i + 0.5) * part), Math.sign(length) * part);
    }
    return pose;
  }

  // Poses along [curvature, length] or [curvature, length, curvature rate] segments from a start,
  // every `step` metres and at each end.
  function drive(start, segments, step) {
    let first = start;
    const stretches = [];
    for (const segment of segments) {
      const [curvature, length, rate = 0] = segment;
      const pieces = Math.max(1, Math.ceil(Math.abs(length) / step));
      const poses = [first];
      for (let i = 1; i <= pieces; ++i) {
        const at = (k) => (Math.abs(length) * k) / pieces;
        poses.push(rate === 0 ? advance(first, curvature, (length * i) / pieces)
          : advanceClothoid(poses[i - 1], segment, at(i - 1), at(i)));
      }
      first = poses[pieces];
      stretches.push({forward: length >= 0, poses});
    }
    return stretches;
  }

  function outline([x, y, h], [rear, front, half]) {
    const [c, s] = [Math.cos(h), Math.sin(h)];
    return [[-rear, -half], [front, -half], [front, half], [-rear, half]]
      .map(([u, v]) => [x + u * c - v * s, y + u * s + v * c]);
  }

  const pointList = (points) => points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(' ');

  function mapOutline({origin: [x, y, h], extent: [width, height]}) {
    const [c, s] = [Math.cos(h), Math.sin(h)];
    return [[0, 0], [width, 0], [width, height], [0, height]].map(([u, v]) => [x + u * c - v * s, y + u * s + v * c]);
  }

  function boxOf(points) {
    return [...d3.extent(points, (p) => p[0]), ...d3.extent(points, (p) => p[1])];
  }

  // The box around the path and what stands near it: what is further away than a third adds nothing.
  function framed(points, things, [rear, front]) {
    const [x0, x1, y0, y1] = boxOf(points);
    const margin = 0.7 * (rear + front) + 0.3 * Math.max(x1 - x0, y1 - y0);
    const reach = [x0 - margin, x1 + margin, y0 - margin, y1 + margin];
    const seen = [x0, x1, y0, y1];
    for (const [a0, a1, b0, b1] of things.map(boxOf)) {
      if (a0 > reach[1] || a1 < reach[0] || b0 > reach[3] || b1 < reach[2]) continue;
      seen[0] = Math.min(seen[0], Math.max(a0, reach[0]));
      seen[1] = Math.max(seen[1], Math.min(a1, reach[1]));
      seen[2] = Math.min(seen[2], Math.max(b0, reach[2]));
      seen[3] = Math.max(seen[3], Math.min(b1, reach[3]));
    }
    return seen;
  }

  function picture(scenario, goalIndex, segments) {
    const goal = scenario.goals[goalIndex];
    const obstacles = scenario.obstacles.concat(goal.obstacles);
    const total = segments.reduce((sum, [, length]) => sum + Math.abs(length), 0);
    const stretches = drive(scenario.start, segments, 0.5);
    const bodies = drive(scenario.start, segments, Math.max(1.2, total / 90)).flatMap((s) => s.poses)
      .map((p) => outline(p, scenario.footprint));
    const ends = [scenario.start, goal.pose].map((p) => outline(p, scenario.footprint));
    const map = scenario.map === null ? null : data.maps[scenario.map];
    const [x0, x1, y0, y1] = framed(bodies.concat(ends).flat(),
      obstacles.concat(scenario.kerbs, map ? [mapOutline(map)] : []), scenario.footprint);
    const side = 1.06 * Math.max(x1 - x0, y1 - y0);
    const [cx, cy] = [(x0 + x1) / 2, (y0 + y1) / 2];
    const svg = d3.select(document.createElementNS('http://www.w3.org/2000/svg', 'svg'))
      .attr('class', 'scene').attr('viewBox', `${cx - side / 2} ${-cy - side / 2} ${side} ${side}`)
      .attr('role', 'img').attr('aria-label', 'Path in its scenario');
    const scene = svg.append('g').attr('transform', 'scale(1,-1)');
    const polygon = (kind, corners) => scene.append('polygon').attr('class', kind).attr('points', pointList(corners));
    if (map) {
      const [x, y, heading] = map.origin;
      scene.append('image').attr('href', map.image).attr('width', map.size[0]).attr('height', map.size[1])
        .attr('transform', `translate(${x},${y}) rotate(${(180 / Math.PI) * heading})`).attr('preserveAspectRatio', 'none');
    }
    scenario.kerbs.forEach((k) => polygon('kerb', k));
    obstacles.forEach((o) => polygon('obstacle', o));
    bodies.forEach((b) => polygon('sweep', b));
    polygon('start', ends[0]);
    polygon('goal', ends[1]);
    for (const s of stretches)
      scene.append('polyline').attr('class', s.forward ? 'forward' : 'reverse').attr('points', pointList(s.poses));
    drawScale(svg, cx - side / 2, -cy + side / 2, side);
    return svg.node();
  }

  // A bar of 10, 20, 50, ... metres in the lower left corner.
  function drawScale(svg, left, bottom, side) {
    const length = [1, 2, 5, 10, 20, 50, 100, 200].filter((l) => l <= side / 3).pop() || 1;
    const [x, y] = [left + 0.03 * side, bottom - 0.03 * side];
    svg.append('line').attr('class', 'scale').attr('x1', x).attr('x2', x + length).attr('y1', y).attr('y2', y);
    svg.append('text').attr('x', x).attr('y', y - 0.015 * side).style('font-size', `${0.045 * side}px`)
      .text(`${length} m`);
  }

  function renderGallery(c) {
    const scenario = scenarioOf(c);
    $('gallery').replaceChildren(...c.methods.map((m) => {
      const example = m[state.example];
      if (!example)
        return element('div', {class: 'panel'}, element('b', {title: m.planner}, named(m.planner)),
          element('small', {}, `${m.solved} of ${m.runs} solved`),
          element('div', {class: 'unsolved'}, state.example === 'best' ? 'never solved' : 'typically unsolved'));
      const run = allRuns[example.run];
      const where = scenario.row ? ` to ${scenario.goals[run.goal].distance} m` : '';
      return element('button', {class: 'panel', type: 'button', on: () => enlarge(c, m, run, example.segments)},
        element('b', {title: m.planner}, named(m.planner)), element('small', {}, `${run.cost.toFixed(1)} m${where}`),
        picture(scenario, run.goal, example.segments));
    }));
  }

  function enlarge(c, m, run, segments) {
    const changes = segments.filter(([, l], i) => i > 0 && l > 0 !== segments[i - 1][1] > 0).length;
    $('dialog-content').replaceChildren(
      element('h3', {}, `${scenarioOf(c).name}, ${m.planner}, ${state.example} path`),
      element('p', {class: 'note'}, `${run.cost.toFixed(2)} m, ${changes} gear ${changes === 1 ? 'change' : 'changes'}, seed ${run.seed}, ` +
        `first path after ${milliseconds(run.first)} ms`),
      picture(scenarioOf(c), run.goal, segments), element('code', {class: 'command'}, run.command));
    $('dialog').showModal();
  }

  // ---- runs ----

  const allRuns = data.runs.rows.map((row) =>
    Object.fromEntries(data.runs.columns.map((name, i) => [name, row[i]])));
  const runsOf = (c, planner) => allRuns.filter((r) =>
    r.scenario === c.scenario && r.region === c.region && (!planner || r.planner === planner));

  function renderRuns(c) {
    const {row, goals} = scenarioOf(c);
    const columns = [
      {title: 'planner', text: true, value: (r) => r.planner, show: (r) => named(r.planner)},
      {title: 'seed', value: (r) => r.seed, show: (r) => String(r.seed)},
      {title: 'status', value: (r) => r.status, show: (r) => r.status.replace(/_/g, ' ') + (r.profile ? ', profiled' : '')},
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

  // ---- what does not change ----

  function facts(title, pairs) {
    return element('div', {}, element('h3', {}, title), element('dl', {},
      ...pairs.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, String(value))])));
  }

  function renderFrame() {
    const {environment: here, overhead, options, jobs} = data;
    const limit = options.time_limit === null ? `${count(options.max_iterations)} iterations`
      : `${options.time_limit} s`;
    $('lead').textContent = `${count(allRuns.length)} runs of ${data.planners.length} planners in ` +
      `${data.scenarios.length} scenarios, at most ${limit} and ${count(options.max_nodes)} nodes each, ` +
      `${jobs} at a time on ${here.processor} (${here.cores} cores).`;
    $('claims').replaceChildren(...data.claims.map((c) => element('div', {class: 'card'},
      element('span', {class: `badge ${c.holds ? 'yes' : 'no'}`}, c.holds ? 'confirmed' : 'not confirmed'),
      element('span', {class: 'badge region'}, `samples from the ${c.region}`),
      element('h4', {}, c.claim[0].toUpperCase() + c.claim.slice(1)), element('p', {}, c.found + '.'),
      c.why ? element('p', {class: 'why'}, element('b', {}, 'Why: '), c.why) : null)));
    $('headlines').replaceChildren(...Object.entries(data.headlines).filter(([, text]) => text)
      .map(([region, text]) => element('p', {class: 'headline'}, element('b', {}, `Samples from the ${region}: `), text)));
    $('claims-section').hidden = data.claims.length === 0;
    const share = (part) => `${((100 * part) / overhead.planning).toFixed(2)} % of the planning time`;
    $('facts').replaceChildren(
      facts('Program and machine', [['version', here.version], ['compiler', `${here.compiler}, ${here.build_type}`],
        ['executable', here.executable], ['processor', here.processor], ['cores', here.cores],
        ['system', here.system], ['runs at a time', jobs], ['last run', data.created]]),
      facts('Options of every run', Object.entries(options).filter(([name]) => name !== 'region' && name !== 'profile')
        .map(([name, value]) => [name, value === null ? 'no limit' : value])),
      facts('What the harness costs', [['planning', `${overhead.planning.toFixed(1)} s in ${count(overhead.runs)} runs`],
        ['storing', share(overhead.storing)], ['judging paths', share(overhead.judging)],
        ['the rest', share(overhead.rest)],
        ['left out', `${data.left_out} runs of other programs, machines or options, or of files changed since`]]),
      facts('Planners', data.planners.map((p) => [p.name, p.summary])));
  }

  // ---- all of it ----

  function render() {
    const regions = [...new Set(data.cells.map((c) => c.region))];
    if (!cell(state.scenario, state.region))
      state.scenario = data.cells.find((c) => c.region === state.region).scenario;
    const c = cell(state.scenario, state.region);
    switcher($('regions'), regions.map((r) => [r, `samples: ${r}`]), 'region');
    switcher($('chips'), data.cells.filter((x) => x.region === state.region)
      .map((x) => [x.scenario, short(scenarioOf(x).name)]), 'scenario');
    switcher($('measures'), Object.entries(measures).map(([key, m]) => [key, m.label]), 'measure');
    switcher($('examples'), [['typical', 'Typical path'], ['best', 'Best path']], 'example');
    $('scenario-title').textContent = `${short(scenarioOf(c).name)}, samples from the ${c.region}`;
    $('scenario-description').textContent = scenarioOf(c).description;
    renderMatrix();
    renderPooled();
    renderMethods(c);
    renderCostCharts(c);
    renderSuccessCharts(c);
    renderBoxCharts(c);
    renderTwins(c);
    renderGallery(c);
    renderRuns(c);
  }

  renderFrame();
  render();
})();
