// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Two searches in the same yard, with the same luck, node by node; also in a yard that is known.

import {element, stage} from './explain.js';
import {tableQueryOf, Tables} from './costs.js';
import {trace, paintPath, paintTruck} from './paint.js';
import {paintField} from './paint_costs.js';
import {boxOf} from './geometry.js';
import {scenesFrom} from './files.js';
import {scenarioOf} from './scene.js';
import {scenarios} from 'catalogue';

const choices = [
  ['rrt-bsc-euc', 'tree, as the crow flies'], ['rrt-bsc-hlut-4', 'tree, by table'], ['rrt-bsc-rs', 'tree, as a truck drives'],
  ['rrt-opt-euc', 'best parent, as the crow flies'], ['rrt-opt-hlut-4', 'best parent, by table'], ['rrt-connect', 'two trees that meet'],
  ['rrt-star', 'tree that mends its edges'], ['hybrid-a-star', 'cells in order of cost'], ['lattice-a-star', 'lattice in order of cost'],
  ['hybrid-a-star:site', 'cells, by the table of the yard'], ['lattice-a-star:site', 'lattice, by the table of the yard'],
];
const asksTable = (planner) => planner.endsWith(':site');
const span = 84;
const most = 1500; // nodes that are shown
const iterations = 1500;

/** Edges of a tree as lists of places, made as they are asked for. */
function edgesOf(vandplan, tree, radius) {
  const poseOf = (i) => ({x: tree.poses[3 * i], y: tree.poses[3 * i + 1], heading: tree.poses[3 * i + 2]});
  const kept = [];
  return (i) => {
    if (kept[i]) return kept[i];
    const parent = tree.parents[i];
    if (parent < 0) return (kept[i] = []);
    const start = poseOf(parent);
    const rows = vandplan.sample({start, segments: vandplan.steer(start, poseOf(i), radius)}, 1.2);
    const places = [];
    for (let at = 0; at < rows.length; at += 6) places.push([rows[at + 1], rows[at + 2]]);
    return (kept[i] = places);
  };
}

function side(vandplan, id, number, standard, again) {
  const known = new Map(vandplan.planners().map(({name, options}) => [name, options.map((option) => option.name)]));
  const canvas = element('canvas', {className: 'exhibit', ariaLabel: 'A growing search tree'});
  canvas.setAttribute('role', 'img');
  const select = element('select', {ariaLabel: `Planner ${number}`, id},
    ...choices.map(([value, textContent]) => element('option', {value, textContent})));
  select.value = standard;
  const caption = element('span', {});
  const own = {canvas, select, caption, figure: element('figure', {}, canvas, element('div', {className: 'bench'}, select, caption))};
  own.stage = stage(canvas, span, () => {});
  select.addEventListener('change', again);
  /** `table`: of the yard, {site, field}, for a planner that asks it. */
  own.plan = (yard, scene, table) => {
    const planner = select.value;
    own.field = table?.field ?? null;
    const options = {...(table ? {site: table.site} : {}), max_iterations: planner.includes('a-star') ? 20000 : iterations, time_limit: 0.4, seed: 1, keep_tree: true};
    if (known.get(planner)?.includes('region')) options.region = 'scene'; // most of the ground is out of sight
    own.result = yard.plan({planner, options});
    own.edge = own.result.tree ? edgesOf(vandplan, own.result.tree, scene.vehicle.min_turning_radius) : null;
    own.size = own.result.tree ? Math.min(most, own.result.tree.parents.length) : 0;
    own.rows = own.result.path ? vandplan.sample(own.result.path, 0.3) : null;
  };
  return own;
}

function paintSide(own, scene, shown, colours) {
  const drawn = own.stage.begin(colours);
  if (!drawn) return;
  const {context, view} = drawn;
  const [left, bottom, right, top] = boxOf([...scene.obstacles.flat(), [scene.start.x, scene.start.y], [scene.goal.x, scene.goal.y]]);
  context.translate(-(left + right) / 2, -(bottom + top) / 2);
  if (own.field) paintField(context, view, own.field, colours, false);
  const count = Math.min(shown, own.size);
  context.beginPath();
  for (let i = 0; i < count; ++i) {
    own.edge(i).forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
  }
  context.strokeStyle = colours.soft;
  context.globalAlpha = 0.55;
  context.lineWidth = 1 / view.scale;
  context.stroke();
  context.globalAlpha = 1;
  context.beginPath();
  for (const polygon of scene.obstacles) trace(context, polygon);
  context.fillStyle = colours.wall;
  context.fill();
  const done = shown >= own.size;
  if (own.rows && done) paintPath(context, view, own.rows, colours, 3);
  paintTruck(context, view, scene.vehicle, scene.goal, colours, {ghost: true});
  paintTruck(context, view, scene.vehicle, scene.start, colours);
  const {path, cost, anytime} = own.result;
  const first = anytime[0];
  own.caption.textContent = !own.size ? 'keeps no tree' : !done ? `${count} nodes` : path && first
    ? `first path after ${first.iteration} steps, best ${cost.toFixed(0)} m` : `no path in ${own.result.iterations} steps`;
}

/** `id`: what the names of its controls begin with; `standard`: two planners; `among`: names of yards, `first` the first one. */
function exhibit(root, vandplan, {id, title, text, standard, among, first}) {
  const state = {on: false, colours: null, shown: 0, playing: true, frame: 0, scene: null, yard: null};
  const tables = new Tables(document.getElementById('app').textContent);
  const made = new Map(); // tables by yard
  const sides = standard.map((planner, i) => side(vandplan, `${id}-${i}`, i + 1, planner, () => again()));
  const yards = scenarios.map((one, i) => ({...one, i})).filter(({label}) => among.test(label));
  const yard = element('select', {ariaLabel: 'Yard', id: `${id}-yard`}, ...yards.map(({label, i}) => element('option', {value: i, textContent: label})));
  yard.value = yards.find(({label}) => label === first).i;
  const play = element('button', {textContent: 'Pause', id: `${id}-play`});
  const step = element('button', {textContent: 'One step', id: `${id}-step`});
  const speed = element('input', {type: 'range', min: 0, max: 3, step: 0.1, value: 1.2, id: `${id}-speed`});
  const restart = element('button', {textContent: 'Again', id: `${id}-again`});
  root.append(element('article', {},
    element('h2', {textContent: title}),
    element('p', {textContent: text}),
    element('div', {className: 'two'}, ...sides.map(({figure}) => figure)),
    element('div', {className: 'bench'}, element('label', {}, 'Yard ', yard), play, step, restart, element('label', {}, 'Speed ', speed)),
  ));

  /** The table of the yard by length, as these searches plan; null if another one is asked for meanwhile. */
  async function tableOf(scene) {
    const key = yard.value;
    const table = made.get(key) ?? (await tables.make(scene, tableQueryOf(scene, {style: 'shortest'})));
    if (table) made.set(key, table);
    return table;
  }

  async function again() {
    if (!state.on) return;
    const chosen = scenarios[Number(yard.value)];
    const scene = scenesFrom(chosen.text, chosen.name)[chosen.goal ?? 0];
    state.scene = scene;
    state.yard?.close();
    state.yard = vandplan.yard(scenarioOf(scene));
    for (const own of sides) {
      const planner = own.select.value;
      own.result = null;
      own.caption.textContent = asksTable(planner) ? 'computing the table \u2026' : '';
      const table = asksTable(planner) ? await tableOf(scene) : null;
      if (state.scene !== scene || (asksTable(planner) && !table)) return; // another yard was chosen
      own.plan(state.yard, scene, table);
    }
    state.shown = 0;
    go();
  }

  function go() {
    if (!state.frame && state.on) state.frame = requestAnimationFrame(frame);
  }

  function frame() {
    state.frame = 0;
    if (!sides.every(({result}) => result)) return; // a table is made
    const end = Math.max(...sides.map(({size}) => size));
    if (state.playing) state.shown = Math.min(end, state.shown + Math.max(0.05, 10 ** speed.value / 10));
    for (const own of sides) paintSide(own, state.scene, Math.floor(state.shown), state.colours);
    if (state.playing && state.shown < end) go();
  }

  yard.addEventListener('change', again);
  restart.addEventListener('click', again);
  play.addEventListener('click', () => {
    state.playing = !state.playing;
    play.textContent = state.playing ? 'Pause' : 'Play';
    go();
  });
  step.addEventListener('click', () => {
    state.playing = false;
    play.textContent = 'Play';
    ++state.shown;
    go();
  });
  return {
    shown(on, colours) {
      Object.assign(state, {on, colours});
      if (on && !state.scene) again();
      else go();
    },
  };
}

export const trees = (root, vandplan) => exhibit(root, vandplan, {
  id: 'tree', standard: ['rrt-bsc-euc', 'rrt-bsc-hlut-4'], among: /^Thesis: [2-7]/, first: 'Thesis: 5 leave cage', title: 'The same luck, another guide',
  text: 'A search tree grows from the truck: each step draws a random pose and joins it to the node that seems nearest. Both trees get the same random poses. The only difference is who answers how near is near.',
});

export const known = (root, vandplan) => exhibit(root, vandplan, {
  id: 'known', standard: ['hybrid-a-star', 'hybrid-a-star:site'], among: /^(Docks|Street|Dead end|Container stacks|Bus depot|Ferry lane|Thesis: [57])/, first: 'Thesis: 5 leave cage', title: 'The same search, in a yard that is known',
  text: 'Trucks drive in the same yard for months, to the same docks. A table that was made of it once knows what every wall costs: the colours, the stronger the nearer. Both searches look at the cheapest node next. Only the right one asks the table what is still to come.',
});
