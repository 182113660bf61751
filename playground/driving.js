// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where a truck that drives a path is, and what there is to say of one that was parked by hand.

import {wrap} from './geometry.js';

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

/** Where the truck of a drive is: {rows, begin, at}, of which `at` goes on; a yard's drive is shown four times as fast as it is. */
export function drivenAt(drive, shown, time) {
  const {rows, begin} = drive;
  const t = (4 * Math.max(0, time - begin)) / 1000;
  while (drive.at + 7 < rows.length && rows[drive.at + 7] <= t) drive.at += 7;
  const at = drive.at;
  const pose = {x: rows[at + 2], y: rows[at + 3], heading: rows[at + 4]};
  if (shown.trail) pose.hitch_angles = [wrap(pose.heading - shown.trail[3 * rowAt(shown, rows[at + 1]) + 2])];
  return {pose, curvature: rows[at + 5], t: rows[at], isOver: t > rows[rows.length - 7] + 3};
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
