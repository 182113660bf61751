// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What there is on the page: a scenario, and what was there before each change. `source` of a scene is its number in
// the list of yards; one from a file or a link has none.

import {boxOf, centreOf, mapCorners, middle, outlines, placed, turned, wrap} from './geometry.js';

/** Everything that is drawn lies in this box. */
export function sceneBox(scene) {
  const points = [scene.start, scene.goal].flatMap((pose) => outlines(scene.vehicle, pose).flat());
  for (const polygon of [...scene.obstacles, ...scene.kerbs, ...scene.inside]) points.push(...polygon);
  if (scene.map) points.push(...mapCorners(scene.map.grid));
  return boxOf(points);
}

/** The goal with the keys of a scenario file: as it is drawn, turned round as well ('either_way'), or 'any' way. */
export function goalOf({goal: {turns, ...pose}}) {
  if (turns === 'any') return {...pose, heading: 'any'};
  return turns === 'either_way' ? {...pose, either_way: true} : pose;
}

/** Whether a vehicle that points somewhere points as a goal wants it, within an angle. */
export function pointsLike({heading, turns}, other, within) {
  const off = Math.abs(wrap(other - heading));
  return turns === 'any' || off < within || (turns === 'either_way' && Math.PI - off < within);
}

/** What the planner gets: the keys of a scenario file. */
export function scenarioOf(scene) {
  const {name, vehicle, bounds, start, obstacles, kerbs, inside, moving, map} = scene;
  return {name, vehicle, bounds, start, goal: goalOf(scene), obstacles, kerbs, ...(inside.length ? {inside} : {}), moving, ...(map ? {map: map.grid} : {})};
}

/** An object of the scene by its handle: {kind: 'start' | 'goal'} or {kind: 'obstacles' | 'kerbs', index}. */
export const polygonAt = (scene, {kind, index}) => (index === undefined ? null : scene[kind][index]);

export function centreAt(scene, item) {
  const polygon = polygonAt(scene, item);
  return polygon ? centreOf(polygon) : middle(scene.vehicle, scene[item.kind]);
}

const grid = 0.5;
const snapped = (value) => Math.round(value / grid) * grid;
const snapAngle = Math.PI / 24;

/** Moves an item by metres from where it was in `before`, and onto the grid when `snap` is on. */
export function moveItem(scene, item, before, dx, dy, snap) {
  const polygon = polygonAt(before, item);
  if (polygon) {
    const [x, y] = polygon[0];
    const mx = snap ? snapped(x + dx) - x : dx;
    const my = snap ? snapped(y + dy) - y : dy;
    scene[item.kind][item.index] = polygon.map(([px, py]) => [px + mx, py + my]);
    return;
  }
  const pose = before[item.kind];
  const place = [pose.x + dx, pose.y + dy].map((value) => (snap ? snapped(value) : value));
  scene[item.kind] = {...scene[item.kind], x: place[0], y: place[1]};
}

/** Turns an item by an angle from how it stood in `before`; a vehicle about the middle of its body. */
export function turnItem(scene, item, before, angle, snap) {
  const polygon = polygonAt(before, item);
  if (polygon) {
    const by = snap ? Math.round(angle / snapAngle) * snapAngle : angle;
    scene[item.kind][item.index] = turned(polygon, by, centreOf(polygon));
    return;
  }
  const pose = before[item.kind];
  const wanted = pose.heading + angle;
  const heading = wrap(snap ? Math.round(wanted / snapAngle) * snapAngle : wanted);
  const [cx, cy] = middle(scene.vehicle, pose);
  const [mx, my] = middle(scene.vehicle, {x: 0, y: 0, heading});
  scene[item.kind] = {...scene[item.kind], x: cx - mx, y: cy - my, heading};
}

export function removeItem(scene, item) {
  if (item.index !== undefined) scene[item.kind].splice(item.index, 1);
}

/** Adds a box of metres around a place; returns its handle. */
export function addBox(scene, kind, [x, y], width, height) {
  const at = {x, y, heading: 0};
  scene[kind].push([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => placed(at, (u * width) / 2, (v * height) / 2)));
  return {kind, index: scene[kind].length - 1};
}

/** Lets another vehicle drive; a trailer that was not there before stands straight behind it. */
export function changeVehicle(scene, vehicle) {
  scene.vehicle = vehicle;
  for (const kind of ['start', 'goal']) {
    const {hitch_angles: angles = [0], ...pose} = scene[kind];
    scene[kind] = vehicle.trailers ? {...pose, hitch_angles: angles} : pose;
  }
}

/** A copy that later changes leave alone; the cells of a map are shared, as nobody changes them. */
export const copyOf = (scene) => ({...structuredClone({...scene, map: null}), map: scene.map});

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
