// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Draws what driving to the goal costs: colours, which fade with the cost, and lines of equal cost.

import {label, paintOutline} from './paint_places.js';
import {middle} from './geometry.js';

/** Red, green and blue of a colour such as #a06be0. */
const shadeOf = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

/** Places between lines of equal cost: some ten lines. */
const stepOf = ({most}) => [1, 2, 5, 10, 20, 50, 100, 200, 500].find((metres) => most / metres < 12) ?? 1000;

function imageOf({columns, rows, costs, most}, colours) {
  const stops = ['cost-near', 'cost-middle', 'cost-far'].map((name) => shadeOf(colours[name]));
  const image = new ImageData(columns, rows);
  costs.forEach((cost, i) => {
    if (!Number.isFinite(cost)) return;
    const at = 2 * Math.min(0.9999, cost / (most || 1));
    const [from, to] = stops.slice(Math.floor(at));
    image.data.set([...from.map((one, k) => one + (at % 1) * (to[k] - one)), 255], 4 * i);
  });
  const canvas = Object.assign(document.createElement('canvas'), {width: columns, height: rows});
  canvas.getContext('2d').putImageData(image, 0, 0);
  return canvas;
}

/** Where a line of equal cost crosses the sides of a square of four places, {at: [x, y], cost} each. */
function crossings(corners, level) {
  const points = [];
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % 4];
    if (a.cost < level === b.cost < level) return;
    const share = (level - a.cost) / (b.cost - a.cost);
    points.push([0, 1].map((k) => a.at[k] + share * (b.at[k] - a.at[k])));
  });
  return points;
}

/** Lines of equal cost, but for squares over which the cost jumps. */
function linesOf(field) {
  const {left, bottom, cell, columns, rows, costs} = field;
  const step = stepOf(field);
  const lines = new Path2D();
  for (let row = 0; row + 1 < rows; ++row) {
    for (let column = 0; column + 1 < columns; ++column) {
      const corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([u, v]) => ({
        at: [left + (column + u + 0.5) * cell, bottom + (row + v + 0.5) * cell], cost: costs[(row + v) * columns + column + u],
      }));
      const own = corners.map(({cost}) => cost);
      const [low, high] = [Math.min(...own), Math.max(...own)];
      if (!(high - low < step)) continue;
      const level = step * Math.ceil(low / step);
      if (level >= high) continue;
      const points = crossings(corners, level);
      for (let i = 0; i + 1 < points.length; i += 2) {
        lines.moveTo(...points[i]);
        lines.lineTo(...points[i + 1]);
      }
    }
  }
  return lines;
}

const kept = new WeakMap();

/** What is drawn of a field, in the colours of the page as they are now. */
function drawingOf(field, colours) {
  let drawing = kept.get(field);
  if (drawing?.colours !== colours) {
    drawing = {colours, image: imageOf(field, colours), lines: drawing?.lines ?? linesOf(field)};
    kept.set(field, drawing);
  }
  return drawing;
}

/** A field of costs (costs.js). `faint`: it belongs to a scene that has changed. */
export function paintField(context, view, field, colours, faint) {
  const {image, lines} = drawingOf(field, colours);
  const {left, bottom, cell, columns, rows} = field;
  context.globalAlpha = faint ? 0.3 : 1;
  context.imageSmoothingEnabled = true;
  context.drawImage(image, left, bottom, columns * cell, rows * cell);
  context.strokeStyle = colours.soft;
  context.lineWidth = 1 / view.scale;
  context.globalAlpha *= 0.45;
  context.stroke(lines);
  context.globalAlpha = 1;
}

/** The vehicle as it would best stand at a place, and what driving from there costs. */
export function paintBest(context, view, vehicle, best, colours) {
  paintOutline(context, view, vehicle, best, colours.ink);
  label(context, view, middle(vehicle, best), `${best.cost.toFixed(0)} m`, {ink: colours.ink, halo: colours.paper});
}
