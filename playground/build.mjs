// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Puts the page together, one file that opens from disk, and the folder npm, which `npm pack` packs.
// usage: node playground/build.mjs CORE.js FOLDER    (beside CORE.js lies CORE.wasm)

import {execFileSync} from 'node:child_process';
import {copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';

const yamlModule = '/usr/share/nodejs/js-yaml/dist/js-yaml.mjs';
const yaml = createRequire(import.meta.url)('/usr/share/nodejs/js-yaml/dist/js-yaml.js');
const here = fileURLToPath(new URL('.', import.meta.url));
const root = join(here, '..');
const web = join(root, 'bindings/web');
const [core, output] = process.argv.slice(2).map((path) => resolve(path));
const work = join(output, '.work');
const npm = join(output, 'npm');

const filesOf = (folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith('.yaml')).sort().map((name) => join(root, folder, name));
const titled = (name) => name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ');

/** Vehicles and scenarios, as a module. */
function catalogue() {
  const vehicles = Object.fromEntries(filesOf('vehicles').map((file) => [basename(file, '.yaml'), yaml.load(readFileSync(file, 'utf8'))]));
  const scenarios = ['docks', 'street', 'dead-end', 'container-stacks', 'bus-depot', 'ferry-lane'].map((name) => ({
    group: 'Yards by the Vändplan authors (BSD-3-Clause)', label: titled(name), name: `${name}.yaml`, text: readFileSync(join(here, 'yards', `${name}.yaml`), 'utf8'),
  }));
  const depot = readFileSync(join(root, 'examples/depot.yaml'), 'utf8');
  scenarios.push({group: scenarios[0].group, label: 'Depot', name: 'depot.yaml', text: depot});
  const shared = [['thesis', 'Thesis', 'Scenarios of the thesis'], ['trailer', 'Trailer', 'With a trailer'], ['moving', 'Moving', 'Among what moves']];
  for (const [folder, label, group] of shared) {
    for (const file of filesOf(`scenarios/${folder}`)) {
      const name = basename(file, '.yaml');
      const text = readFileSync(file, 'utf8');
      scenarios.push({group, label: `${label}: ${name.replaceAll('-', ' ')}`, name: `${name}.yaml`, text, ...(/^goals:/m.test(text) ? {goal: 2} : {})});
    }
  }
  return `export const vehicles = ${JSON.stringify(vehicles)};\nexport const scenarios = ${JSON.stringify(scenarios)};\n`;
}

const aliases = {
  catalogue: join(work, 'catalogue.js'), 'js-yaml': yamlModule, 'vandplan-core.js': core, 'vandplan-core.wasm.gz': join(work, 'core.wasm.gz'), vandplan: join(web, 'vandplan.mjs'),
};

function bundle(entry, to, ...how) {
  execFileSync('esbuild', [
    entry, '--bundle', '--minify', '--charset=utf8', '--target=es2022', `--outfile=${to}`, '--log-level=warning', '--loader:.gz=binary',
    ...Object.entries(aliases).map(([from, file]) => `--alias:${from}=${file}`), ...how,
  ], {stdio: 'inherit'});
}

rmSync(npm, {recursive: true, force: true});
mkdirSync(work, {recursive: true});
mkdirSync(npm);
writeFileSync(join(work, 'catalogue.js'), catalogue());
writeFileSync(join(work, 'core.wasm.gz'), gzipSync(readFileSync(core.replace(/js$/, 'wasm')), {level: 9}));

// Without `process` the core takes no part of Node for granted: what it needs is in browsers and in Node.
const anywhere = ['--platform=browser', '--external:fs', '--external:path', '--define:process=undefined'];

// ---- the package for npm ----

/** A module of the package, which loads the others at run time. `threads`: those of 'browser' or of 'node'. */
const part = (name, to, threads, ...how) =>
  bundle(join(web, name), join(npm, to), '--external:./*.mjs', `--alias:threads=${join(web, `threads_${threads}.js`)}`, ...how);
const node = ['--format=esm', '--platform=node'];
const required = [
  '--format=cjs', '--platform=node', '--define:import.meta.url=here', '--banner:js=const here = require("node:url").pathToFileURL(__filename);',
];
part('core.mjs', 'core.mjs', 'browser', '--format=esm', ...anywhere);
part('vandplan.mjs', 'vandplan.mjs', 'browser', '--format=esm');
part('vandplan.mjs', 'vandplan.cjs', 'node', ...required);
part('worker.mjs', 'worker.mjs', 'browser', '--format=esm');
part('worker.mjs', 'worker.node.mjs', 'node', ...node);
part('worker.mjs', 'worker.cjs', 'node', ...required);
part('thread.mjs', 'thread.mjs', 'browser', '--format=esm');
part('thread.mjs', 'thread.node.mjs', 'node', ...node);
const worker = readFileSync(join(npm, 'worker.cjs'), 'utf8');
writeFileSync(join(npm, 'worker.cjs'), worker.replace('"./vandplan.mjs"', '"./vandplan.cjs"'));
for (const name of ['vandplan', 'worker']) {
  for (const kind of ['mts', 'cts']) copyFileSync(join(web, `${name}.d.ts`), join(npm, `${name}.d.${kind}`));
}
copyFileSync(join(web, 'README.md'), join(npm, 'README.md'));
copyFileSync(join(root, 'LICENSE'), join(npm, 'LICENSE'));
const [, version] = readFileSync(join(root, 'CMakeLists.txt'), 'utf8').match(/project\(vandplan VERSION ([0-9.]+)/);
const {name, ...fields} = JSON.parse(readFileSync(join(web, 'package.json'), 'utf8'));
writeFileSync(join(npm, 'package.json'), `${JSON.stringify({name, version, ...fields}, null, 2)}\n`);

// ---- the page ----

bundle(join(here, 'main.js'), join(work, 'page.js'), '--format=iife', ...anywhere);

// What stands in a script of HTML must not end it.
const script = readFileSync(join(work, 'page.js'), 'utf8').replaceAll(/<(?=\/script|!--|script)/gi, '\\x3C');
const page = readFileSync(join(here, 'index.html'), 'utf8')
  .replace('/*STYLE*/', () => readFileSync(join(here, 'style.css'), 'utf8'))
  .replace('/*SCRIPT*/', () => script);
writeFileSync(join(output, 'index.html'), page);
rmSync(work, {recursive: true});
