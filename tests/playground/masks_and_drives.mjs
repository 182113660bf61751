// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Masks: are they read with their maps, drawn, planned for, and saved as they were? Does the drive that is shown obey
// the speeds of masks and zones, and stop at vias?

import {createRequire} from 'node:module';

const yaml = createRequire(import.meta.url)('/usr/share/nodejs/js-yaml/dist/js-yaml.js');

const [columns, rows] = [40, 30];

/** The keys and the image of a map of raw percents; a function of column and row, counted from below, gives them. */
function mapOf(name, percentAt) {
  const percents = Array.from({length: columns * rows}, (_, i) => percentAt(i % columns, rows - 1 - Math.floor(i / columns)));
  const keys = `image: ${name}.pgm\nresolution: 1\norigin: [-10, -15, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: raw\n`;
  return [[`${name}.yaml`, keys], [`${name}.pgm`, `P2\n${columns} ${rows}\n255\n${percents.join(' ')}`]];
}

const walls = mapOf('walls', (column, row) => (column >= 18 && column < 20 && row >= 10 && row < 19 ? 100 : 0));
const price = mapOf('price', (column, row) => (column > 30 ? 255 : 3 * row));
const speed = mapOf('speed', (column) => (column >= 22 ? 70 : 0));
const masks = 'masks:\n  - {map: maps/walls.yaml, as: obstacles}\n  - {map: price.yaml, as: cost, of: 4}\n  - {map: speed.yaml, type: 1, base: 100, multiplier: -1}\n';
const scenario = 'name: masked\nvehicle: van\nbounds: {x: [-10, 30], y: [-15, 15]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: {x: 20, y: 2, heading: 0}\nobstacles: []\n';
const all = [...walls, ...price, ...speed];

/** `help`: {expect, found, click, choose, plays, picture} of the test that opens the page. */
export async function takesMasksAndDrives(page, help) {
  await namesWhatIsMissing(page, help);
  await gradesShades(page, help);
  await keepsToMasks(page, help);
  await showsStops(page, help);
}

/** Drops files at once: [name, text]. */
const drop = (page, files) => page.value(`(() => { const data = new DataTransfer(); for (const [name, text] of ${JSON.stringify(files)}) data.items.add(new File([text], name));
  document.getElementById('note').textContent = ''; dispatchEvent(new DragEvent('drop', {dataTransfer: data, cancelable: true})); })()`);

async function namesWhatIsMissing(page, {expect}) {
  const name = await page.value('vandplanPage.scene.name');
  const yard = ['masked.yaml', scenario + masks];
  const wrong = [
    [[yard], 'masks[0].map: drop "maps/walls.yaml" and its image together'],
    [[yard, ...walls, ...price], 'masks[2].map: drop "speed.yaml"'],
    [[yard, ...walls, ...price, speed[0]], 'speed.yaml: drop its image "speed.pgm"'],
    [[['masked.yaml', scenario + masks.replace('as: cost', 'as: price')], ...all], 'masks[1].as: expected'],
    [[['masked.yaml', scenario + masks.replace('of: 4', 'of: -4')], ...all], 'masks[1]'],
    [[['masked.yaml', `${scenario}map: plan.yaml\n${masks}`], ...all], 'map: drop "plan.yaml"'],
  ];
  for (const [files, part] of wrong) {
    await drop(page, files);
    await page.until('document.getElementById("note").textContent');
    const note = await page.value('document.getElementById("note").textContent');
    expect(note.includes(part), `"${part}" is not in "${note}"`);
    expect((await page.value('vandplanPage.scene.name')) === name, 'what is not whole changes nothing');
  }
}

/** Black, grey, white and two between them are graded as Nav2 publishes them (tests/io/scenario_file_test.cpp). */
async function gradesShades(page, {expect}) {
  const graded = {scale: [100, 50, 0, 88, 63], raw: [0, 255, 255, 50, 100], trinary: [100, 255, 0, 255, 255]};
  for (const [mode, percents] of Object.entries(graded)) {
    const keys = `image: grey.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.9\nfree_thresh: 0.1\nmode: ${mode}\n`;
    const yard = scenario.replace('masked', mode) + 'masks: [{map: grey.yaml, as: cost, of: 5}]\n';
    await drop(page, [['yard.yaml', yard], ['grey.yaml', keys], ['grey.pgm', 'P2 5 1 255 0 127 255 50 100']]);
    await page.until(`vandplanPage.scene.name === "${mode}"`);
    const read = await page.value('[...vandplanPage.scene.masks[0].map.percents]');
    expect(JSON.stringify(read) === JSON.stringify(percents), `${mode}: ${read} and not ${percents}`);
  }
}

/** The colour of a place of the yard, without what is planned. */
const colourAt = (page, x, y) => page.value(`(() => { const p = vandplanPage, [u, v] = p.view.toPage([${x}, ${y}]).map((one) => Math.round(one * p.view.ratio)), {shown} = p;
  p.editor.select(null); p.shown = null; p.drawn(true); p.shown = shown; return [...p.context.getImageData(u, v, 1, 1).data].slice(0, 3); })()`);
const apart = (a, b) => Math.max(...a.map((one, i) => Math.abs(one - b[i])));

/** What the page saves of the scene that it shows. */
const saved = (page) => page.value(`(() => { const make = URL.createObjectURL; let blob; URL.createObjectURL = (one) => { blob = one; return make.call(URL, one); };
  document.getElementById('save').click(); URL.createObjectURL = make; return blob.text(); })()`);

async function keepsToMasks(page, help) {
  const {expect, found, click, picture} = help;
  await drop(page, [...all, ['masked.yaml', scenario + masks]]);
  await page.until('vandplanPage.scene.name === "masked"');
  await found(page);
  expect(await page.value('vandplanPage.result.check.valid && vandplanPage.result.cost > vandplanPage.result.check.length + 1'), 'metres have the price of a mask');
  expect((await page.value('Math.max(...vandplanPage.result.path.segments.map(({curvature}) => Math.abs(curvature)))')) > 0.02, 'the walls of a mask are driven round');
  const [wall, steep, flat] = [await colourAt(page, 9.4, -2.6), await colourAt(page, -5.6, 12.4), await colourAt(page, -5.6, -12.4)];
  expect(apart(wall, flat) > 40, `a wall of a mask is drawn: ${wall}, ${flat}`);
  expect(steep.every((shade, i) => shade < flat[i] - 4) && apart(steep, wall) > 20, `so is its price, faintly: ${steep}, ${flat}`);
  await page.mouse('mouseMoved', await page.value('vandplanPage.view.toPage([5.5, 5.5])'));
  await page.until('vandplanPage.at && Math.hypot(vandplanPage.at[0] - 5.5, vandplanPage.at[1] - 5.5) < 0.3');
  await page.value('vandplanPage.drawn(true)');
  const legend = await page.value('[...document.querySelectorAll("#masks-legend li")].map((one) => one.textContent)');
  const said = ['walls.yaml: obstacles', 'price.yaml: a metre costs 1 to 4.5 \u00D7, here 3.4', 'speed.yaml: at most 30 to 100 % of the largest speed, here 100'];
  expect(JSON.stringify(legend) === JSON.stringify(said) && (await page.value('!document.getElementById("legend").hidden')), `the legend names masks: ${legend}`);
  await picture(page, 'desk-masks');
  const rowsOf = await page.value('(() => { const p = vandplanPage; p.toggleDrive(); const {rows} = p.drive; p.stopDriving(); return [...rows]; })()');
  const speeds = (holds) => Math.max(...rowsOf.filter((_, i) => i % 7 === 6 && holds(rowsOf[i - 4])).map(Math.abs));
  const most = 2.5; // of a van, unless its file says otherwise [m/s]
  expect(speeds((x) => x > 13) <= 0.3 * most + 1e-9 && speeds((x) => x < 11) > 0.4 * most, `the drive obeys a mask: ${speeds((x) => x > 13)} of ${most} m/s`);
  const text = await saved(page);
  const {masks: again} = yaml.load(text);
  const wanted = yaml.load(masks).masks.map((mask) => ({...mask, map: mask.map.split('/').at(-1)}));
  expect(JSON.stringify(again) === JSON.stringify(wanted), `masks are saved: ${JSON.stringify(again)}`);
  const scene = () => page.value('JSON.stringify({...vandplanPage.scene, options: 0, masks: vandplanPage.scene.masks.map(({rule, map}) => [rule, map.name, [...map.percents]])})');
  const before = await scene();
  await click(page, 'add-wall');
  await click(page, 'undo');
  expect((await scene()) === before, 'undo leaves them alone');
  await click(page, 'link');
  await page.until('document.getElementById("note").textContent.includes("too large")');
  await drop(page, [['mine.yaml', 'name: mine\n' + scenario.slice(scenario.indexOf('vehicle'))]]);
  await page.until('vandplanPage.scene.name === "mine"');
  await drop(page, [...all, ['again.yaml', text]]);
  await page.until('vandplanPage.scene.name === "masked"');
  expect((await scene()) === before, 'what was saved opens as it was');
  await found(page);
}

/** The truck stands on the weighbridge of the depot for a while, and is slow on its ramp. */
async function showsStops(page, {expect, found, choose, plays, picture}) {
  await choose(page, 'scenario', 'Depot');
  await found(page);
  await plays(page);
  await page.until('vandplanPage.drive?.at > 70');
  const {stops, slow} = await page.value(`(() => { const {stops, rows} = vandplanPage.drive; let slow = 0;
    for (let i = 0; i < rows.length; i += 7) if (rows[i + 2] > 48 && rows[i + 2] < 78 && rows[i + 3] < 20) slow = Math.max(slow, Math.abs(rows[i + 6]));
    return {stops, slow}; })()`);
  expect(Math.abs(slow - 1.2) < 0.01, `the drive obeys the zone: ${slow} m/s on the ramp`);
  expect(stops.length === 1 && stops[0].via === 0, `the drive has a stop: ${JSON.stringify(stops)}`);
  await page.value('globalThis.driven = vandplanPage.drive; 0'); // it may be over on a slow machine
  /** What is shown so many seconds after the drive began: the drive's time, and the colour of the plate of the via. */
  const shownAfter = (seconds) => page.value(`(() => { const p = vandplanPage, {x, y, heading} = p.scene.via[0], v = p.scene.vehicle, m = (v.wheelbase + v.front_overhang - v.rear_overhang) / 2;
    p.drive = Object.assign(driven, {at: 0, begin: performance.now() - 1000 * ${seconds}}); p.drawn(true);
    const [u, w] = p.view.toPage([x + m * Math.cos(heading), y + m * Math.sin(heading)]).map((one) => Math.round((one + 7) * p.view.ratio));
    return {t: driven.rows[driven.at], plate: [...p.context.getImageData(u, w, 1, 1).data].slice(0, 3)}; })()`);
  const [{t: stop}] = stops;
  const [before, early, late, after] = [await shownAfter(stop / 4 - 0.3), await shownAfter(stop / 4 + 0.2), await shownAfter(stop / 4 + 0.6), await shownAfter(stop / 4 + 1.5)];
  expect(before.t < stop && early.t === stop && late.t === stop && after.t > stop, `the truck stands there for a while: ${[before.t, early.t, late.t, after.t]}, ${stop}`);
  const isRed = ({plate: [red, , blue]}) => red > blue + 40;
  expect(isRed(early) && isRed(late) && !isRed(before), `the plate of the via is red while the truck stands there: ${before.plate}, ${early.plate}`);
  await shownAfter(stop / 4);
  await picture(page, 'desk-stop');
  await page.value('vandplanPage.stopDriving()');
}
