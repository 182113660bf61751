// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What driving to the dock costs: are yards coloured by it, is it that of the place under the mouse, and is a table made
// anew when something changes? Does the planner use it?

import {pause} from './browser.mjs';

const yard = (goal, more = '') => `vehicle: van\nbounds: {x: [-30, 40], y: [-25, 25]}\nstart: {x: -15, y: 0, heading: 0}\n${goal}\n`
  + `obstacles:\n  - [[0, -9], [2, -9], [2, 17], [0, 17]]\n  - [[26, 12], [31, 12], [31, 15], [26, 15]]\n${more}`;
const oneDock = `name: one dock\n${yard('goal: {x: 20, y: 0, heading: 0}')}`;
const twoDocks = `name: two docks\n${yard('goal: {any_of: [{x: 20, y: 0, heading: 0}, {x: -15, y: 15, heading: 0, either_way: true}]}')}`;
const moving = `name: with movers\n${yard('goal: {x: 20, y: 0, heading: 0}', 'moving:\n  - {outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]], trajectory: [[0, 30, 20, 0], [9, 30, 10, 0]]}\n')}`;

const drop = async (page, {dropped}, name, text) => {
  await dropped(page, `${name}.yaml`, JSON.stringify(text));
  await page.until(`vandplanPage.scene.name === "${name}"`);
};
const textOf = (page, id) => page.value(`document.getElementById('${id}').textContent`);
const isSeen = (page, id) => page.value(`(({width, height}) => width > 0 && height > 0)(document.getElementById('${id}').getBoundingClientRect())`);
/** A table of the scene as it is now, and a plan with it. */
const isMade = (page) => page.until('!vandplanPage.dirty && vandplanPage.costs.made && !vandplanPage.costs.isMaking && !vandplanPage.costs.fault');
const press = (page) => page.value('document.getElementById("yard").focus()').then(() => page.key('c'));

/** The colour of a place of the yard, without what is planned. */
const colourAt = (page, x, y) => page.value(`(() => { const p = vandplanPage, [u, v] = p.view.toPage([${x}, ${y}]).map((one) => Math.round(one * p.view.ratio)), {shown, pointer} = p;
  p.editor.select(null); p.shown = p.pointer = null; p.drawn(true); Object.assign(p, {shown, pointer}); return [...p.context.getImageData(u, v, 1, 1).data].slice(0, 3); })()`);
const apart = (a, b) => Math.max(...a.map((one, i) => Math.abs(one - b[i])));

/** `help`: {expect, found, click, choose, dropped, picture} of the test that opens the page. */
export async function showsCosts(page, help) {
  await coloursTheYard(page, help);
  await saysWhatPlacesCost(page, help);
  await plansWithTheTable(page, help);
  await followsChanges(page, help);
  await takesSeveralDocks(page, help);
  await saysWhyNot(page, help);
}

async function coloursTheYard(page, help) {
  const {expect, found, click, picture} = help;
  await drop(page, help, 'one dock', oneDock);
  await found(page);
  const places = [[24, 5.3], [-15.4, 8.3], [20, -18]];
  const before = [];
  for (const place of places) before.push(await colourAt(page, ...place));
  expect(!(await isSeen(page, 'legend')), 'without colours there is no legend');
  await click(page, 'costs');
  await isMade(page);
  expect((await page.value('document.getElementById("costs").getAttribute("aria-pressed")')) === 'true', 'the button is pressed');
  const after = [];
  for (const place of places) after.push(await colourAt(page, ...place));
  expect(after.every((colour, i) => i === 1 || apart(colour, before[i]) > 12), `the yard is coloured: ${before}; ${after}`);
  expect(apart(after[0], before[0]) > apart(after[1], before[1]) + 30, `near the dock more than far from it: ${after}`);
  const wall = await colourAt(page, 1, 3.3);
  expect(apart(wall, after[0]) > 30, 'walls lie above it');
  expect(await isSeen(page, 'legend'), 'there is a legend');
  await picture(page, 'desk-costs');
}

/** Takes the mouse off the yard, onto the panel. */
async function leaves(page) {
  await page.mouse('mouseMoved', [1300, 400]);
  await page.until('vandplanPage.pointer === null');
  await page.value('vandplanPage.drawn(true)');
}

async function saysWhatPlacesCost(page, {expect}) {
  await page.mouse('mouseMoved', [700, 400]);
  await page.until('vandplanPage.pointer !== null');
  await leaves(page);
  const cost = await page.value('vandplanPage.result.cost');
  const truck = Number((await textOf(page, 'costs-here')).match(/^From the truck: (\d+) m$/)?.[1]);
  expect(Math.abs(truck / cost - 1) < 0.25, `the truck's cost is ${truck}, that of its path ${cost}`);
  const over = async (x, y) => {
    await page.mouse('mouseMoved', await page.value(`vandplanPage.view.toPage([${x}, ${y}])`));
    await page.until(`vandplanPage.at && Math.hypot(vandplanPage.at[0] - ${x}, vandplanPage.at[1] - ${y}) < 1`);
    await page.value('vandplanPage.drawn(true)');
    return textOf(page, 'costs-here');
  };
  const numbers = [];
  for (const x of [19.5, 10, -10, -18]) numbers.push(Number((await over(x, 0)).match(/^From there: (\d+) m$/)?.[1]));
  expect(numbers.every((one, i) => i === 0 || one > numbers[i - 1]), `the farther the dearer: ${numbers}`);
  expect(numbers[0] < 4 && numbers[2] > 35, `around the wall it is far: ${numbers}`);
  await over(10, 0);
  // Along the rear of the vehicle, where its label is not.
  const [shades, label] = await page.value(`(() => { const p = vandplanPage, {pointer} = p, v = p.scene.vehicle, {x, y, heading} = p.costs.bestAt(p.at);
    const place = (ahead, aside) => [x + ahead * Math.cos(heading) - aside * Math.sin(heading), y + ahead * Math.sin(heading) + aside * Math.cos(heading)];
    const rear = Array.from({length: 40}, (_, i) => place(-v.rear_overhang, (i / 39 - 0.5) * v.width)), middle = Array.from({length: 40}, (_, i) => place((v.wheelbase + v.front_overhang - v.rear_overhang) / 2 + (i - 20) * 0.03, 0));
    const shot = (places) => p.drawn(true) ?? places.map((one) => p.context.getImageData(...p.view.toPage(one).map((k) => Math.round(k * p.view.ratio)), 1, 1).data[1]);
    const own = [shot(rear), shot(middle)]; p.pointer = null; const none = [shot(rear), shot(middle)]; p.pointer = pointer;
    return own.map((line, k) => line.filter((shade, i) => Math.abs(shade - none[k][i]) > 40).length); })()`);
  expect(shades > 5 && label > 5, `the vehicle is drawn there, and its cost: ${shades}, ${label} of 40 places differ`);
  expect((await over(1, 5)) === 'From there: no way', 'from within a wall there is no way');
  await leaves(page);
}

/** With the table a path is there before anything is searched; without it, with the same luck, it is found later. */
async function plansWithTheTable(page, {expect, picture}) {
  await page.until('vandplanPage.without?.anytime.length && vandplanPage.result?.path', 120);
  const [iteration, later] = await page.value('[vandplanPage.result.anytime[0].iteration, vandplanPage.without.anytime[0].iteration]');
  expect(iteration === 0 && later > 0, `the first path comes in round ${iteration} with the table, ${later} without`);
  await page.value('vandplanPage.drawn(true)');
  const news = await textOf(page, 'costs-news');
  expect(/^A path of \d+ m: after [<\d. ]+m?s with the table, (after|not in) [<\d. ]+m?s without$/.test(news), `the legend says "${news}"`);
  expect(await isSeen(page, 'trace-without'), 'the curve without it is named');
  await picture(page, 'desk-costs-trace');
}

/** A wall or another price makes another table; undo, and the key, take it back. */
async function followsChanges(page, {expect, click}) {
  const truck = async () => {
    await isMade(page);
    await page.value('vandplanPage.drawn(true)');
    return Number((await textOf(page, 'costs-here')).match(/\d+/)[0]);
  };
  const before = await truck();
  await page.value('vandplanPage.history.remember(vandplanPage.scene); vandplanPage.scene.obstacles.push([[0, -24], [2, -24], [2, -8], [0, -8]]); vandplanPage.changed("ground")');
  const closed = await truck(); // the way around the other end is longer
  expect(closed > before + 10, `a wall makes it dearer: ${before}, ${closed}`);
  const [full, faint] = await page.value(`(() => { const p = vandplanPage, [u, v] = p.view.toPage([24, 5.3]).map((one) => Math.round(one * p.view.ratio));
    const colour = () => p.drawn(true) ?? [...p.context.getImageData(u, v, 1, 1).data]; p.pointer = null; const full = colour(); p.scene.goal.x += 3; p.changed('ends'); return [full, colour()]; })()`);
  expect(faint[1] > full[1] + 20, `what is not of this dock is faint: ${full}, ${faint}`);
  await pause(300); // a table may be on its way then, or be there: nobody waits for it
  await page.value('vandplanPage.scene.goal.x -= 1; vandplanPage.changed("ends"); vandplanPage.drawn(true)');
  await isMade(page);
  expect(await page.value('vandplanPage.costs.made.goals[0].x === 22'), 'the table is that of the last goal');
  await click(page, 'undo');
  expect((await truck()) === before, 'undo brings the costs back');
  await page.value("(() => { const s = document.getElementById('margin'); s.value = 1; s.dispatchEvent(new Event('input')); })()");
  await truck();
  await page.until('vandplanPage.result?.path && vandplanPage.result.anytime[0].iteration === 0');
  await click(page, 'as-driver');
  await press(page);
  await page.until('!vandplanPage.costs.isOn && !vandplanPage.dirty');
  await page.value('vandplanPage.drawn(true)');
  expect(!(await isSeen(page, 'legend')), 'the key takes the colours away');
  await press(page);
  await isMade(page);
}

async function takesSeveralDocks(page, help) {
  await drop(page, help, 'two docks', twoDocks);
  await isMade(page);
  help.expect((await page.value('vandplanPage.costs.made.goals.length')) === 3, 'a dock either way is two goals');
  const [one, other] = await page.value('[[20, 0], [-15, 15]].map((at) => vandplanPage.costs.bestAt(at).cost)');
  help.expect(one < 2 && other < 2, `each dock is near itself: ${one}, ${other}`);
}

/** Where there is no table, the page says why, and plans as before. */
async function saysWhyNot(page, help) {
  await drop(page, help, 'with movers', moving);
  await page.until('document.getElementById("costs-news").textContent === "No table: a table knows no moving obstacles"');
  await help.found(page);
  help.expect(!(await isSeen(page, 'costs-scale')), 'nothing is coloured then');
  await press(page);
  await page.until('!vandplanPage.costs.isOn');
}

/** On a phone the legend covers neither panel nor buttons, and a tap says what a place costs. */
export async function showsCostsByTouch(page, help) {
  const {expect, click, picture} = help;
  await drop(page, help, 'one dock', oneDock);
  await click(page, 'costs');
  await isMade(page);
  const [legend, panel, top] = await page.value(`['legend', 'panel', 'top'].map((id) => (({left, right, top, bottom}) => ({left, right, top, bottom}))(document.getElementById(id).getBoundingClientRect()))`);
  expect(legend.left >= 0 && legend.right <= 390 && legend.bottom < panel.top && legend.top >= top.bottom, `the legend is ${JSON.stringify(legend)}, between ${top.bottom} and ${panel.top}`);
  const at = await page.value('vandplanPage.view.toPage([-15, 12])');
  await page.touch([at], 'touchStart');
  await page.touch([], 'touchEnd');
  await page.until('document.getElementById("costs-here").textContent.startsWith("From there")');
  await picture(page, 'phone-costs');
  await click(page, 'costs');
}
