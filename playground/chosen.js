// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What can be set of the goal, and of the zone or via that is selected.

import {entriesOf, withEntries} from './places.js';

const byId = (id) => document.getElementById(id);

const unlimited = 3; // what the slider of speeds says where there is no limit [m/s]
const degrees = (angle) => Math.round((((180 * angle) / Math.PI) % 360 + 360) % 360);
const widthOf = ([from, to]) => (to < from ? to + 2 * Math.PI : to) - from;
const middleOf = (range) => range[0] + widthOf(range) / 2;

/** The object with a key that has a value, or without it. */
function having(object, key, value) {
  const {[key]: _, ...rest} = object;
  return value === undefined ? rest : {...rest, [key]: value};
}

const entriesHaving = (key) => (place, value) => withEntries(place, (entry) => having(entry, key, value || undefined));

const oneWay = [-0.6, 0.6];

function wayOf({closed, direction}) {
  if (closed) return 'closed';
  return direction ? 'one' : '';
}

/** Each control: of what it is, what it shows of that, what a value makes of that, and how it says a value. */
const controls = {
  turns: {of: 'goal', shows: (goal) => entriesOf(goal)[0].turns ?? '', makes: entriesHaving('turns')},
  straight: {of: 'goal', shows: (goal) => entriesOf(goal)[0].straight ?? 0, makes: entriesHaving('straight'), says: (value) => `${value} m`},
  'via-turns': {of: 'via', shows: (via) => entriesOf(via)[0].turns ?? '', makes: entriesHaving('turns')},
  'via-stop': {of: 'via', shows: (via) => Boolean(via.stop), makes: (via, value) => having(via, 'stop', value || undefined)},
  'zone-way': {
    of: 'zones', shows: wayOf,
    makes: (zone, value) => having(having(zone, 'closed', value === 'closed' || undefined), 'direction', value === 'one' ? (zone.direction ?? oneWay) : undefined),
  },
  'zone-heading': {
    of: 'zones', shows: ({direction}) => degrees(middleOf(direction ?? oneWay)), says: (value) => `${value}\u00B0`,
    makes: (zone, value) => {
      const by = (Math.PI * value) / 180 - middleOf(zone.direction ?? oneWay);
      return having(zone, 'direction', (zone.direction ?? oneWay).map((one) => one + by));
    },
  },
  'zone-gears': {of: 'zones', shows: ({gears = 'both'}) => gears, makes: (zone, value) => having(zone, 'gears', value === 'both' ? undefined : value)},
  'zone-cost': {of: 'zones', shows: ({cost = 1}) => cost, makes: (zone, value) => having(zone, 'cost', value === 1 ? undefined : value), says: (value) => `${value} \u00D7`},
  'zone-speed': {
    of: 'zones', shows: ({max_speed: most = unlimited}) => most, makes: (zone, value) => having(zone, 'max_speed', value === unlimited ? undefined : value),
    says: (value) => (value === unlimited ? 'any' : `${value} m/s`),
  },
  'zone-body': {of: 'zones', shows: ({body}) => Boolean(body), makes: (zone, value) => having(zone, 'body', value || undefined)},
};

const titles = {zones: 'Zone', via: 'Via'};

function valueOf({type, value, checked}) {
  if (type === 'checkbox') return checked;
  return type === 'range' ? Number(value) : value;
}

function says(id, value) {
  const {says: text} = controls[id];
  if (text) byId(id).parentElement.querySelector('.value').textContent = text(Number(Number(value).toPrecision(3)));
}

/** The object that a control is of: one that is selected, or the goal. */
function objectOf(scene, selected, kind) {
  if (kind === 'goal') return scene.goal;
  return selected?.kind === kind ? scene[kind][selected.index] : undefined;
}

let before = '';

/** Lets the controls show the scene, and those be seen that are of what is selected. */
export function showChosen(scene, selected) {
  const own = titles[selected?.kind] ? scene[selected.kind][selected.index] : undefined;
  const now = JSON.stringify([selected, own, scene.goal]);
  if (now === before) return;
  before = now;
  const title = own ? own.name || `${titles[selected.kind]} ${selected.index + 1}` : '';
  byId('chosen').hidden = !own;
  byId('chosen-title').textContent = title;
  byId('more').textContent = own ? `${title}, prices and planner` : 'Prices and planner';
  for (const [id, {of, shows}] of Object.entries(controls)) {
    const object = objectOf(scene, selected, of);
    if (of !== 'goal') byId(id).parentElement.hidden = !object || (id === 'zone-heading' && !object.direction);
    if (!object) continue;
    const value = shows(object);
    if (typeof value === 'boolean') byId(id).checked = value;
    else byId(id).value = value;
    says(id, value);
  }
}

/** Calls `change(kind, made)` when somebody sets something: `made` makes a new object of the old one; `begins`: it can be undone to here. */
export function listenToChosen(change) {
  for (const [id, {of, makes}] of Object.entries(controls)) {
    const isSlider = byId(id).type === 'range';
    let goesOn = false; // a slider that is held
    byId(id).addEventListener(isSlider ? 'input' : 'change', ({target}) => {
      change(of, (object) => makes(object, valueOf(target)), {begins: !goesOn});
      goesOn = isSlider;
    });
    byId(id).addEventListener('change', () => {
      goesOn = false;
    });
  }
}
