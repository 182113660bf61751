// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Points, poses and outlines. Metres and radians, counter-clockwise, a pose is the rear axle.

export const wrap = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));

export const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

/** Where a point of the frame of a pose lies. */
export function placed(pose, x, y) {
  const c = Math.cos(pose.heading);
  const s = Math.sin(pose.heading);
  return [pose.x + c * x - s * y, pose.y + s * x + c * y];
}

/** Where a place lies in the frame of a pose. */
export function inFrame(pose, [x, y]) {
  const c = Math.cos(pose.heading);
  const s = Math.sin(pose.heading);
  return [c * (x - pose.x) + s * (y - pose.y), -s * (x - pose.x) + c * (y - pose.y)];
}

/** The corners of the body of a vehicle or a trailer in its own frame: its outline, or the rectangle of its lengths. */
export function bodyOf({wheelbase, front_overhang: ahead, rear_overhang: behind, width, outline: corners}) {
  if (corners) return corners;
  const front = wheelbase + ahead;
  const half = width / 2;
  return [[-behind, -half], [front, -half], [front, half], [-behind, half]];
}

/** The corners of a body at a pose. */
export const outline = (body, pose) => bodyOf(body).map(([x, y]) => placed(pose, x, y));

/** Where the trailer of a vehicle stands: the midpoint of its axle. */
export function trailerPose(vehicle, pose, hitch = pose.hitch_angles?.[0] ?? 0) {
  const [x, y] = placed(pose, vehicle.hitch ?? 0, 0);
  const heading = pose.heading - hitch;
  const [{wheelbase}] = vehicle.trailers;
  return {x: x - wheelbase * Math.cos(heading), y: y - wheelbase * Math.sin(heading), heading};
}

/** Where the vehicle stands whose trailer stands there. */
export function tractorPose(vehicle, trailer, hitch) {
  const [x, y] = placed(trailer, vehicle.trailers[0].wheelbase, 0);
  const heading = wrap(trailer.heading + hitch);
  const at = vehicle.hitch ?? 0;
  return {x: x - at * Math.cos(heading), y: y - at * Math.sin(heading), heading};
}

/** The corners of the body of a trailer. */
export const trailerOutline = ({trailers: [trailer]}, pose) => outline(trailer, pose);

/** The outlines of the vehicle and of what it pulls. */
export const outlines = (vehicle, pose) =>
  vehicle.trailers ? [outline(vehicle, pose), trailerOutline(vehicle, trailerPose(vehicle, pose))] : [outline(vehicle, pose)];

/** The middle of the body. */
export const middle = (vehicle, pose) =>
  placed(pose, (vehicle.wheelbase + vehicle.front_overhang - vehicle.rear_overhang) / 2, 0);

export function contains(polygon, [x, y]) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [ax, ay] = polygon[i];
    const [bx, by] = polygon[j];
    if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
  }
  return inside;
}

export function centreOf(polygon) {
  let x = 0;
  let y = 0;
  for (const [px, py] of polygon) {
    x += px;
    y += py;
  }
  return [x / polygon.length, y / polygon.length];
}

export const distance = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** The distance of a place from the side between two corners. */
export function fromSide([x, y], [ax, ay], [bx, by]) {
  const dx = bx - ax;
  const dy = by - ay;
  const along = clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0, 1);
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}

export function turned(polygon, angle, [cx, cy]) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return polygon.map(([x, y]) => [cx + c * (x - cx) - s * (y - cy), cy + s * (x - cx) + c * (y - cy)]);
}

/** The smallest box around points: [x_min, y_min, x_max, y_max]. */
export function boxOf(points) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return box;
}

/** The corners of what is hit, of which the planner says what and where it is; null if it is not in the scene. */
export function hitCorners(scene, {what, index, cell}) {
  if (what === 'masks') return mapCorners(scene.masks[index].map.grid);
  if (index !== undefined) return (what === 'zones' ? scene.zones[index]?.area : scene[what]?.[index]) ?? null;
  if (what === 'bounds') {
    const {x, y} = scene.bounds;
    return [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
  }
  if (!cell || !scene.map) return null;
  const {origin, resolution} = scene.map.grid;
  const half = resolution / 2;
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => placed({...cell, heading: origin.heading}, u * half, v * half));
}

/** The corners of a map. */
export function mapCorners({origin, resolution, columns, rows}) {
  const width = columns * resolution;
  const height = rows * resolution;
  return [[0, 0], [width, 0], [width, height], [0, height]].map(([x, y]) => placed(origin, x, y));
}
