// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Numbers, sliders and choices beside the yard.

const byId = (id) => document.getElementById(id);

const choices = ['gears', 'steering'];
export const sliders = ['gear_change_cost', 'reverse_weight', 'clearance_weight', 'curvature_change_cost', 'margin'];
/** The settings among options. */
export const settingsIn = (options) => ({
  ...(options.style === 'shortest' ? shortest : {}),
  ...Object.fromEntries([...sliders, ...choices].filter((key) => options[key] !== undefined).map((key) => [key, options[key]])),
});
/** A driver's settings with these prices. */
export const driverOf = (prices) => ({...settingsIn(prices), margin: 0, gears: 'both', steering: 'continuous-between-stops'});
export const shortest = {gear_change_cost: 0, reverse_weight: 1, clearance_weight: 0, curvature_change_cost: 0, margin: 0, steering: 'reeds-shepp'};

const words = {
  start_in_collision: 'The truck stands in something',
  goal_in_collision: 'The goal is in something',
  no_path: 'Proven: there is no way',
  iteration_limit: 'No way found yet',
  node_limit: 'No way found yet',
  time_limit: 'No way found yet',
  searching: 'Searching \u2026',
  rejected: 'The judge rejects the path',
};

export const duration = (seconds) =>
  seconds < 1e-4 ? '< 0.1 ms' : seconds < 0.01 ? `${(1000 * seconds).toFixed(2)} ms` : seconds < 1 ? `${(1000 * seconds).toFixed(0)} ms` : `${seconds.toFixed(1)} s`;

const metres = (value) => (value === Infinity ? 'none near' : value === null ? '' : `${value.toFixed(value < 10 ? 2 : 1)} m`);

/** A reason of the planner without the keys of scenario files. */
const said = (reason) => reason.replace(/\bzones\[\d+\] \(([^)]*)\)/g, 'the zone "$1"').replace(/\bzones\[\d+\]/g, 'a zone').replace(/\bvia\[(\d+)\]/g, (_, i) => `via ${Number(i) + 1}`).replace(/\bobstacles\[\d+\]/g, 'a wall').replace(/\bkerbs\[\d+\]/g, 'a kerb').replace(/\binside\[\d+\]/g, 'the yard').replace(/\bmasks\[\d+\]/g, 'a mask').replace(/\bmoving\[\d+\]/g, 'what moves');

export function showResult(result, hash) {
  const status = byId('status');
  const {path, check} = result;
  status.className = path ? 'good' : result.status === 'searching' ? '' : 'bad';
  status.textContent = path ? `Judged: nothing touches` : words[result.status] + (result.reason ? `: ${said(result.reason)}` : '');
  const first = result.first ?? result.anytime[0];
  const gap = result.lower_bound > 0 && path ? result.cost / result.lower_bound - 1 : null;
  const texts = {
    first: first && path ? duration(first.time) : '',
    length: path ? metres(check.length) : '',
    gears: path ? String(check.gear_changes) : '',
    reverse: path ? metres(check.reverse_length) : '',
    clearance: path ? metres(check.clearance) : '',
    cost: path ? metres(result.cost) : '',
    gap: gap === null ? '' : gap < 0.0005 ? 'optimal' : `${(100 * gap).toFixed(gap < 0.1 ? 1 : 0)} %`,
  };
  for (const [name, text] of Object.entries(texts)) byId(`n-${name}`).textContent = text || '\u2013';
  byId('hash').textContent = hash ? `path ${hash}` : '';
}

export function showError(message) {
  const status = byId('status');
  status.className = 'bad';
  status.textContent = said(message);
  for (const dd of document.querySelectorAll('#numbers dd')) dd.textContent = '\u2013';
  byId('hash').textContent = '';
}

/** A canvas of the panel and its context in pixels of the page, empty; null while it is hidden. */
function sheet(canvas) {
  const ratio = devicePixelRatio || 1;
  const {clientWidth: width, clientHeight: height} = canvas;
  if (!width) return null;
  const size = {width: Math.round(width * ratio), height: Math.round(height * ratio)};
  if (canvas.width !== size.width || canvas.height !== size.height) Object.assign(canvas, size);
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return {context, width, height};
}

/**
 * The cost of the best path over time, which is drawn logarithmically, and below it what is proven that no path costs
 * less than: {time, bound} of each plan. Dashed: the cost `without` a table of the site, or null.
 */
export function paintTrace(colours, {anytime, time, path}, bounds, without) {
  const drawn = sheet(byId('trace'));
  byId('trace-without').hidden = !without;
  if (!drawn || !path || !anytime.length) return;
  const {context, width, height} = drawn;
  const other = without?.anytime ?? [];
  const least = Math.max(1e-5, Math.min(anytime[0].time, other[0]?.time ?? Infinity, bounds[0]?.time ?? Infinity));
  const span = Math.log(Math.max(time, 2 * least) / least);
  const best = anytime.at(-1).cost;
  const low = Math.min(best, other.at(-1)?.cost ?? best, ...bounds.map(({bound}) => bound));
  const high = Math.max(anytime[0].cost, other[0]?.cost ?? 0, 1.02 * best, 1.02 * low);
  const x = (t) => 4 + ((width - 8) * Math.log(Math.max(t, least) / least)) / span;
  const y = (cost) => 6 + (height - 14) * (1 - (cost - low) / (high - low));
  const steps = (samples) => {
    samples.forEach(([t, value], i) => {
      if (i) context.lineTo(x(t), y(samples[i - 1][1]));
      context.lineTo(x(t), y(value));
    });
    context.lineTo(width - 4, y(samples.at(-1)[1]));
  };
  const line = (samples, colour, wide) => {
    context.beginPath();
    steps(samples);
    context.strokeStyle = colour;
    context.lineWidth = wide;
    context.lineJoin = 'round';
    context.stroke();
  };
  const costsOf = (samples) => samples.map((sample) => [sample.time, sample.cost]);
  if (other.length) {
    context.setLineDash([3, 3]);
    line(costsOf(other), colours.ink, 1.5);
    context.setLineDash([]);
  }
  line(costsOf(anytime), colours.accent, 2);
  context.lineTo(width - 4, height);
  context.lineTo(x(anytime[0].time), height);
  context.globalAlpha = 0.12;
  context.fillStyle = colours.accent;
  context.fill();
  context.globalAlpha = 1;
  if (bounds.length) line(bounds.map(({time: t, bound}) => [t, bound]), colours.soft, 1.5);
}

function shown(slider, value) {
  const unit = slider.dataset.unit;
  const number = Number(value.toPrecision(3)); // a slider itself goes in steps
  slider.parentElement.querySelector('.value').textContent = `${number}${unit ? ' ' + unit : ''}`;
}

export function fillSettings(settings) {
  for (const key of sliders) {
    byId(key).value = settings[key];
    shown(byId(key), settings[key]);
  }
  for (const key of choices) byId(key).value = settings[key];
}

/** Calls `changed(key, value)` for each slider and choice. */
export function listen(changed) {
  for (const key of sliders) {
    byId(key).addEventListener('input', ({target}) => {
      shown(target, Number(target.value));
      changed(key, Number(target.value));
    });
  }
  for (const key of [...choices, 'planner', 'vehicle']) {
    byId(key).addEventListener('change', ({target}) => changed(key, target.value));
  }
}

/** Which settings the planner honours: others cannot be set. */
export function enable(info) {
  for (const key of sliders) if (key !== 'margin') byId(key).disabled = !info.capabilities.includes('prices');
  byId('gears').disabled = !info.capabilities.includes('gears');
  byId('steering').disabled = !info.capabilities.includes('steering');
}

const option = (value, label) => Object.assign(document.createElement('option'), {value, textContent: label});

/** Fills a list; choices with a `group` stand below its name. */
export function fillChoice(id, choices, value) {
  const groups = new Map();
  const entries = [];
  for (const {value: own, label, group} of choices) {
    if (group && !groups.has(group)) {
      groups.set(group, Object.assign(document.createElement('optgroup'), {label: group}));
      entries.push(groups.get(group));
    }
    const entry = option(own, label);
    if (group) groups.get(group).append(entry);
    else entries.push(entry);
  }
  const select = byId(id);
  select.replaceChildren(...entries);
  if (value !== undefined) select.value = value;
}

/** Which yard the list names: one of its own, or, above these, what came from a file or a link; below the verdict, what to do there. */
export function showYard({source, name, description}) {
  const select = byId('scenario');
  select.querySelector('[data-foreign]')?.remove();
  if (source === undefined) {
    const entry = option('', name.slice(0, 60));
    entry.dataset.foreign = '';
    select.prepend(entry);
  }
  select.value = source ?? '';
  byId('task').textContent = description;
}

let hiding = 0;

/** A line at the bottom of the page for some seconds. */
export function note(message, seconds = 4.5) {
  const element = byId('note');
  element.textContent = String(message).slice(0, 300);
  element.hidden = false;
  clearTimeout(hiding);
  hiding = setTimeout(() => {
    element.hidden = true;
  }, 1000 * seconds);
}
