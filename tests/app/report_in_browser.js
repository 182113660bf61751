// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Uses the report as a reader would and tells the page around it what does not work.
window.addEventListener('load', () => {
  'use strict';
  const faults = window.faults;  // what the console heard
  const data = JSON.parse(document.getElementById('data').textContent);
  const all = (selector) => [...document.querySelectorAll(selector)];
  const expect = (works, what) => {
    if (!works && !faults.includes(what)) faults.push(what);
  };
  const size = (node) => node.getBoundingClientRect();

  function column(table, title) {
    return [...table.querySelectorAll('th')].findIndex((head) => head.textContent.startsWith(title));
  }
  const numbers = (table, i) => [...table.querySelectorAll('tbody tr')]
    .map((row) => parseFloat(row.cells[i].textContent.replace(/\u2009/g, ''))).filter((v) => !isNaN(v));
  const sorted = (values, sign) => values.every((v, i) => i === 0 || sign * (v - values[i - 1]) >= 0);

  function checkSorting(id, title) {
    const table = document.querySelector(`#${id} table`);
    const i = column(table, title);
    expect(i >= 0, `${id} has no column ${title}`);
    if (i < 0) return;
    for (const [sign, direction] of [[1, 'ascending'], [-1, 'descending']]) {
      table.querySelectorAll('th button')[i].click();
      const values = numbers(table, i);
      expect(values.length > 1, `${id} has no numbers in column ${title}`);
      expect(new Set(values).size > 1, `${id} has the same number everywhere in column ${title}`);
      expect(sorted(values, sign), `${id} is not ${direction} by ${title}`);
      expect(table.querySelectorAll('th')[i].getAttribute('aria-sort') === direction,
        `${id} does not say that it is ${direction} by ${title}`);
    }
  }

  const groups = new Set(data.planners.filter((p) => p.strategy).map((p) => `${p.strategy} ${p.tries_goal}`)).size;

  function checkPictures() {
    for (const image of all('img'))
      expect(image.complete && image.naturalWidth > 500 && size(image).width > 200, 'an image does not show');
    expect(all('.sheet img').length === 1, 'the sheet of best paths is missing');
    for (const svg of all('.chart svg, .gallery svg')) {
      expect(size(svg).width > 60 && size(svg).height > 60, 'a drawing has no size');
      expect(!/NaN|undefined|Infinity/.test(svg.outerHTML), 'a drawing holds what is no number');
    }
    for (const line of all('.gallery polyline'))
      expect(size(line).width + size(line).height > 0, 'a path is not drawn');
    for (const id of ['cost-charts', 'success-charts', 'box-charts'])
      expect(all(`#${id} svg`).length === groups, `${id} has not one chart for each strategy and setting of the goal`);
  }

  // Every method that has a path of the kind shows it.
  function checkGallery(scenario, region, kind) {
    const {methods} = data.cells.find((c) => c.scenario === scenario && c.region === region);
    expect(all('#gallery .panel').length === methods.length, 'a method has no panel');
    expect(all('#gallery svg').length === methods.filter((m) => m[kind]).length, `a ${kind} path is missing`);
  }

  // What the vehicle drives over and around is there, the map as an image that loads.
  function checkGround(scenario) {
    const {map, kerbs, obstacles, goals} = data.scenarios[scenario];
    const paths = all('#gallery svg').length;
    expect(all('#gallery image').length === (map === null ? 0 : paths), 'a map is missing');
    expect(all('#gallery .kerb').length === paths * kerbs.length, 'a kerb is missing');
    expect(all('#gallery .obstacle').length >= paths * obstacles.length && goals.length > 0, 'an obstacle is missing');
    for (const image of all('#gallery image'))
      expect(size(image).width > 60 && size(image).height > 60, 'a map does not show');
  }

  const press = (id, label) =>
    all(`#${id} button`).find((button) => button.textContent.startsWith(label)).click();
  const short = (name) => name.replace(/^thesis-/, '');

  for (const {scenario, region} of data.cells) {
    press('regions', `samples: ${region}`);
    press('chips', short(data.scenarios[scenario].name));
    for (const [label, kind] of [['Typical', 'typical'], ['Best', 'best']]) {
      press('examples', label);
      checkGallery(scenario, region, kind);
      checkGround(scenario);
      checkPictures();
    }
    checkSorting('runs', 'nodes');
    checkSorting('methods', 'nodes');
    for (const table of all('table')) expect(table.rows.length > 1, 'a table is empty');
    expect(document.documentElement.scrollWidth <= window.innerWidth, 'the page is wider than its window');
  }
  // The longer list goes down.
  const scenariosDown = data.scenarios.length > data.planners.length;
  for (const measure of ['Solved', 'First solution', 'Whole run']) {
    press('measures', measure);
    checkSorting('matrix', scenariosDown ? data.planners[measure === 'Solved' ? 1 : 0].name : measure === 'Solved' ? '4' : '9');
    expect(all('#matrix tbody tr').length === (scenariosDown ? data.scenarios : data.planners).length,
      'the matrix has not a line for each');
    expect(all('#matrix .best').length >= 3, 'the best of a scenario is not marked');
  }

  document.querySelector('#runs tbody tr').click();
  expect(/^vandplan plan \S+\.yaml --planner /.test(document.getElementById('command').textContent),
    'a run that is chosen shows no command');
  document.querySelector('#gallery button').click();
  const dialog = document.getElementById('dialog');
  expect(dialog.open && dialog.querySelector('svg') && size(dialog.querySelector('svg')).width > 200,
    'a path that is chosen is not enlarged');
  dialog.querySelector('form button').click();
  expect(!dialog.open, 'the enlarged path does not close');

  // Both settings of the goal are judged, in both regions.
  expect(all('#claims .card').length === 12 && all('#claims-table .badge').length === 12, 'a claim is not judged');
  expect(all('#headlines .headline').length === 5, 'a headline is missing');
  for (const id of ['headlines', 'lead', 'claims', 'claims-table', 'facts'])
    expect(document.getElementById(id).textContent.length > 60, `${id} says nothing`);
  expect(!/undefined|NaN|\[object/.test(document.body.innerText), 'the text holds what is no text');
  for (const {name} of performance.getEntriesByType('resource'))
    expect(name.startsWith('data:'), `the page asks for ${name}`);
  parent.postMessage(`${window.innerWidth} px wide: ${faults.length ? faults.join(', ') : 'works'}`, '*');
});
