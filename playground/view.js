// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where on the canvas is a place in the yard?

import {clamp} from './geometry.js';

export class View {
  x = 0; // the place in the middle of what is free of panels [m]
  y = 0;
  scale = 10; // pixels of the page a metre
  width = 1;
  height = 1;
  inset = {left: 0, right: 0, top: 0, bottom: 0}; // what panels cover

  constructor(canvas) {
    this.canvas = canvas;
  }

  /** Takes the size of the canvas over; true if it changed. */
  resize() {
    const {clientWidth, clientHeight} = this.canvas;
    const ratio = Math.min(devicePixelRatio || 1, 2.5);
    const width = Math.round(clientWidth * ratio);
    const height = Math.round(clientHeight * ratio);
    const changed = this.canvas.width !== width || this.canvas.height !== height;
    if (changed) Object.assign(this.canvas, {width, height});
    Object.assign(this, {width: clientWidth, height: clientHeight, ratio});
    return changed;
  }

  get centre() {
    const {left, right, top, bottom} = this.inset;
    return [(left + this.width - right) / 2, (top + this.height - bottom) / 2];
  }

  toPage([x, y]) {
    const [cx, cy] = this.centre;
    return [cx + (x - this.x) * this.scale, cy - (y - this.y) * this.scale];
  }

  toYard([u, v]) {
    const [cx, cy] = this.centre;
    return [this.x + (u - cx) / this.scale, this.y - (v - cy) / this.scale];
  }

  /** Shows a box of the yard with a border around it. */
  fit([left, bottom, right, top], border = 1.16) {
    const {inset} = this;
    const width = Math.max(50, this.width - inset.left - inset.right);
    const height = Math.max(50, this.height - inset.top - inset.bottom);
    this.x = (left + right) / 2;
    this.y = (bottom + top) / 2;
    const scale = Math.min(width / (border * (right - left) + 2), height / (border * (top - bottom) + 2));
    this.scale = clamp(scale, 0.05, 60);
  }

  /** Zooms by a factor; the place under a point of the page stays there. */
  zoom(factor, at = this.centre) {
    const [x, y] = this.toYard(at);
    this.scale = clamp(this.scale * factor, 0.05, 200);
    const [u, v] = this.toPage([x, y]);
    this.pan(at[0] - u, at[1] - v);
  }

  pan(du, dv) {
    this.x -= du / this.scale;
    this.y += dv / this.scale;
  }

  /** Lets the canvas be drawn on in metres, y upwards. */
  enter(context) {
    const [cx, cy] = this.centre;
    const k = this.scale * this.ratio;
    context.setTransform(k, 0, 0, -k, this.ratio * cx - k * this.x, this.ratio * cy + k * this.y);
  }
}
