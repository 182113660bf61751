// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Do the types fit the module, and does each function have a description? Programs that import and require it compile.
// usage: node types.mjs TYPESCRIPT    in the folder of a project that has the package

import {writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';

const require = createRequire(`${process.cwd()}/`);
const ts = require(process.argv[2]);
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

// ---- programs ----

const program = (line) => `${line}
const scenario: Scenario = {vehicle: 'two-axle-truck', bounds: {x: [-50, 50], y: [-50, 50]}, start: {x: 0, y: 0, heading: 0}, goal: {x: 0, y: 12, heading: 'any'}};
async function main(): Promise<number> {
  const vandplan = await load();
  const result: Result = await startWorker().plan(scenario, {margin: 0.2}, {onProgress: ({cost}) => cost, signal: new AbortController().signal});
  // @ts-expect-error
  vandplan.plan({...scenario, wals: []});
  const map = {origin: scenario.start, resolution: 1, columns: 1, rows: 1, cells: new Uint8Array(1)};
  const masks: Mask[] = [{map, as: 'cost', of: 2}, {map, type: 1, base: 100, multiplier: -1, percents: new Uint8Array(1)}];
  // @ts-expect-error
  masks.push({map, as: 'walls'});
  vandplan.plan({...scenario, masks}, {site: new Uint8Array(1)});
  const site = await startWorker().siteTable(scenario, {goals: [scenario.start], options: {margin: 0.2}}, {onProgress: (goals) => goals.toFixed()});
  const [cost] = vandplan.siteCosts(site, {x: [0], y: new Float32Array(1)}, vandplan.siteInfo(vandplan.yard(scenario).siteTable({cell: 0.2})).goals.length);
  const docks: ChangingSiteTable = vandplan.changingSiteTable(scenario, {headings: 24}, (goals) => goals.toFixed());
  docks.repair(scenario);
  vandplan.plan(scenario, {site: docks.site});
  // @ts-expect-error
  docks.site = site;
  docks.close();
  // @ts-expect-error
  vandplan.siteTable(scenario, {margin: 0.2});
  if (result.path) vandplan.drive(result.path, scenario).subarray(vandplan.drive(result.path, 'van', 0.1).length);
  // @ts-expect-error
  const none: number = result.cost;
  return result.path ? vandplan.check(scenario, result.path).length + (cost ?? 0) : new InputError({where: 'a', problem: 'b'}).where.length;
}
main();
`;
const imports = `import {InputError, load, type ChangingSiteTable, type Mask, type Result, type Scenario} from 'vandplan';\nimport {startWorker} from 'vandplan/worker';`;
writeFileSync('imports.mts', program(imports));
writeFileSync('requires.cts', program(imports));
const {ModuleKind, ModuleResolutionKind, ScriptTarget} = ts;
const strict = {strict: true, noEmit: true, target: ScriptTarget.ES2022, lib: ['lib.es2022.d.ts', 'lib.dom.d.ts'], types: [], exactOptionalPropertyTypes: true};
const ways = [
  {module: ModuleKind.Node16, moduleResolution: ModuleResolutionKind.Node16},
  {module: ModuleKind.ESNext, moduleResolution: ModuleResolutionKind.Bundler},
];
let types = null;
for (const [i, way] of ways.entries()) {
  const files = i ? ['imports.mts'] : ['imports.mts', 'requires.cts'];
  types = ts.createProgram(files, {...strict, ...way});
  for (const {messageText, file, start} of ts.getPreEmitDiagnostics(types)) {
    const line = file ? file.getLineAndCharacterOfPosition(start).line + 1 : 0;
    expect(false, `${file?.fileName}:${line}: ${ts.flattenDiagnosticMessageText(messageText, '\n')}`);
  }
}

// ---- descriptions ----

/** Members of the interfaces that the module's objects have, by interface. */
const members = {};
const isDescribed = (node) => ts.getJSDocCommentsAndTags(node).some(({comment}) => comment?.length > 5);
const isFunction = (node) => ts.isMethodSignature(node) || ts.isFunctionDeclaration(node) || node.type?.kind === ts.SyntaxKind.FunctionType;
const declarations = types.getSourceFiles().filter(({fileName}) => /vandplan\/\w+\.d\.mts$/.test(fileName));
expect(declarations.length === 2, `types are in ${declarations.map(({fileName}) => fileName)}`);
for (const file of declarations) {
  for (const node of file.statements.filter((one) => one.name)) {
    expect(isDescribed(node), `${node.name.text} has no description`);
    for (const member of node.members ?? []) {
      if (isFunction(member)) expect(isDescribed(member), `${node.name.text}.${member.name?.text} has no description`);
      if (ts.isInterfaceDeclaration(node)) (members[node.name.text] ??= []).push(member.name?.text);
    }
  }
}
const vandplan = await require('vandplan').load();
const named = (object) => Object.keys(object).sort().join(' ');
expect(named(vandplan) === members.Vandplan.sort().join(' '), `the module has ${named(vandplan)}, its types ${members.Vandplan}`);
const result = vandplan.plan({vehicle: 'two-axle-truck', bounds: {x: [-9, 9], y: [-9, 9]}, start: {x: 0, y: 0, heading: 0}, goal: {x: 5, y: 0, heading: 0}}, {max_iterations: 1});
const site = vandplan.siteTable({vehicle: 'van', bounds: {x: [-9, 9], y: [-9, 9]}, start: {x: 0, y: 0, heading: 0}, goal: {x: 5, y: 0, heading: 0}}, {cell: 0.5});
for (const [type, object] of [['SiteInfo', vandplan.siteInfo(site)], ['Result', result], ['Check', result.check], ['Prices', vandplan.prices('driver', 'two-axle-truck')], ['PlannerInfo', vandplan.planners()[0]]]) {
  expect(named(object) === members[type].sort().join(' '), `${type} has ${named(object)}, its type ${members[type]}`);
}
process.exit(faults ? 1 : 0);
