// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Shows the data of a comparison: what is there, what does the reader look at, and how is it written?

const data = JSON.parse(document.getElementById('data').textContent);
const state = {
  region: data.cells[0].region,
  scenario: data.cells[0].scenario,
  measure: 'end',
  search: 'first',
  example: 'typical',
};
const $ = (id) => document.getElementById(id);

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
