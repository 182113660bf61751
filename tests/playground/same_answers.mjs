// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does WebAssembly plan the same paths as the command line, bit for bit? Nine scenarios, three planners; a trailer,
// somebody on foot, and a depot; masks, and a table of a site. Does it drive them alike?
// usage: node same_answers.mjs PLAYGROUND VANDPLAN [--timing]

import {execFileSync} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {basename, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';

const [playground, program] = process.argv.slice(2, 4).map((path) => resolve(path));
const timing = process.argv.includes('--timing');
const require = createRequire(import.meta.url);
const {load, InputError} = require(join(playground, 'npm/vandplan.cjs'));
const {startWorker} = require(join(playground, 'npm/worker.cjs'));
const yaml = require('/usr/share/nodejs/js-yaml/dist/js-yaml.js');
const scenarios = fileURLToPath(new URL('../../scenarios', import.meta.url));
const thesis = join(scenarios, 'thesis');
const runs = [['anytime', 300], ['rrt-opt-hlut-4', 500], ['rrt-connect', 500]];
const work = mkdtempSync(join(tmpdir(), 'vandplan-'));
const vandplan = await load();
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

/** What the command line finds: one result for each goal. */
function native(file, planner, iterations, more = []) {
  const output = join(work, 'result.json');
  try {
    execFileSync(program, ['plan', file, '--planner', planner, '--max-iterations', String(iterations), '--output', output, ...more], {stdio: 'ignore'});
  } catch (error) {
    if (error.status !== 1) throw error; // 1: no path
  }
  const result = JSON.parse(readFileSync(output, 'utf8'));
  return result.goals ?? [result];
}

const read = (file) => yaml.load(readFileSync(file, 'utf8'));

/** The lengths of a vehicle of the catalogue, or those that are given. */
function vehicleOf(given) {
  const {max_steering_angle: angle, ...vehicle} = typeof given === 'string' ? read(join(scenarios, '../vehicles', `${given}.yaml`)) : given;
  return angle ? {...vehicle, min_turning_radius: (vehicle.wheelbase * Math.cos(angle)) / Math.sin(angle)} : vehicle;
}

/** The scenario of each goal of a file, as the module takes it. */
function scenariosOf(file) {
  const {goals, options: _, ...given} = read(file);
  const scenario = {...given, vehicle: vehicleOf(given.vehicle)};
  if (!goals) return [scenario];
  return goals.map(({goal, obstacles = []}) => ({...scenario, goal, obstacles: [...scenario.obstacles, ...obstacles]}));
}

/** A path of a result file: its segments say "left" where the module says a curvature. */
function pathOf({path}, {min_turning_radius: radius}) {
  const curvatures = {left: 1 / radius, straight: 0, right: -1 / radius};
  return {
    start: path.start,
    segments: path.segments.map(({turn, curvature, length, curvature_rate = 0}) => ({curvature: turn ? curvatures[turn] : curvature, length, curvature_rate})),
  };
}

const files = readdirSync(thesis).filter((one) => one.endsWith('.yaml')).sort().map((name) => [join(thesis, name), runs]);
files.push([join(scenarios, 'trailer/turn-round-yard.yaml'), [['anytime', 6000]]]);
files.push([join(scenarios, 'moving/reversing-truck.yaml'), [['anytime', 100]]]);
files.push([join(scenarios, '../examples/depot.yaml'), [['anytime', 3000]]]); // zones, a via, a set of goals
const slim = join(work, 'slim.yaml'); // its outline makes another path than the rectangle of the same lengths would
writeFileSync(slim, `name: slim
vehicle:
  {wheelbase: 4, min_turning_radius: 6, outline: [[-1, -1.2], [5, -0.3], [5, 0.3], [-1, 1.2]], hitch: -0.8,
   trailers: [{wheelbase: 4, outline: [[-2, -0.4], [1, -1.2], [3, 0], [1, 1.2], [-2, 0.4]]}]}
bounds: {x: [-20, 40], y: [-20, 20]}
start: {x: 0, y: 0, heading: 0}
goal: {x: 24, y: 3, heading: 0}
obstacles: [[[5.1, 0.9], [12, 0.9], [12, 9], [5.1, 9]], [[5.1, -9], [12, -9], [12, -1.4], [5.1, -1.4]]]
`);
files.push([slim, [['anytime', 2000]]]);
let compared = 0;
for (const [file, its] of files) {
  const name = basename(file);
  for (const [planner, max_iterations] of its) {
    const theirs = native(file, planner, max_iterations);
    let ratio = '';
    scenariosOf(file).slice(0, 3).forEach((scenario, i) => {
      const own = vandplan.plan(scenario, {...read(file).options, planner, max_iterations, time_limit: null});
      const solved = !own.path || (own.check.valid && (own.duration > 0) === Boolean(scenario.moving));
      expect(solved, `${name}: ${own.check?.reason}, driven in ${own.duration} s`);
      const hash = own.path ? vandplan.hash(own.path) : own.status;
      const other = theirs[i].path ? vandplan.hash(pathOf(theirs[i], scenario.vehicle)) : theirs[i].status;
      expect(hash === other, `${name}, goal ${i + 1}, ${planner}: ${hash}, the command line has ${other}`);
      if (timing) ratio += ` ${(own.time / theirs[i].time.total).toFixed(1)}`;
      ++compared;
    });
    if (timing) console.log(`${name} ${planner}: time of WebAssembly by native:${ratio}`);
  }
}

// ---- driving: speeds of zones and masks, stops at vias ----

/** Rows of the module's drive that the command line does not have for the result that it wrote last. */
function otherRows(file, rows) {
  const table = execFileSync(program, ['speed', file, join(work, 'result.json'), '--output', '-'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']}).trim().split('\n');
  const columns = ['t', 's', 'x', 'y', 'heading', 'curvature', 'v'].map((name) => table[0].split(',').indexOf(name));
  const theirs = table.slice(1).map((line) => columns.map((column) => Number(line.split(',')[column])));
  const other = theirs.findIndex((row, i) => row.some((number, k) => !(Math.abs(number - rows[7 * i + k]) < 1e-9)));
  return rows.length !== 7 * theirs.length ? `${rows.length / 7} rows and not ${theirs.length}` : other < 0 ? '' : `row ${other} and not ${theirs[other]}`;
}

const depot = join(scenarios, '../examples/depot.yaml');
const [inDepot] = scenariosOf(depot);
const way = pathOf(native(depot, 'anytime', 3000)[0], inDepot.vehicle);
const obeying = vandplan.drive(way, inDepot);
expect(otherRows(depot, obeying) === '', `the drive in the depot: ${otherRows(depot, obeying)}`);
const rowsOf = (rows) => Array.from({length: rows.length / 7}, (_, i) => rows.subarray(7 * i, 7 * i + 7));
expect(rowsOf(obeying).some(([, , x, y, , , v]) => v === 0 && Math.hypot(x - 93, y - 26) < 1e-5), 'the truck stands on the weighbridge');
expect(rowsOf(obeying).every(([, , x, y, , , v]) => Math.abs(v) < 1.2 + 1e-9 || x < 48 || x > 78 || y > 20), 'it is slow on the ramp');
expect(vandplan.drive(way, inDepot.vehicle).at(-7) < obeying.at(-7) - 5, 'its own limits alone let it drive faster');

// Masks: walls, a price, and Nav2's speeds in percent; from files there, from cells here.
const [columns, rows] = [40, 30];
const percentsOf = {
  walls: (column, row) => (column >= 18 && column < 20 && row >= 10 && row < 19 ? 100 : 0),
  price: (column, row) => (column > 30 ? 255 : 3 * row),
  speed: (column) => (column >= 22 ? 70 : 0),
};
const masks = Object.entries(percentsOf).map(([name, percentAt]) => {
  const percents = Uint8Array.from({length: columns * rows}, (_, i) => percentAt(i % columns, Math.floor(i / columns)));
  const topFirst = Array.from({length: rows}, (_, row) => [...percents.subarray((rows - 1 - row) * columns, (rows - row) * columns)]).flat();
  writeFileSync(join(work, `${name}.pgm`), Buffer.concat([Buffer.from(`P5\n${columns} ${rows}\n255\n`), Buffer.from(topFirst)]));
  writeFileSync(join(work, `${name}.yaml`), `image: ${name}.pgm\nresolution: 1\norigin: [-10, -15, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: raw\n`);
  const cells = percents.map((percent) => (percent > 100 ? 2 : percent > 65 ? 1 : percent < 19.6 ? 0 : 2));
  return {map: {origin: {x: -10, y: -15, heading: 0}, resolution: 1, columns, rows, cells}, percents};
});
const masked = {
  vehicle: 'van', bounds: {x: [-10, 30], y: [-15, 15]}, start: {x: 0, y: 0, heading: 0}, goal: {x: 20, y: 2, heading: 0}, obstacles: [],
  masks: [{map: masks[0].map, as: 'obstacles'}, {...masks[1], as: 'cost', of: 4}, {...masks[2], type: 1, base: 100, multiplier: -1}],
};
const maskedFile = join(work, 'masked.yaml');
writeFileSync(maskedFile, `${yaml.dump({name: 'masked', ...masked, masks: undefined}, {skipInvalid: true})}masks:
  - {map: walls.yaml, as: obstacles}
  - {map: price.yaml, as: cost, of: 4}
  - {map: speed.yaml, type: 1, base: 100, multiplier: -1}
`);
const [amongMasks] = native(maskedFile, 'anytime', 1000);
const own = vandplan.plan(masked, {max_iterations: 1000, time_limit: null});
expect(own.check?.valid && vandplan.hash(own.path) === vandplan.hash(pathOf(amongMasks, vehicleOf('van'))), `masks: ${own.reason}`);
expect(own.path.segments.some(({curvature}) => curvature !== 0) && own.cost > own.check.length + 1, 'the walls of a mask are driven round, and metres have its price');
const amongRows = vandplan.drive(own.path, masked);
expect(otherRows(maskedFile, amongRows) === '', `the drive among masks: ${otherRows(maskedFile, amongRows)}`);
const unmasked = vandplan.yard({...masked, masks: []});
expect(unmasked.drive({path: own.path}).at(-7) < amongRows.at(-7) - 1, 'a mask limits the speed');
unmasked.close();

// A table of a site, as the command line makes it.
const siteFile = join(work, 'yard.yaml');
writeFileSync(siteFile, 'name: yard\nvehicle: two-axle-truck\nbounds: {x: [-50, 50], y: [-50, 50]}\nstart: {x: 0, y: 0, heading: 0}\n'
  + 'goal: {x: 0, y: 12, heading: 0}\nobstacles:\n  - [[-20, 5], [15, 5], [15, 7], [-20, 7]]\n');
execFileSync(program, ['table', 'site', siteFile, '--output', join(work, 'yard.vst')], {stdio: 'ignore'});
const site = readFileSync(join(work, 'yard.vst')); // a Buffer, which is a view of a part of memory
const [bySite] = native(siteFile, 'anytime', 300, ['--site', join(work, 'yard.vst')]);
const {name: _name, ...siteYard} = read(siteFile);
const withSite = {max_iterations: 300, time_limit: null, site};
const ownBySite = vandplan.plan(siteYard, withSite);
const siteHash = vandplan.hash(pathOf(bySite, vehicleOf('two-axle-truck')));
expect(vandplan.hash(ownBySite.path) === siteHash && ownBySite.anytime[0].iteration === 0, 'a plan begins with the way of the site\'s table');
expect(vandplan.plan(siteYard, {...withSite, site: null}).anytime[0].iteration > 0, 'without a table it does not');
const kept = vandplan.yard(siteYard);
for (const again of [site, site, new Uint8Array(site)]) {
  expect(vandplan.hash(kept.plan({options: {...withSite, site: again}}).path) === siteHash, 'so do many plans in a yard');
}
kept.close();
const worker = startWorker();
expect(vandplan.hash((await worker.plan(siteYard, withSite)).path) === siteHash, 'so does a worker');

// The module makes tables itself: the same bytes, also of several goals and with other options, and in a worker.
const isTable = (own, theirs, what) => expect(own instanceof Uint8Array && theirs.equals(own), `${what}: not the bytes of the command line`);
isTable(vandplan.siteTable(siteYard), site, 'a table');
const docks = [siteYard.goal, {x: -12, y: -20, heading: 1.5}];
writeFileSync(join(work, 'docks.csv'), `x,y,heading\n${docks.map(({x, y, heading}) => `${x},${y},${heading}`).join('\n')}\n`);
execFileSync(program, ['table', 'site', siteFile, '--goals', join(work, 'docks.csv'), '--set', 'margin=0.4', '--set', 'reverse_weight=3', '--headings', '24', '--cell', '0.2',
  '--output', join(work, 'docks.vst')], {stdio: 'ignore'});
const toDocks = readFileSync(join(work, 'docks.vst'));
const query = {goals: docks, options: {margin: 0.4, reverse_weight: 3}, headings: 24, cell: 0.2};
const steps = [];
isTable(vandplan.siteTable(siteYard, query, (goals) => steps.push(goals)), toDocks, 'a table of two goals');
expect(steps.join() === '1,2', `each goal is told of: ${steps}`);
const told = [];
isTable(await worker.siteTable(siteYard, query, {onProgress: (goals) => told.push(goals)}), toDocks, 'a table of a worker');
expect(told.join() === '1,2', `a worker tells of each goal: ${told}`);
const wrongGoal = await worker.siteTable(siteYard, {goals: [{x: 0, y: 6, heading: 0}]}).catch((error) => error);
expect(wrongGoal instanceof InputError && wrongGoal.where === 'goals[0]', `a worker refuses a goal in a wall: ${wrongGoal}`);
const controller = new AbortController();
const leftAlone = worker.siteTable(siteYard, {cell: 0.03, headings: 72}, {signal: controller.signal}).catch(({name}) => name);
setTimeout(() => controller.abort(), 100);
expect((await leftAlone) === 'AbortError', 'a table can be called off');
isTable(await worker.siteTable(siteYard), site, 'a table after one that was called off');
worker.close();

// A table is repaired where a truck parks and leaves again: the bytes of tables that are made anew, whatever the start.
const stands = [[8, -4], [12, -4], [12, -1], [8, -1]];
const busyYard = {...siteYard, obstacles: [...siteYard.obstacles, stands]};
const toldByIt = [];
const changing = vandplan.changingSiteTable(siteYard, query, (goals) => toldByIt.push(goals));
expect(toldByIt.join() === '1,2', `a table that changes tells of each goal: ${toldByIt}`);
const beforeTruck = changing.site;
isTable(beforeTruck, toDocks, 'a table before its first repair');
changing.repair({...busyYard, start: {x: 30.4, y: -20, heading: 1}});
isTable(changing.site, Buffer.from(vandplan.siteTable(busyYard, query)), 'a table where a truck has parked');
isTable(beforeTruck, toDocks, 'the bytes before a repair');
expect(vandplan.plan(busyYard, {...withSite, margin: 0.4, reverse_weight: 3, site: changing.site}).anytime[0].iteration === 0, 'a plan begins with the way of a repaired table');
changing.repair(siteYard);
isTable(changing.site, toDocks, 'a table where the truck has left');
refuses('problem', () => changing.repair({...siteYard, vehicle: 'van'}));
changing.close();
refuses('changingSiteTable', () => changing.site);
refuses('changingSiteTable', () => changing.repair(siteYard));

// What a table says of poses: with a heading, and with the best one.
const info = vandplan.siteInfo(toDocks);
expect(JSON.stringify(info.goals) === JSON.stringify(docks) && info.headings === 24 && Math.abs(info.cell - 0.2 * vehicleOf('two-axle-truck').min_turning_radius) < 1e-9, `a table holds ${JSON.stringify(info)}`);
expect(info.bounds.x[0] < -20 && info.bounds.x[1] > 15, `its box is ${JSON.stringify(info.bounds)}`);
const between = docks.map(({x, y, heading}) => docks.map((_, goal) => vandplan.siteCosts(toDocks, {x: [x], y: [y], heading: [heading]}, goal)[0]));
expect(between[0][0] < 2 && between[1][1] < 2 && between[0][1] > 25 && between[1][0] > 25, `from dock to dock it costs ${JSON.stringify(between)}`);
let luck = 1;
const random = (from, to) => from + (to - from) * ((luck = (luck * 16807) % 2147483647) / 2147483647);
const many = Array.from({length: 400}, () => [random(-60, 60), random(-60, 60), random(-9, 9)]);
const [xs, ys, turns] = [0, 1, 2].map((k) => many.map((pose) => pose[k]));
for (const goal of [0, 1]) {
  const best = vandplan.siteCosts(toDocks, {x: new Float32Array(xs), y: new Float64Array(ys)}, goal);
  const least = new Float64Array(many.length).fill(Infinity);
  for (let i = 0; i < 24; ++i) {
    const heading = xs.map(() => docks[goal].heading + (i * 2 * Math.PI) / 24);
    vandplan.siteCosts(toDocks, {x: new Float32Array(xs), y: ys, heading}, goal).forEach((cost, k) => (least[k] = Math.min(least[k], cost)));
  }
  expect(best.every((cost, i) => cost === least[i]), 'the best heading is the cheapest of all');
  expect(best.some(Number.isFinite) && best.some((cost) => cost === Infinity), 'some places are known, some lie outside');
}
const costs = vandplan.siteCosts(site, {x: [0, 0, NaN, 900], y: [12, 6, 0, 0], heading: [0, 0, 0, 0]});
expect(costs[0] < 1 && costs.subarray(1).every((cost) => cost === Infinity), `at the goal, in a wall, nowhere, outside: ${costs}`);
const plain = vandplan.yard(siteYard);
const ratios = [];
many.forEach(([x, y, heading], i) => {
  const start = {x: 0.6 * x, y: 0.5 * y, heading};
  if (i >= 60 || !plain.isFree({pose: start})) return;
  const [cost] = vandplan.siteCosts(site, {x: [start.x], y: [start.y], heading: [heading]});
  const {cost: found} = plain.plan({start, options: {max_iterations: 1000, time_limit: null, steering: 'reeds-shepp'}});
  if (found !== null && Number.isFinite(cost)) ratios.push(cost / found);
});
plain.close();
const sorted = [...ratios].sort((a, b) => a - b);
expect(ratios.length > 20 && Math.abs(sorted[sorted.length >> 1] - 1) < 0.1 && sorted[0] > 0.7 && sorted.at(-1) < 1.5, `costs are about those of paths: ${sorted.map((one) => one.toFixed(2))}`);
rmSync(work, {recursive: true});

// ---- what the module promises besides ----

const truck = {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, min_turning_radius: 7};
const yard = {vehicle: truck, bounds: {x: [-50, 50], y: [-50, 50]}, start: {x: 0, y: 0, heading: 0}, goal: {x: 0, y: 12, heading: 0},
  obstacles: [[[-20, 5], [15, 5], [15, 7], [-20, 7]]]};

function refuses(where, act) {
  try {
    act();
    expect(false, `${where} is not refused`);
  } catch (error) {
    expect(error instanceof InputError && error.where === where, `${where}: ${error.where ?? error.stack}`);
  }
}
refuses('wals', () => vandplan.plan({...yard, wals: []}));
refuses('vehicle.width', () => vandplan.plan({...yard, vehicle: {...truck, width: '2'}}));
refuses('goal.heading', () => vandplan.plan({...yard, goal: {x: 1, y: 1}}));
refuses('obstacles[0]', () => vandplan.plan({...yard, obstacles: [[[0, 9], [1, 10], [0, 10], [1, 9]]]}));
refuses('margin', () => vandplan.plan(yard, {margin: -1}));
refuses('start.hitch_angles', () => vandplan.plan({...yard, start: {...yard.start, hitch_angles: [0.1]}}));
refuses('goal.trailer', () => vandplan.plan({...yard, goal: {trailer: {x: 0, y: 0, heading: 0}}}));
refuses('moving[0].trajectory[0]', () => vandplan.plan({...yard, moving: [{outline: [[0, 0], [1, 0], [0, 1]], trajectory: [[0, 1]]}]}));
refuses('vehicle.outline', () => vandplan.plan({...yard, vehicle: {...truck, outline: [[-1, -1], [5, 0], [-1, 1], [1, 0]]}}));
refuses('vehicle.outline', () => vandplan.plan({...yard, vehicle: {wheelbase: 4, min_turning_radius: 6, outline: []}}));
refuses('map.cells', () => vandplan.plan({...yard, map: {origin: {x: 0, y: 0, heading: 0}, resolution: 1, columns: 2, rows: 2, cells: new Uint8Array(3)}}));
for (const wrong of ['yard.vst', new Uint8Array(200), site.subarray(0, 5000), 7]) refuses('site', () => vandplan.plan(siteYard, {...withSite, site: wrong}));
refuses('site', () => vandplan.plan({...siteYard, vehicle: 'van'}, withSite));
refuses('site', () => vandplan.plan(siteYard, {...withSite, planner: 'prm'}));
refuses('goals', () => vandplan.siteTable(siteYard, {goals: []}));
refuses('goals[1].heading', () => vandplan.siteTable(siteYard, {goals: [siteYard.goal, {x: 1, y: 2}]}));
refuses('goals', () => vandplan.siteTable({...siteYard, goal: {...siteYard.goal, heading: 'any'}}));
for (const headings of [7, 9.5, 1e9, NaN]) refuses('headings', () => vandplan.siteTable(siteYard, {headings}));
refuses('cell', () => vandplan.siteTable(siteYard, {cell: 2}));
refuses('margn', () => vandplan.siteTable(siteYard, {options: {margn: 1}}));
refuses('query.margin', () => vandplan.siteTable(siteYard, {margin: 1}));
refuses('moving', () => vandplan.siteTable({...siteYard, moving: [{outline: [[0, 0], [1, 0], [0, 1]], trajectory: [[0, 40, 40, 0]]}]}));
for (const goal of [1, -1, 0.5, NaN]) refuses('goal', () => vandplan.siteCosts(site, {x: [0], y: [0]}, goal));
refuses('poses', () => vandplan.siteCosts(site, {x: [0], y: [0, 1]}));
refuses('poses', () => vandplan.siteCosts(site, {x: [0], y: [0], heading: []}));
for (const x of [undefined, 7, 'x'.length]) refuses('poses.x', () => vandplan.siteCosts(site, {x, y: [0]}));
refuses('site', () => vandplan.siteInfo(site.subarray(0, 5000)));
refuses('site', () => vandplan.siteCosts('yard.vst', {x: [0], y: [0]}));
const [walls, price] = masked.masks;
refuses('masks[0].as', () => vandplan.plan({...masked, masks: [{...walls, as: 'walls'}]}));
refuses('masks[0].as', () => vandplan.plan({...masked, masks: [{map: walls.map}]}));
refuses('masks[1].of', () => vandplan.plan({...masked, masks: [walls, {...price, of: undefined}]}));
refuses('masks[0].type', () => vandplan.plan({...masked, masks: [{map: walls.map, type: 3}]}));
refuses('masks[0].as', () => vandplan.plan({...masked, masks: [{...walls, type: 0}]}));
refuses('masks[0].map.cells', () => vandplan.plan({...masked, masks: [{...walls, map: {...walls.map, rows: 7}}]}));
refuses('masks[0].map.resolution', () => vandplan.plan({...masked, masks: [{...walls, map: {...walls.map, resolution: 0}}]}));
refuses('step', () => vandplan.drive(way, inDepot, 0));
refuses('path', () => vandplan.drive(null, inDepot));

refuses('vehicle', () => vandplan.plan({...yard, vehicle: 'lorry'}));

const planned = vandplan.plan(yard, {max_iterations: 500, time_limit: null, margin: 0.3});
expect(planned.check.valid && planned.check.clearance >= 0.3, 'the margin is kept');
expect(vandplan.check(yard, planned.path, {margin: 0.2, steering: planned.steering}).valid, 'the judge accepts the path');
expect(!vandplan.check({...yard, obstacles: [[[-1, -1], [1, -1], [1, 1]]]}, planned.path).valid, 'the judge sees another obstacle');
const ahead = vandplan.plan(yard, {max_iterations: 2000, time_limit: null, gears: 'forward'});
expect(ahead.path.segments.every(({length}) => length >= 0), 'a path in one gear');
expect(!vandplan.check(yard, ahead.path, {steering: ahead.steering, gears: 'reverse'}).valid, 'the judge knows gears');
refuses('gears', () => vandplan.plan(yard, {gears: 'first'}));
const anyway = {...yard, goal: {any_of: [{x: 500, y: 0, heading: 0}, {...yard.goal, heading: 'any'}]}};
const turned = vandplan.plan(anyway, {max_iterations: 2000, time_limit: null});
expect(turned.goal.index === 1 && turned.goal.x === yard.goal.x, 'a set of goals');
expect(turned.cost <= 1.01 * vandplan.plan(yard, {max_iterations: 2000, time_limit: null}).cost, 'any heading is no dearer than one');
expect(vandplan.plan(yard, {max_iterations: 500, time_limit: null}).goal === null, 'a pose is no set');
refuses('goal.any_of', () => vandplan.plan({...yard, goal: {any_of: []}}));
refuses('goal.x', () => vandplan.plan({...yard, goal: {x: [2, 1], y: 0, heading: 'any'}}));
refuses('goal.heading', () => vandplan.plan({...yard, goal: {x: [1, 2], y: 0}}));
const from = {x: 1, y: 4, heading: 0.4};
const nodes = {x: new Float32Array([1]), y: new Float32Array([4]), heading: new Float32Array([0.4])};
const exact = vandplan.steer(from, {x: 0, y: 0, heading: 0}, 7).reduce((sum, {length}) => sum + Math.abs(length), 0);
const [length] = vandplan.distances('reeds-shepp', nodes, {x: 0, y: 0, heading: 0}, 7);
expect(Math.abs(length - exact) < 1e-3, `length ${length} of a path of ${exact}`);
const [words] = vandplan.words(from, {x: 0, y: 0, heading: 0}, 7);
expect(Math.abs(words.reduce((sum, {length: l}) => sum + Math.abs(l), 0) - exact) < 1e-9, 'the shortest word is the shortest path');
expect(Math.abs(vandplan.distances('euclid', nodes, {x: 0, y: 0, heading: 0}, 7)[0] - Math.hypot(1, 4)) < 1e-6, 'Euclid');
const [table] = vandplan.distances('hlut-4', nodes, {x: 0, y: 0, heading: 0}, 7);
expect(table > 0 && Math.abs(table - exact) < 3, `the table says ${table}, the exact length is ${exact}`);
const drive = vandplan.drive(planned.path, truck);
expect(drive.length % 7 === 0 && Math.abs(drive.at(-6) - planned.check.length) < 1e-6, 'the drive ends at the end of the path');

// A vehicle may have a name, and an angle of its wheels in place of the radius.
const few = {max_iterations: 200, time_limit: null};
const hashWith = (vehicle, one = vandplan) => one.hash(one.plan({...yard, vehicle}, few).path);
const angle = Math.atan2(truck.wheelbase, truck.min_turning_radius);
expect(vandplan.vehicles().includes('van'), 'the names of vehicles');
expect(hashWith('van') === hashWith(yaml.load(readFileSync(join(scenarios, '../vehicles/van.yaml'), 'utf8'))), 'a name stands for the lengths');
const {min_turning_radius: _, ...lengths} = truck;
const byAngle = vandplan.plan({...yard, vehicle: {...lengths, max_steering_angle: angle}}, few);
expect(vandplan.check(yard, byAngle.path).valid, 'an angle of the wheels stands for the radius');
// Prices that are not set fit the vehicle.
const byDriver = vandplan.prices('driver', truck);
expect(byDriver.gear_change_cost === 5 && vandplan.prices('driver', {...truck, min_turning_radius: 3.5}).gear_change_cost === 2.5, 'a driver\'s prices');
expect(vandplan.prices('shortest', 'van').gear_change_cost === 0, 'no prices by length');
// What is in the way of the goal is named by its number.
const wall = [[-60, -1], [-50, -1], [-50, 1], [-60, 1]];
const around = ({goal: {x, y}}) => [[x - 1, y - 1], [x + 1, y - 1], [x + 1, y + 1], [x - 1, y + 1]];
const {status: refused, hit} = vandplan.plan({...yard, obstacles: [wall, around(yard)]}, few);
expect(refused === 'goal_in_collision' && hit.what === 'obstacles' && hit.index === 1, `the goal hits ${JSON.stringify(hit)}`);
expect(vandplan.check({...yard, obstacles: [wall, around(yard)]}, byAngle.path).hit.index === 1, 'so does a path to it');
expect(byAngle.hit === null && byAngle.check.hit === null, 'nothing is hit where there is a path');
// The module for pages runs in Node, too.
const {load: loadModule} = await import(pathToFileURL(join(playground, 'npm/vandplan.mjs')));
expect(hashWith(truck, await loadModule()) === hashWith(truck), 'both modules plan the same path');

// A trailer follows: its axle stays as far from the hitch as it is, and what a path of many arcs does, its arcs do.
const rig = {...truck, hitch: -1.6, max_hitch_angle: 0.9, trailers: [{wheelbase: 5.8, front_overhang: -1, rear_overhang: 3.6, width: 2.55}]};
const arc = {start: {x: 0, y: 0, heading: 0}, segments: [{curvature: 0.1, length: 6}]};
const [places, trailer] = [vandplan.sample(arc, 0.5), vandplan.trailer(arc, rig, 0.2, 0.5)];
expect(trailer.length / 3 === places.length / 6, 'a place of the trailer for each of the vehicle');
for (let i = 0; 6 * i < places.length; ++i) {
  const [, x, y, heading] = places.slice(6 * i);
  const off = Math.hypot(x - 1.6 * Math.cos(heading) - trailer[3 * i], y - 1.6 * Math.sin(heading) - trailer[3 * i + 1]);
  expect(Math.abs(off - 5.8) < 1e-9, `the axle of the trailer is ${off} m from the hitch`);
}
const there = vandplan.advance({x: 0, y: 0, heading: 0, hitch_angles: [0.2]}, rig, {curvature: 0.1, length: 6});
expect(Math.abs(there.heading - there.hitch_angles[0] - trailer.at(-1)) < 1e-9, 'the trailer ends as it stands after the arc');

console.log(`${compared} paths compared, ${faults} faults`);
process.exit(faults ? 1 : 0);
