// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Do the examples of the package's README run, and print what they say? Files are named by their first line, and a
// comment behind console.log is what it prints. Also: with require, and the version.
// usage: node examples.mjs README VERSION    in the folder of a project that has the package

import {execFileSync} from 'node:child_process';
import {existsSync, readFileSync, writeFileSync} from 'node:fs';

const [readme, version] = process.argv.slice(2);
const files = [...readFileSync(readme, 'utf8').matchAll(/^```(?:js|yaml)\n(?:\/\/|#) (\S+)\n(.*?)^```$/gms)].map(([, name, text]) => ({name, text}));
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

/** Lines that follow each other are one if they are equal: of a loop, which may run once or twice. */
const distinct = (lines) => lines.filter((line, i) => line !== lines[i - 1]).join('\n');

files.push({
  name: 'require.cjs',
  text: `
const {load, hashOf, InputError} = require('vandplan');
const {startWorker} = require('vandplan/worker');
(async () => {
  const {yard} = await import('./yard.mjs');
  const vandplan = await load();
  console.log(vandplan.version); // ${version}
  const {path} = vandplan.plan(yard, {max_iterations: 200});
  const worker = startWorker();
  const other = await worker.plan(yard, {max_iterations: 200});
  console.log(hashOf(path) === hashOf(other.path)); // true
  const wrong = await worker.plan({...yard, wals: []}).catch((error) => error);
  console.log(wrong instanceof InputError, wrong.where); // true wals
  const waiting = [worker.plan(yard, {time_limit: 60}), worker.plan(yard)].map((plan) => plan.catch((error) => error.message));
  worker.close();
  console.log((await Promise.all(waiting)).join()); // the worker is closed,the worker is closed
})();
`,
});
files.push({
  name: 'queue.mjs', // what is called off while others wait, or waits itself
  text: `
import {startWorker} from 'vandplan/worker';
import {yard} from './yard.mjs';
const worker = startWorker();
const begin = Date.now();
const [first, second] = [new AbortController(), new AbortController()];
const plans = [
  worker.plan(yard, {time_limit: 60}, {signal: first.signal}),
  worker.plan(yard, {time_limit: 60}, {signal: second.signal}),
  worker.plan(yard, {max_iterations: 200}),
  worker.plan({...yard, name: () => 1}),
  worker.plan(yard, {max_iterations: 200}, {signal: AbortSignal.abort()}),
].map((plan) => plan.then(({status}) => status, ({name, message}) => (name === 'Error' ? message : name)));
second.abort(new Error('not any more'));
setTimeout(() => first.abort(), 300);
console.log((await Promise.all(plans)).join()); // AbortError,not any more,solved,DataCloneError,AbortError
console.log(Date.now() - begin < 50000); // true
worker.close();
`,
});
for (const {name, text} of files) writeFileSync(name, text);
for (const {name, text} of files.filter((file) => /js$/.test(file.name))) {
  const expected = [...text.matchAll(/console\.log\(.*\/\/ (.*)$/gm)].map(([, said]) => said);
  const printed = execFileSync('node', [name], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], timeout: 300000}).trimEnd().split('\n');
  expect(distinct(printed) === distinct(expected.length ? expected : ['']), `${name} prints\n${printed.join('\n')}\nand not\n${expected.join('\n')}`);
}
expect(existsSync('yard.svg') && /^<svg .*<polygon .*<polyline points="[-0-9., ]{200,}".*<\/svg>$/s.test(readFileSync('yard.svg', 'utf8')), 'yard.svg is no picture');
expect(files.length >= 10, `the README has only ${files.length} examples`);
process.exit(faults ? 1 : 0);
