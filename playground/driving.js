// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where a truck that drives a path is, and what there is to say of one that was parked by hand.

import {wrap} from './geometry.js';
import {isAt} from './places.js';

/** The number of the row, of a path that is shown, at so many metres. */
function rowAt({rows}, s) {
  let low = 0;
  for (let high = rows.length / 6 - 1; low < high; ) {
    const middle = (low + high) >> 1;
    if (rows[6 * middle] < s) low = middle + 1;
    else high = middle;
  }
  return low;
}

const timesFaster = 4; // a yard's drive is shown so many times as fast as it is
const leastStand = 0.9; // how long it is shown that a vehicle stands at a via [s]

/** The first row at which a drive stands at a via that the path passes after `s` metres; -1 if it does nowhere. */
function standingRow(rows, {vehicle}, place, s) {
  for (let at = 0; at < rows.length; at += 7) {
    const [, driven, x, y, heading, , speed] = rows.subarray(at, at + 7);
    if (speed !== 0 || driven < s - 1e-6) continue;
    if (driven < s + 1e-6 || isAt(vehicle, place, {x, y, heading}, 1e-3, 1e-3)) return at;
  }
  return -1;
}

/** A drive that begins to be shown: rows t, s, x, y, heading, curvature, speed; `at` goes on. `stops`: where it stands at vias. */
export function beginDrive(rows, scene, passed, begin) {
  const stops = [];
  scene.via.forEach((place, via) => {
    const at = place.stop && passed[via] ? standingRow(rows, scene, place, passed[via].s) : -1;
    if (at >= 0) stops.push({via, t: rows[at], s: rows[at + 1]});
  });
  return {rows, stops, begin, at: 0};
}

/** The time of a drive that is shown after some seconds: at stops time stands, too. */
function timeShown({stops}, seconds) {
  let moving = seconds;
  for (const {t} of stops) {
    if (timesFaster * moving <= t) break;
    if (timesFaster * (moving - leastStand) <= t) return t;
    moving -= leastStand;
  }
  return timesFaster * moving;
}

/** Where the truck of a drive is, how fast [m/s], and the number of the via at which it stands. */
export function drivenAt(drive, shown, time) {
  const {rows, stops, begin} = drive;
  const t = timeShown(drive, Math.max(0, time - begin) / 1000);
  while (drive.at + 7 < rows.length && rows[drive.at + 7] <= t) drive.at += 7;
  const at = drive.at;
  const pose = {x: rows[at + 2], y: rows[at + 3], heading: rows[at + 4]};
  if (shown.trail) pose.hitch_angles = [wrap(pose.heading - shown.trail[3 * rowAt(shown, rows[at + 1]) + 2])];
  const speed = Math.abs(rows[at + 6]);
  const stop = speed === 0 ? stops.find(({s}) => Math.abs(s - rows[at + 1]) < 1e-6) : null;
  return {pose, curvature: rows[at + 5], t: rows[at], speed, standsAt: stop?.via, isOver: t > rows[rows.length - 7] + 3};
}

/** What a way that was driven by hand cost, beside the planner's. */
export function parkedNote({length, reverse, gearChanges}, result, {reverse_weight: weight, gear_change_cost: change}) {
  const own = result?.path ? result.check : null;
  const price = (metres, back, changes) => metres + (weight - 1) * back + change * changes;
  const more = own ? price(length, reverse, gearChanges) / Math.max(1, price(own.length, own.reverse_length, own.gear_changes)) - 1 : 0;
  const planned = own
    ? ` The planner: ${own.length.toFixed(0)} m, gear changes: ${own.gear_changes}. Your way costs ${Math.abs(100 * more).toFixed(0)} % ${more < 0 ? 'less' : 'more'}.` : '';
  const gap = own && result.lower_bound > 0 ? result.cost / result.lower_bound - 1 : null;
  const proven = gap === null ? '' : gap < 0.0005 ? ' Its path is proven to be the best.' : ` Its path is proven to cost at most ${Math.ceil(100 * gap)} % more than the best.`;
  return `Parked! You: ${length.toFixed(0)} m, gear changes: ${gearChanges}.${planned}${proven}`;
}
