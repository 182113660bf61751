// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long from a movement of the mouse to the path on the screen, and from opening the page to its first path?
// usage: node timings.mjs PLAYGROUND CHROMIUM

import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser, pause} from './browser.mjs';
import {traces} from './traces.mjs';

const [playground, chromium] = process.argv.slice(2);
const url = pathToFileURL(resolve(playground, 'index.html')).href;
const size = {width: 1440, height: 900};
const at = (numbers, share) => {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
};

/**
 * Notes of each frame with a plan how long after the movement of the mouse it was handed to the screen, and how long it
 * worked [ms]. A message that a frame sends comes once all of it was painted.
 */
const watch = `(() => {
  const page = vandplanPage;
  let moved = null;
  let shown = null; // the movement that the last plan was made for
  globalThis.frames = [];
  page.canvas.addEventListener('pointermove', (event) => { moved = event.timeStamp; }, true);
  const plan = page.plan.bind(page);
  page.plan = () => {
    plan();
    shown = moved;
  };
  const paint = page.frame.bind(page);
  page.frame = (time) => {
    const begin = performance.now();
    paint(time);
    const from = shown;
    shown = null;
    if (from === null || !page.shown) return;
    const {port1, port2} = new MessageChannel();
    port1.onmessage = () => { const now = performance.now(); frames.push([now - from, now - begin]); };
    port2.postMessage(0);
  };
})()`;

/** Drags the goal along a trace; what came of each movement. */
async function dragged(page, trace) {
  await page.value('frames.length = 0');
  const [u, v] = await page.value(`(() => { const p = vandplanPage, d = p.scene.vehicle, g = p.scene.goal, m = (d.wheelbase + d.front_overhang - d.rear_overhang) / 2;
    return p.view.toPage([g.x + m * Math.cos(g.heading), g.y + m * Math.sin(g.heading)]); })()`);
  await page.mouse('mouseMoved', [u, v]);
  await page.mouse('mousePressed', [u, v], {buttons: 1});
  const begin = performance.now();
  for (const [i, [x, y]] of trace.entries()) {
    await pause(Math.max(0, begin + 8 * i - performance.now()));
    page.mouse('mouseMoved', [u + x, v + y], {buttons: 1});
  }
  await page.mouse('mouseReleased', [u + trace.at(-1)[0], v + trace.at(-1)[1]]);
  await page.until('!vandplanPage.dirty');
  const frames = await page.value('frames');
  await page.key('z', 2);
  await page.until('!vandplanPage.dirty');
  return frames;
}

async function measured(page, name) {
  await page.until('vandplanPage.result?.path && !vandplanPage.dirty');
  await pause(2000); // the second thread is done, too
  const frames = [];
  for (const trace of traces) frames.push(...await dragged(page, trace));
  const [late, work] = [0, 1].map((k) => frames.map((frame) => frame[k]));
  console.log(`${name.padEnd(28)} ${String(frames.length).padStart(4)} frames, after the movement: median ${at(late, 0.5).toFixed(1)}, 95 % ${at(late, 0.95).toFixed(1)} ms; `
    + `work: median ${at(work, 0.5).toFixed(1)}, 95 % ${at(work, 0.95).toFixed(1)} ms`);
}

const browser = await Browser.open(chromium);
const page = await browser.page(url, size);
const first = await page.value('performance.getEntriesByName("first-path")[0]?.startTime');
const load = await page.value('performance.timing.loadEventEnd - performance.timing.navigationStart');
console.log(`loaded after ${load} ms, first path painted ${first?.toFixed(0)} ms after opening`);
await page.value(watch);
const names = await page.value('[...document.getElementById("scenario").options].map((o) => o.text)');
for (const [i, name] of names.entries()) {
  if (/^(Trailer|Moving)/.test(name)) continue; // planned by the second thread
  await page.value(`(() => { const s = document.getElementById('scenario'); s.value = ${i}; s.dispatchEvent(new Event('change')); })()`);
  await measured(page, name);
}
const map = 'P2\n500 500\n255\n' + Array.from({length: 250000}, (_, i) => ((Math.floor(i / 500) % 60 < 2 && (i % 500) % 120 > 30) ? 0 : 254)).join(' ');
const scenario = 'name: map\nvehicle: tpcap-car\nbounds: {x: [0, 100], y: [0, 100]}\nstart: {x: 30, y: 30, heading: 0}\ngoal: {x: 50, y: 54, heading: 0}\nmap: map.pgm\n';
await page.value(`(async () => { const data = new DataTransfer(); data.items.add(new File([${JSON.stringify(map)}], 'map.pgm'));
  data.items.add(new File([${JSON.stringify(scenario)}], 'yard.yaml'));
  dispatchEvent(new DragEvent('drop', {dataTransfer: data, cancelable: true})); })()`);
await page.until('vandplanPage.scene.map');
await measured(page, 'map of 500 x 500 cells');
await browser.close();
