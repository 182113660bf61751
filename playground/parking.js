// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Parking by hand: arrow keys drive, and what was driven is compared with what the planner found.

import {clamp} from './geometry.js';
import {isAt} from './places.js';

const keys = {ArrowUp: 1, ArrowDown: -1, ArrowLeft: 1, ArrowRight: -1};

export class Parking {
  pose;
  curvature = 0;
  length = 0;
  reverse = 0; // of it, metres in reverse
  gearChanges = 0;
  touched = false;
  trail = [];
  done = false;
  #gear = 0;
  #held = new Set();

  /**
   * `isFree(pose)` says whether the vehicle touches nothing, `advance(pose, segment)` where it is after
   * a segment.
   */
  constructor(scene, isFree, advance) {
    this.advance = advance;
    this.pose = {...scene.start};
    this.vehicle = scene.vehicle;
    this.goal = scene.goal;
    this.isFree = isFree;
    this.trail = [[this.pose.x, this.pose.y]];
  }

  key(name, down) {
    if (!keys[name]) return false;
    if (down) this.#held.add(name);
    else this.#held.delete(name);
    return true;
  }

  /** Lets go of all keys. */
  release() {
    this.#held.clear();
  }

  /** Drives on for some seconds; true if anything moved. */
  step(seconds) {
    const drive = (this.#held.has('ArrowUp') ? 1 : 0) - (this.#held.has('ArrowDown') ? 1 : 0);
    const turn = (this.#held.has('ArrowLeft') ? 1 : 0) - (this.#held.has('ArrowRight') ? 1 : 0);
    const sharpest = 1 / this.vehicle.min_turning_radius;
    const before = this.curvature;
    if (turn) this.curvature = clamp(this.curvature + turn * sharpest * seconds * 1.6, -sharpest, sharpest);
    else if (drive) this.curvature -= clamp(this.curvature, -sharpest * seconds, sharpest * seconds);
    if (!drive) return this.curvature !== before;
    const way = drive * (drive > 0 ? 4.5 : 3) * seconds;
    const next = this.advance(this.pose, {curvature: this.curvature, length: way});
    const folded = Math.abs(next.hitch_angles?.[0] ?? 0) > (this.vehicle.max_hitch_angle ?? 1.2);
    this.touched = folded || !this.isFree(next);
    if (this.touched) return true;
    this.pose = next;
    this.length += Math.abs(way);
    this.reverse += Math.max(0, -way);
    if (this.#gear && this.#gear !== drive) ++this.gearChanges;
    this.#gear = drive;
    this.trail.push([next.x, next.y]);
    this.done = isAt(this.vehicle, this.goal, next, 0.6, 0.12);
    return true;
  }
}
