// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How it works: four things to play with.

import {near} from './explain_near.js';
import {known, trees} from './explain_trees.js';
import {wordsAround} from './explain_words.js';
import {paletteOf} from './paint.js';

/** An element with text and children; text is never read as HTML. */
export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** A canvas that knows its size; `act(place, event)` at each movement over it, in metres. */
export function stage(canvas, span, act) {
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    const scale = box.width / span;
    return [(event.clientX - box.left - box.width / 2) / scale, -(event.clientY - box.top - box.height / 2) / scale];
  };
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener('pointermove', (event) => act(place(event), event));
  canvas.addEventListener('pointerdown', (event) => act(place(event), event));
  return {
    /** The context in metres around the middle, and pixels a metre; null while hidden. */
    begin(colours) {
      const ratio = Math.min(devicePixelRatio || 1, 2);
      const width = Math.round(canvas.clientWidth * ratio);
      const height = Math.round(canvas.clientHeight * ratio);
      if (!width) return null;
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
      const context = canvas.getContext('2d');
      const scale = width / span;
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.fillStyle = colours.grid;
      context.fillRect(0, 0, width, height);
      context.setTransform(scale, 0, 0, -scale, width / 2, height / 2);
      return {context, view: {scale: scale / ratio}, height: height / scale};
    },
  };
}

/** Fills the page; what comes back is told when it is shown and when colours change. */
export function explain(root, vandplan) {
  const parts = [near, trees, known, wordsAround].map((make) => make(root, vandplan));
  let colours = paletteOf(document.documentElement);
  const all = (method, ...rest) => parts.forEach((part) => part[method]?.(...rest));
  return {
    shown(on) {
      colours = paletteOf(document.documentElement);
      all('shown', on, colours);
    },
    recolour() {
      colours = paletteOf(document.documentElement);
      all('shown', !root.hidden, colours);
    },
  };
}
