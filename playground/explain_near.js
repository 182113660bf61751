// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How near is it? Three answers for every place around a truck.

import {element, stage} from './explain.js';
import {paintPath, paintTruck} from './paint.js';
import {vehicles} from 'catalogue';

const measures = [
  {name: 'euclid', label: 'As the crow flies'},
  {name: 'hlut-4', label: 'Looked up in a table'},
  {name: 'reeds-shepp', label: 'As a truck drives'},
];
const span = 44; // metres across
const cells = 88; // across
const far = 42; // metres, the end of the scale
const way = '#35e0c8'; // the colour of what is driven or flown, on all of the scale

/** From the accent colour where it is near to the ground's where it is far. */
function ramp(value) {
  const t = Math.min(1, value / far);
  const stops = [[0.10, 0.07, 0.25], [0.40, 0.10, 0.43], [0.75, 0.22, 0.32], [0.95, 0.48, 0.16], [0.99, 0.80, 0.42], [0.99, 0.96, 0.84]];
  const at = Math.min(stops.length - 1.001, t * (stops.length - 1));
  const i = Math.floor(at);
  return stops[i].map((one, k) => 255 * (one + (at - i) * (stops[i + 1][k] - one)));
}

const shades = new Uint8Array(3 * 512);
for (let i = 0; i < 512; ++i) shades.set(ramp((far * i) / 511), 3 * i);

function columnsOf(heading) {
  const x = new Float32Array(cells * cells);
  const y = new Float32Array(cells * cells);
  for (let i = 0; i < x.length; ++i) {
    x[i] = ((i % cells) + 0.5 - cells / 2) * (span / cells);
    y[i] = (Math.floor(i / cells) + 0.5 - cells / 2) * (span / cells);
  }
  return {x, y, heading: new Float32Array(x.length).fill(heading)};
}

/** A picture of lengths, row by row from below, with a line every 5 m. */
function imageOf(lengths) {
  const image = new ImageData(cells, cells);
  for (let row = 0; row < cells; ++row) {
    for (let column = 0; column < cells; ++column) {
      const length = lengths[row * cells + column];
      const shade = 3 * Math.min(511, Math.round((511 * Math.min(length, far)) / far));
      const at = 4 * (row * cells + column);
      image.data.set([shades[shade], shades[shade + 1], shades[shade + 2], 255], at);
    }
  }
  const canvas = Object.assign(document.createElement('canvas'), {width: cells, height: cells});
  canvas.getContext('2d').putImageData(image, 0, 0);
  return canvas;
}

export function near(root, vandplan) {
  const vehicle = vehicles['two-axle-truck'];
  const radius = 7;
  const state = {heading: 0, from: {x: 0, y: 3.4}, colours: null, on: false, frame: 0};
  const article = element('article', {},
    element('h2', {textContent: 'Three metres to the side is a long way'}),
    element('p', {textContent: 'A planner asks one question all the time: how near is this truck to that one? Move over a picture. The dashed truck is the goal; the colour says how far it is from each place, dark is near. As the crow flies, beside is near. A truck cannot drive sideways: from beside, it has to go back and forth.'}),
  );
  const maps = element('div', {className: 'maps'});
  const views = measures.map(({name, label}) => {
    const canvas = element('canvas', {ariaLabel: label});
    canvas.setAttribute('role', 'img');
    const number = element('b', {});
    maps.append(element('figure', {}, canvas, element('figcaption', {}, element('span', {textContent: label}), number)));
    return {name, canvas, number, stage: stage(canvas, span, ([x, y]) => {
      state.from = {x, y};
      draw();
    })};
  });
  const turn = element('input', {type: 'range', min: -180, max: 180, value: 0, step: 1, id: 'near-turn'});
  turn.addEventListener('input', () => {
    state.heading = (turn.value * Math.PI) / 180;
    draw();
  });
  const verdict = element('p', {});
  article.append(maps, element('div', {className: 'bench'}, element('label', {}, 'Turn your truck ', turn)), verdict);
  root.append(article);

  function draw() {
    if (!state.on || state.frame) return;
    state.frame = requestAnimationFrame(paintAll);
  }

  function paintAll() {
    state.frame = 0;
    const goal = {x: 0, y: 0, heading: 0};
    const from = {...state.from, heading: state.heading};
    const columns = columnsOf(state.heading);
    const here = {x: new Float32Array([from.x]), y: new Float32Array([from.y]), heading: new Float32Array([from.heading])};
    const path = {start: from, segments: vandplan.steer(from, goal, radius)};
    const rows = vandplan.sample(path, 0.2);
    const numbers = {};
    for (const {name, number, stage: place} of views) {
      const drawn = place.begin(state.colours);
      if (!drawn) return;
      const {context, view} = drawn;
      context.imageSmoothingEnabled = true;
      context.drawImage(imageOf(vandplan.distances(name, columns, goal, radius)), -span / 2, -span / 2, span, span);
      numbers[name] = vandplan.distances(name, here, goal, radius)[0];
      number.textContent = `${numbers[name].toFixed(1)} m`;
      const light = {...state.colours, accent: '#ffffff', 'accent-ink': '#ffffff', paper: '#1a1033', ink: '#1a1033', body: '#ffffff', glass: '#8d86b5'};
      paintTruck(context, view, vehicle, goal, light, {ghost: true});
      paintTruck(context, view, vehicle, from, {...light, body: '#ffffff90'});
      if (name !== 'euclid') {
        paintPath(context, view, rows, {...light, forward: way, reverse: way, 'accent-ink': way}, 3);
        continue;
      }
      context.beginPath();
      context.moveTo(from.x, from.y);
      context.lineTo(0, 0);
      context.strokeStyle = way;
      context.lineWidth = 3 / view.scale;
      context.stroke();
    }
    const times = numbers['reeds-shepp'] / Math.max(0.1, numbers.euclid);
    verdict.textContent = times > 1.5
      ? `From here the truck drives ${times.toFixed(1)} times as far as the crow flies. A search that asks the crow looks in the wrong places first.`
      : 'From here the crow is about right. Move beside the goal, or turn your truck.';
  }

  return {
    shown(on, colours) {
      Object.assign(state, {on, colours});
      draw();
    },
  };
}
