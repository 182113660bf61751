// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long from a movement of the mouse to the path on the screen, and from opening the page to its first path?
// usage: node timings.mjs PLAYGROUND CHROMIUM

import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser, pause} from './browser.mjs';

const [playground, chromium] = process.argv.slice(2);
const url = pathToFileURL(resolve(playground, 'index.html')).href;
const size = {width: 1440, height: 900};
const at = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];

/** Drags the goal around a loop of places and notes what each frame took [ms]. */
const drag = `(async () => {
  const page = vandplanPage, canvas = page.canvas, times = [];
  const frame = () => new Promise(requestAnimationFrame);
  const v = page.scene.vehicle, m = (v.wheelbase + v.front_overhang - v.rear_overhang) / 2, g = page.scene.goal;
  const [u, w] = page.view.toPage([g.x + m * Math.cos(g.heading), g.y + m * Math.sin(g.heading)]);
  const send = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, {pointerId: 1, pointerType: 'mouse', button: type === 'pointermove' ? -1 : 0, buttons: 1, clientX: x, clientY: y, bubbles: true}));
  canvas.setPointerCapture = () => {};
  send('pointerdown', u, w);
  for (let i = 1; i <= 120; ++i) {
    const a = i / 120 * 2 * Math.PI, r = 90 * Math.sin(a / 2);
    const x = u + r * Math.cos(3 * a), y = w + r * Math.sin(3 * a);
    await frame();
    const begin = performance.now();
    send('pointermove', x, y);
    await frame();
    times.push(page.painted - begin);
  }
  send('pointerup', u, w);
  return times;
})()`;

const browser = await Browser.open(chromium);
const page = await browser.page(url, size);
const first = await page.value('performance.getEntriesByName("first-path")[0]?.startTime');
const load = await page.value('performance.timing.loadEventEnd - performance.timing.navigationStart');
console.log(`loaded after ${load} ms, first path painted ${first?.toFixed(0)} ms after opening`);
const names = await page.value('[...document.getElementById("scenario").options].map((o) => o.text)');
const rows = [];
for (const [i, name] of names.entries()) {
  await page.value(`(() => { const s = document.getElementById('scenario'); s.value = ${i}; s.dispatchEvent(new Event('change')); })()`);
  await pause(2500);
  rows.push([name, (await page.value(drag)).sort((a, b) => a - b)]);
}
const map = 'P2\n500 500\n255\n' + Array.from({length: 250000}, (_, i) => ((Math.floor(i / 500) % 60 < 2 && (i % 500) % 120 > 30) ? 0 : 254)).join(' ');
await page.value(`(async () => { const data = new DataTransfer(); data.items.add(new File([${JSON.stringify(map)}], 'map.pgm'));
  dispatchEvent(new DragEvent('drop', {dataTransfer: data, cancelable: true})); await new Promise((r) => setTimeout(r, 3000)); })()`);
rows.push(['map of 500 x 500 cells', (await page.value(drag)).sort((a, b) => a - b)]);
for (const [name, times] of rows) console.log(`${name.padEnd(28)} median ${at(times, 0.5).toFixed(1)} ms, 95 % ${at(times, 0.95).toFixed(1)} ms`);
await browser.close();
