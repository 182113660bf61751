// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How do cost and success grow with time?

// On a phone a chart is drawn smaller, so that its text stays as large.
const size = {width: window.innerWidth < 560 ? 340 : 480, height: 270, left: 46, right: 10, top: 10, bottom: 34};

function frame(container, title, methods, height) {
  const legend = element('div', {class: 'legend'}, ...methods.map((m) => {
    const line = element('i');
    line.style.background = colourOf(m.planner);
    return element('span', {}, line, labelOf(m.planner));
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
  for (const group of inGroups(c.methods)) {
    const svg = frame(container, group.title, group.methods);
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
    lines(svg, group.methods, x, y, pointsOf, domain[1]);
  }
}

function renderSuccessCharts(c) {
  const container = $('success-charts');
  container.replaceChildren();
  for (const group of inGroups(c.methods)) {
    const svg = frame(container, group.title, group.methods);
    const x = timeScale();
    const y = d3.scale.linear().domain([0, 1]).range([size.height - size.bottom, size.top]);
    axis(svg, x, 'bottom', inMilliseconds, logTicks(x.domain()), 'time [ms]');
    axis(svg, y, 'left', (v) => `${Math.round(100 * v)} %`, [0, 0.25, 0.5, 0.75, 1]);
    lines(svg, group.methods, x, y, (m) => m.curve.solved.map(([value, low, high], i) =>
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
  for (const group of inGroups(c.methods)) {
    const height = 26 * group.methods.length + size.top + size.bottom;
    const svg = frame(container, group.title, group.methods, height);
    const right = size.width - size.right - 58;
    const left = size.left + 30;
    const x = d3.scale.log().domain(domain).range([left, right]);
    const bottom = height - size.bottom;
    svg.append('g').attr('class', 'axis').attr('transform', `translate(0,${bottom})`)
      .call(d3.svg.axis().scale(x).orient('bottom').tickFormat(String).tickValues(logTicks(domain))
        .innerTickSize(-(bottom - size.top)).tickPadding(6));
    svg.append('text').attr('x', right).attr('y', bottom + 30).attr('text-anchor', 'end')
      .text(row ? 'cost per metre of distance' : 'cost [m]');
    group.methods.forEach((m, i) => drawBox(svg, m, costsOf(m), x, size.top + 26 * i + 13, left, right));
  }
}

function drawBox(svg, m, costs, x, y, left, right) {
  const colour = colourOf(m.planner);
  const at = (v) => (v === null ? right : x(v));
  const [, low, middle, high] = m.quantiles;
  const line = (x1, x2, y1, y2, width) => svg.append('line').attr('x1', x1).attr('x2', x2)
    .attr('y1', y1).attr('y2', y2).attr('stroke', colour).attr('stroke-width', width);
  svg.append('text').attr('x', left - 8).attr('y', y + 4).attr('text-anchor', 'end')
    .text(labelOf(m.planner));
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
