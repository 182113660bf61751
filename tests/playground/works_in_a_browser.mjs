// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the page work, on a desk and on a phone?
// usage: node works_in_a_browser.mjs PLAYGROUND CHROMIUM [SCREENSHOTS]

import {existsSync, mkdirSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser, pause} from './browser.mjs';
import {showsCosts, showsCostsByTouch} from './costs.mjs';
import {takesGoalsAndZones, takesThemByTouch} from './goals_and_zones.mjs';
import {takesMasksAndDrives} from './masks_and_drives.mjs';

const [playground, chromium, pictures] = process.argv.slice(2);
const url = pathToFileURL(resolve(playground, 'index.html')).href;
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

async function picture(page, name) {
  if (!pictures) return;
  if (!existsSync(pictures)) mkdirSync(pictures, {recursive: true});
  await page.screenshot(join(pictures, `${name}.png`));
}

const status = (page) => page.value('vandplanPage.result?.status');
const pose = (page, which) => page.value(`({...vandplanPage.scene.${which}})`);
const settled = (page) => page.until('!vandplanPage.dirty');
/**
 * A path of the scene as it is now; the second thread may have to find it. The page gives up after some seconds, which
 * may not be enough beside other work: then it is asked again.
 */
async function found(page) {
  const path = '!vandplanPage.dirty && vandplanPage.result?.path';
  for (let asked = 1; asked < 10; ++asked) {
    if (await page.until(path, 10).then(() => true, () => false)) return;
    await page.value('!vandplanPage.dirty && vandplanPage.changed("ends")');
  }
  await page.until(path).catch(async (error) => {
    throw new Error(`${error.message}\nthe page says ${await page.value('JSON.stringify([vandplanPage.dirty, vandplanPage.result?.status, vandplanPage.result?.reason])')}`);
  });
}
/** What a browser shows after a while, for those who look at it. */
const whenLookedAt = (ms) => (pictures ? pause(ms) : undefined);
const choose = (page, id, label) =>
  page.value(`(() => { const s = document.getElementById('${id}'); s.value = [...s.options].find((o) => o.text === '${label}').value; s.dispatchEvent(new Event('change')); })()`);
const click = (page, id) => page.value(`document.getElementById('${id}').click()`);
const plays = async (page) => {
  await page.until('!document.getElementById("play").disabled');
  await click(page, 'play');
};
/** Where the middle of a body is on the page. */
const bodyAt = (page, which) => page.value(`(() => { const p = vandplanPage, v = p.scene.vehicle, s = p.scene.${which}, m = (v.wheelbase + v.front_overhang - v.rear_overhang) / 2;
  return p.view.toPage([s.x + m * Math.cos(s.heading), s.y + m * Math.sin(s.heading)]); })()`);
const cornerOf = (page, index) => page.value(`vandplanPage.view.toPage(vandplanPage.scene.obstacles[${index}][0])`);
const centreOf = (page, index) => page.value(`(() => { const o = vandplanPage.scene.obstacles[${index}]; return vandplanPage.view.toPage([0, 1].map((k) => o.reduce((sum, c) => sum + c[k], 0) / o.length)); })()`);

async function drags(page) {
  await found(page);
  expect((await status(page)) === 'solved', 'the first yard has a path');
  expect(await page.value('vandplanPage.result.check.valid'), 'the judge has seen it');
  const before = await pose(page, 'goal');
  const at = await bodyAt(page, 'goal');
  await page.drag(at, [at[0] + 4, at[1] + 120]);
  await found(page);
  const after = await pose(page, 'goal');
  expect(Math.hypot(after.x - before.x, after.y - before.y) > 2, 'the goal follows the mouse');
  expect((await status(page)) === 'solved', 'there is a path to it');
  const scale = await page.value('vandplanPage.view.scale');
  expect(Math.abs((after.x - before.x) * scale - 4) < 2 && Math.abs((after.y - before.y) * scale + 120) < 2, 'it goes as far as the mouse');
  await page.key('z', 2);
  await settled(page);
  expect((await pose(page, 'goal')).x === before.x, 'undo brings it back');
  await page.key('z', 2 | 8);
  await settled(page);
  expect((await pose(page, 'goal')).x === after.x, 'redo takes it there again');
  await page.key('z', 2);
  await page.key('y', 2);
  await settled(page);
  expect((await pose(page, 'goal')).x === after.x, 'so does Ctrl Y');
}

async function edits(page) {
  const count = await page.value('vandplanPage.scene.obstacles.length');
  await click(page, 'add-wall');
  await settled(page);
  expect((await page.value('vandplanPage.scene.obstacles.length')) === count + 1, 'a wall is added');
  const corner = await cornerOf(page, count);
  await page.drag(corner, [corner[0] - 30, corner[1] + 20]);
  const moved = await cornerOf(page, count);
  expect(Math.hypot(moved[0] - corner[0] + 30, moved[1] - corner[1] - 20) < 3, 'its corner follows the mouse');
  const centre = await centreOf(page, count);
  await page.drag(centre, [centre[0] + 40, centre[1] + 10]);
  const then = await centreOf(page, count);
  expect(Math.abs(then[0] - centre[0] - 40) < 3, 'the wall follows the mouse');
  await page.key('Delete');
  await settled(page);
  expect((await page.value('vandplanPage.scene.obstacles.length')) === count, 'Delete removes it');
  await page.value('document.getElementById("yard").focus()');
  await page.key('n');
  const before = await pose(page, 'goal');
  await page.key('ArrowRight');
  await page.key(',');
  await settled(page);
  const after = await pose(page, 'goal');
  expect(after.heading !== before.heading && after.x !== before.x, 'keys move and turn the goal');
}

/** Sliders have a driver's prices for the vehicle unless somebody moved them; the button resets them to those. */
async function pricesFit(page) {
  const text = (id) => page.value(`document.getElementById('${id}').parentElement.querySelector('.value').textContent`);
  const wanted = await page.value('vandplanPage.vandplan.prices("driver", vandplanPage.scene.vehicle).gear_change_cost');
  expect(wanted < 4.9 && (await page.value('vandplanPage.settings.gear_change_cost')) === wanted, 'a gear change of a van costs less than a truck\'s');
  expect((await text('gear_change_cost')) === `${Number(wanted.toPrecision(3))} m`, 'its slider says so');
  await page.value("(() => { const s = document.getElementById('gear_change_cost'); s.value = 17; s.dispatchEvent(new Event('input')); })()");
  await choose(page, 'vehicle', 'two axle truck');
  expect((await text('gear_change_cost')) === '17 m' && (await text('curvature_change_cost')) === '5 m', 'a truck has its prices, but for the one that was set');
  await choose(page, 'vehicle', 'van');
  await click(page, 'as-driver');
  expect((await page.value('vandplanPage.settings.gear_change_cost')) === wanted, 'a driver resets it to the van\'s');
  await found(page);
}

/** In one gear the path has no metre in the other one, and a style does not take the gear back. */
async function goesInOneGear(page) {
  await choose(page, 'scenario', 'Thesis: 5 leave cage');
  await found(page);
  await choose(page, 'gears', 'reverse only');
  await settled(page);
  await click(page, 'as-shortest');
  await page.until('vandplanPage.result?.path && vandplanPage.result.path.segments.every(({length}) => length <= 0)');
  await choose(page, 'planner', 'prm');
  expect(await page.value('document.getElementById("gears").disabled'), 'a roadmap knows no gears');
  await choose(page, 'planner', 'anytime');
  await choose(page, 'gears', 'forward and reverse');
  await click(page, 'as-driver');
  await found(page);
}

/** A goal that may point any way is no dearer, and the file says so; undo takes it back. */
async function turnsAtTheGoal(page) {
  await choose(page, 'scenario', 'Thesis: 5 leave cage');
  await found(page);
  const fixed = await page.value('vandplanPage.result.cost');
  await choose(page, 'turns', 'whichever way');
  await page.until('vandplanPage.result?.path && vandplanPage.result.goal');
  await page.until(`vandplanPage.result.cost <= ${1.01 * fixed}`);
  expect((await page.value('vandplanPage.scene.goal.turns')) === 'any', 'the scene says that the goal may turn');
  await choose(page, 'turns', 'or turned round');
  await page.until('vandplanPage.result?.path && vandplanPage.result.goal');
  await click(page, 'undo');
  await click(page, 'undo');
  await found(page);
  expect((await page.value('document.getElementById("turns").value')) === '', 'undo takes it back');
  expect((await page.value('vandplanPage.result.goal')) === null, 'a pose is no set');
}

async function slides(page) {
  await choose(page, 'scenario', 'Thesis: 5 leave cage');
  await found(page);
  const set = (id, value) => page.value(`(() => { const s = document.getElementById('${id}'); s.value = ${value}; s.dispatchEvent(new Event('input')); })()`);
  await set('margin', 0.5);
  await found(page);
  expect((await page.value('vandplanPage.result.check.clearance')) >= 0.499, 'the margin is kept');
  await click(page, 'as-shortest');
  await found(page);
  const length = await page.value('vandplanPage.result.cost - vandplanPage.result.check.length');
  expect(Math.abs(length) < 1e-6, 'the cost of the shortest style is the length');
  await choose(page, 'planner', 'rrt-connect');
  await found(page);
  expect((await status(page)) === 'solved', 'another planner finds a path');
  await choose(page, 'planner', 'anytime');
  await click(page, 'as-driver');
  await choose(page, 'vehicle', 'van');
  await found(page);
  await pricesFit(page);
  expect((await page.value('vandplanPage.scene.vehicle.wheelbase')) < 4.5, 'the vehicle is another one');
  await page.until('vandplanPage.result.time > 0.15', 60);
}

/** Drops one file; `content` is an expression of the page. */
const dropped = (page, name, content) => page.value(`(async () => { const data = new DataTransfer(); data.items.add(new File([${content}], ${JSON.stringify(name)}));
  document.getElementById('note').textContent = ''; dispatchEvent(new DragEvent('drop', {dataTransfer: data, cancelable: true})); })()`);

/** Each yard of our own has a path and says what to do; the list names what is shown, also what came from a file, and after undo. */
async function lists(page) {
  const named = () => page.value('document.getElementById("scenario").selectedOptions[0].text');
  const ours = await page.value('[...document.querySelectorAll("#scenario optgroup")].filter((g) => g.label.includes("BSD-3-Clause")).flatMap((g) => [...g.children].map((o) => o.text))');
  expect(['Container stacks', 'Bus depot', 'Ferry lane', 'Depot'].every((name) => ours.includes(name)), `our yards are ${ours}`);
  for (const name of ours) {
    await choose(page, 'scenario', name);
    await found(page);
    expect((await status(page)) === 'solved' && (await page.value('vandplanPage.result.check.valid')), `${name} has a path`);
    expect((await page.value('document.getElementById("task").textContent')).length > 10, `${name} says what to do`);
    await picture(page, `desk-${name.toLowerCase().replace(' ', '-')}`);
  }
  const yaml = 'name: mine\nvehicle: van\nbounds: {x: [-30, 30], y: [-30, 30]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: {x: 9, y: 4, heading: 0}\nobstacles: []\n';
  await dropped(page, 'mine.yaml', JSON.stringify(yaml));
  await page.until('vandplanPage.scene.name === "mine"');
  expect((await named()) === 'mine', 'the list names the file that was dropped');
  await click(page, 'undo');
  expect((await named()) === ours.at(-1), 'undo brings back the name, too');
  expect((await page.value('document.getElementById("vehicle").value')) !== 'van', 'and that of the vehicle');
  await click(page, 'redo');
  await choose(page, 'scenario', 'Docks');
  expect(!(await page.value('[...document.getElementById("scenario").options].some((o) => o.text === "mine")')), 'a yard of the list takes the place of the file');
  await found(page);
}

async function pulls(page) {
  await choose(page, 'scenario', 'Trailer: turn round yard');
  await found(page);
  expect(await page.value('vandplanPage.shown.trail.length / 3 === vandplanPage.shown.rows.length / 6'), 'the trailer is shown all the way');
  expect(await page.value('document.getElementById("vehicle").value') === 'tractor-semitrailer', 'its vehicle is known by name');
  await plays(page);
  await page.until('vandplanPage.drive?.at > 70');
  await picture(page, 'desk-trailer');
  await choose(page, 'vehicle', 'van');
  await settled(page);
  expect(await page.value('vandplanPage.scene.start.hitch_angles === undefined && vandplanPage.shown?.trail === null'), 'a van pulls nothing');
  await choose(page, 'scenario', 'Moving: reversing truck');
  await found(page);
  expect(await page.value('vandplanPage.result.drive.length > 0'), 'a path among what moves has its times');
  await plays(page);
  await page.until('vandplanPage.drive?.at > 70');
  await picture(page, 'desk-moving');
}

async function opensFiles(page) {
  const text = await page.value(`(async () => { const p = vandplanPage; return p.vandplan.version; })()`);
  expect(/^\d+\.\d+/.test(text), 'it knows its version');
  const broken = [
    ['bad.yaml', '"name: [1, 2"', 'bad.yaml:'], ['bad.yaml', '"__proto__: {x: 1}"', 'not known'],
    ['bad.yaml', '"a: &a [x, x]\\nb: &b [*a, *a]\\nname: [*b, *b]"', 'not known'], ['bad.yaml', '"wals: []"', 'wals'], ['bad.txt', '"x"', 'expected'], ['bad.pgm', '"P5 9 9 255 "', 'ends'],
    ['huge.yaml', '"a".repeat(3e6)', 'larger'], ['bad.png', '"no image"', 'image'], ['huge.pgm', '"P5 99999 99999 255 "', 'cells'],
  ];
  for (const [name, content, part] of broken) {
    const before = await page.value('JSON.stringify([vandplanPage.scene.name, vandplanPage.scene.goal])');
    await dropped(page, name, content);
    await page.until('document.getElementById("note").textContent');
    const note = await page.value('document.getElementById("note").textContent');
    expect((await page.value('JSON.stringify([vandplanPage.scene.name, vandplanPage.scene.goal])')) === before, `${name} changes nothing`);
    expect(note.includes(part), `${name} gives "${note}"`);
  }
  const evil = '<img src=x onerror="globalThis.evil=1"><script>globalThis.evil=1</' + 'script>';
  const yaml = `name: '${evil}'\nvehicle: van\nbounds: {x: [-30, 30], y: [-30, 30]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: {x: 9, y: 4, heading: 0}\nobstacles: []\n`;
  await dropped(page, 'mine.yaml', JSON.stringify(yaml));
  await page.until('vandplanPage.scene.goal.x === 9'); // it is shown
  await found(page);
  expect((await page.value('globalThis.evil')) === undefined, 'nothing in a file runs');
  const map = 'P2\n40 40\n255\n' + Array.from({length: 1600}, (_, i) => (Math.floor(i / 40) === 20 && i % 40 < 28 ? 0 : 254)).join(' ');
  await dropped(page, 'yard.pgm', JSON.stringify(map));
  await page.until('vandplanPage.scene.map?.grid.columns === 40');
  await settled(page);
}

const straight = 'name: straight\nvehicle: van\nbounds: {x: [-30, 30], y: [-30, 30]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: {x: 9, y: 0, heading: 0}\nobstacles:\n  - [[-9, 5], [20, 5], [20, 7], [-9, 7]]\n';

/** What is saved opens again as it was, sliders, too; pictures are images; a PNG is a map; reasons are words. */
async function saves(page) {
  await dropped(page, 'straight.yaml', JSON.stringify(straight));
  await page.until('vandplanPage.scene.name === "straight"');
  await found(page);
  await page.value(`(() => { const s = document.getElementById('gear_change_cost'); s.value = 17; s.dispatchEvent(new Event('input'));
    globalThis.saved = []; const make = URL.createObjectURL; URL.createObjectURL = (blob) => { saved.push(blob); return make.call(URL, blob); }; })()`);
  await found(page);
  await click(page, 'save');
  const text = await page.value('saved.find(({type}) => type === "text/yaml").text()');
  expect(/gear_change_cost: 17/.test(text) && !/reverse_weight/.test(text), `a saved scenario has the price that was set, and no other: ${text}`);
  const scene = await page.value('JSON.stringify({...vandplanPage.scene, options: 0})');
  await click(page, 'as-driver');
  await dropped(page, 'again.yaml', JSON.stringify(text));
  await page.until('vandplanPage.settings.gear_change_cost === 17');
  expect((await page.value('JSON.stringify({...vandplanPage.scene, options: 0})')) === scene, 'what was saved opens as it was');
  expect(await page.value('document.getElementById("gear_change_cost").value === "17"'), 'with its price on the slider');
  await click(page, 'picture');
  await page.until('saved.some(({type}) => type === "image/png")');
  const image = await page.value('(async () => { const own = await createImageBitmap(saved.find(({type}) => type === "image/png")); return [own.width, own.height]; })()');
  expect(image[0] === 1440 && image[1] === 900, `a picture is ${image}`);
  await page.value('vandplanPage.scene.goal.y = 5; vandplanPage.changed("ends")');
  await page.until('vandplanPage.result?.status === "goal_in_collision"');
  const reason = await page.value('document.getElementById("status").textContent');
  expect(reason.includes('a wall') && !reason.includes('['), `the reason is in words: ${reason}`);
  expect((await page.value('JSON.stringify(vandplanPage.result.hit)')) === '{"what":"obstacles","index":0}', 'it says which wall is hit');
  const reds = () => page.value(`(() => { const {view, context, scene} = vandplanPage; const [x, y] = view.toPage(scene.obstacles[0][0]).map((c) => Math.round(c * view.ratio));
    const {data} = context.getImageData(x - 3, y - 3, 7, 7); let n = 0; for (let i = 0; i < data.length; i += 4) n += data[i] > data[i + 1] + 60 && data[i] > data[i + 2] + 60; return n; })()`);
  expect((await reds()) > 3, 'and outlines it in red');
  await page.value('vandplanPage.scene.goal.y = 0; vandplanPage.changed("ends")');
  await found(page);
  expect((await reds()) === 0 && (await page.value('vandplanPage.result.hit === null')), 'no more once the goal is free');
  await dropped(page, 'yard.png', `await (async () => { const c = new OffscreenCanvas(60, 50); const d = c.getContext('2d'); d.fillStyle = '#fff'; d.fillRect(0, 0, 60, 50);
    d.fillStyle = '#000'; d.fillRect(0, 0, 60, 2); return c.convertToBlob(); })()`);
  await page.until('vandplanPage.scene.map?.grid.rows === 50');
  expect(await page.value('(({cells}) => cells[0] === 0 && cells[60 * 49] === 1)(vandplanPage.scene.map.grid)'), 'the black rows of a PNG are occupied');
}

/** Somebody parks by hand with the arrow keys, and is told what it costs. */
async function parks(page) {
  await dropped(page, 'straight.yaml', JSON.stringify(straight));
  await page.until('vandplanPage.scene.name === "straight"');
  await click(page, 'as-driver');
  await found(page);
  await click(page, 'park');
  const key = (type) => page.send('Input.dispatchKeyEvent', {type, key: 'ArrowUp'});
  await key('keyDown');
  await page.until('vandplanPage.parked?.length > 3');
  await picture(page, 'desk-park');
  await page.until('document.getElementById("note").textContent.startsWith("Parked!")');
  await key('keyUp');
  const note = await page.value('document.getElementById("note").textContent');
  expect(/You: [89] m, gear changes: 0\. The planner: 9 m.*Your way costs \d+ % .*proven to/.test(note), `it says "${note}"`);
  expect(await page.value('document.getElementById("pad").hidden && document.getElementById("park").getAttribute("aria-pressed") === "false"'), 'and it is over');
}

/** On a phone there are buttons for it, that drive as long as a finger is on them. */
async function parksByTouch(page) {
  await dropped(page, 'straight.yaml', JSON.stringify(straight));
  await page.until('vandplanPage.scene.name === "straight"');
  await found(page);
  await click(page, 'park');
  const boxes = await page.value('[...document.querySelectorAll("#pad button")].map((b) => { const r = b.getBoundingClientRect(); return [r.left, r.right, r.bottom - r.top, document.elementFromPoint((r.left + r.right) / 2, (r.top + r.bottom) / 2) === b]; })');
  expect(boxes.every(([left, right, high, seen]) => left >= 0 && right <= 390 && right - left > 40 && high > 40 && seen), `buttons are on the phone, and large enough: ${JSON.stringify(boxes)}`);
  const note = await page.value('(({width}) => width)(document.getElementById("note").getBoundingClientRect())');
  expect(note > 300, `what is said takes the width of the phone: ${note}`);
  await picture(page, 'phone-park');
  const at = await page.value('(() => { const r = document.querySelector("#pad [data-key=ArrowUp]").getBoundingClientRect(); return [(r.left + r.right) / 2, (r.top + r.bottom) / 2]; })()');
  await page.touch([at], 'touchStart');
  await page.until('vandplanPage.parked?.length > 1');
  await page.touch([], 'touchEnd');
  const length = await page.value('vandplanPage.parked.length');
  await pause(200);
  expect((await page.value('vandplanPage.parked.length')) - length < 0.5, 'it stops when the finger leaves');
  await click(page, 'give-up');
  expect(await page.value('vandplanPage.parked === null && document.getElementById("pad").hidden'), 'one can give up');
}

async function links(browser, page, size) {
  await choose(page, 'scenario', 'Street');
  await settled(page);
  await click(page, 'link');
  await page.until('location.hash.length > 20');
  const hash = await page.value('location.hash');
  const other = await browser.page(url + hash, size);
  expect((await other.value('vandplanPage.scene.name')) === 'street', 'a link carries the yard');
  expect(other.faults.length === 0, `the linked page complains: ${other.faults}`);
  const bad = await browser.page(`${url}#yard=xxxx`, size);
  await bad.until('document.getElementById("note").textContent.includes("link")');
  await page.send('Page.bringToFront'); // frames are painted in front only
}

/** A body that is no rectangle is read, drawn, planned for and linked; what the planner refuses changes nothing. */
async function drawsOutlines(browser, page, size) {
  const drop = (corners) => dropped(page, 'slim.yaml', JSON.stringify(`name: slim\nvehicle: {wheelbase: 4, min_turning_radius: 6, outline: ${corners}}\n`
      + 'bounds: {x: [-20, 40], y: [-20, 20]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: {x: 24, y: 3, heading: 0}\nobstacles: []\n'));
  const name = await page.value('vandplanPage.scene.name');
  await drop('[[-1, -1.2], [5, 0], [-1, 1.2], [1, 0]]');
  await page.until('document.getElementById("note").textContent.includes("vehicle.outline")');
  expect((await page.value('vandplanPage.scene.name')) === name, 'an outline that is not convex changes nothing');
  await drop('[[-1, -1.2], [5, -0.3], [5, 0.3], [-1, 1.2]]');
  await page.until('vandplanPage.scene.name === "slim"');
  await found(page);
  const white = (x, y) => page.value(`(() => { const p = vandplanPage, [u, v] = p.view.toPage([${x}, ${y}]).map((one) => Math.round(one * p.view.ratio));
    return p.context.getImageData(u, v, 1, 1).data.every((shade) => shade > 250); })()`);
  expect(await white(2, 0.5), 'the body is drawn');
  expect(!(await white(3.8, 0.8)), 'it is as slim ahead as its outline says');
  await picture(page, 'desk-outline');
  await click(page, 'link');
  await page.until('location.hash.length > 20');
  const other = await browser.page(url + await page.value('location.hash'), size);
  expect((await other.value('JSON.stringify(vandplanPage.scene.vehicle)')) === (await page.value('JSON.stringify(vandplanPage.scene.vehicle)')), 'a link carries the outline');
  await page.value('location.hash = ""');
  await page.send('Page.bringToFront');
}

async function explains(page, name) {
  await click(page, 'show-how');
  await page.until('document.querySelectorAll("#how .maps b")[2].textContent.endsWith("m")');
  await whenLookedAt(2500);
  await picture(page, `${name}-how-1`);
  const numbers = await page.value('[...document.querySelectorAll("#how .maps b")].map((b) => parseFloat(b.textContent))');
  expect(numbers[2] > 1.5 * numbers[0], `beside is far for a truck: ${numbers}`);
  await page.until('/\\d/.test(document.querySelector("#how .two .bench span").textContent)');
  await page.value('document.querySelectorAll("#how article")[1].scrollIntoView()');
  await whenLookedAt(1500);
  await picture(page, `${name}-how-2`);
  await page.value('document.querySelectorAll("#how article")[2].scrollIntoView()');
  await page.value('document.getElementById("known-speed").value = 3'); // nodes are shown frame by frame
  const captions = '[...document.querySelectorAll("#how .two")[1].querySelectorAll(".bench span")].map((one) => one.textContent)';
  await page.until(`${captions}.every((text) => /first path after|no path in/.test(text))`, 180);
  const [blind, guided] = await page.value(captions);
  const steps = (text) => Number(text.match(/first path after (\d+)/)?.[1] ?? Infinity);
  expect(4 * steps(guided) < steps(blind), `a table of the yard makes a search quicker: ${blind}; ${guided}`);
  await picture(page, `${name}-how-3`);
  await page.value('document.querySelectorAll("#how article")[3].scrollIntoView()');
  await whenLookedAt(300);
  await picture(page, `${name}-how-4`);
  await page.until('document.querySelectorAll("#how article p")[document.querySelectorAll("#how article p").length - 1].textContent.includes("words fit")');
  await click(page, 'show-plan');
}

/** Every control has a name, and texts can be told from what is behind them. */
async function isAccessible(page) {
  const nameless = await page.value(`[...document.querySelectorAll('button, select, input:not([hidden]), canvas')].filter((e) =>
    !(e.textContent.trim() || e.ariaLabel || e.getAttribute('aria-label') || e.labels?.length)).map((e) => e.id || e.tagName)`);
  expect(nameless.length === 0, `without a name: ${nameless}`);
  const weak = await page.value(`(() => {
    const level = (c) => { const [r, g, b] = c.match(/[\\d.]+/g).map((v) => { v /= 255; return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4; }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
    const probe = document.createElement('i'); document.body.append(probe);
    const colour = (name) => { probe.style.color = 'var(--' + name + ')'; return level(getComputedStyle(probe).color); };
    const paper = colour('paper');
    const weak = ['ink', 'soft', 'accent-ink', 'good', 'bad'].filter((name) => { const one = colour(name); return (Math.max(one, paper) + 0.05) / (Math.min(one, paper) + 0.05) < 4.5; });
    probe.remove(); return weak; })()`);
  expect(weak.length === 0, `too little contrast: ${weak}`);
}

async function onADesk(browser) {
  const size = {width: 1440, height: 900};
  const page = await browser.page(url, size);
  await settled(page);
  await picture(page, 'desk-docks');
  await isAccessible(page);
  expect(await page.value('document.activeElement.id === "yard"'), 'keys work at once');
  await drags(page);
  await edits(page);
  await lists(page);
  await slides(page);
  await goesInOneGear(page);
  await turnsAtTheGoal(page);
  await picture(page, 'desk-cage');
  await pulls(page);
  await opensFiles(page);
  await drawsOutlines(browser, page, size);
  await takesGoalsAndZones(page, {expect, found, click, dropped, picture});
  await takesMasksAndDrives(page, {expect, found, click, choose, plays, picture});
  await showsCosts(page, {expect, found, click, dropped, picture});
  await saves(page);
  await parks(page);
  await links(browser, page, size);
  await plays(page);
  await page.until('vandplanPage.drive?.at > 0'); // the truck drives
  await picture(page, 'desk-street');
  await explains(page, 'desk');
  expect(page.faults.length === 0, `the page complains: ${page.faults.join('\n')}`);
  const dark = await browser.page(url, {...size, dark: true});
  await settled(dark);
  await isAccessible(dark);
  await picture(dark, 'desk-dark');
}

/** On the screens of laptops nothing lies over the prices, and every tool can be reached. */
async function onLaptops(browser) {
  for (const [width, height] of [[1024, 768], [1280, 800], [1366, 768]]) {
    const page = await browser.page(url, {width, height});
    const boxes = await page.value(`['#panel', '#tools'].map((name) => { const {left, right, top, bottom} = document.querySelector(name).getBoundingClientRect(); return {left, right, top, bottom}; })`);
    const [panel, tools] = boxes;
    expect(tools.right <= panel.left || tools.left >= panel.right || tools.top >= panel.bottom, `${width} x ${height}: the tools lie over the prices`);
    const hidden = await page.value(`[...document.querySelectorAll('#tools button')].find((button) => { const {left, right, top, bottom} = button.getBoundingClientRect(); return !button.contains(document.elementFromPoint((left + right) / 2, (top + bottom) / 2)); })?.id`);
    expect(!hidden, `${width} x ${height}: the tool "${hidden}" cannot be reached`);
    await picture(page, `laptop-${width}`);
    await page.send('Page.close');
  }
}

async function onAPhone(browser) {
  const page = await browser.page(url, {width: 390, height: 844, touch: true});
  await settled(page);
  await picture(page, 'phone-docks');
  const before = await pose(page, 'goal');
  const at = await bodyAt(page, 'goal');
  await page.touch([at], 'touchStart');
  for (let i = 1; i <= 6; ++i) await page.touch([[at[0] - 4 * i, at[1] + 12 * i]], 'touchMove');
  await page.touch([], 'touchEnd');
  await settled(page);
  expect((await pose(page, 'goal')).y < before.y - 2, 'the goal follows a finger');
  const scale = await page.value('vandplanPage.view.scale');
  await page.touch([[150, 120], [240, 120]], 'touchStart');
  for (let i = 1; i <= 5; ++i) await page.touch([[150 - 8 * i, 120], [240 + 8 * i, 120]], 'touchMove');
  await page.touch([], 'touchEnd');
  expect((await page.value('vandplanPage.view.scale')) > 1.2 * scale, 'two fingers zoom');
  expect(await page.value('document.documentElement.scrollWidth <= innerWidth'), 'nothing is wider than the phone');
  await click(page, 'more');
  await whenLookedAt(200);
  await picture(page, 'phone-panel');
  await click(page, 'more');
  await parksByTouch(page);
  await takesThemByTouch(page, {expect, click, dropped, picture});
  await showsCostsByTouch(page, {expect, click, dropped, picture});
  await explains(page, 'phone');
  expect(page.faults.length === 0, `the page complains on a phone: ${page.faults.join('\n')}`);
}

const browser = await Browser.open(chromium);
try {
  await onADesk(browser);
  await onLaptops(browser);
  await onAPhone(browser);
} catch (error) {
  expect(false, error.stack);
}
await browser.close();
console.log(faults ? `${faults} faults` : 'the page works');
process.exit(faults ? 1 : 0);
