// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Two searches in the same yard, with the same luck, node by node.

import {element, stage} from './explain.js';
import {trace, paintPath, paintTruck} from './paint.js';
import {boxOf} from './geometry.js';
import {scenesFrom} from './files.js';
import {scenarioOf} from './scene.js';
import {scenarios} from 'catalogue';

const choices = [
  ['rrt-bsc-euc', 'tree, as the crow flies'], ['rrt-bsc-hlut-4', 'tree, by table'], ['rrt-bsc-rs', 'tree, as a truck drives'],
  ['rrt-opt-euc', 'best parent, as the crow flies'], ['rrt-opt-hlut-4', 'best parent, by table'], ['rrt-connect', 'two trees that meet'],
  ['rrt-star', 'tree that mends its edges'], ['hybrid-a-star', 'cells in order of cost'], ['lattice-a-star', 'lattice in order of cost'],
];
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

function side(vandplan, index, standard, again) {
  const known = new Map(vandplan.planners().map(({name, options}) => [name, options.map((option) => option.name)]));
  const canvas = element('canvas', {className: 'exhibit', ariaLabel: 'A growing search tree'});
  canvas.setAttribute('role', 'img');
  const select = element('select', {ariaLabel: `Planner ${index + 1}`, id: `tree-${index}`},
    ...choices.map(([value, textContent]) => element('option', {value, textContent})));
  select.value = standard;
  const caption = element('span', {});
  const own = {canvas, select, caption, figure: element('figure', {}, canvas, element('div', {className: 'bench'}, select, caption))};
  own.stage = stage(canvas, span, () => {});
  select.addEventListener('change', again);
  own.plan = (yard, scene) => {
    const planner = select.value;
    const options = {max_iterations: planner.includes('a-star') ? 20000 : iterations, time_limit: 0.4, seed: 1, keep_tree: true};
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

export function trees(root, vandplan) {
  const state = {on: false, colours: null, shown: 0, playing: true, frame: 0, scene: null, yard: null};
  const sides = [side(vandplan, 0, 'rrt-bsc-euc', () => again()), side(vandplan, 1, 'rrt-bsc-hlut-4', () => again())];
  const yards = scenarios.map((one, i) => ({...one, i})).filter(({label}) => /^Thesis: [2-7]/.test(label));
  const yard = element('select', {ariaLabel: 'Yard', id: 'tree-yard'}, ...yards.map(({label, i}) => element('option', {value: i, textContent: label})));
  yard.value = yards.find(({label}) => label.includes('5'))?.i ?? yards[0].i;
  const play = element('button', {textContent: 'Pause', id: 'tree-play'});
  const step = element('button', {textContent: 'One step', id: 'tree-step'});
  const speed = element('input', {type: 'range', min: 0, max: 3, step: 0.1, value: 1.2, id: 'tree-speed'});
  const restart = element('button', {textContent: 'Again', id: 'tree-again'});
  root.append(element('article', {},
    element('h2', {textContent: 'The same luck, another guide'}),
    element('p', {textContent: 'A search tree grows from the truck: each step draws a random pose and joins it to the node that seems nearest. Both trees get the same random poses. The only difference is who answers how near is near.'}),
    element('div', {className: 'two'}, ...sides.map(({figure}) => figure)),
    element('div', {className: 'bench'}, element('label', {}, 'Yard ', yard), play, step, restart, element('label', {}, 'Speed ', speed)),
  ));

  function again() {
    if (!state.on) return;
    const chosen = scenarios[Number(yard.value)];
    state.scene = scenesFrom(chosen.text, chosen.name)[chosen.goal ?? 0];
    state.yard?.close();
    state.yard = vandplan.yard(scenarioOf(state.scene));
    for (const own of sides) own.plan(state.yard, state.scene);
    state.shown = 0;
    go();
  }

  function go() {
    if (!state.frame && state.on) state.frame = requestAnimationFrame(frame);
  }

  function frame() {
    state.frame = 0;
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
