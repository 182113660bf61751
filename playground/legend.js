// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What the colours of the yard mean: those of costs, and those of masks.

import {inFrame} from './geometry.js';
import {duration} from './panel.js';
import {entriesOf} from './places.js';
import {blocks} from './scene.js';

const byId = (id) => document.getElementById(id);

/** Sets a text only if it is another one: screen readers read it again. */
function say(id, text) {
  const element = byId(id);
  if (element.textContent !== text) element.textContent = text;
}

const metres = (cost) => `${cost.toFixed(0)} m`;

/** What a place costs: that under the mouse, or that of the truck. */
function here({costs, at, scene: {start}}) {
  const [x, y] = at ?? [start.x, start.y];
  const cost = at ? costs.bestAt(at)?.cost : costs.from(start);
  const text = cost < Infinity ? metres(cost) : costs.knows([x, y]) ? 'no way' : 'outside of the table';
  return `From ${at ? 'there' : 'the truck'}: ${text}`;
}

/** Why there is no table, without the keys of files. */
const because = (fault) => fault.replace(/^goals\[\d+\]: is/, 'the goal is').replace(/^\w+: expected .*: /, '');

/** What is going on: a table is made, there is none, or what it brings. */
function news({costs, without, scene, result}) {
  if (costs.isMaking) {
    const docks = entriesOf(scene.goal).length;
    return docks > 1 ? `Computing the table: ${Math.min(costs.done, docks)} of ${docks} docks \u2026` : 'Computing the table \u2026';
  }
  if (costs.fault) return `No table: ${because(costs.fault)}`;
  if (!without?.first || !result?.path) return '';
  const {first, anytime, time} = without;
  if (first.iteration > 0) return 'The table\'s way is no path here';
  const other = anytime.find(({cost}) => cost <= first.cost);
  return `A path of ${metres(first.cost)}: after ${duration(first.time)} with the table, ${other ? `after ${duration(other.time)}` : `not in ${duration(time)}`} without`;
}

function showCosts(page) {
  const {costs} = page;
  byId('costs-legend').hidden = !costs.isOn;
  if (!costs.isOn) return;
  const isShown = costs.made !== null && !costs.fault;
  byId('costs-scale').hidden = !isShown;
  say('costs-news', news(page));
  if (!isShown) return;
  say('costs-most', metres(costs.made.field.most));
  say('costs-here', costs.isMaking ? '\u2026' : here(page));
}

// ---- masks ----

/** What a mask says of a cell, by the percents of its occupancy: a number, its unit, and what it is. */
function meaningOf({rule: {as, of, type, base = 0, multiplier = 1}}) {
  if (as === 'cost') return {valueOf: (percent) => 1 + (percent / 100) * of, unit: '\u00D7', text: 'a metre costs'};
  if (as === 'max_speed') return {valueOf: (percent) => (1 - percent / 100) * of, unit: 'm/s', text: 'at most'};
  return {valueOf: (percent) => base + multiplier * percent, unit: type === 1 ? '% of the largest speed' : 'm/s', text: 'at most'};
}

const tidy = (value) => String(Number(value.toPrecision(2)));

/** The percents of a mask at a place; undefined outside, or where it says nothing. */
function percentAt({map: {grid, percents}}, at) {
  const [column, row] = inFrame(grid.origin, at).map((one) => Math.floor(one / grid.resolution));
  const isInside = column >= 0 && column < grid.columns && row >= 0 && row < grid.rows;
  const percent = isInside ? percents[row * grid.columns + column] : 255;
  return percent > 100 ? undefined : percent;
}

const spans = new WeakMap();

/** Least and largest percents of a mask. */
function spanOf(mask) {
  if (!spans.has(mask)) {
    const said = mask.map.percents.filter((percent) => percent <= 100);
    spans.set(mask, said.length ? [said.reduce((a, b) => Math.min(a, b)), said.reduce((a, b) => Math.max(a, b))] : null);
  }
  return spans.get(mask);
}

function textOf(mask, at) {
  const {name} = mask.map;
  if (blocks(mask)) return `${name}: obstacles`;
  const span = spanOf(mask);
  if (!span) return `${name}: says nothing`;
  const {valueOf, unit, text} = meaningOf(mask);
  const [low, high] = span.map(valueOf).sort((a, b) => a - b).map(tidy);
  const percent = at ? percentAt(mask, at) : undefined;
  const own = percent === undefined ? '' : `, here ${tidy(valueOf(percent))}`;
  return `${name}: ${text} ${low === high ? low : `${low} to ${high}`} ${unit}${own}`;
}

const kindOf = (mask) => (blocks(mask) ? 'wall' : mask.rule.as === 'cost' ? 'price' : 'speed');

let before = '';

function showMasks({scene, at}) {
  const texts = scene.masks.map((mask) => [kindOf(mask), textOf(mask, at)]);
  const now = JSON.stringify(texts);
  if (now === before) return;
  before = now;
  byId('masks-legend').replaceChildren(...texts.map(([kind, text]) => {
    const item = document.createElement('li');
    item.append(Object.assign(document.createElement('i'), {className: kind}), text);
    return item;
  }));
}

/** Lets the legend say what is on the yard of a page; it is hidden while there is nothing to say. */
export function showLegend(page) {
  showCosts(page);
  showMasks(page);
  byId('legend').hidden = !page.costs.isOn && !page.scene.masks.length;
}
