// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does a page that a bundler made of the package plan in a browser, in its own thread and in a worker? Built, and in the
// bundler's development server.
// usage: node in_a_browser.mjs VITE CHROMIUM    in the folder of a project that has the package

import {rmSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

import {Browser} from '../playground/browser.mjs';

const [vite, chromium] = process.argv.slice(2);
const {build, createServer, preview} = await import(pathToFileURL(vite).href);
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

writeFileSync('index.html', '<!doctype html><link rel="icon" href="data:,"><script type="module" src="/main.js"></script>\n');
writeFileSync('main.js', `
import {InputError, load} from 'vandplan';
import {startWorker} from 'vandplan/worker';
import {yard} from './yard.mjs';

async function main() {
  const worker = startWorker();
  const sooner = [];
  const planned = await worker.plan(yard, {max_iterations: 2000}, {onProgress: ({cost}) => sooner.push(cost)});
  const fetched = performance.getEntriesByType('resource').filter(({name}) => name.includes('core')).length;
  const controller = new AbortController();
  const left = worker.plan(yard, {time_limit: 60}, {signal: controller.signal}).catch(({name}) => name);
  setTimeout(() => controller.abort(), 100);
  const wrong = await worker.plan({...yard, wals: []}).catch((error) => error instanceof InputError && error.where);
  worker.close();
  const vandplan = await load();
  const {path} = vandplan.plan(yard, {max_iterations: 2000});
  return {hash: vandplan.hash(path), other: vandplan.hash(planned.path), sooner: sooner.length, left: await left, wrong, fetched};
}
main().then((said) => (globalThis.said = said), (error) => (globalThis.said = {error: String(error)}));
`);

async function look(browser, server, name) {
  try {
    const page = await browser.page(server.resolvedUrls.local[0], {width: 800, height: 600, ready: 'globalThis.said'});
    const {hash, other, sooner, left, wrong, fetched, error} = await page.value('globalThis.said');
    expect(!error && page.faults.length === 0, `${name}: ${error}; ${page.faults.join('; ')}`);
    expect(/^[0-9a-f]{16}$/.test(hash) && hash === other, `${name}: the page has ${hash}, its worker ${other}`);
    expect(sooner > 0 && left === 'AbortError' && wrong === 'wals', `${name}: ${sooner} results before the last; ${left}; ${wrong}`);
    expect(name !== 'built' || fetched === 0, `${name}: a page that plans in a worker alone loads the core, too`);
  } catch (error) {
    expect(false, `${name}: ${error.message}`);
  } finally {
    await server.close();
  }
}

const common = {logLevel: 'error', cacheDir: 'vite_cache', configFile: false};
const local = {host: '127.0.0.1', port: 0};
rmSync('dist', {recursive: true, force: true});
await build({...common, build: {chunkSizeWarningLimit: 3000}});
const browser = await Browser.open(chromium);
try {
  await look(browser, await preview({...common, preview: local}), 'built');
  await look(browser, await (await createServer({...common, server: local, optimizeDeps: {exclude: ['vandplan']}})).listen(), 'served');
} finally {
  await browser.close();
}
process.exit(faults ? 1 : 0);
