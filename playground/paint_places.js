// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Draws zones, goals that are more than a pose, and vias.

import {boxOf, centreOf, middle, outlines, placed} from './geometry.js';
import {trace} from './paint.js';
import {areaOf, entriesOf, poseOf, posesOf} from './places.js';

/** Writes a text at a place of the yard, in pixels of the page: on a plate, with a halo, or as it is. */
export function label(context, view, place, text, {ink, plate = null, square = false, halo = null}) {
  const [x, y] = view.toPage(place);
  context.save();
  context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
  context.font = '600 12px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  if (plate) {
    context.beginPath();
    if (square) context.rect(x - 10, y - 10, 20, 20);
    else context.arc(x, y, 10.5, 0, 2 * Math.PI);
    context.fillStyle = plate;
    context.fill();
  }
  if (halo) {
    context.strokeStyle = halo;
    context.lineWidth = 4;
    context.lineJoin = 'round';
    context.strokeText(text, x, y + 0.5);
  }
  context.fillStyle = ink;
  context.fillText(text, x, y + 0.5);
  context.restore();
}

/** An arrow in the middle of an area, in the middle of a range of directions. */
function paintArrow(context, view, [left, bottom, right, top], [from, to], colours) {
  const size = 0.3 * Math.min(right - left, top - bottom);
  const heading = from + (to < from ? to + 2 * Math.PI - from : to - from) / 2;
  const at = (ahead, aside) => placed({x: (left + right) / 2, y: (bottom + top) / 2, heading}, ahead * size, aside * size);
  context.beginPath();
  for (const [begin, ...rest] of [[at(-1, 0), at(1, 0)], [at(0.5, 0.4), at(1, 0), at(0.5, -0.4)]]) {
    context.moveTo(...begin);
    for (const point of rest) context.lineTo(...point);
  }
  context.strokeStyle = colours.soft;
  context.lineWidth = 2 / view.scale;
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.stroke();
}

const speed = (metres) => `${Number(metres.toPrecision(2))} m/s`;

/** What a zone says beside its arrow. */
const rulesOf = ({name, closed, gears, cost, max_speed: most}) => [
  name, closed && 'closed', gears && gears !== 'both' && `${gears} only`, cost > 1 && `\u00D7 ${Number(cost.toPrecision(3))}`, most !== undefined && speed(most),
].filter(Boolean).join(', ');

/** Where a polygon begins above a place on the x axis. */
const lowest = (polygon, x) => Math.min(...polygon.flatMap(([ax, ay], i) => {
  const [bx, by] = polygon[(i + 1) % polygon.length];
  return ax <= x === bx <= x ? [] : [ay + ((x - ax) * (by - ay)) / (bx - ax)];
}));

/** Zones: closed ones in the colour of walls, others in that of kerbs. */
export function paintZones(context, view, zones, colours) {
  for (const zone of zones) {
    context.beginPath();
    trace(context, zone.area);
    context.fillStyle = zone.closed ? colours.wall : colours.kerb;
    context.globalAlpha = zone.closed ? 0.4 : 0.45;
    context.fill();
    context.globalAlpha = 1;
    context.strokeStyle = zone.closed ? colours['wall-line'] : colours['kerb-line'];
    context.lineWidth = 1.25 / view.scale;
    context.stroke();
  }
  for (const zone of zones) {
    const box = boxOf(zone.area);
    if (zone.direction) paintArrow(context, view, box, zone.direction, colours);
    const text = rulesOf(zone);
    const middleX = (box[0] + box[2]) / 2;
    if (text && 7 * text.length < (box[2] - box[0]) * view.scale) {
      label(context, view, [middleX, lowest(zone.area, middleX) + 10 / view.scale], text, {ink: zone.closed ? colours.ink : colours.soft});
    }
  }
}

/** Thin and dashed: how a vehicle may stand somewhere. */
export function paintOutline(context, view, vehicle, pose, colour) {
  context.beginPath();
  for (const body of outlines(vehicle, pose)) trace(context, body);
  context.strokeStyle = colour;
  context.lineWidth = 1.25 / view.scale;
  context.setLineDash([4 / view.scale, 3 / view.scale]);
  context.stroke();
  context.setLineDash([]);
}

/** Where an axle may be, and between which headings. */
function paintRange(context, view, vehicle, entry, colour) {
  const area = areaOf(entry);
  context.strokeStyle = colour;
  context.fillStyle = colour;
  context.lineWidth = 1.25 / view.scale;
  if (area) {
    context.beginPath();
    trace(context, area);
    context.globalAlpha = 0.14;
    context.fill();
    context.globalAlpha = 1;
    context.stroke();
  }
  if (!Array.isArray(entry.heading)) return;
  const {x, y} = poseOf(vehicle, entry);
  context.beginPath();
  context.moveTo(x, y);
  context.arc(x, y, vehicle.wheelbase, ...entry.heading);
  context.closePath();
  context.globalAlpha = 0.2;
  context.fill();
  context.globalAlpha = 1;
}

/** The straight last stretch, which may be driven in either gear: a line that ends at the goal. */
function paintStretch(context, view, vehicle, entry, colour) {
  const pose = poseOf(vehicle, entry);
  context.beginPath();
  for (const end of [-entry.straight, entry.straight]) {
    context.moveTo(pose.x, pose.y);
    context.lineTo(...placed(pose, end, 0));
  }
  context.strokeStyle = colour;
  context.lineWidth = 1.5 / view.scale;
  context.setLineDash([2 / view.scale, 4 / view.scale]);
  context.stroke();
  context.setLineDash([]);
}

/** The areas of goals, and straight lines to them: both lie below walls. */
export function paintGoalGround(context, view, {vehicle, goal}, colours) {
  for (const entry of entriesOf(goal)) {
    paintRange(context, view, vehicle, entry, colours['accent-ink']);
    if (entry.straight > 0) paintStretch(context, view, vehicle, entry, colours['accent-ink']);
  }
}

/** How the vehicle may stand at each of several goals. */
export function paintGoals(context, view, {vehicle, goal}, colours) {
  for (const pose of goal.any_of ? posesOf(vehicle, goal) : []) paintOutline(context, view, vehicle, pose, colours['accent-ink']);
}

/** How fast the driven vehicle is, above it. */
export function paintSpeed(context, view, vehicle, {pose, speed: metres, standsAt}, colours) {
  const top = Math.max(...outlines(vehicle, pose).flat().map(([, y]) => y));
  const [x] = middle(vehicle, pose);
  label(context, view, [x, top + 12 / view.scale], standsAt === undefined ? `${metres.toFixed(1)} m/s` : 'stop', {ink: standsAt === undefined ? colours.ink : colours.bad, halo: colours.paper});
}

/**
 * Vias in their order, those with a stop on a square plate, which is red while the vehicle stands there (`standsAt`);
 * where the path passes one, if it may pass elsewhere.
 */
export function paintVias(context, view, {vehicle, via}, passed, colours, standsAt) {
  via.forEach((place, i) => {
    for (const entry of entriesOf(place)) {
      paintRange(context, view, vehicle, entry, colours.soft);
      paintOutline(context, view, vehicle, poseOf(vehicle, entry), colours.soft);
    }
    const poses = posesOf(vehicle, place);
    const there = passed[i];
    if (there && !vehicle.trailers) paintOutline(context, view, vehicle, there, colours.ink);
    const at = there && poses.length > 1 ? middle(vehicle, there) : centreOf(poses.map((pose) => middle(vehicle, pose)));
    label(context, view, at, String(i + 1), {ink: colours.paper, plate: i === standsAt ? colours.bad : colours.ink, square: place.stop});
  });
}
