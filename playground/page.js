// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The yard on the page: what is shown, what changes it, and when it is planned and painted.

import {vehicles} from 'catalogue';

import {showChosen} from './chosen.js';
import {Costs} from './costs.js';
import {beginDrive, drivenAt, parkedNote} from './driving.js';
import {Editor} from './edit.js';
import {showLegend} from './legend.js';
import {paletteOf} from './paint.js';
import * as panel from './panel.js';
import {Parking} from './parking.js';
import {paintPage} from './picture.js';
import {Planning, queryOf} from './planning.js';
import {vehicle} from './reading.js';
import {adders, changeVehicle, goalsOf, History, isGround, isThere, sceneBox} from './scene.js';
import {View} from './view.js';

const byId = (id) => document.getElementById(id);

export class Page {
  scene = null;
  history = new History();
  settings = {}; // what driving costs, the margin, gears and steering
  own = {}; // those that the scenario or somebody has set: all others are a driver's for the vehicle
  wanted = {}; // those that somebody has set
  result = null;
  known = null; // the last path of this scene, before it was changed
  shown = null; // of the path: {rows: s, x, y, heading, curvature, direction; trail: x, y, heading of the trailer, or null}
  dirty = false; // a plan is wanted in the next frame
  drive = null; // an animated drive (driving.js)
  parked = null; // somebody who parks by hand
  pointer = null; // where the mouse is on the canvas, or where it was tapped; null on what lies above it
  reached = 0; // which of several goals the last path led to
  bounds = []; // {time, bound}: what plans of this scene proved, and how long they took
  without = null; // how a plan of this scene went without the table of the site, beside the one with it
  #frame = 0;
  #colours = null;

  constructor(vandplan) {
    this.vandplan = vandplan;
    this.canvas = byId('yard');
    this.context = this.canvas.getContext('2d');
    this.view = new View(this.canvas);
    this.planners = new Map(vandplan.planners().map((info) => [info.name, info]));
    this.info = this.planners.get('anytime');
    const script = byId('app').textContent;
    this.planning = new Planning(vandplan, script, (result) => this.improved(result));
    this.costs = new Costs(vandplan, script, () => this.costed());
    this.editor = new Editor(this.canvas, this);
    this.snap = () => byId('snap').checked;
    new ResizeObserver(() => this.resized()).observe(this.canvas);
    for (const kind of ['pointermove', 'pointerdown', 'pointerleave']) this.canvas.addEventListener(kind, (event) => this.pointed(event));
  }

  // ---- what is shown ----

  /** Shows a scene, and all of it. What the planner refuses throws its InputError, and changes nothing. */
  open(scene, {keep = false} = {}) {
    ++this.planning.groundVersion;
    this.planning.yard(scene);
    if (keep && this.scene) this.history.remember(this.scene);
    this.scene = scene;
    this.known = null;
    this.reached = 0;
    this.editor.selected = null;
    this.stopDriving();
    this.own = {...this.wanted, ...panel.settingsIn(scene.options ?? {})};
    this.settle();
    this.named();
    this.changed('ends');
    this.fit();
  }

  /** Lets the lists say which yard and which vehicle are shown. */
  named() {
    panel.showYard(this.scene);
    const lengths = ({wheelbase, width, min_turning_radius: radius, outline, trailers}) => JSON.stringify([wheelbase, width, radius, outline, trailers]);
    byId('vehicle').value = Object.keys(vehicles).find((name) => lengths(vehicle(name)) === lengths(this.scene.vehicle)) ?? '';
  }

  /** What a driver of the vehicle of the scene would set. */
  driver = () => panel.driverOf(this.vandplan.prices('driver', this.scene.vehicle));

  /** Puts a driver's settings where nothing is set. */
  settle() {
    this.settings = {...this.driver(), ...this.own};
    panel.fillSettings(this.settings);
  }

  fit() {
    this.measure();
    this.view.fit(sceneBox(this.scene));
    this.drawn(true);
  }

  /** What panels cover of the canvas. */
  measure() {
    this.view.resize();
    const wide = this.view.width > 720;
    const [box, tools] = ['panel', 'tools'].map((id) => byId(id).getBoundingClientRect());
    this.view.inset = wide
      ? {left: 10, right: this.view.width - box.left, top: 66, bottom: this.view.height - tools.top + 8}
      : {left: 4, right: 4, top: 58, bottom: this.view.height - box.top};
  }

  resized() {
    if (!this.scene) return;
    const [x, y] = [this.view.x, this.view.y];
    this.measure();
    Object.assign(this.view, {x, y});
    this.drawn(true);
  }

  recolour() {
    this.#colours = paletteOf(document.documentElement);
    this.drawn();
  }

  // ---- changes ----

  changed(kind) {
    if (kind === 'ground') ++this.planning.groundVersion;
    this.stopParking();
    this.stopDriving();
    this.dirty = true;
    this.drawn();
  }

  /** Something has to be drawn in the next frame; `now` at once. */
  drawn(now = false) {
    if (now) {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
      this.frame(performance.now());
    } else if (!this.#frame) {
      this.#frame = requestAnimationFrame((time) => this.frame(time));
    }
  }

  frame(time) {
    this.#frame = 0;
    if (!this.scene) return;
    if (this.dirty) this.plan();
    if (this.parked) this.parkOn(time);
    this.paint(time);
    this.buttons();
    if (this.drive || this.parked) this.drawn();
    if (!this.painted) performance.mark('first-path');
    this.painted = performance.now();
  }

  plan() {
    this.dirty = false;
    this.bounds = [];
    this.without = null;
    this.moved ||= this.editor.dragging;
    try {
      const site = this.costs.isOn ? this.costs.of(this.scene, this.tableOptions(), this.planning.groundVersion) : null;
      const result = this.planning.now(this.scene, this.settings, this.info, this.editor.dragging ? this.known : null, site);
      this.take(result ?? {status: 'searching', path: null, anytime: []});
    } catch (error) {
      this.failed(error.message);
    }
  }

  failed(message) {
    this.result = null;
    this.shown = null;
    panel.showError(message);
  }

  take(result) {
    this.result = result;
    this.known = result.path ?? this.known;
    if (result.goal) this.reached = result.goal.index;
    if (result.lower_bound > 0) this.bounds.push({time: result.time, bound: result.lower_bound});
    this.shown = result.path ? this.placesOf(result.path) : null;
    panel.showResult(result, result.path && !this.editor.dragging ? this.vandplan.hash(result.path) : '');
    if (!this.editor.dragging) panel.paintTrace(this.#colours, result, this.bounds, this.without);
  }

  placesOf(path) {
    const {vehicle: driven, start} = this.scene;
    const step = 0.2;
    return {
      rows: this.vandplan.sample(path, step),
      trail: driven.trailers ? this.vandplan.trailer(path, driven, start.hitch_angles?.[0] ?? 0, step) : null,
    };
  }

  /** A longer run found something for the scene that is shown, or has an error to tell. */
  improved(result) {
    if (result.without) {
      this.without = result.without;
      if (this.result) panel.paintTrace(this.#colours, this.result, this.bounds, this.without);
      this.drawn();
      return;
    }
    if (result.status === 'error') {
      this.failed(result.reason);
      this.drawn();
      return;
    }
    const better = result.path && (!this.result?.path || result.cost <= this.result.cost + 1e-9);
    if (!better && this.result?.path) return;
    if (this.drive && result.path) return;
    // How soon there was a path is what the first plan says: the second thread had more time, and later.
    const first = this.result?.path ? this.result.anytime[0] : null;
    this.take(first ? {...result, first: this.result.first ?? first} : result);
    this.drawn();
  }

  // ---- what driving costs from everywhere ----

  /** Options of the plans that a table of the scene is for. */
  tableOptions = () => queryOf(this.scene, this.settings, this.planners.get('anytime'), null).options;

  toggleCosts() {
    this.costs.toggle();
    byId('costs').setAttribute('aria-pressed', String(this.costs.isOn));
    this.replan();
  }

  /** A table is made, or further, or there is none. */
  costed() {
    if (!this.costs.isMaking) this.replan();
    this.drawn();
  }

  /** Plans again, unless the truck drives. */
  replan() {
    this.dirty ||= !this.drive;
    this.drawn();
  }

  /** The mouse moves over the canvas, or a finger taps it. */
  pointed({type, pointerType, clientX, clientY}) {
    const says = this.costs.isOn || this.scene?.masks.length > 0; // something of the place
    if (pointerType !== 'mouse' && !(says && type === 'pointerdown')) return;
    const box = this.canvas.getBoundingClientRect();
    this.pointer = type === 'pointerleave' || this.editor.dragging ? null : [clientX - box.left, clientY - box.top];
    if (says) this.drawn();
  }

  /** The place under the mouse, in the yard, or null. */
  get at() {
    return this.pointer && this.view.toYard(this.pointer);
  }

  /** The scene with those settings among its options that it came with or that are not a driver's, for files and links. */
  sceneAsSet() {
    const options = {...this.scene.options};
    const driver = this.driver();
    for (const [key, value] of Object.entries(this.settings)) {
      if (key in options || value !== driver[key]) options[key] = value;
    }
    return {...this.scene, options};
  }

  restore(scene) {
    if (!scene) return;
    this.scene = scene;
    const {selected} = this.editor;
    if (selected && !isThere(scene, selected)) this.editor.selected = null;
    this.settle();
    this.named();
    this.changed('ground');
  }

  undo() {
    this.restore(this.history.undo(this.scene));
  }

  redo() {
    this.restore(this.history.redo(this.scene));
  }

  add(kind) {
    this.history.remember(this.scene);
    const item = adders[kind](this.scene, this.view.toYard(this.view.centre));
    this.changed(isGround(item) ? 'ground' : 'ends');
    this.editor.select(item);
    this.canvas.focus({preventScroll: true});
  }

  set(key, value) {
    if (key === 'planner') {
      this.info = this.planners.get(value);
      panel.enable(this.info);
    } else if (key === 'vehicle') {
      if (!vehicles[value]) return;
      this.history.remember(this.scene);
      changeVehicle(this.scene, vehicle(value));
      this.settle();
      if (this.scene.masks.length) ++this.planning.groundVersion; // they may give speeds in percent of the vehicle's
    } else {
      for (const all of [this.settings, this.own, this.wanted]) all[key] = value;
    }
    this.changed('ends');
  }

  /** Makes another object of the goal, or of what is selected; `begins`: undo comes back to what there was. */
  remake(kind, made, {begins}) {
    if (begins) this.history.remember(this.scene);
    const {index} = kind === 'goal' ? {} : this.editor.selected;
    if (index === undefined) this.scene.goal = made(this.scene.goal);
    else this.scene[kind][index] = made(this.scene[kind][index]);
    this.changed(isGround({kind}) ? 'ground' : 'ends');
  }

  /** Sets all settings but the gears; without any they are a driver's. */
  style(settings = {}) {
    const {gears} = this.settings;
    this.own = {...settings, gears};
    this.wanted = {...settings, gears};
    this.settle();
    this.changed('ends');
  }

  buttons() {
    byId('undo').disabled = !this.history.canUndo;
    byId('redo').disabled = !this.history.canRedo;
    byId('remove').disabled = this.editor.selected?.index === undefined;
    byId('play').disabled = !this.result?.path;
    byId('park').disabled = this.scene.via.length + this.scene.zones.length + this.scene.masks.length > 0; // nobody says there what hands may do
    showChosen(this.scene, this.editor.selected);
    showLegend(this);
  }

  key(key, shift) {
    const keys = {
      c: () => this.toggleCosts(), C: () => this.toggleCosts(), n: () => this.editor.next(shift), N: () => this.editor.next(shift), f: () => this.fit(), F: () => this.fit(), ' ': () => this.toggleDrive(),
      '+': () => this.zoom(1.25), '=': () => this.zoom(1.25), '-': () => this.zoom(0.8),
      Delete: () => this.editor.remove(), Backspace: () => this.editor.remove(), Escape: () => this.escape(),
    };
    if (!keys[key]) return false;
    keys[key]();
    return true;
  }

  escape() {
    this.stopParking();
    this.stopDriving();
    this.editor.select(null);
  }

  zoom(factor) {
    this.view.zoom(factor);
    this.drawn();
  }

  // ---- driving ----

  toggleDrive() {
    if (this.drive) this.stopDriving();
    else if (this.result?.path) {
      this.stopParking();
      const {path, drive, via} = this.result;
      const {start, vehicle: driven} = this.scene;
      const rows = drive ?? this.planning.yard(this.scene).drive({path, start, ...goalsOf(this.scene), vehicle: driven});
      this.drive = beginDrive(rows, this.scene, via, performance.now());
      byId('play').textContent = '\u25A0\uFE0E Stop';
    }
    this.drawn();
  }

  stopDriving() {
    this.drive = null;
    byId('play').textContent = '\u25B6\uFE0E Drive';
  }

  /** Where the driven truck is. */
  driven(time) {
    const driven = drivenAt(this.drive, this.shown, time);
    if (driven.isOver) this.stopDriving();
    return driven;
  }

  togglePark() {
    if (this.parked) {
      this.stopParking();
      this.drawn();
      return;
    }
    this.stopDriving();
    const yard = this.planning.yard(this.scene);
    const driven = this.scene.vehicle;
    this.parked = new Parking(this.scene, (pose) => yard.isFree({pose, vehicle: driven}), (pose, segment) => this.vandplan.advance(pose, driven, segment));
    this.parkedAt = performance.now();
    byId('park').setAttribute('aria-pressed', 'true');
    this.canvas.focus({preventScroll: true});
    byId('pad').hidden = false;
    panel.note('Your turn: arrow keys, or the buttons, drive the truck to the dashed one. Esc gives up.');
    this.drawn();
  }

  stopParking() {
    if (!this.parked) return;
    this.parked = null;
    byId('pad').hidden = true;
    byId('park').setAttribute('aria-pressed', 'false');
  }

  parking(event) {
    return Boolean(this.parked?.key(event.key, true));
  }

  parkOn(time) {
    const seconds = Math.min(0.05, Math.max(0, (time - this.parkedAt) / 1000));
    this.parkedAt = time;
    this.parked.step(seconds);
    if (!this.parked.done) return;
    panel.note(parkedNote(this.parked, this.result, this.settings), 12);
    this.stopParking();
  }

  // ---- painting ----

  paint(time) {
    paintPage(this, this.#colours, this.drive ? this.driven(time) : null);
  }

  /** What is on the canvas, without handles, as an image. */
  picture() {
    this.clean = true;
    this.drawn(true);
    return new Promise((resolve) => {
      this.canvas.toBlob((blob) => {
        this.clean = false;
        this.drawn();
        resolve(blob);
      });
    });
  }
}
