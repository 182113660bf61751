// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The functions of the module, for a core that is loaded. Types and descriptions: vandplan.d.ts.

import {vehicles} from 'catalogue';

/** Wrong input. `where`: the wrong key. `problem`: the fault and what was expected. */
export class InputError extends Error {
  constructor({where, problem}) {
    super(`${where}: ${problem}`);
    this.name = 'InputError';
    this.where = where;
    this.problem = problem;
  }
}

function taken(answer) {
  if (answer !== null && typeof answer === 'object' && answer.error) throw new InputError(answer.error);
  return answer;
}

/** Vehicle as the core reads it, from a name of the catalogue or from its lengths. */
function vehicleOf(given) {
  if (typeof given === 'string' && !Object.hasOwn(vehicles, given)) {
    throw new InputError({where: 'vehicle', problem: `there is no "${given}", expected one of ${Object.keys(vehicles).join(', ')}`});
  }
  return typeof given === 'string' ? vehicles[given] : given;
}

/** Scenario or query whose vehicle is in the form that the core reads. */
const withVehicle = (given) => (given?.vehicle === undefined ? given : {...given, vehicle: vehicleOf(given.vehicle)});

/** Scenario whose world is built once. `close` frees its memory. */
class Yard {
  #core;
  #number;

  constructor(core, scenario) {
    this.#core = core;
    this.#number = taken(core.openYard(withVehicle(scenario)));
  }

  plan(query = {}) {
    return taken(this.#core.planIn(this.#number, withVehicle(query)));
  }

  check(query) {
    return taken(this.#core.checkIn(this.#number, withVehicle(query)));
  }

  drive(query) {
    return taken(this.#core.driveIn(this.#number, withVehicle(query)));
  }

  isFree(query) {
    return taken(this.#core.isFreeIn(this.#number, withVehicle(query)));
  }

  siteTable(query = {}, onProgress) {
    return taken(this.#core.siteTableIn(this.#number, withVehicle(query), onProgress));
  }

  changingSiteTable(query = {}, onProgress) {
    return new ChangingSiteTable(this.#core, this.#number, query, onProgress);
  }

  close() {
    this.#core.closeYard(this.#number);
  }
}

/** Table of a site that is repaired where the site changes. `close` frees its memory. */
class ChangingSiteTable {
  #core;
  #number;
  #site;

  constructor(core, yardNumber, query, onProgress) {
    this.#core = core;
    this.#number = taken(core.openSiteIn(yardNumber, withVehicle(query), onProgress));
  }

  get site() {
    this.#site ??= taken(this.#core.changedSite(this.#number));
    return this.#site;
  }

  repair(scenario) {
    taken(this.#core.repairSite(this.#number, withVehicle(scenario)));
    this.#site = undefined;
  }

  close() {
    this.#core.closeSite(this.#number);
    this.#site = undefined;
  }
}

/** Functions of the module. */
export function functionsOf(core) {
  const inYard = (scenario, work) => {
    const yard = new Yard(core, scenario);
    try {
      return work(yard);
    } finally {
      yard.close();
    }
  };
  return {
    version: core.version(),
    planners: () => core.planners(),
    vehicles: () => Object.keys(vehicles),
    prices: (style, vehicle) => taken(core.prices(style, vehicleOf(vehicle))),
    yard: (scenario) => new Yard(core, scenario),
    plan: (scenario, {planner, ...options} = {}) => inYard(scenario, (yard) => yard.plan({planner, options})),
    siteTable: (scenario, query, onProgress) => inYard(scenario, (yard) => yard.siteTable(query, onProgress)),
    changingSiteTable: (scenario, query, onProgress) => inYard(scenario, (yard) => yard.changingSiteTable(query, onProgress)),
    siteInfo: (site) => taken(core.siteInfo(site)),
    siteCosts: (site, poses, goal = 0) => taken(core.siteCosts(site, poses, goal)),
    check: (scenario, path, claims = {}) => inYard(scenario, (yard) => yard.check({path, ...claims})),
    sample: (path, step = 0.1) => taken(core.sampledPath(path, step)),
    // A scenario has a start, a vehicle has none.
    drive: (path, of, step = 0.05) =>
      of?.start ? inYard(of, (yard) => yard.drive({path, step})) : taken(core.drivenPath(path, vehicleOf(of), step)),
    trailer: (path, vehicle, hitchAngle = 0, step = 0.1) => taken(core.trailedPath(path, vehicleOf(vehicle), hitchAngle, step)),
    advance: (pose, vehicle, {curvature, length}) => taken(core.advanced(pose, vehicleOf(vehicle), curvature, length)),
    steer: (from, to, radius, {reverse = true} = {}) => taken(core.steered(from, to, radius, reverse)),
    words: (from, to, radius, {reverse = true} = {}) => taken(core.wordsBetween(from, to, radius, reverse)),
    distances: (measure, nodes, sample, radius) => taken(core.distances(measure, nodes, sample, radius)),
    hash: hashOf,
  };
}

/** Hash of a path's start and segments: 16 hexadecimal digits (64-bit FNV-1a). */
export function hashOf(path) {
  const numbers = [path.start.x, path.start.y, path.start.heading];
  for (const {curvature, length, curvature_rate = 0} of path.segments) numbers.push(curvature, length, curvature_rate);
  const bytes = new DataView(new ArrayBuffer(8 * numbers.length));
  numbers.forEach((number, i) => bytes.setFloat64(8 * i, number + 0, true)); // -0 becomes 0, as in files
  let hash = 0xcbf29ce484222325n;
  for (let i = 0; i < bytes.byteLength; ++i) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(bytes.getUint8(i))) * 0x100000001b3n);
  }
  return hash.toString(16).padStart(16, '0');
}
