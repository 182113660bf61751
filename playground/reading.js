// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What a scenario file says becomes a scene, or an error that names the key.
//
// Everything that comes from a file or a link passes through here: only known keys, only numbers
// that are finite, no more of anything than the page can show.

import {vehicles} from 'catalogue';

import {boxOf, tractorPose} from './geometry.js';

export class ReadError extends Error {}

const fail = (where, problem) => {
  throw new ReadError(`${where}: ${problem}`);
};

export const most = {polygons: 2000, corners: 20000, outline: 100, movers: 40, rows: 2000, goals: 500, via: 40, zones: 200, masks: 20, text: 2e6};

function object(value, where, keys) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) fail(where, 'expected a map of keys');
  for (const key of Object.keys(value)) {
    if (!keys.includes(key)) fail(where, `the key "${key.slice(0, 40)}" is not known`);
  }
  return value;
}

function number(value, where, least = -1e10, largest = 1e10) {
  if (typeof value !== 'number' || !(value >= least && value <= largest)) fail(where, 'expected a number');
  return value;
}

function text(value, where) {
  if (value === undefined) return '';
  if (typeof value !== 'string') fail(where, 'expected text');
  return value.slice(0, 2000);
}

function pair(value, where) {
  if (!Array.isArray(value) || value.length !== 2) fail(where, 'expected two numbers');
  return value.map((one) => number(one, where));
}

function list(value, where, largest) {
  if (!Array.isArray(value) || value.length > largest) fail(where, `expected a list of at most ${largest}`);
  return value;
}

function flag(value, where) {
  if (typeof value !== 'boolean') fail(where, 'expected true or false');
  return value;
}

const numberOrPair = (value, where) => (Array.isArray(value) ? pair(value, where) : number(value, where));

function pose(value, where) {
  object(value, where, ['x', 'y', 'heading', 'curvature', 'hitch_angles']);
  const read = {x: number(value.x, `${where}.x`), y: number(value.y, `${where}.y`), heading: number(value.heading, `${where}.heading`)};
  if (value.curvature !== undefined) read.curvature = number(value.curvature, `${where}.curvature`);
  return read;
}

/** Where a path begins or ends: a pose, and how wheels and trailer stand there. */
function end(value, where, driven) {
  if (value === null || typeof value !== 'object') fail(where, 'expected a map of keys');
  if (!driven.trailers) {
    if (value.hitch_angles !== undefined || value.trailer !== undefined) fail(where, 'the vehicle has no trailer');
    return pose(value, where);
  }
  const angles = value.hitch_angles ?? [0];
  if (!Array.isArray(angles) || angles.length !== 1) fail(`${where}.hitch_angles`, 'expected a list with one angle');
  const hitch = number(angles[0], `${where}.hitch_angles`, -3.2, 3.2);
  if (value.trailer === undefined) return {...pose(value, where), hitch_angles: [hitch]};
  object(value, where, ['trailer', 'curvature', 'hitch_angles']);
  return {...tractorPose(driven, pose(value.trailer, `${where}.trailer`), hitch), hitch_angles: [hitch]};
}

const axleKeys = ['x', 'y', 'area', 'heading', 'either_way'];

/** Where an axle may be, and which way it may point: `turns` is 'either_way' or 'any' if it may turn. */
function axle(value, where) {
  object(value, where, axleKeys);
  const read = {};
  if (value.area === undefined) Object.assign(read, {x: numberOrPair(value.x, `${where}.x`), y: numberOrPair(value.y, `${where}.y`)});
  else if (value.x !== undefined || value.y !== undefined) fail(`${where}.area`, 'is given beside x or y');
  else [read.area] = polygons([value.area], `${where}.area`);
  const isAny = value.heading === 'any';
  read.heading = isAny ? 0 : numberOrPair(value.heading, `${where}.heading`);
  if (value.either_way !== undefined && flag(value.either_way, `${where}.either_way`)) read.turns = 'either_way';
  return isAny ? {...read, turns: 'any'} : read;
}

function hitchAngles(value, where) {
  if (value === 'any') return value;
  if (!Array.isArray(value) || value.length !== 1) fail(where, 'expected a list with one angle, or any');
  return [numberOrPair(value[0], where)];
}

/** A goal or a via that is not one of several (places.js says what it becomes). */
function entry(value, where, driven, keys) {
  object(value, where, [...axleKeys, 'trailer', 'hitch_angles', ...keys]);
  const {trailer, hitch_angles: angles, curvature, straight, stop, ...own} = value;
  if (!driven.trailers && (trailer !== undefined || angles !== undefined)) fail(where, 'the vehicle has no trailer');
  if (trailer !== undefined && Object.keys(own).length) fail(`${where}.trailer`, 'is given beside a place of the vehicle');
  const read = trailer === undefined ? axle(own, where) : {...axle(trailer, `${where}.trailer`), trailer: true};
  if (driven.trailers) read.hitch_angles = hitchAngles(angles ?? [0], `${where}.hitch_angles`);
  if (curvature !== undefined) read.curvature = number(curvature, `${where}.curvature`);
  if (straight !== undefined) read.straight = number(straight, `${where}.straight`, 0, 1000);
  if (stop !== undefined && flag(stop, `${where}.stop`)) read.stop = true;
  return read;
}

/** A goal or a via: one place, or several of which one will do. `keys`: what may stand there beside a place. */
function place(value, where, driven, keys) {
  if (value?.any_of === undefined) return entry(value, where, driven, keys);
  const {any_of: several, ...beside} = object(value, where, ['any_of', ...keys.filter((key) => key === 'stop')]);
  if (!list(several, `${where}.any_of`, most.goals).length) fail(`${where}.any_of`, 'is empty');
  const read = several.map((one, i) => entry(one, `${where}.any_of[${i}]`, driven, keys.filter((key) => key !== 'stop')));
  return beside.stop === undefined || !flag(beside.stop, `${where}.stop`) ? {any_of: read} : {any_of: read, stop: true};
}

const zoneKeys = ['name', 'area', 'closed', 'gears', 'direction', 'cost', 'max_speed', 'body'];

/** Ground with rules of its own; a zone keeps the keys of its file. */
function zones(value) {
  return list(value ?? [], 'zones', most.zones).map((one, i) => {
    const where = `zones[${i}]`;
    object(one, where, zoneKeys);
    const [area] = polygons([one.area], `${where}.area`);
    const read = {...one, area};
    if (one.name !== undefined) read.name = text(one.name, `${where}.name`);
    for (const key of ['closed', 'body']) if (one[key] !== undefined) flag(one[key], `${where}.${key}`);
    if (one.gears !== undefined && !['both', 'forward', 'reverse'].includes(one.gears)) fail(`${where}.gears`, 'expected both, forward or reverse');
    if (one.direction !== undefined) read.direction = pair(one.direction, `${where}.direction`);
    if (one.cost !== undefined) number(one.cost, `${where}.cost`, 1, 1000);
    if (one.max_speed !== undefined) number(one.max_speed, `${where}.max_speed`, 0, 1000);
    return read;
  });
}

/** The last part of a file's name: what is dropped has no folder. */
export const baseName = (name) => String(name).split(/[/\\]/).at(-1);

const missing = (where, name) => fail(where, `drop ${JSON.stringify(String(name).slice(0, 60))} and its image together with the scenario`);

/** The map of a scenario. Without masks the only map that was dropped is it, whatever its name. */
function mapOf({map: name, masks, unknown}, maps) {
  const named = name === undefined ? undefined : maps.get(baseName(name));
  const map = named ?? (masks === undefined && maps.size === 1 ? maps.values().next().value : null);
  if (name !== undefined && !map) missing('map', name);
  return map && unknown === 'free' ? {...map, grid: {...map.grid, unknown: 'free'}} : map;
}

/** Further maps; the rule of each keeps the keys of its file. */
function masks(value, maps) {
  return list(value ?? [], 'masks', most.masks).map((one, i) => {
    const where = `masks[${i}]`;
    const {map: name, ...rule} = object(one, where, ['map', 'as', 'of', 'type', 'base', 'multiplier']);
    if (rule.type === undefined && !['obstacles', 'max_speed', 'cost'].includes(rule.as)) fail(`${where}.as`, 'expected obstacles, max_speed or cost');
    for (const key of ['of', 'type', 'base', 'multiplier']) if (rule[key] !== undefined) number(rule[key], `${where}.${key}`);
    if (typeof name !== 'string') fail(`${where}.map`, 'expected the name of a map');
    return {rule, map: maps.get(baseName(name)) ?? missing(`${where}.map`, name)};
  });
}

function earth(value) {
  if (value === undefined) return {};
  object(value, 'origin', ['longitude', 'latitude']);
  return {origin: {longitude: number(value.longitude, 'origin.longitude', -180, 180), latitude: number(value.latitude, 'origin.latitude', -90, 90)}};
}

/** What moves while the vehicle drives. */
function movers(value) {
  if (value === undefined) return [];
  if (!Array.isArray(value) || value.length > most.movers) fail('moving', `expected a list of at most ${most.movers}`);
  return value.map((one, i) => {
    const where = `moving[${i}]`;
    object(one, where, ['outline', 'trajectory', 'after', 'inflate']);
    const [outline] = polygons([one.outline], `${where}.outline`);
    if (!Array.isArray(one.trajectory) || one.trajectory.length < 1 || one.trajectory.length > most.rows) fail(`${where}.trajectory`, 'expected rows');
    const trajectory = one.trajectory.map((row) => {
      if (!Array.isArray(row) || row.length !== 4) fail(`${where}.trajectory`, 'expected rows of t, x, y, heading');
      return row.map((part) => number(part, `${where}.trajectory`));
    });
    const after = one.after ?? 'stays';
    if (after !== 'stays' && after !== 'leaves') fail(`${where}.after`, 'expected stays or leaves');
    return {outline, trajectory, after, ...(one.inflate === undefined ? {} : {inflate: number(one.inflate, `${where}.inflate`, 0, 10)})};
  });
}

function polygons(value, where) {
  if (value === undefined) return [];
  if (!Array.isArray(value)) fail(where, 'expected a list of polygons');
  if (value.length > most.polygons) fail(where, `more than ${most.polygons} polygons`);
  let corners = 0;
  return value.map((polygon, i) => {
    if (!Array.isArray(polygon) || polygon.length < 3) fail(`${where}[${i}]`, 'expected three corners or more');
    corners += polygon.length;
    if (corners > most.corners) fail(where, `more than ${most.corners} corners`);
    return polygon.map((corner) => pair(corner, `${where}[${i}]`));
  });
}

const lengths = ['wheelbase', 'front_overhang', 'rear_overhang', 'width'];
const limits = ['max_steering_rate', 'max_curvature_rate', 'max_acceleration', 'max_braking', 'max_lateral_acceleration', 'max_jerk'];

/** The limits of the vehicle of the catalogue that has these lengths. */
function usualLimits(vehicle) {
  const keys = [...lengths, 'min_turning_radius', 'track_width'];
  const known = Object.values(vehicles).find((one) => !vehicle.outline && keys.every((key) => one[key] === vehicle[key]));
  return Object.fromEntries(Object.entries(known ?? {}).filter(([key]) => limits.includes(key) || key === 'max_speed'));
}

/** Lengths of the body of a vehicle or a trailer, and its outline; those left out beside it are those of the box around it. */
function body(value, where, leastFront = 0) {
  const read = {wheelbase: number(value.wheelbase, `${where}.wheelbase`, 0, 1000)};
  const box = {};
  if (value.outline !== undefined) {
    [read.outline] = polygons([value.outline], `${where}.outline`);
    if (read.outline.length > most.outline) fail(`${where}.outline`, `more than ${most.outline} corners`);
    const [behind, right, front, left] = boxOf(read.outline);
    Object.assign(box, {front_overhang: front - read.wheelbase, rear_overhang: -behind, width: 2 * Math.max(-right, left)});
  }
  for (const key of lengths.slice(1)) {
    read[key] = value[key] === undefined && key in box ? box[key] : number(value[key], `${where}.${key}`, key === 'front_overhang' ? leastFront : 0, 1000);
  }
  return read;
}

/** A vehicle by its name in the catalogue, or by its lengths. */
export function vehicle(value) {
  if (typeof value === 'string') {
    return Object.hasOwn(vehicles, value) ? vehicle(vehicles[value]) : fail('vehicle', `there is no "${value.slice(0, 40)}" in the catalogue`);
  }
  object(value, 'vehicle', [...lengths, ...limits, 'min_turning_radius', 'max_steering_angle', 'track_width', 'max_speed', 'hitch', 'max_hitch_angle', 'trailers', 'outline']);
  const read = body(value, 'vehicle');
  if (value.max_steering_angle !== undefined) {
    const angle = number(value.max_steering_angle, 'vehicle.max_steering_angle', 1e-3, 1.57);
    read.min_turning_radius = (read.wheelbase * Math.cos(angle)) / Math.sin(angle);
  } else {
    read.min_turning_radius = number(value.min_turning_radius, 'vehicle.min_turning_radius', 0.01, 1e4);
  }
  if (value.trailers !== undefined) {
    if (!Array.isArray(value.trailers) || value.trailers.length !== 1) fail('vehicle.trailers', 'expected a list with one trailer');
    const [trailer] = value.trailers;
    object(trailer, 'vehicle.trailers[0]', [...lengths, 'outline']);
    read.trailers = [body(trailer, 'vehicle.trailers[0]', -100)];
    if (value.hitch !== undefined) read.hitch = number(value.hitch, 'vehicle.hitch', -100, 100);
    if (value.max_hitch_angle !== undefined) read.max_hitch_angle = number(value.max_hitch_angle, 'vehicle.max_hitch_angle', 0, 3.14);
  }
  if (value.track_width !== undefined) read.track_width = number(value.track_width, 'vehicle.track_width', 0, 1000);
  Object.assign(read, usualLimits(read));
  for (const key of limits) {
    if (value[key] === 'none') delete read[key];
    else if (value[key] !== undefined) read[key] = number(value[key], `vehicle.${key}`, 0, 1e6);
  }
  if (value.max_speed !== undefined) {
    object(value.max_speed, 'vehicle.max_speed', ['forward', 'reverse']);
    read.max_speed = {...read.max_speed};
    for (const [key, speed] of Object.entries(value.max_speed)) read.max_speed[key] = number(speed, `vehicle.max_speed.${key}`, 0, 1000);
  }
  return read;
}

function options(value) {
  if (value === undefined) return {};
  object(value, 'options', Object.keys(value ?? {}));
  return Object.fromEntries(
    Object.entries(value).slice(0, 40).map(([key, one]) => {
      if (!['number', 'string', 'boolean'].includes(typeof one)) fail(`options.${key.slice(0, 40)}`, 'expected a number or a word');
      return [key, one];
    }),
  );
}

const keys = ['name', 'description', 'vehicle', 'bounds', 'start', 'goal', 'goals', 'via', 'obstacles', 'kerbs', 'inside', 'zones', 'map', 'unknown', 'masks', 'moving', 'options', 'origin'];

/** The problems that a parsed scenario file states, as scenes; a row of goals has one for each. `maps`: by the names of their files. */
export function scenesOf(document, maps = new Map()) {
  object(document, 'the file', keys);
  const map = mapOf(document, maps);
  const driven = vehicle(document.vehicle ?? fail('vehicle', 'is missing'));
  const scene = {
    name: text(document.name, 'name') || 'yard',
    description: text(document.description, 'description'),
    vehicle: driven,
    start: end(document.start, 'start', driven),
    obstacles: polygons(document.obstacles, 'obstacles'),
    kerbs: polygons(document.kerbs, 'kerbs'),
    inside: polygons(document.inside, 'inside'),
    map,
    masks: masks(document.masks, maps),
    via: list(document.via ?? [], 'via', most.via).map((one, i) => place(one, `via[${i}]`, driven, ['stop'])),
    zones: zones(document.zones),
    moving: movers(document.moving),
    options: options(document.options),
    ...earth(document.origin),
  };
  if (document.bounds !== undefined) {
    object(document.bounds, 'bounds', ['x', 'y']);
    scene.bounds = {x: pair(document.bounds.x, 'bounds.x'), y: pair(document.bounds.y, 'bounds.y')};
  } else if (map) {
    scene.bounds = map.bounds;
  } else {
    fail('bounds', 'are missing');
  }
  if (document.goals === undefined) return [{...scene, goal: place(document.goal, 'goal', driven, ['curvature', 'straight'])}];
  if (!Array.isArray(document.goals) || document.goals.length < 1 || document.goals.length > 200) fail('goals', 'expected a list');
  return document.goals.map((one, i) => {
    object(one, `goals[${i}]`, ['distance', 'goal', 'obstacles']);
    const own = polygons(one.obstacles, `goals[${i}].obstacles`);
    return {...scene, goal: end(one.goal, `goals[${i}].goal`, driven), obstacles: [...scene.obstacles, ...own]};
  });
}
