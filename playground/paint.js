// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Draws the yard. Colours come from the style sheet, so that dark and light are decided there.

import {hitCorners, mapCorners, outline, outlines, placed, trailerOutline, trailerPose} from './geometry.js';
import {posesOf} from './places.js';
import {blocks, placeAt, polygonAt} from './scene.js';

const names = ['paper', 'grid', 'ink', 'soft', 'wall', 'wall-line', 'kerb', 'kerb-line', 'accent', 'accent-ink', 'forward', 'reverse', 'body', 'glass', 'bad', 'cost-near', 'cost-middle', 'cost-far'];

/** The colours of the page as they are now. */
export function paletteOf(element) {
  const style = getComputedStyle(element);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

export function trace(context, polygon) {
  polygon.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
}

/** Lines every 1, 5 or 25 m, whatever can be told apart. */
export function paintGrid(context, view, colours) {
  const step = [1, 2, 5, 10, 25, 50, 100, 250].find((metres) => metres * view.scale >= 26) ?? 500;
  const [left, top] = view.toYard([0, 0]);
  const [right, bottom] = view.toYard([view.width, view.height]);
  context.beginPath();
  for (let x = Math.ceil(left / step) * step; x <= right; x += step) {
    context.moveTo(x, bottom);
    context.lineTo(x, top);
  }
  for (let y = Math.ceil(bottom / step) * step; y <= top; y += step) {
    context.moveTo(left, y);
    context.lineTo(right, y);
  }
  context.strokeStyle = colours.grid;
  context.lineWidth = 1 / view.scale;
  context.stroke();
}

/** Shades all that is outside of some areas. */
function shadeOutside(context, view, areas, colours) {
  const [left, top] = view.toYard([-10, -10]);
  const [right, bottom] = view.toYard([view.width + 10, view.height + 10]);
  context.beginPath();
  trace(context, [[left, bottom], [right, bottom], [right, top], [left, top]]);
  for (const area of areas) trace(context, area);
  context.fillStyle = colours.grid;
  context.globalAlpha = 0.6;
  context.fill('evenodd');
  context.globalAlpha = 1;
}

/** Where the rear axle may be, and where the whole body may. */
export function paintBounds(context, view, {bounds: {x, y}, inside}, colours) {
  shadeOutside(context, view, [[[x[0], y[0]], [x[0], y[1]], [x[1], y[1]], [x[1], y[0]]]], colours);
  if (!inside.length) return;
  shadeOutside(context, view, inside, colours);
  context.beginPath();
  for (const area of inside) trace(context, area);
  context.strokeStyle = colours['wall-line'];
  context.lineWidth = 1.25 / view.scale;
  context.stroke();
}

const images = new WeakMap();

/** Cells of a map as an image in one colour. `opacityOf(value, i)`, from 0 to 255, is asked once of each cell's value: the image is kept with `owner`. */
function imageOf(owner, {columns, rows}, colour, values, opacityOf) {
  const kept = images.get(owner);
  if (kept?.colour === colour) return kept.canvas;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, {width: columns, height: rows});
  const context = canvas.getContext('2d');
  context.fillStyle = colour;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
  const image = context.createImageData(columns, rows);
  values.forEach((value, i) => image.data.set([r, g, b, opacityOf(value, i)], 4 * i));
  context.putImageData(image, 0, 0);
  images.set(owner, {colour, canvas});
  return canvas;
}

function paintCells(context, {origin, resolution}, image) {
  context.save();
  context.translate(origin.x, origin.y);
  context.rotate(origin.heading);
  context.scale(resolution, resolution);
  context.imageSmoothingEnabled = false;
  context.drawImage(image, 0, 0);
  context.restore();
}

/** A map: obstacles dark, unknown cells half as much. */
export function paintMap(context, {grid}, colours) {
  paintCells(context, grid, imageOf(grid, grid, colours.wall, grid.cells, (cell) => [0, 255, 110][cell]));
}

/** Masks, faintly: cells that are obstacles in the colour of walls; those with a price in that of kerbs, those with a speed in that of glass, the more so the fuller. */
export function paintMasks(context, masks, colours) {
  for (const mask of masks) {
    const {grid, percents} = mask.map;
    const isWall = blocks(mask);
    const opacityOf = isWall ? (_, i) => (grid.cells[i] === 1 ? 115 : 0) : (percent) => (percent > 100 || percent === 0 ? 0 : 40 + percent);
    const colour = isWall ? colours.wall : mask.rule.as === 'cost' ? colours.kerb : colours.glass;
    paintCells(context, grid, imageOf(mask, grid, colour, percents, opacityOf));
  }
}

export function paintPolygons(context, view, scene, colours) {
  const groups = [[scene.kerbs, colours.kerb, colours['kerb-line']], [scene.obstacles, colours.wall, colours['wall-line']]];
  for (const [polygons, fill, line] of groups) {
    context.beginPath();
    for (const polygon of polygons) trace(context, polygon);
    context.fillStyle = fill;
    context.strokeStyle = line;
    context.lineWidth = 1.25 / view.scale;
    context.lineJoin = 'round';
    context.fill('nonzero');
    context.stroke();
  }
}

/** Outlines in red what is in the way of the start or the goal. */
export function paintHit(context, view, scene, hit, colours) {
  const corners = hitCorners(scene, hit);
  if (!corners) return;
  context.beginPath();
  trace(context, corners);
  context.strokeStyle = colours.bad;
  context.lineWidth = 3 / view.scale;
  context.lineJoin = 'round';
  context.stroke();
}

function wheel(context, x, y, angle, size) {
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.roundRect(-size / 2, -size / 6, size, size / 3, size / 10);
  context.fill();
  context.restore();
}

/** Traces a body in its own frame: rectangles have round corners. */
function traceBody(context, body, round) {
  context.beginPath();
  if (body.outline) trace(context, body.outline);
  else context.roundRect(-body.rear_overhang, -body.width / 2, body.wheelbase + body.front_overhang + body.rear_overhang, body.width, round);
}

/** A trailer seen from above, and its drawbar. */
function paintTrailer(context, view, vehicle, pose, colours, {ghost, bad}) {
  const [trailer] = vehicle.trailers;
  const at = trailerPose(vehicle, pose);
  const front = trailer.wheelbase + trailer.front_overhang;
  context.save();
  context.translate(at.x, at.y);
  context.rotate(at.heading);
  context.lineJoin = 'round';
  if (!ghost) {
    context.fillStyle = colours.ink;
    for (const side of [-1, 1]) wheel(context, 0, side * (trailer.width / 2 - 0.12), 0, 1);
  }
  context.strokeStyle = bad ? colours.bad : ghost ? colours['accent-ink'] : colours.ink;
  context.lineWidth = (ghost ? 1.75 : 1.5) / view.scale;
  if (front < trailer.wheelbase) {
    context.beginPath();
    context.moveTo(front, 0);
    context.lineTo(trailer.wheelbase, 0);
    context.stroke();
  }
  traceBody(context, trailer, 0.15);
  context.fillStyle = bad ? colours.bad : ghost ? colours.accent : colours.body;
  context.globalAlpha = ghost || bad ? 0.2 : 1;
  context.fill();
  context.globalAlpha = 1;
  if (ghost) context.setLineDash([5 / view.scale, 4 / view.scale]);
  context.stroke();
  context.restore();
}

/** A vehicle seen from above, its front wheels turned to a curvature, and its trailer. */
export function paintTruck(context, view, vehicle, pose, colours, {curvature = 0, ghost = false, bad = false} = {}) {
  const front = vehicle.wheelbase + vehicle.front_overhang;
  const length = front + vehicle.rear_overhang;
  const {width} = vehicle;
  const cab = Math.min(0.28 * length, 2.1);
  const above = vehicle.trailers?.[0].front_overhang > 0; // a semitrailer lies on its tractor
  if (vehicle.trailers && !above) paintTrailer(context, view, vehicle, pose, colours, {ghost, bad});
  context.save();
  context.translate(pose.x, pose.y);
  context.rotate(pose.heading);
  context.lineJoin = 'round';
  const line = bad ? colours.bad : ghost ? colours['accent-ink'] : colours.ink;
  if (!ghost) {
    context.fillStyle = colours.ink;
    const size = Math.min(1.0, 0.22 * vehicle.wheelbase);
    const turn = Math.atan(vehicle.wheelbase * curvature);
    for (const side of [-1, 1]) {
      wheel(context, 0, side * (width / 2 - size / 8), 0, size);
      wheel(context, vehicle.wheelbase, side * (width / 2 - size / 8), turn, size);
    }
  }
  traceBody(context, vehicle, 0.22);
  context.fillStyle = bad ? colours.bad : ghost ? colours.accent : colours.body;
  context.globalAlpha = ghost || bad ? 0.2 : 1;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = line;
  context.lineWidth = (ghost ? 1.75 : 1.5) / view.scale;
  if (ghost) context.setLineDash([5 / view.scale, 4 / view.scale]);
  context.stroke();
  context.setLineDash([]);
  if (vehicle.outline) context.clip(); // a cab is as slim as the body is there
  context.beginPath(); // where the cab ends, and its windscreen
  context.moveTo(front - cab, -width / 2);
  context.lineTo(front - cab, width / 2);
  context.lineWidth = 1 / view.scale;
  context.stroke();
  context.beginPath();
  context.roundRect(front - 0.36 * cab, -0.4 * width, 0.2 * cab, 0.8 * width, 0.1);
  context.fillStyle = ghost ? colours['accent-ink'] : colours.glass;
  context.globalAlpha = ghost ? 0.45 : 1;
  context.fill();
  context.restore();
  if (above) paintTrailer(context, view, vehicle, pose, colours, {ghost, bad});
}

/** Where something that moves is at a time, or null once it has left. */
function moverPose({trajectory, after}, t) {
  const next = trajectory.findIndex(([at]) => at > t);
  const last = trajectory.at(-1);
  if (next < 0) return after === 'leaves' && t > last[0] ? null : {x: last[1], y: last[2], heading: last[3]};
  const [t1, x1, y1, h1] = trajectory[next];
  const [t0, x0, y0, h0] = trajectory[Math.max(0, next - 1)];
  const share = t1 > t0 ? Math.max(0, (t - t0) / (t1 - t0)) : 1;
  const turn = h1 - h0 - 2 * Math.PI * Math.round((h1 - h0) / (2 * Math.PI));
  return {x: x0 + share * (x1 - x0), y: y0 + share * (y1 - y0), heading: h0 + share * turn};
}

/** What moves, at a time, and the way it takes. */
export function paintMovers(context, view, moving, t, colours) {
  context.strokeStyle = colours.soft;
  context.lineWidth = 1.25 / view.scale;
  for (const mover of moving) {
    context.beginPath();
    mover.trajectory.forEach(([, x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.setLineDash([2 / view.scale, 6 / view.scale]);
    context.stroke();
    context.setLineDash([]);
    const pose = moverPose(mover, t);
    if (!pose) continue;
    context.beginPath();
    trace(context, mover.outline.map(([x, y]) => placed(pose, x, y)));
    context.fillStyle = colours.glass;
    context.fill();
    context.stroke();
  }
}

/** Traces the bodies at row i of a path: {rows: s, x, y, heading, curvature, direction; trail: x, y, heading or null}. */
function traceBodies(context, vehicle, {rows, trail}, i) {
  const at = 6 * i;
  trace(context, outline(vehicle, {x: rows[at + 1], y: rows[at + 2], heading: rows[at + 3]}));
  if (trail) trace(context, trailerOutline(vehicle, {x: trail[3 * i], y: trail[3 * i + 1], heading: trail[3 * i + 2]}));
}

/** What the bodies sweep along a path; of its rows each one, or the second, or third. */
export function paintSwept(context, view, vehicle, path, colours, every) {
  const count = path.rows.length / 6;
  context.beginPath();
  for (let i = 0; i < count; i += every) traceBodies(context, vehicle, path, i);
  traceBodies(context, vehicle, path, count - 1);
  context.fillStyle = colours.accent;
  context.globalAlpha = 0.13;
  context.fill('nonzero');
  context.globalAlpha = 1;
}

/** Outlines of the body every few metres. */
export function paintFootprints(context, view, vehicle, path, colours, spacing) {
  const {rows} = path;
  context.beginPath();
  let next = spacing;
  for (let i = 0; 6 * i < rows.length; ++i) {
    if (rows[6 * i] < next) continue;
    next = rows[6 * i] + spacing;
    traceBodies(context, vehicle, path, i);
  }
  context.strokeStyle = colours.accent;
  context.globalAlpha = 0.3;
  context.lineWidth = 1 / view.scale;
  context.stroke();
  context.globalAlpha = 1;
}

/** The way of the rear axle, in the colours of pictures: forward solid, in reverse dashed, a ring at each gear change. */
export function paintPath(context, view, rows, colours, width = 3) {
  const px = 1 / view.scale;
  const changes = [];
  for (let begin = 0; begin < rows.length; ) {
    const direction = rows[begin + 5];
    let end = begin;
    while (end < rows.length && rows[end + 5] === direction) end += 6;
    context.beginPath();
    for (let i = begin; i <= Math.min(end, rows.length - 6); i += 6) {
      if (i === begin) context.moveTo(rows[i + 1], rows[i + 2]);
      else context.lineTo(rows[i + 1], rows[i + 2]);
    }
    context.strokeStyle = direction > 0 ? colours.forward : colours.reverse;
    context.lineWidth = width * px;
    context.lineCap = 'round';
    context.lineJoin = 'round';
    if (direction < 0) context.setLineDash([2 * px, 7 * px]);
    context.stroke();
    context.setLineDash([]);
    if (end < rows.length) changes.push([rows[end + 1], rows[end + 2]]);
    begin = end;
  }
  for (const [x, y] of changes) {
    context.beginPath();
    context.arc(x, y, 5 * px, 0, 2 * Math.PI);
    context.fillStyle = colours.paper;
    context.fill();
    context.strokeStyle = colours['accent-ink'];
    context.lineWidth = 2 * px;
    context.stroke();
  }
}

/** Places where an item can be taken hold of, and how far they are from what they turn [px]. */
export const handleGap = 26;

/** Where the handle is that turns an item, in the yard. */
export function turnHandle(view, scene, item, centre) {
  const {vehicle} = scene;
  const place = placeAt(scene, item);
  const poses = place && !place.area ? posesOf(vehicle, place) : [];
  if (poses.length === 1) return placed(poses[0], vehicle.wheelbase + vehicle.front_overhang + handleGap / view.scale, 0);
  const points = poses.length ? poses.flatMap((pose) => outlines(vehicle, pose).flat()) : polygonAt(scene, item);
  const top = Math.max(...points.map(([, y]) => y));
  return [centre[0], top + handleGap / view.scale];
}

export function paintHandle(context, view, [x, y], colours, {square = false} = {}) {
  const px = 1 / view.scale;
  context.beginPath();
  if (square) context.rect(x - 4.5 * px, y - 4.5 * px, 9 * px, 9 * px);
  else context.arc(x, y, 6.5 * px, 0, 2 * Math.PI);
  context.fillStyle = colours.paper;
  context.fill();
  context.strokeStyle = colours['accent-ink'];
  context.lineWidth = 2 * px;
  context.stroke();
}

export {mapCorners};
