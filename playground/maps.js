// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Maps of ROS' map_server: images, and the keys that say what their shades mean.

import {boxOf, mapCorners} from './geometry.js';
import {ReadError} from './reading.js';

const largestMap = 4e6; // cells

/** Shades of grey from 0 to 255, row by row from the top, of a PGM image. */
function pgm(bytes, name) {
  const fail = (problem) => {
    throw new ReadError(`${name}: ${problem}`);
  };
  let at = 0;
  const token = () => {
    let word = '';
    for (; at < bytes.length; ++at) {
      const letter = String.fromCharCode(bytes[at]);
      if (letter === '#') while (at < bytes.length && bytes[at] !== 10) ++at;
      else if (!/\s/.test(letter)) word += letter;
      else if (word) break;
      if (word.length > 9) fail('is no PGM image');
    }
    return word;
  };
  const kind = token();
  if (kind !== 'P5' && kind !== 'P2') fail('is no PGM image');
  const [width, height, white] = [token(), token(), token()].map(Number);
  if (!(width >= 1 && height >= 1 && width * height <= largestMap)) fail(`expected 1 to ${largestMap / 1e6} million cells`);
  if (!(white >= 1 && white <= 255)) fail('expected 1 to 255 shades');
  const shades = new Int16Array(width * height);
  if (kind === 'P5') {
    ++at;
    if (bytes.length - at < shades.length) fail('ends too early');
    for (let i = 0; i < shades.length; ++i) shades[i] = Math.min(255, Math.round((255 * bytes[at + i]) / white));
  } else {
    for (let i = 0; i < shades.length; ++i) shades[i] = Math.max(0, Math.min(255, Math.round((255 * Number(token())) / white)));
  }
  return {width, height, shades};
}

/** Shades of an image that the browser reads; -1 is transparent. */
async function png(file, name) {
  let bitmap;
  try {
    bitmap = await createImageBitmap(file);
  } catch {
    throw new ReadError(`${name}: is no image that can be read`);
  }
  const {width, height} = bitmap;
  if (width * height > largestMap) throw new ReadError(`${name}: more than ${largestMap / 1e6} million cells`);
  const canvas = Object.assign(document.createElement('canvas'), {width, height});
  const context = canvas.getContext('2d', {willReadFrequently: true});
  context.drawImage(bitmap, 0, 0);
  const {data} = context.getImageData(0, 0, width, height);
  const shades = new Int16Array(width * height);
  for (let i = 0; i < shades.length; ++i) shades[i] = data[4 * i + 3] < 128 ? -1 : (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3;
  return {width, height, shades};
}

const plainMap = {resolution: 0.2, origin: [0, 0, 0], mode: 'trinary', negate: 0, occupied_thresh: 0.65, free_thresh: 0.196};

/** What a shade says: cell (0 free, 1 occupied, 2 unknown) and occupancy in percent (255: unknown), as map_server publishes them. */
function saidBy(shade, {mode, negate, occupied_thresh: occupied, free_thresh: free}) {
  const isRaw = mode === 'raw';
  if (shade < 0 || (isRaw && shade > 100)) return {cell: 2, percent: 255};
  const chance = isRaw ? shade / 100 : (Number(negate) ? shade : 255 - shade) / 255;
  const cell = chance > occupied ? 1 : chance < free ? 0 : 2;
  if (isRaw) return {cell, percent: shade};
  if (cell !== 2) return {cell, percent: 100 * cell};
  if (mode !== 'scale') return {cell, percent: 255};
  return {cell, percent: occupied > free ? Math.round((100 * (chance - free)) / (occupied - free)) : 0};
}

/** A map of ROS' map_server: its keys and its image. Without keys a cell is 0.2 m. `percents`: occupancy of each cell. */
export async function mapFrom(image, keys, name) {
  const bytes = new Uint8Array(await image.slice(0, 20e6).arrayBuffer());
  const {width, height, shades} = bytes[0] === 0x50 ? pgm(bytes, image.name) : await png(image, image.name);
  const rule = {...plainMap, ...keys};
  const {resolution, origin, occupied_thresh: occupied, free_thresh: free} = rule;
  const numbers = [resolution, occupied, free, ...(Array.isArray(origin) ? origin : [NaN])];
  if (!numbers.every(Number.isFinite) || !(resolution > 0) || numbers.length !== 6) throw new ReadError(`${name}: expected a resolution and an origin`);
  if (!['trinary', 'scale', 'raw'].includes(rule.mode)) throw new ReadError(`${name}: expected the mode trinary, scale or raw`);
  const said = Array.from({length: 257}, (_, i) => saidBy(i - 1, rule));
  const cells = new Uint8Array(width * height);
  const percents = new Uint8Array(width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const {cell, percent} = said[shades[(height - 1 - row) * width + column] + 1];
      cells[row * width + column] = cell;
      percents[row * width + column] = percent;
    }
  }
  const grid = {origin: {x: origin[0], y: origin[1], heading: origin[2]}, resolution, columns: width, rows: height, cells};
  const [left, bottom, right, top] = boxOf(mapCorners(grid));
  return {name, grid, percents, bounds: {x: [left, right], y: [bottom, top]}};
}

/** A scene on a map that no scenario came with: a car where there is room at two ends of it. */
export function sceneOnMap(map, vehicle, isFree) {
  const {grid} = map;
  const free = [];
  const step = Math.max(1, Math.round(2 / grid.resolution));
  const scene = {name: map.name, description: '', vehicle, bounds: map.bounds, obstacles: [], kerbs: [], inside: [], via: [], zones: [], moving: [], map, masks: [], options: {}};
  for (let row = 0; row < grid.rows; row += step) {
    for (let column = 0; column < grid.columns; column += step) {
      if (grid.cells[row * grid.columns + column] === 0) free.push([column, row]);
    }
  }
  const poses = free.map(([column, row]) => ({
    x: grid.origin.x + (column + 0.5) * grid.resolution,
    y: grid.origin.y + (row + 0.5) * grid.resolution,
    heading: 0,
  }));
  if (!poses.length) throw new ReadError(`${map.name}: nothing on it is free`);
  const check = isFree({...scene, start: poses[0], goal: poses[0]});
  const start = poses.find(check) ?? poses[0];
  const goal = poses.findLast(check) ?? poses.at(-1);
  return {...scene, start, goal};
}
