// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What was asked, claimed and measured? It stays as it is whatever the reader looks at.

function facts(title, pairs) {
  return element('div', {}, element('h3', {}, title), element('dl', {},
    ...pairs.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, String(value))])));
}

const fewOf = (planners) => (planners.length > 2 ? `${planners[0]} and ${planners.length - 1} others` : planners.join(', '));

const badge = (claim) =>
  element('span', {class: `badge ${claim.holds ? 'yes' : 'no'}`}, claim.holds ? 'confirmed' : 'not confirmed');

// What holds where: claims down, settings and regions across; then the figures, claim by claim.
function renderClaims() {
  const where = [...new Set(data.claims.map((c) => `${c.setting}, ${c.region}`))];
  const claims = [...new Set(data.claims.map((c) => c.claim))].map((claim) => ({claim,
    found: where.map((w) => data.claims.find((c) => c.claim === claim && `${c.setting}, ${c.region}` === w))}));
  $('claims-table').replaceChildren(...(claims.length ? [table([
    {title: 'claim', text: true, value: (row) => claims.indexOf(row), show: (row) => row.claim},
    ...where.map((title, i) => ({title, value: (row) => Number(row.found[i].holds), show: (row) => badge(row.found[i])})),
  ], claims)] : []));
  $('claims').replaceChildren(...data.claims.map((c) => element('div', {class: 'card'}, badge(c),
    element('span', {class: 'badge region'}, `${c.setting}, ${c.region}`),
    element('h4', {}, c.claim[0].toUpperCase() + c.claim.slice(1)), element('p', {}, c.found + '.'),
    c.why ? element('p', {class: 'why'}, element('b', {}, 'Why: '), c.why) : null)));
}

function renderFrame() {
  const {environment: here, overhead, options, jobs} = data;
  const limit = options.time_limit === null ? `${count(options.max_iterations)} iterations`
    : `${options.time_limit} s`;
  $('lead').textContent = `${count(data.all_runs)} runs of ${data.planners.length} planners in ` +
    `${data.scenarios.length} scenarios, at most ${limit} each, ` +
    (here.cores ? `${jobs} at a time on ${here.processor} (${here.cores} cores).`
      : 'on any machine, which finds the same; times are not told.');
  renderClaims();
  $('headlines').replaceChildren(
    ...Object.entries(data.headlines).filter(([, text]) => text)
      .map(([region, text]) => element('p', {class: 'headline'}, element('b', {}, `Samples from the ${region}: `), text)),
    ...data.verdicts.map((text) => element('p', {class: 'headline'}, text)));
  $('claims-section').hidden = data.claims.length === 0;
  const share = (part) => overhead.planning === 0 ? 'not told' : `${((100 * part) / overhead.planning).toFixed(2)} % of the planning time`;
  $('facts').replaceChildren(
    facts('Program and machine', [['version', here.version], ['compiler', `${here.compiler}, ${here.build_type}`],
      ['executable', here.executable], ['processor', here.processor], ['cores', here.cores],
      ['system', here.system], ['runs at a time', jobs], ['last run', data.created]]),
    facts('Options of the runs', Object.entries(options).map(([name, value]) => [name, value === null ? 'no limit' : value])
      .concat(data.differing_options.map((o) => [`${o.name} of ${fewOf(o.planners)}`, o.value]))),
    facts('What the harness costs', [['planning', `${overhead.planning.toFixed(1)} s in ${count(overhead.runs)} runs`],
      ['storing', share(overhead.storing)], ['judging paths', share(overhead.judging)],
      ['the rest', share(overhead.rest)],
      ['left out', `${data.left_out} runs of other programs, machines or options, or of files changed since`],
      ...data.rejected.map((r) => [`rejected paths of ${r.planner}`, `${r.runs}, the first because ${r.reason}`])]),
    facts('Planners', data.planners.map((p) => [p.name, p.summary])));
}
