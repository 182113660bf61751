// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Zones, vias, and goals that are more than a pose: are they read, drawn, edited, planned for, and saved as they were?

import {createRequire} from 'node:module';

const yaml = createRequire(import.meta.url)('/usr/share/nodejs/js-yaml/dist/js-yaml.js');

const open = 'vehicle: van\nbounds: {x: [-40, 60], y: [-40, 40]}\nstart: {x: 0, y: 0, heading: 0}\nobstacles: []\n';
const square = (x, y, side) => `[[${x}, ${y}], [${x + side}, ${y}], [${x + side}, ${y + side}], [${x}, ${y + side}]]`;

/** Every key of the file that stands in a scenario for goals, vias and zones. */
const everything = `name: everything
${open}via:
  - {x: 10, y: [-1, 1], heading: any}
  - {any_of: [{x: 16, y: 3, heading: [-0.5, 0.25]}, {x: 16, y: -3, heading: 0.1, either_way: true}], stop: true}
goal:
  any_of:
    - {x: 30, y: 10.123456789, heading: 1.4, straight: 3}
    - {area: ${square(34, 5, 4)}, heading: any, curvature: 0.05}
    - {x: [40, 42], y: 6, heading: [1.2, 1.9], straight: 2.5}
zones:
  - {name: pond, area: ${square(-30, -30, 10)}, closed: true, body: true}
  - {name: lane, area: ${square(5, -4, 8)}, direction: [5.6, 6.9], cost: 1.7, max_speed: 1.25}
  - {area: ${square(20, 10, 6)}, gears: forward, body: false}
origin: {longitude: 11.9, latitude: 57.7}
`;

const rig = `name: rig
vehicle: tractor-semitrailer
bounds: {x: [-60, 60], y: [-60, 60]}
start: {x: 0, y: 0, heading: 0, hitch_angles: [0.1]}
goal: {trailer: {x: [20, 24], y: 3, heading: 0, either_way: true}, hitch_angles: [[-0.1, 0.1]]}
obstacles: []
`;

/** `help`: {expect, found, click, choose, dropped, picture, touch} of the test that opens the page. */
export async function takesGoalsAndZones(page, help) {
  await losesNothing(page, help);
  await drawsZones(page, help);
  await keepsToZones(page, help);
  await passesVias(page, help);
  await choosesDocks(page, help);
  await endsStraight(page, help);
}

const drop = async (page, {dropped}, name, text) => {
  await dropped(page, `${name}.yaml`, JSON.stringify(text));
  await page.until(`vandplanPage.scene.name === "${name}"`);
};

/** What the page saves of the scene that it shows. */
const saved = (page, click) => page.value(`(() => { const make = URL.createObjectURL; let blob; URL.createObjectURL = (one) => { blob = one; return make.call(URL, one); };
  document.getElementById('save').click(); URL.createObjectURL = make; return blob.text(); })()`);

/** A file is saved with all that it said; a link, too. */
async function losesNothing(page, help) {
  for (const text of [everything, rig]) {
    const document = yaml.load(text);
    await drop(page, help, document.name, text);
    const again = yaml.load(await saved(page));
    const reads = (value) => JSON.stringify(value, (_, one) => (one && typeof one === 'object' && !Array.isArray(one) ? Object.fromEntries(Object.entries(one).sort()) : one));
    for (const key of ['via', 'goal', 'zones', 'origin', 'start']) {
      help.expect(reads(again[key]) === reads(document[key]), `${document.name} is saved with ${key}: ${reads(again[key])}`);
    }
  }
  await drop(page, help, 'everything', everything);
  await help.found(page);
  help.expect(await page.value('vandplanPage.result.via.length === 2 && vandplanPage.result.check.valid'), 'the path passes both vias');
  await help.picture(page, 'desk-everything');
}

/** The colour of a place of the yard. */
const colourAt = (page, x, y) => page.value(`(() => { const p = vandplanPage, [u, v] = p.view.toPage([${x}, ${y}]).map((one) => Math.round(one * p.view.ratio));
  p.editor.select(null); p.drawn(true); return [...p.context.getImageData(u, v, 1, 1).data].slice(0, 3); })()`);
const apart = (a, b) => Math.max(...a.map((one, i) => Math.abs(one - b[i])));

async function drawsZones(page, help) {
  const paper = await colourAt(page, -13.4, -13.4);
  help.expect(apart(await colourAt(page, 24.6, 14.6), paper) > 8, 'a zone is tinted');
  help.expect(apart(await colourAt(page, -26.6, -27.6), paper) > 50, 'a closed one like a wall');
  const arrow = async () => {
    const shades = [];
    for (let x = 7; x < 11; x += 0.25) shades.push(apart(await colourAt(page, x, 0.3), paper));
    return Math.max(...shades);
  };
  await page.value('vandplanPage.shown = null');
  help.expect((await arrow()) > 60, 'one that is one-way has an arrow');
  await page.value('vandplanPage.scene.zones = []; vandplanPage.changed("ground"); vandplanPage.dirty = false; vandplanPage.shown = null');
  help.expect(apart(await colourAt(page, 24.6, 14.6), paper) < 4, 'no zone, no tint');
}

/** Where an item is on the page. */
const middleOf = (page, expression) => page.value(`(() => { const p = vandplanPage, c = ${expression}; return p.view.toPage([0, 1].map((k) => c.reduce((sum, one) => sum + one[k], 0) / c.length)); })()`);
const onPage = (page, x, y) => page.value(`vandplanPage.view.toPage([${x}, ${y}])`);
const set = (page, id, value, event = 'change') => page.value(`(() => { const s = document.getElementById('${id}'); s[s.type === 'checkbox' ? 'checked' : 'value'] = ${JSON.stringify(value)}; s.dispatchEvent(new Event('${event}')); })()`);

const straightOn = `name: straight on\n${open}goal: {x: 30, y: 0, heading: 0}\n`;

/** A zone that is drawn by hand is driven round once it is closed; it can be undone, and saved. */
async function keepsToZones(page, help) {
  await drop(page, help, 'straight on', straightOn);
  await help.found(page);
  const direct = await page.value('vandplanPage.result.check.length');
  await help.click(page, 'add-zone');
  await page.until('vandplanPage.scene.zones.length === 1 && !document.getElementById("chosen").hidden');
  const centre = await middleOf(page, 'p.scene.zones[0].area');
  await page.drag(centre, await onPage(page, 15, 2));
  const corner = await page.value('vandplanPage.view.toPage(vandplanPage.scene.zones[0].area[0])');
  await page.drag(corner, await onPage(page, 8, -6));
  const [x, y] = await page.value('vandplanPage.scene.zones[0].area[0]');
  help.expect(Math.hypot(x - 8, y + 6) < 0.3, `its corner follows the mouse: ${x}, ${y}`);
  await set(page, 'zone-way', 'closed');
  await help.found(page);
  await page.until(`vandplanPage.result?.path && vandplanPage.result.check.length > ${direct} + 0.3`);
  help.expect(/closed: true/.test(await saved(page)), 'the closed zone is saved');
  await help.picture(page, 'desk-zone');
  await set(page, 'zone-way', 'one');
  await set(page, 'zone-heading', 180, 'input');
  await help.found(page);
  const [from, to] = await page.value('vandplanPage.scene.zones[0].direction');
  help.expect(Math.abs(Math.abs((from + to) / 2) - Math.PI) < 0.01, `the arrow is turned: ${from} to ${to}`);
  await page.until(`vandplanPage.result?.path && vandplanPage.result.check.length > ${direct} + 0.3`);
  const panned = await page.value('vandplanPage.view.x');
  await page.value('vandplanPage.editor.select(null)');
  const [u, v] = await middleOf(page, 'p.scene.zones[0].area');
  await page.drag([u, v], [u + 40, v]);
  help.expect((await page.value('vandplanPage.view.x')) !== panned && (await page.value('vandplanPage.editor.selected')) === null, 'the view is dragged on a zone that is not selected');
  await page.drag([u + 40, v], [u, v]);
  await page.mouse('mousePressed', [u, v], {buttons: 1});
  await page.mouse('mouseReleased', [u, v]);
  help.expect((await page.value('vandplanPage.editor.selected?.kind')) === 'zones', 'a click selects it');
  await page.key('Delete');
  await help.found(page);
  help.expect((await page.value('vandplanPage.scene.zones.length')) === 0, 'Delete removes it');
  await help.click(page, 'undo');
  help.expect((await page.value('vandplanPage.scene.zones.length')) === 1, 'undo brings it back');
}

/** A via that is drawn by hand is passed. */
async function passesVias(page, help) {
  await drop(page, help, 'straight on', straightOn);
  await help.click(page, 'add-via');
  const pose = () => page.value('(({x, y}) => [x, y])(vandplanPage.scene.via[0])');
  const at = await page.value('(() => { const p = vandplanPage, v = p.scene.vehicle, {x, y} = p.scene.via[0]; return p.view.toPage([x + v.wheelbase / 2, y]); })()');
  const [fromX, fromY] = await pose();
  const scale = await page.value('vandplanPage.view.scale');
  await page.drag(at, [at[0], at[1] - 10 * scale]);
  const [x, y] = await pose();
  help.expect(Math.abs(x - fromX) < 0.2 && Math.abs(y - fromY - 10) < 0.3, `the via follows the mouse: ${x}, ${y}`);
  const passes = `vandplanPage.result?.path && vandplanPage.result.via.length === 1 && Math.hypot(vandplanPage.result.via[0].x - ${x}, vandplanPage.result.via[0].y - ${y}) < 1e-5`;
  await page.until(passes);
  const off = await page.value(`(() => { const {rows} = vandplanPage.shown; let least = 1e9; for (let i = 0; i < rows.length; i += 6) least = Math.min(least, Math.hypot(rows[i + 1] - ${x}, rows[i + 2] - ${y})); return least; })()`);
  help.expect(off < 0.11, `the path passes the via, ${off} m from it`);
  await set(page, 'via-stop', true);
  await set(page, 'via-turns', '');
  await page.until(passes);
  const via = yaml.load(await saved(page)).via[0];
  help.expect(via.stop === true && via.heading === 0 && via.x === x, `it is saved: ${JSON.stringify(via)}`);
  help.expect(await page.value('document.getElementById("park").disabled'), 'nobody parks by hand past vias');
  await help.picture(page, 'desk-via');
  await page.key('Delete');
  await help.found(page);
  help.expect(await page.value('vandplanPage.result.via.length === 0'), 'without a via the path passes none');
}

/** Docks in a row are moved together, and one by one after a click; the path leads to the best one. */
async function choosesDocks(page, help) {
  await drop(page, help, 'straight on', straightOn);
  await help.click(page, 'add-dock');
  await help.click(page, 'add-dock');
  const docks = () => page.value('(vandplanPage.scene.goal.any_of ?? [vandplanPage.scene.goal]).map(({x, y}) => [x, y])');
  const row = await docks();
  const step = [row[1][1] - row[0][1], row[2][1] - row[1][1]];
  help.expect(row.length === 3 && step[0] < -2 && Math.abs(step[0] - step[1]) < 1e-9, `docks are in a row: ${JSON.stringify(row)}`);
  await page.until('vandplanPage.result?.path && vandplanPage.result.goal?.index === 0');
  await page.value('vandplanPage.editor.select(null)');
  const at = (dock) => page.value(`(() => { const p = vandplanPage, {x, y} = p.scene.goal.any_of[${dock}]; return p.view.toPage([x + p.scene.vehicle.wheelbase / 2, y]); })()`);
  const down = async (from, metres) => page.drag(from, [from[0], from[1] - metres * (await page.value('vandplanPage.view.scale'))]);
  await down(await at(1), -step[0]);
  const moved = await docks();
  help.expect(moved.every(([, y], i) => Math.abs(y - row[i][1] + step[0]) < 0.3), `all docks follow the mouse: ${JSON.stringify(moved)}`);
  await page.until('vandplanPage.result?.path && vandplanPage.result.goal?.index === 1');
  const press = await at(2);
  await page.mouse('mousePressed', press, {buttons: 1});
  await page.mouse('mouseReleased', press);
  await down(await at(2), -5);
  const alone = await docks();
  help.expect(alone[1][1] === moved[1][1] && alone[2][1] < moved[2][1] - 4, `one dock follows after a click: ${JSON.stringify(alone)}`);
  await help.picture(page, 'desk-row');
  await page.key('Delete');
  help.expect((await docks()).length === 2, 'Delete removes that one');
  await help.click(page, 'undo');
  help.expect(JSON.stringify(await docks()) === JSON.stringify(alone), 'undo brings it back');
  help.expect(yaml.load(await saved(page)).goal.any_of.length === 3, 'the docks are saved');
}

/** The slider makes the last metres straight, and the file says so. */
async function endsStraight(page, help) {
  await drop(page, help, 'straight on', straightOn.replace('y: 0, heading: 0}\n', 'y: 9, heading: 0.5}\n'));
  await set(page, 'straight', 6, 'input');
  await help.found(page);
  const last = await page.value(`(() => { let sum = 0; for (const {curvature, curvature_rate, length} of vandplanPage.result.path.segments.toReversed()) { if (curvature || curvature_rate) break; sum += Math.abs(length); } return sum; })()`);
  help.expect(last >= 6 - 1e-6, `the last ${last} m are straight`);
  help.expect(yaml.load(await saved(page)).goal.straight === 6, 'the file says so');
}

/** By touch: a zone is added and moved, a tap selects another one, and a via and docks are added. */
export async function takesThemByTouch(page, help) {
  await drop(page, help, 'straight on', straightOn);
  const swipe = async (from, to) => {
    await page.touch([from], 'touchStart');
    for (let i = 1; i <= 6; ++i) await page.touch([[0, 1].map((k) => from[k] + ((to[k] - from[k]) * i) / 6)], 'touchMove');
    await page.touch([], 'touchEnd');
  };
  await help.click(page, 'add-zone');
  const from = await middleOf(page, 'p.scene.zones[0].area');
  await swipe(from, [from[0], from[1] - 60]);
  const to = await middleOf(page, 'p.scene.zones[0].area');
  help.expect(Math.abs(to[1] - from[1] + 60) < 4, `a zone follows a finger: ${from}, ${to}`);
  await page.value('vandplanPage.editor.select(null)');
  await page.touch([to], 'touchStart');
  await page.touch([], 'touchEnd');
  help.expect((await page.value('vandplanPage.editor.selected?.kind')) === 'zones', 'a tap selects it');
  await help.click(page, 'more');
  await page.until('document.getElementById("zone-way").getBoundingClientRect().height > 20');
  await help.picture(page, 'phone-zone');
  await help.click(page, 'more');
  await help.click(page, 'add-via');
  const via = () => page.value('(() => { const p = vandplanPage, v = p.scene.vehicle, {x, y} = p.scene.via[0]; return p.view.toPage([x + v.wheelbase / 2, y]); })()');
  const before = await via();
  await swipe(before, [before[0], before[1] + 50]);
  help.expect(Math.abs((await via())[1] - before[1] - 50) < 4, 'a via follows a finger');
  await help.click(page, 'add-dock');
  await page.until('vandplanPage.result?.path && vandplanPage.result.via.length === 1 && vandplanPage.result.goal');
}
