// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What driving to the goal costs from everywhere: a table of the yard, made in a thread of its own.

import {second} from './threads.js';
import {entriesOf, poseOf} from './places.js';
import {sceneBox, scenarioOf} from './scene.js';

const finest = 0.12; // side of a cell [turning radii]
const coarsest = 1;
const headings = 36;
const mostPairs = 1.5e6; // pairs of cell and heading: some seconds a goal
const beyond = 20; // how far a table reaches beyond what stands in a yard [m]
const waits = 250; // how long nothing changes before a table is made [ms]

/** Turns of a goal that may point other ways, too. Of a goal that may point any way there are four. */
const turnsOf = {any: [0, 1, 2, 3], either_way: [0, 2]};

const goalsOf = ({vehicle, goal}) => entriesOf(goal).flatMap((entry) => {
  const {x, y, heading} = poseOf(vehicle, entry);
  return (turnsOf[entry.turns] ?? [0]).map((quarters) => ({x, y, heading: heading + (quarters * Math.PI) / 2}));
});

/** Side of the cells of a yard: larger in a large one [turning radii]. */
function cellOf(scene) {
  const [left, bottom, right, top] = sceneBox(scene);
  const {x, y} = scene.bounds;
  const width = Math.min(x[1], right + beyond) - Math.max(x[0], left - beyond);
  const height = Math.min(y[1], top + beyond) - Math.max(y[0], bottom - beyond);
  const cell = Math.sqrt((Math.max(1, width) * Math.max(1, height) * headings) / mostPairs) / scene.vehicle.min_turning_radius;
  return Math.min(coarsest, Math.max(finest, Number(cell.toPrecision(2))));
}

/** What is asked for the table of a scene; `options` are those of its plans. */
export function tableQueryOf(scene, {time_limit: _, seed: __, steering: ___, ...options}) {
  return {goals: goalsOf(scene), vehicle: scene.vehicle, options, headings, cell: cellOf(scene)};
}

/** Least cost of any heading, to the cheapest goal, in the middle of each cell of a table: row by row from below. */
function fieldOf(vandplan, site) {
  const {goals, bounds: {x: [left, right], y: [bottom, top]}, cell} = vandplan.siteInfo(site);
  const [columns, rows] = [Math.round((right - left) / cell), Math.round((top - bottom) / cell)];
  const x = Float64Array.from({length: columns * rows}, (_, i) => left + (0.5 + (i % columns)) * cell);
  const y = Float64Array.from(x, (_, i) => bottom + (0.5 + Math.floor(i / columns)) * cell);
  const costs = vandplan.siteCosts(site, {x, y}, 0);
  for (let goal = 1; goal < goals.length; ++goal) vandplan.siteCosts(site, {x, y}, goal).forEach((cost, i) => (costs[i] = Math.min(costs[i], cost)));
  const finite = costs.filter(Number.isFinite).sort();
  return {left, bottom, cell, columns, rows, costs, most: finite[Math.floor(0.98 * finite.length)] ?? 0};
}

/** Makes the table of a scenario to those goals that are free: {site, goals, field}, with what is drawn of it. */
export function madeTable(vandplan, scenario, {goals, ...query}, onProgress) {
  const yard = vandplan.yard(scenario);
  try {
    const free = goals.filter((pose) => yard.isFree({pose, vehicle: query.vehicle}));
    const site = yard.siteTable({...query, goals: free.length ? free : goals}, onProgress);
    return {site, goals: vandplan.siteInfo(site).goals, field: fieldOf(vandplan, site)};
  } finally {
    yard.close();
  }
}

/** Makes tables in a second thread: the last one that was asked for. A thread ends with a table that nobody waits for any more. */
export class Tables {
  #script;
  #thread = null;
  #job = null;

  constructor(script) {
    this.#script = script;
  }

  /** {site, goals, field} of a scene; null if another table is asked for before it is made. `onProgress`: gets the number of goals that are done. */
  make(scene, query, onProgress = () => {}) {
    this.leave();
    this.#thread ??= second(this.#script);
    if (!this.#thread) return Promise.reject(new Error('this browser has no second thread for it'));
    const thread = this.#thread;
    return new Promise((resolve, reject) => {
      this.#job = {resolve};
      const fail = ({message}) => {
        reject(new Error(message));
        this.leave();
      };
      thread.onmessage = ({data: {done, made, error}}) => {
        if (done) return onProgress(done);
        if (error) return fail({message: error});
        this.#job = null;
        resolve(made);
      };
      thread.onerror = fail;
      thread.postMessage({table: query, scenario: scenarioOf(scene)});
    });
  }

  /** Nobody waits for a table any more. */
  leave() {
    if (!this.#job) return;
    this.#thread.terminate();
    this.#job.resolve(null);
    this.#thread = this.#job = null;
  }
}

/** The table of the scene that a page shows, while somebody wants to see it. */
export class Costs {
  isOn = false;
  made = null; // {site, goals, field} of the last table
  done = 0; // goals of the next one
  fault = ''; // why there is none
  #tables;
  #key = ''; // what `made` or `fault` belongs to
  #wanted = ''; // what a table is made for, or empty
  #timer = 0;

  /** `changed()` is called when there is something else to show. */
  constructor(vandplan, script, changed) {
    this.vandplan = vandplan;
    this.changed = changed;
    this.#tables = new Tables(script);
  }

  get isMaking() {
    return this.#wanted !== '';
  }

  toggle() {
    this.isOn = !this.isOn;
    if (!this.isOn) this.#leave();
  }

  /**
   * The bytes of the table of a scene; null where there is none. It is made once nothing has changed for a while.
   * `options`: those of its plans; `version`: that of its ground.
   */
  of(scene, options, version) {
    const query = tableQueryOf(scene, options);
    const key = JSON.stringify([version, query]);
    if (key === this.#wanted) return null;
    this.#leave();
    if (key === this.#key) return this.fault ? null : this.made.site;
    this.#wanted = key;
    this.done = 0;
    this.#timer = setTimeout(() => this.#make(scene, query, key), waits);
    return null;
  }

  #leave() {
    clearTimeout(this.#timer);
    this.#tables.leave();
    this.#wanted = '';
  }

  async #make(scene, query, key) {
    const progress = (done) => {
      this.done = done;
      this.changed();
    };
    const outcome = await this.#tables.make(scene, query, progress).then((made) => made && {made, fault: ''}, ({message: fault}) => ({fault}));
    if (!outcome) return; // nobody waits for it
    Object.assign(this, outcome);
    this.#key = key;
    this.#wanted = '';
    this.changed();
  }

  /** Whether a place lies in the table. */
  knows([x, y]) {
    const {left, bottom, cell, columns, rows} = this.made.field;
    return x >= left && x <= left + columns * cell && y >= bottom && y <= bottom + rows * cell;
  }

  /** Cost of a pose to the cheapest goal. */
  from({x, y, heading}) {
    const costs = this.made.goals.map((_, goal) => this.vandplan.siteCosts(this.made.site, {x: [x], y: [y], heading: [heading]}, goal)[0]);
    return Math.min(...costs);
  }

  /** The pose at a place from which driving is cheapest, and its cost; null without a way. */
  bestAt([x, y]) {
    let best = null;
    this.made.goals.forEach((goal, number) => {
      const heading = Array.from({length: headings}, (_, i) => goal.heading + (i * 2 * Math.PI) / headings);
      const costs = this.vandplan.siteCosts(this.made.site, {x: heading.map(() => x), y: heading.map(() => y), heading}, number);
      costs.forEach((cost, i) => {
        if (cost < (best?.cost ?? Infinity)) best = {x, y, heading: heading[i], cost};
      });
    });
    return best;
  }
}
