// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Plans: at once and briefly while something is dragged, in a second thread for longer once it rests.

import {load} from 'vandplan';

import {madeTable} from './costs.js';
import {goalsOf, scenarioOf} from './scene.js';
import {second} from './threads.js';

/** How long a plan may take in a frame, its judge included, and to a first path where that takes longer [s]. */
const frameBudget = 0.003;
const leastBudget = 0.0015;
const firstBudget = 0.01;
/** The same where the path of a frame before shows the way [s]. */
const warmBudget = 0.002;
/** How long a plan may take once nothing changes [s]. */
const restBudgets = [0.2, 1.5];
/** A trailer, what moves, a way past something or to one of many goals takes longer than a frame: the second thread does it. */
const longBudgets = [0.3, 1.5, 6];
/** Longest plan that is made without the table of the site, too [s]. */
const longestTwice = 1.5;

export const isLong = ({vehicle, moving, via, goal}) => Boolean(vehicle.trailers || moving.length || via.length || goal.any_of);
const budgetsOf = (scene) => (isLong(scene) ? longBudgets : restBudgets);

/** Keeps the world of the last ground, so that dragging the truck does not build it again. */
export class Ground {
  #vandplan;
  #yard = null;
  #version = -1;

  constructor(vandplan) {
    this.#vandplan = vandplan;
  }

  /** The yard of a scenario; `version` changes with its bounds, walls and map. */
  at(scenario, version) {
    if (this.#version !== version) {
      this.#yard?.close();
      this.#yard = null;
      this.#version = -1;
      this.#yard = this.#vandplan.yard(scenario);
      this.#version = version;
    }
    return this.#yard;
  }
}

/** What the planner is asked for a scene; `site`: the bytes of a table of the site, or null. */
export function queryOf(scene, settings, info, time, site = null) {
  const options = {...scene.options, time_limit: time, seed: 1, margin: settings.margin, margin_ramp: settings.margin > 0 ? 5 : 0};
  if (info.capabilities.includes('prices')) {
    for (const key of ['gear_change_cost', 'reverse_weight', 'clearance_weight', 'curvature_change_cost']) options[key] = settings[key];
  } else {
    for (const key of ['gear_change_cost', 'reverse_weight', 'clearance_weight', 'curvature_change_cost', 'clearance_distance', 'style']) delete options[key];
  }
  if (info.capabilities.includes('gears')) options.gears = settings.gears;
  else delete options.gears;
  if (info.capabilities.includes('steering') && !scene.vehicle.trailers) options.steering = settings.steering;
  else delete options.steering;
  if (site && info.name === 'anytime') options.site = site;
  return {planner: info.name, options, start: scene.start, ...goalsOf(scene), vehicle: scene.vehicle};
}

/** How a plan goes without the table of the site, with the same luck; `first`: its first path with the table. */
function without(yard, {options: {site: _, ...options}, ...query}, result) {
  const {anytime, time} = yard.plan({...query, options});
  return {anytime, time, first: result.anytime[0] ?? null};
}

/**
 * Runs in another thread. For {id, version, scenario, query} it answers {id, result}, then {id, without} if the query
 * has a table of the site. For {table, scenario} it answers {done} for each goal, then {made}. Or {id, error}.
 */
export async function work() {
  const loading = load().then((vandplan) => ({vandplan, ground: new Ground(vandplan)}));
  onmessage = async ({data: {id, version, scenario, query, table}}) => {
    const {vandplan, ground} = await loading;
    try {
      if (table) return postMessage({made: madeTable(vandplan, scenario, table, (done) => postMessage({done}))});
      const yard = ground.at(scenario, version);
      const result = yard.plan(query);
      postMessage({id, result});
      const {site, time_limit: time, target_gap: gap} = query.options;
      if (site && !gap && time <= longestTwice) postMessage({id, without: without(yard, query, result)});
    } catch (error) {
      postMessage({id, error: String(error.message ?? 'it takes too much memory')});
    }
  };
}

export class Planning {
  #ground;
  #worker;
  #id = 0;
  #timer = 0;
  #busy = false;
  #next = null;
  #judged = 0; // seconds that the last plan took beside its budget
  #isHard = false; // the last first path took longer than a frame's plan may
  groundVersion = 0;

  /**
   * `better(result)` is called with a better path of the scene that was asked for last; with {without} of a plan
   * without the table of the site.
   */
  constructor(vandplan, script, better) {
    this.#ground = new Ground(vandplan);
    this.#worker = second(script);
    this.better = better;
    if (!this.#worker) return;
    this.#worker.onmessage = ({data}) => this.#took(data);
    this.#worker.onerror = () => {
      this.#worker = null;
    };
  }

  yard(scene) {
    return this.#ground.at(scenarioOf(scene), this.groundVersion);
  }

  /**
   * A plan within the budget of a frame; longer ones follow once nothing is asked for a while. Null where the second
   * thread alone plans. `known` is the path of a scene that is nearly the same, or null; `site` the table of the site,
   * or null.
   */
  now(scene, settings, info, known, site) {
    const id = ++this.#id;
    this.#next = null;
    clearTimeout(this.#timer);
    const yard = this.yard(scene);
    if (isLong(scene) && this.#worker) {
      this.#improve(id, scene, settings, info, site, 0);
      return null;
    }
    const warm = known && info.name === 'anytime';
    const time = warm ? warmBudget : Math.max(leastBudget, frameBudget - this.#judged);
    const ask = (within, more = {}) => {
      const query = queryOf(scene, settings, info, within, site);
      if (warm && !more.target_gap) query.warm_start = known;
      const begin = performance.now();
      const result = yard.plan({...query, options: {...query.options, ...more}});
      if (result.path) this.#judged = (performance.now() - begin) / 1000 - result.time;
      return result;
    };
    const first = () => ask(firstBudget, info.capabilities.includes('target_gap') ? {target_gap: 1000} : {}); // who proves a gap ends with the first path
    const isHard = this.#isHard && !warm;
    let result = isHard ? first() : ask(time);
    if (result.status === 'time_limit' && !isHard) result = first();
    const ended = ['start_in_collision', 'goal_in_collision', 'no_path'].includes(result.status);
    if (!ended) {
      this.#isHard = !(result.anytime[0]?.time < time);
      this.#timer = setTimeout(() => this.#improve(id, scene, settings, info, site, 0), 140);
    }
    return result;
  }

  #improve(id, scene, settings, info, site, step) {
    if (id !== this.#id || step >= budgetsOf(scene).length) return;
    const ask = {id, step, scene, settings, info, site};
    if (this.#busy) this.#next = ask;
    else this.#send(ask);
  }

  #send({id, step, scene, settings, info, site}) {
    const query = queryOf(scene, settings, info, budgetsOf(scene)[step], site);
    const isFirst = step === 0 && isLong(scene) && info.capabilities.includes('target_gap'); // it ends with the first path
    if (isFirst) query.options = {target_gap: 1000, ...query.options};
    this.asked = {id, step, scene, settings, info, site};
    if (!this.#worker) return;
    this.#busy = true;
    this.#worker.postMessage({id, version: this.groundVersion, scenario: scenarioOf(scene), query});
  }

  #took({id, result, without: other, error}) {
    if (other && id === this.#id) this.better({without: other});
    if (other) return;
    this.#busy = false;
    if (id === this.#id && error) this.better({status: 'error', reason: error});
    if (id === this.#id && result) {
      const {scene, settings, info, site, step} = this.asked;
      const isLast = step + 1 === budgetsOf(scene).length || result.status !== 'time_limit';
      this.better(result.path || isLast ? result : {...result, status: 'searching'});
      if (result.path || !isLast) this.#improve(id, scene, settings, info, site, step + 1);
    }
    if (this.#next && !this.#busy) {
      const next = this.#next;
      this.#next = null;
      if (next.id === this.#id) this.#send(next);
    }
  }
}
