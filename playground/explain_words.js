// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// All ways of a few arcs and a line between two poses; the shortest of them is the shortest of all.

import {element, stage} from './explain.js';
import {paintPath, paintTruck} from './paint.js';
import {vehicles} from 'catalogue';

const span = 76;

export function wordsAround(root, vandplan) {
  const vehicle = vehicles['two-axle-truck'];
  const state = {goal: {x: 4, y: 9}, heading: 2.6, reverse: true, on: false, colours: null};
  const canvas = element('canvas', {className: 'exhibit wide', ariaLabel: 'All words between two poses'});
  canvas.setAttribute('role', 'img');
  const caption = element('p', {});
  const turn = element('input', {type: 'range', min: -180, max: 180, value: 149, step: 1, id: 'words-turn'});
  const reverse = element('input', {type: 'checkbox', checked: true, id: 'words-reverse'});
  const place = stage(canvas, span, ([x, y], event) => {
    if (event.buttons || event.pointerType === 'mouse') {
      state.goal = {x, y};
      draw();
    }
  });
  turn.addEventListener('input', () => {
    state.heading = (turn.value * Math.PI) / 180;
    draw();
  });
  reverse.addEventListener('change', () => {
    state.reverse = reverse.checked;
    draw();
  });
  root.append(element('article', {},
    element('h2', {textContent: 'Arcs, a line, arcs'}),
    element('p', {textContent: 'On open ground the shortest way between two poses is known: full left, full right or straight, a few of them in a row, forward or in reverse. There are 48 such words; the shortest that fits is the answer. It takes a tenth of a microsecond to find its length.'}),
    canvas,
    element('div', {className: 'bench'}, element('label', {}, 'Turn the goal ', turn), element('label', {}, reverse, ' may reverse')),
    caption,
  ));

  function draw() {
    if (!state.on) return;
    const drawn = place.begin(state.colours);
    if (!drawn) return;
    const {context, view} = drawn;
    const from = {x: 0, y: 0, heading: 0};
    const to = {...state.goal, heading: state.heading};
    const words = vandplan.words(from, to, vehicle.min_turning_radius, {reverse: state.reverse});
    words.slice(0, 24).reverse().forEach((segments, i, all) => {
      const rows = vandplan.sample({start: from, segments}, 0.4);
      const best = i === all.length - 1;
      context.globalAlpha = best ? 1 : 0.1 + (0.3 * i) / all.length;
      paintPath(context, view, rows, best ? state.colours : {...state.colours, forward: state.colours.soft, reverse: state.colours.soft, 'accent-ink': state.colours.soft}, best ? 3.5 : 1.25);
    });
    context.globalAlpha = 1;
    paintTruck(context, view, vehicle, to, state.colours, {ghost: true});
    paintTruck(context, view, vehicle, from, state.colours);
    const lengths = words.map((segments) => segments.reduce((sum, {length}) => sum + Math.abs(length), 0));
    caption.textContent = words.length
      ? `${words.length} words fit. The shortest is ${lengths[0].toFixed(1)} m, the longest ${lengths.at(-1).toFixed(1)} m.`
      : 'Both poses are the same.';
  }

  return {
    shown(on, colours) {
      Object.assign(state, {on, colours});
      draw();
    },
  };
}
