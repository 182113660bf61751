// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What there is on the page: a scenario, and what was there before each change. `source` of a scene is its number in
// the list of yards; one from a file or a link has none.

import {boxOf, centreOf, mapCorners, outlines, placed, turned} from './geometry.js';
import {areaOf, centreOfPlace, entriesOf, fileOf, movedPlace, nextDock, placeFor, posesOf, turnedPlace} from './places.js';

/** Everything that is drawn lies in this box. */
export function sceneBox(scene) {
  const points = [];
  for (const place of [scene.start, scene.goal, ...scene.via]) {
    for (const pose of posesOf(scene.vehicle, place)) points.push(...outlines(scene.vehicle, pose).flat());
    for (const entry of entriesOf(place)) points.push(...(areaOf(entry) ?? []));
  }
  for (const polygon of [...scene.obstacles, ...scene.kerbs, ...scene.inside, ...scene.zones.map(({area}) => area)]) points.push(...polygon);
  for (const {grid} of [...(scene.map ? [scene.map] : []), ...scene.masks.map(({map}) => map)]) points.push(...mapCorners(grid));
  return boxOf(points);
}

/** Goal and vias, as the planner takes them. */
export const goalsOf = ({goal, via}) => ({goal: fileOf(goal), via: via.map(fileOf)});

/** Whether occupied cells of a mask are obstacles. */
export const blocks = ({rule}) => rule.as === 'obstacles' || rule.type === 0;

/** A mask as the planner takes it. Of obstacles the cells alone count. */
const maskOf = (mask) => ({...mask.rule, map: mask.map.grid, ...(blocks(mask) ? {} : {percents: mask.map.percents})});

/** What the planner gets: the keys of a scenario file. */
export function scenarioOf(scene) {
  const {name, vehicle, bounds, start, obstacles, kerbs, inside, zones, moving, map, masks} = scene;
  return {
    name, vehicle, bounds, start, ...goalsOf(scene), obstacles, kerbs, ...(inside.length ? {inside} : {}), zones, masks: masks.map(maskOf), moving, ...(map ? {map: map.grid} : {}),
  };
}

// ---- objects, by their handles ----
//
// A handle is {kind: 'start' | 'goal'}, {kind: 'goal', index} for one of several goals, or
// {kind: 'via' | 'obstacles' | 'kerbs' | 'zones', index}.

/** Whether an object is ground, which the world of the planner is built of. */
export const isGround = ({kind}) => ['obstacles', 'kerbs', 'zones'].includes(kind);

/** The place of a handle, or null for ground. */
export function placeAt(scene, {kind, index}) {
  if (kind === 'via') return scene.via[index] ?? null;
  if (kind === 'goal' && index !== undefined) return scene.goal.any_of?.[index] ?? null;
  return kind === 'goal' || kind === 'start' ? scene[kind] : null;
}

function setPlace(scene, {kind, index}, place) {
  if (index === undefined) scene[kind] = place;
  else (kind === 'via' ? scene.via : scene.goal.any_of)[index] = place;
}

/** The polygon of a handle, whose corners can be dragged; null if it has none. */
export function polygonAt(scene, item) {
  if (!isGround(item)) return placeAt(scene, item)?.area ?? null;
  const object = scene[item.kind][item.index] ?? null;
  return item.kind === 'zones' ? (object?.area ?? null) : object;
}

export const isThere = (scene, item) => Boolean(placeAt(scene, item) ?? polygonAt(scene, item));

export function centreAt(scene, item) {
  const place = placeAt(scene, item);
  return place ? centreOfPlace(scene.vehicle, place) : centreOf(polygonAt(scene, item));
}

const grid = 0.5;
const snapped = (value) => Math.round(value / grid) * grid;
const snapAngle = Math.PI / 24;
const snappedAngle = (angle) => Math.round(angle / snapAngle) * snapAngle;

/** Moves an item by metres from where it was in `before`, and onto the grid when `snap` is on. */
export function moveItem(scene, item, before, dx, dy, snap) {
  const place = placeAt(before, item);
  if (place) {
    setPlace(scene, item, movedPlace(place, dx, dy, snap ? snapped : null));
    return;
  }
  const polygon = polygonAt(before, item);
  const [x, y] = polygon[0];
  const mx = snap ? snapped(x + dx) - x : dx;
  const my = snap ? snapped(y + dy) - y : dy;
  setPolygon(scene, item, polygon.map(([px, py]) => [px + mx, py + my]));
}

function setPolygon(scene, {kind, index}, polygon) {
  if (kind === 'zones') scene.zones[index] = {...scene.zones[index], area: polygon};
  else scene[kind][index] = polygon;
}

/** Turns an item by an angle from how it stood in `before`; a vehicle about the middle of its body. */
export function turnItem(scene, item, before, angle, snap) {
  const place = placeAt(before, item);
  if (place) {
    setPlace(scene, item, turnedPlace(scene.vehicle, place, angle, snap ? snappedAngle : null));
    return;
  }
  const by = snap ? snappedAngle(angle) : angle;
  const polygon = polygonAt(before, item);
  setPolygon(scene, item, turned(polygon, by, centreOf(polygon)));
  const {direction} = before[item.kind][item.index];
  if (direction) scene.zones[item.index].direction = direction.map((one) => one + by);
}

/** Removes an item that has an index: there is always a start and a goal. */
export function removeItem(scene, {kind, index}) {
  if (index === undefined) return;
  if (kind !== 'goal') {
    scene[kind].splice(index, 1);
    return;
  }
  scene.goal.any_of.splice(index, 1);
  if (scene.goal.any_of.length === 1) [scene.goal] = scene.goal.any_of;
}

const boxAround = ([x, y], width, height) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => placed({x, y, heading: 0}, (u * width) / 2, (v * height) / 2));

const added = (kind, list, one) => ({kind, index: list.push(one) - 1});

/** What can be added around a place; returns its handle. */
export const adders = {
  obstacles: (scene, place) => added('obstacles', scene.obstacles, boxAround(place, 10, 2)),
  kerbs: (scene, place) => added('kerbs', scene.kerbs, boxAround(place, 6, 3)),
  zones: (scene, place) => added('zones', scene.zones, {area: boxAround(place, 14, 8), direction: [-0.6, 0.6]}),
  via: (scene, [x, y]) => added('via', scene.via, {x, y, heading: scene.start.heading, turns: 'any', ...(scene.vehicle.trailers ? {hitch_angles: 'any'} : {})}),
  /** One more goal, beside those that are there. */
  goal: (scene) => {
    const docks = entriesOf(scene.goal);
    scene.goal = {any_of: [...docks, nextDock(scene.vehicle, docks)]};
    return {kind: 'goal', index: docks.length};
  },
};

/** Lets another vehicle drive; a trailer that was not there before stands straight behind it. */
export function changeVehicle(scene, vehicle) {
  scene.vehicle = vehicle;
  for (const kind of ['start', 'goal']) scene[kind] = placeFor(vehicle, scene[kind]);
  scene.via = scene.via.map((place) => placeFor(vehicle, place));
}

/** A copy that later changes leave alone; the cells of maps are shared, as nobody changes them. */
export const copyOf = (scene) => ({...structuredClone({...scene, map: null, masks: null}), map: scene.map, masks: scene.masks});

/** What was there before each change, and what was undone. */
export class History {
  #past = [];
  #future = [];

  /** Call before a change, with what there is. */
  remember(scene) {
    this.#past.push(copyOf(scene));
    if (this.#past.length > 200) this.#past.shift();
    this.#future = [];
  }

  /** What was there before, or null. */
  undo(scene) {
    if (!this.#past.length) return null;
    this.#future.push(copyOf(scene));
    return this.#past.pop();
  }

  redo(scene) {
    if (!this.#future.length) return null;
    this.#past.push(copyOf(scene));
    return this.#future.pop();
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }
}
