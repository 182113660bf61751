// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Puts the page together: one file that opens from disk, and the module for other pages and for Node.
// usage: node playground/build.mjs CORE.js FOLDER

import {execFileSync} from 'node:child_process';
import {mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync, copyFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {basename, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const yamlModule = '/usr/share/nodejs/js-yaml/dist/js-yaml.mjs';
const yaml = createRequire(import.meta.url)('/usr/share/nodejs/js-yaml/dist/js-yaml.js');
const here = fileURLToPath(new URL('.', import.meta.url));
const root = join(here, '..');
const [core, output] = process.argv.slice(2).map((path) => resolve(path));
const work = join(output, '.work');

const filesOf = (folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith('.yaml')).sort().map((name) => join(root, folder, name));
const titled = (name) => name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ');

/** Vehicles and scenarios, as a module. */
function catalogue() {
  const vehicles = Object.fromEntries(filesOf('vehicles').map((file) => [basename(file, '.yaml'), yaml.load(readFileSync(file, 'utf8'))]));
  const scenarios = ['docks', 'street', 'dead-end', 'container-stacks', 'bus-depot', 'ferry-lane'].map((name) => ({
    group: 'Yards by the Vändplan authors (BSD-3-Clause)', label: titled(name), name: `${name}.yaml`, text: readFileSync(join(here, 'yards', `${name}.yaml`), 'utf8'),
  }));
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

function bundle(entry, to, format, more = []) {
  execFileSync('esbuild', [
    entry, '--bundle', '--minify', '--charset=utf8', '--target=es2022', `--format=${format}`, `--outfile=${to}`, '--log-level=warning',
    `--alias:vandplan-core=${core}`, `--alias:vandplan=${join(root, 'bindings/web/vandplan.js')}`,
    `--alias:catalogue=${join(work, 'catalogue.js')}`, `--alias:js-yaml=${yamlModule}`, ...more,
  ], {stdio: 'inherit'});
}

mkdirSync(work, {recursive: true});
writeFileSync(join(work, 'catalogue.js'), catalogue());
// Without `process` the core takes no part of Node for granted: what it needs is in browsers and in Node.
const browsers = ['--platform=browser', '--external:fs', '--external:path', '--define:process=undefined'];
bundle(join(here, 'main.js'), join(work, 'page.js'), 'iife', browsers);
bundle(join(root, 'bindings/web/vandplan.js'), join(output, 'vandplan.mjs'), 'esm', browsers);
bundle(join(root, 'bindings/web/vandplan.js'), join(output, 'vandplan.cjs'), 'cjs', ['--platform=node']);
copyFileSync(join(root, 'bindings/web/vandplan.d.ts'), join(output, 'vandplan.d.ts'));

// What stands in a script of HTML must not end it.
const script = readFileSync(join(work, 'page.js'), 'utf8').replaceAll(/<(?=\/script|!--|script)/gi, '\\x3C');
const page = readFileSync(join(here, 'index.html'), 'utf8')
  .replace('/*STYLE*/', () => readFileSync(join(here, 'style.css'), 'utf8'))
  .replace('/*SCRIPT*/', () => script);
writeFileSync(join(output, 'index.html'), page);
rmSync(work, {recursive: true});
