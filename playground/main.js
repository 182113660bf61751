// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Brings yard, files, buttons and the page together. The same script is the second thread.

import {scenarios, vehicles} from 'catalogue';
import {load} from 'vandplan';

import {listenToChosen} from './chosen.js';
import {explain} from './explain.js';
import {dropped, linkOf, sceneFromLink, scenesFrom, yamlOf} from './files.js';
import {sceneOnMap} from './maps.js';
import {Page} from './page.js';
import * as panel from './panel.js';
import {work} from './planning.js';
import {ReadError, vehicle} from './reading.js';
import {scenarioOf} from './scene.js';

const byId = (id) => document.getElementById(id);

/** The scene of a yard of the list. */
function listed(source) {
  const {text, name, goal = 0} = scenarios[source];
  return {...scenesFrom(text, name)[goal], source};
}

// ---- files ----

function download(blob, name) {
  const link = Object.assign(document.createElement('a'), {href: URL.createObjectURL(blob), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const fileName = (scene) => scene.name.replace(/[^\w-]+/g, '-').slice(0, 60) || 'yard';

/** Opens what somebody dropped or chose: a scenario, a map, or a scenario with its maps. */
async function openFiles(page, list) {
  const {scenario, maps} = await dropped(list);
  if (scenario) return page.open(scenesFrom(scenario.text, scenario.name, maps)[0], {keep: true});
  const [map] = maps.values();
  const free = (scene) => {
    const yard = page.vandplan.yard(scenarioOf(scene));
    return (pose) => yard.isFree({pose, vehicle: scene.vehicle});
  };
  page.open(sceneOnMap(map, vehicle('tpcap-car'), free), {keep: true});
}

/** Runs `act`; what it throws is shown. */
const told = (act) => async (...all) => {
  try {
    await act(...all);
  } catch (error) {
    panel.note(error.message);
    if (!(error instanceof ReadError) && error.name !== 'InputError') throw error;
  }
};

function listenToFiles(page) {
  byId('open').addEventListener('click', () => byId('file').click());
  byId('file').addEventListener('change', told(async ({target}) => {
    await openFiles(page, target.files);
    target.value = '';
  }));
  byId('save').addEventListener('click', () => download(new Blob([yamlOf(page.sceneAsSet())], {type: 'text/yaml'}), `${fileName(page.scene)}.yaml`));
  byId('picture').addEventListener('click', async () => download(await page.picture(), `${fileName(page.scene)}.png`));
  byId('link').addEventListener('click', told(async () => {
    if (page.scene.map || page.scene.masks.length) throw new ReadError('A scene with a map is too large for a link: save it instead');
    location.hash = await linkOf(page.sceneAsSet());
    let copied = false;
    try {
      await navigator.clipboard.writeText(location.href);
      copied = true;
    } catch { /* the address bar has it */ }
    panel.note(copied ? 'The link is copied.' : 'The address of the page is the link now.');
  }));
  const drop = (over) => document.body.classList.toggle('dropping', over);
  addEventListener('dragover', (event) => {
    event.preventDefault();
    drop(true);
  });
  addEventListener('dragleave', (event) => !event.relatedTarget && drop(false));
  addEventListener('drop', told(async (event) => {
    event.preventDefault();
    drop(false);
    await openFiles(page, event.dataTransfer.files);
  }));
  addEventListener('hashchange', told(async () => {
    const scene = await sceneFromLink(location.hash);
    if (scene) page.open(scene, {keep: true});
  }));
}

// ---- buttons ----

function show(page, how) {
  document.body.classList.toggle('how', how);
  byId('how').hidden = !how;
  byId('plan').hidden = how;
  document.querySelector('#top label').style.visibility = how ? 'hidden' : '';
  byId('show-plan').setAttribute('aria-pressed', String(!how));
  byId('show-how').setAttribute('aria-pressed', String(how));
  page.how ??= explain(byId('how'), page.vandplan);
  page.how.shown(how);
  if (!how) page.drawn();
}

function setTheme(page, theme) {
  document.documentElement.dataset.theme = theme;
  page.recolour();
  page.how?.recolour();
}

function listenToButtons(page) {
  const clicks = {
    play: () => page.toggleDrive(), costs: () => page.toggleCosts(), undo: () => page.undo(), redo: () => page.redo(), fit: () => page.fit(), park: () => page.togglePark(),
    remove: () => page.editor.remove(), 'add-wall': () => page.add('obstacles'), 'add-kerb': () => page.add('kerbs'), 'add-zone': () => page.add('zones'), 'add-dock': () => page.add('goal'), 'add-via': () => page.add('via'),
    'as-driver': () => page.style(), 'as-shortest': () => page.style(panel.shortest),
    help: () => byId('about').showModal(), 'about-close': () => byId('about').close(),
    'show-plan': () => show(page, false), 'show-how': () => show(page, true),
    theme: () => setTheme(page, document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark'),
    more: () => {
      const open = byId('panel').classList.toggle('open');
      byId('more').setAttribute('aria-expanded', String(open));
    },
  };
  for (const [id, act] of Object.entries(clicks)) byId(id).addEventListener('click', act);
  panel.listen((key, value) => page.set(key, value));
  listenToChosen((...what) => page.remake(...what));
  byId('scenario').addEventListener('change', told(({target}) => {
    if (target.value !== '') page.open(listed(Number(target.value)), {keep: true});
  }));
  addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || (key !== 'z' && key !== 'y') || byId('plan').hidden) return;
    event.preventDefault();
    if (event.shiftKey || key === 'y') page.redo();
    else page.undo();
  });
  for (const button of document.querySelectorAll('#pad [data-key]')) {
    const press = (down) => () => page.parked?.key(button.dataset.key, down);
    button.addEventListener('pointerdown', press(true));
    for (const kind of ['pointerup', 'pointercancel', 'lostpointercapture', 'pointerleave']) button.addEventListener(kind, press(false));
    button.addEventListener('contextmenu', (event) => event.preventDefault()); // a long press on a phone
  }
  byId('give-up').addEventListener('click', () => page.togglePark());
  addEventListener('blur', () => page.parked?.release()); // whoever leaves the page lets go of its keys
  addEventListener('keyup', (event) => page.parked?.key(event.key, false));
}

async function start() {
  const page = new Page(await load());
  const dark = matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', () => setTheme(page, dark.matches ? 'dark' : 'light'));
  panel.fillChoice('scenario', scenarios.map(({label, group}, value) => ({value, label, group})));
  panel.fillChoice('vehicle', [{value: '', label: 'of the scenario'}, ...Object.keys(vehicles).map((name) => ({value: name, label: name.replaceAll('-', ' ')}))]);
  panel.fillChoice('planner', [...page.planners.keys()].map((name) => ({value: name, label: name})), 'anytime');
  listenToFiles(page);
  listenToButtons(page);
  setTheme(page, dark.matches ? 'dark' : 'light');
  page.vandplan.plan(scenarioOf(listed(0)), {time_limit: 0.02}); // what has run once runs faster
  await told(async () => {
    const scene = await sceneFromLink(location.hash);
    if (scene) page.open(scene);
  })();
  if (!page.scene) page.open(listed(0));
  page.canvas.focus({preventScroll: true}); // keys work at once
  globalThis.vandplanPage = page; // for those who look behind the page, and its tests
}

if (typeof document === 'undefined') work();
else start();
