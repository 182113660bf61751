// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Mouse, touch and keyboard on the yard.

import {contains, distance, fromSide, outlines} from './geometry.js';
import {turnHandle} from './paint.js';
import {areaOf, entriesOf, poseOf} from './places.js';
import {centreAt, copyOf, isGround, moveItem, polygonAt, removeItem, turnItem} from './scene.js';

const sameItem = (a, b) => a && b && a.kind === b.kind && a.index === b.index;

/** All that can be selected, in the order of the key N. */
const itemsOf = (scene) => [
  {kind: 'goal'},
  ...(scene.goal.any_of ?? []).map((_, index) => ({kind: 'goal', index})),
  {kind: 'start'},
  ...['via', 'obstacles', 'kerbs', 'zones'].flatMap((kind) => scene[kind].map((_, index) => ({kind, index}))),
];

const changeOf = (item) => (isGround(item) ? 'ground' : 'ends');

export class Editor {
  selected = null;
  #pointers = new Map();
  #drag = null;
  #pinch = null;

  /**
   * `page`: {scene, view, history, snap(), changed(kind), drawn(), played()}; `changed` is called with
   * 'ends' or 'ground' after each change.
   */
  constructor(canvas, page) {
    this.canvas = canvas;
    this.page = page;
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    for (const kind of ['pointerup', 'pointercancel']) canvas.addEventListener(kind, (event) => this.#up(event));
    canvas.addEventListener('wheel', (event) => this.#wheel(event), {passive: false});
    canvas.addEventListener('keydown', (event) => this.#key(event));
  }

  get dragging() {
    return this.#drag !== null && this.#drag.kind !== 'pan';
  }

  select(item) {
    this.selected = item;
    this.page.drawn();
  }

  /**
   * What lies under a point of the page: {kind: 'turn' | 'corner' | 'move' | 'pan', item, corner, tapped}. Whoever taps
   * it, and drags nothing, selects `tapped`: a zone, on which the ground can be dragged, or one of several goals.
   */
  #hit(point, reach) {
    const {scene, view} = this.page;
    const turnable = [this.selected, {kind: 'goal'}, {kind: 'start'}].filter(Boolean);
    for (const item of turnable) {
      const handle = view.toPage(turnHandle(view, scene, item, centreAt(scene, item)));
      if (distance(handle, point) < reach + 4) return {kind: 'turn', item};
    }
    const polygon = this.selected && polygonAt(scene, this.selected);
    if (polygon && polygon.length <= 40) {
      const corner = polygon.findIndex((place) => distance(view.toPage(place), point) < reach);
      if (corner >= 0) return {kind: 'corner', item: this.selected, corner};
    }
    return this.#body(view.toYard(point), reach / view.scale);
  }

  #body(place, reach) {
    const {scene} = this.page;
    const near = (polygon) =>
      contains(polygon, place) || polygon.some((corner, i) => fromSide(place, corner, polygon[(i + 1) % polygon.length]) < reach / 2);
    const polygon = this.selected && polygonAt(scene, this.selected);
    const own = polygon && near(polygon) ? {kind: 'move', item: this.selected} : null;
    if (own && this.selected.kind !== 'zones') return own; // what stands in a zone lies above it
    const isThere = (entry) => [...outlines(scene.vehicle, poseOf(scene.vehicle, entry)), areaOf(entry) ?? []].some(near);
    const dock = entriesOf(scene.goal).findIndex(isThere);
    if (dock >= 0) return this.#goal(dock);
    if (isThere(scene.start)) return {kind: 'move', item: {kind: 'start'}};
    const via = scene.via.findIndex((one) => entriesOf(one).some(isThere));
    if (via >= 0) return {kind: 'move', item: {kind: 'via', index: via}};
    for (const kind of ['obstacles', 'kerbs']) {
      const index = scene[kind].findLastIndex(near);
      if (index >= 0) return {kind: 'move', item: {kind, index}};
    }
    if (own) return own;
    const zone = scene.zones.findLastIndex(({area}) => near(area));
    return {kind: 'pan', item: null, tapped: zone >= 0 ? {kind: 'zones', index: zone} : null};
  }

  /** Goals are dragged together, until one of them has been tapped. */
  #goal(index) {
    if (!this.page.scene.goal.any_of) return {kind: 'move', item: {kind: 'goal'}};
    const {kind, index: chosen} = this.selected ?? {};
    if (kind !== 'goal') return {kind: 'move', item: {kind: 'goal'}};
    const one = {kind: 'goal', index};
    return chosen === undefined ? {kind: 'move', item: {kind: 'goal'}, tapped: one} : {kind: 'move', item: one};
  }

  #point(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  #down(event) {
    if (event.button > 0 && event.pointerType === 'mouse') return;
    this.canvas.focus({preventScroll: true});
    document.body.classList.remove('keys');
    this.canvas.setPointerCapture(event.pointerId);
    const point = this.#point(event);
    this.#pointers.set(event.pointerId, point);
    if (this.#pointers.size === 2) {
      this.#drag = null;
      const [a, b] = [...this.#pointers.values()];
      this.#pinch = {apart: distance(a, b), middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]};
      return;
    }
    const hit = this.#hit(point, event.pointerType === 'mouse' ? 9 : 20);
    this.#drag = {...hit, point, last: point, before: copyOf(this.page.scene), moved: false};
    if (!sameItem(hit.item, this.selected)) this.select(hit.item);
    this.page.grabbed?.();
  }

  #move(event) {
    const point = this.#point(event);
    if (!this.#pointers.has(event.pointerId)) {
      if (event.pointerType === 'mouse') this.canvas.style.cursor = this.#cursor(this.#hit(point, 9).kind);
      return;
    }
    this.#pointers.set(event.pointerId, point);
    if (this.#pinch && this.#pointers.size === 2) this.#pinched();
    else if (this.#drag) this.#dragged(point);
  }

  #cursor(kind) {
    return {turn: 'alias', corner: 'crosshair', move: 'move', pan: 'grab'}[kind];
  }

  #pinched() {
    const [a, b] = [...this.#pointers.values()];
    const apart = distance(a, b);
    const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    this.page.view.pan(middle[0] - this.#pinch.middle[0], middle[1] - this.#pinch.middle[1]);
    this.page.view.zoom(apart / this.#pinch.apart, middle);
    this.#pinch = {apart, middle};
    this.page.drawn();
  }

  #dragged(point) {
    const drag = this.#drag;
    const {scene, view, history} = this.page;
    if (!drag.moved && distance(point, drag.point) < 3) return;
    if (drag.kind === 'pan') {
      drag.moved = true;
      view.pan(point[0] - drag.last[0], point[1] - drag.last[1]);
      drag.last = point;
      this.page.drawn();
      return;
    }
    if (!drag.moved) history.remember(scene);
    drag.moved = true;
    const [x0, y0] = view.toYard(drag.point);
    const [x, y] = view.toYard(point);
    if (drag.kind === 'move') moveItem(scene, drag.item, drag.before, x - x0, y - y0, this.page.snap());
    else if (drag.kind === 'corner') this.#dragCorner(drag, [x, y]);
    else this.#turn(drag, [x, y], [x0, y0]);
    this.page.changed(changeOf(drag.item));
  }

  #dragCorner({item, corner}, [x, y]) {
    const place = this.page.snap() ? [Math.round(2 * x) / 2, Math.round(2 * y) / 2] : [x, y];
    polygonAt(this.page.scene, item)[corner] = place;
  }

  #turn({item, before}, [x, y], [x0, y0]) {
    const [cx, cy] = centreAt(before, item);
    const angle = Math.atan2(y - cy, x - cx) - Math.atan2(y0 - cy, x0 - cx);
    turnItem(this.page.scene, item, before, angle, this.page.snap());
  }

  #up(event) {
    this.#pointers.delete(event.pointerId);
    if (this.#pointers.size < 2) this.#pinch = null;
    if (!this.#pointers.size) {
      const tapped = this.#drag?.moved === false ? this.#drag.tapped : null;
      this.#drag = null;
      if (tapped) this.select(tapped);
      this.page.drawn();
    }
  }

  #wheel(event) {
    event.preventDefault();
    const step = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
    this.page.view.zoom(Math.exp(-0.0016 * step), this.#point(event));
    this.page.drawn();
  }

  #change(item, change) {
    const {scene, history} = this.page;
    history.remember(scene);
    change(copyOf(scene));
    this.page.changed(changeOf(item));
  }

  remove() {
    const item = this.selected;
    if (item?.index === undefined) return;
    this.#change(item, () => removeItem(this.page.scene, item));
    this.select(item.kind === 'goal' ? {kind: 'goal'} : null);
  }

  next(back) {
    const items = itemsOf(this.page.scene);
    const at = items.findIndex((item) => sameItem(item, this.selected));
    const step = back ? -1 : 1;
    this.select(items[at < 0 ? 0 : (at + step + items.length) % items.length]);
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    document.body.classList.add('keys');
    const {page} = this;
    const item = this.selected;
    const metres = event.shiftKey ? 0.1 : 1;
    const moves = {ArrowLeft: [-metres, 0], ArrowRight: [metres, 0], ArrowUp: [0, metres], ArrowDown: [0, -metres]};
    const turns = {',': 1, '.': -1, '<': 0.2, '>': -0.2};
    if (page.parking?.(event)) {
      event.preventDefault();
      return;
    }
    if (moves[event.key] && item) {
      this.#change(item, (before) => moveItem(page.scene, item, before, ...moves[event.key], false));
    } else if (moves[event.key]) {
      page.view.pan(...moves[event.key].map((way, i) => (i ? 1 : -1) * 60 * Math.sign(way)));
      page.drawn();
    } else if (turns[event.key] && item) {
      this.#change(item, (before) => turnItem(page.scene, item, before, (turns[event.key] * Math.PI) / 36, false));
    } else if (!page.key(event.key, event.shiftKey)) {
      return;
    }
    event.preventDefault();
  }
}
