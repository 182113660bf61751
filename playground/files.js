// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Files and links: YAML, maps, and a scene in the address.

import {JSON_SCHEMA, dump, load} from 'js-yaml';

import {boxOf, mapCorners} from './geometry.js';
import {most, ReadError, scenesOf} from './reading.js';
import {goalsOf} from './scene.js';

/** The value of a YAML text; nothing in it is ever run. */
export function parsed(text, name) {
  if (text.length > most.text) throw new ReadError(`${name}: is larger than ${most.text / 1e6} MB`);
  try {
    return load(text, {schema: JSON_SCHEMA});
  } catch (error) {
    const line = error.mark ? `${name}:${error.mark.line + 1}` : name;
    throw new ReadError(`${line}: ${String(error.reason ?? error.message).slice(0, 120)}`);
  }
}

// ---- scenarios ----

export const scenesFrom = (text, name, map) => scenesOf(parsed(text, name), map);

/** What a scenario file says of a scene, as plain keys. */
function documentOf(scene) {
  const {name, description, vehicle, bounds, start, obstacles, kerbs, inside, zones, moving, map, options, origin} = scene;
  const {goal, via} = goalsOf(scene);
  return {
    name,
    ...(description ? {description} : {}),
    vehicle,
    bounds,
    start,
    ...(via.length ? {via} : {}),
    goal,
    ...(obstacles.length || !map ? {obstacles} : {}),
    ...(kerbs.length ? {kerbs} : {}),
    ...(inside.length ? {inside} : {}),
    ...(zones.length ? {zones} : {}),
    ...(moving.length ? {moving} : {}),
    ...(map ? {map: map.name, ...(map.grid.unknown === 'free' ? {unknown: 'free'} : {})} : {}),
    ...(Object.keys(options ?? {}).length ? {options} : {}),
    ...(origin ? {origin} : {}),
  };
}

/** The text of a scenario file. */
export const yamlOf = (scene) => dump(documentOf(scene), {flowLevel: 2, lineWidth: 110, noRefs: true});

// ---- links ----

async function through(bytes, stream, largest) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    size += next.value.length;
    if (size > largest) {
      reader.cancel();
      throw new ReadError('the link: holds more than the page can show');
    }
    parts.push(next.value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** What stands behind the # of an address for a scene without a map. */
export async function linkOf(scene) {
  const bytes = new TextEncoder().encode(JSON.stringify(documentOf(scene)));
  const packed = await through(bytes, new CompressionStream('deflate-raw'), most.text);
  let binary = '';
  for (const byte of packed) binary += String.fromCharCode(byte);
  return '#yard=' + btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The scene of a link; null if the address carries none. */
export async function sceneFromLink(hash) {
  if (!hash.startsWith('#yard=')) return null;
  if (hash.length > 200000) throw new ReadError('the link: is too long');
  try {
    const binary = atob(hash.slice(6).replaceAll('-', '+').replaceAll('_', '/'));
    const packed = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const bytes = await through(packed, new DecompressionStream('deflate-raw'), most.text);
    return scenesOf(JSON.parse(new TextDecoder().decode(bytes)))[0];
  } catch (error) {
    if (error instanceof ReadError) throw error;
    throw new ReadError('the link: cannot be read');
  }
}

// ---- maps ----

const largestMap = 4e6; // cells

/** Shades of grey, row by row from the top, of a PGM image. */
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
  const shades = new Uint8Array(width * height);
  if (kind === 'P5') {
    ++at;
    if (bytes.length - at < shades.length) fail('ends too early');
    for (let i = 0; i < shades.length; ++i) shades[i] = Math.min(255, (255 * bytes[at + i]) / white);
  } else {
    for (let i = 0; i < shades.length; ++i) shades[i] = Math.min(255, (255 * Number(token())) / white);
  }
  return {width, height, shades};
}

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
  const shades = new Uint8Array(width * height);
  for (let i = 0; i < shades.length; ++i) shades[i] = data[4 * i + 3] < 128 ? 205 : (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3;
  return {width, height, shades};
}

const plainMap = {resolution: 0.2, origin: [0, 0, 0], negate: 0, occupied_thresh: 0.65, free_thresh: 0.196};

/** A map of ROS' map_server: its keys and its image. Without keys a cell is 0.2 m. */
export async function mapFrom(image, keys, name) {
  const bytes = new Uint8Array(await image.slice(0, 20e6).arrayBuffer());
  const {width, height, shades} = bytes[0] === 0x50 ? pgm(bytes, image.name) : await png(image, image.name);
  const {resolution, origin, negate, occupied_thresh: occupied, free_thresh: free} = {...plainMap, ...keys};
  const numbers = [resolution, occupied, free, ...(Array.isArray(origin) ? origin : [NaN])];
  if (!numbers.every(Number.isFinite) || !(resolution > 0) || numbers.length !== 6) throw new ReadError(`${name}: expected a resolution and an origin`);
  const cells = new Uint8Array(width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const shade = shades[(height - 1 - row) * width + column];
      const chance = (Number(negate) ? shade : 255 - shade) / 255;
      cells[row * width + column] = chance > occupied ? 1 : chance < free ? 0 : 2;
    }
  }
  const grid = {origin: {x: origin[0], y: origin[1], heading: origin[2]}, resolution, columns: width, rows: height, cells};
  const [left, bottom, right, top] = boxOf(mapCorners(grid));
  return {name, grid, bounds: {x: [left, right], y: [bottom, top]}};
}

/** A scene on a map that no scenario came with: a car where there is room at two ends of it. */
export function sceneOnMap(map, vehicle, isFree) {
  const {grid} = map;
  const free = [];
  const step = Math.max(1, Math.round(2 / grid.resolution));
  const scene = {name: map.name, description: '', vehicle, bounds: map.bounds, obstacles: [], kerbs: [], inside: [], via: [], zones: [], moving: [], map, options: {}};
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
