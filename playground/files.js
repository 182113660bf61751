// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Files and links: YAML, what was dropped, and a scene in the address.

import {JSON_SCHEMA, dump, load} from 'js-yaml';

import {mapFrom} from './maps.js';
import {baseName, most, ReadError, scenesOf} from './reading.js';
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

export const scenesFrom = (text, name, maps) => scenesOf(parsed(text, name), maps);

/** What a scenario file says of a scene, as plain keys. */
function documentOf(scene) {
  const {name, description, vehicle, bounds, start, obstacles, kerbs, inside, zones, moving, map, masks, options, origin} = scene;
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
    ...(masks.length ? {masks: masks.map((mask) => ({map: mask.map.name, ...mask.rule}))} : {}),
    ...(Object.keys(options ?? {}).length ? {options} : {}),
    ...(origin ? {origin} : {}),
  };
}

/** The text of a scenario file. */
export const yamlOf = (scene) => dump(documentOf(scene), {flowLevel: 2, lineWidth: 110, noRefs: true});

// ---- what was dropped ----

/** Maps by the names of their files: keys and image, or an image alone. */
async function mapsIn(keysOf, images) {
  const maps = new Map();
  const left = new Map(images.map((image) => [image.name, image]));
  for (const [name, keys] of keysOf) {
    const wanted = baseName(keys.image);
    const image = images.find((one) => one.name === wanted) ?? (keysOf.size + images.length === 2 ? images[0] : null); // one of each belong together
    if (!image) throw new ReadError(`${name}: drop its image ${JSON.stringify(wanted.slice(0, 60))} together with it`);
    left.delete(image.name);
    maps.set(name, await mapFrom(image, keys, name));
  }
  for (const [name, image] of left) maps.set(name, await mapFrom(image, {}, name));
  return maps;
}

/** Of files that somebody dropped or chose: the scenario, {text, name} or null, and the maps by their names. */
export async function dropped(list) {
  const files = [...list];
  const texts = files.filter(({name}) => /\.ya?ml$/i.test(name));
  const images = files.filter(({name}) => /\.(pgm|png)$/i.test(name));
  if (!texts.length && !images.length) throw new ReadError('expected a scenario (.yaml) or a map (.pgm, .png)');
  let scenario = null;
  const keysOf = new Map();
  for (const file of texts) {
    if (file.size > most.text) throw new ReadError(`${file.name}: is larger than ${most.text / 1e6} MB`);
    const text = await file.text();
    const value = parsed(text, file.name);
    if (value && typeof value === 'object' && 'image' in value) keysOf.set(file.name, value);
    else scenario = {text, name: file.name};
  }
  return {scenario, maps: await mapsIn(keysOf, images)};
}

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

/** What stands behind the # of an address for a scene without maps. */
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
