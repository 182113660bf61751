// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What do the paths look like?

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
