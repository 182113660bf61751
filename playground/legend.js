// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What the colours of the yard mean.

import {duration} from './panel.js';
import {entriesOf} from './places.js';

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

/** Lets the legend say what is on the yard of a page; it is hidden while there is nothing to say. */
export function showLegend(page) {
  showCosts(page);
  byId('legend').hidden = !page.costs.isOn;
}
