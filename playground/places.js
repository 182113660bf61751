// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Start, goals and vias: places, which may be more than one pose.
//
// A place has the keys of a scenario file, but for three things. `heading` is always there, so that there is something
// to draw: `turns` says whether 'any' other one, or the one turned round ('either_way') will do. `trailer: true` says
// that the keys are those of the trailer's axle. A place of several has them in `any_of`, and nothing beside it but
// `stop`, with which the vehicle stands at a via.

import {boxOf, centreOf, clamp, contains, distance, middle, placed, tractorPose, turned, wrap} from './geometry.js';

const half = (value) => (Array.isArray(value) ? (value[0] + value[1]) / 2 : value);
const ends = (value) => (Array.isArray(value) ? value : [value, value]);

/** The places of which one will do. */
export const entriesOf = (place) => place.any_of ?? [place];

/** Where the axle of a place may be: the corners of an area, or null if it is a point. */
export function areaOf({x, y, area}) {
  if (area) return area;
  if (!Array.isArray(x) && !Array.isArray(y)) return null;
  const [[left, right], [bottom, top]] = [ends(x), ends(y)];
  return [[left, bottom], [right, bottom], [right, top], [left, top]];
}

/** The middle of a place; of a ring-shaped area it need not be in it. */
const spot = ({x, y, area}) => (area ? centreOf(area) : [half(x), half(y)]);

/** How far headings go from the first one, counter-clockwise. */
const widthOf = ([from, to]) => (to < from ? to + 2 * Math.PI : to) - from;

const middleHeading = (heading) => ends(heading)[0] + widthOf(ends(heading)) / 2;

const middleHitch = ({hitch_angles: angles = [0]}) => (angles === 'any' ? 0 : half(angles[0]));

/** How a vehicle stands in the middle of a place that is not one of several. */
export function poseOf(vehicle, entry) {
  const [x, y] = spot(entry);
  const at = {x, y, heading: middleHeading(entry.heading)};
  if (!vehicle.trailers) return at;
  const hitch = middleHitch(entry);
  return {...(entry.trailer ? tractorPose(vehicle, at, hitch) : at), hitch_angles: [hitch]};
}

/** How a vehicle stands at each of the places of which one will do. */
export const posesOf = (vehicle, place) => entriesOf(place).map((entry) => poseOf(vehicle, entry));

/** The middle of what is drawn of a place. */
export function centreOfPlace(vehicle, place) {
  if (place.area) return centreOf(place.area);
  return centreOf(posesOf(vehicle, place).map((pose) => middle(vehicle, pose)));
}

/** A place whose entries were changed by a function. */
export const withEntries = (place, change) => (place.any_of ? {...place, any_of: place.any_of.map(change)} : change(place));

const plus = (value, by) => (Array.isArray(value) ? value.map((one) => one + by) : value + by);

/** A place moved by metres; `onto` rounds coordinates, so that its first entry lies on the grid. */
export function movedPlace(place, dx, dy, onto = null) {
  const [x, y] = spot(entriesOf(place)[0]);
  const [mx, my] = onto ? [onto(x + dx) - x, onto(y + dy) - y] : [dx, dy];
  const tidy = (value) => (onto ? Number(value.toFixed(9)) : value);
  const shift = (value, by) => (Array.isArray(value) ? plus(value, by).map(tidy) : tidy(value + by));
  return withEntries(place, (entry) => {
    if (entry.area) return {...entry, area: entry.area.map(([px, py]) => [shift(px, mx), shift(py, my)])};
    return {...entry, x: shift(entry.x, mx), y: shift(entry.y, my)};
  });
}

/** A place turned about its middle; `onto` rounds headings, to which that of the first entry is turned. */
export function turnedPlace(vehicle, place, angle, onto = null) {
  const centre = centreOfPlace(vehicle, place);
  const first = middleHeading(entriesOf(place)[0].heading);
  const by = onto ? onto(first + angle) - first : angle;
  return withEntries(place, (entry) => {
    const {x, y, ...rest} = entry;
    const heading = Array.isArray(entry.heading) ? plus(entry.heading, by) : wrap(entry.heading + by);
    const area = areaOf(entry); // a box that is turned is a box no more
    if (area) return {...rest, heading, area: turned(area, by, centre)};
    const [[tx, ty]] = turned([[x, y]], by, centre);
    return {...entry, x: tx, y: ty, heading};
  });
}

/** Whether a vehicle at a pose is at a place, within metres and an angle. */
export function isAt(vehicle, place, pose, metres, angle) {
  return entriesOf(place).some((entry) => {
    const wanted = poseOf(vehicle, entry);
    const area = entry.trailer ? null : areaOf(entry);
    const [left, bottom, right, top] = boxOf(area ?? [[wanted.x, wanted.y]]);
    const near = [clamp(pose.x, left, right), clamp(pose.y, bottom, top)];
    if (distance(near, [pose.x, pose.y]) >= metres || (entry.area && !contains(entry.area, [pose.x, pose.y]))) return false;
    const off = Math.abs(wrap(pose.heading - wanted.heading));
    const within = angle + widthOf(ends(entry.heading)) / 2;
    return entry.turns === 'any' || off < within || (entry.turns === 'either_way' && Math.PI - off < within);
  });
}

/** Another dock: as far from the last one as that is from the one before, or beside it. */
export function nextDock(vehicle, entries) {
  const [before, last] = [entries.at(-2), entries.at(-1)];
  const ahead = {x: 0, y: 0, heading: poseOf(vehicle, last).heading};
  const [dx, dy] = before ? [0, 1].map((i) => spot(last)[i] - spot(before)[i]) : placed(ahead, 0, -(vehicle.width + 1.5));
  return movedPlace(last, dx, dy);
}

/** A place as another vehicle stands there. */
export function placeFor(vehicle, place) {
  return withEntries(place, ({trailer, hitch_angles: angles, ...entry}) => {
    if (vehicle.trailers) return {...entry, ...(trailer ? {trailer} : {}), hitch_angles: angles ?? [0]};
    return entry;
  });
}

/** The keys of a scenario file for a place that is not one of several. */
function fileEntry({turns, trailer, straight, curvature, hitch_angles: angles, stop, ...axle}) {
  const own = turns === 'any' ? {...axle, heading: 'any'} : turns === 'either_way' ? {...axle, either_way: true} : axle;
  const beside = {curvature, hitch_angles: angles, straight, stop};
  return {...(trailer ? {trailer: own} : own), ...Object.fromEntries(Object.entries(beside).filter(([, value]) => value !== undefined))};
}

/** A place with the keys of a scenario file. */
export const fileOf = (place) => (place.any_of ? {...place, any_of: place.any_of.map(fileEntry)} : fileEntry(place));
