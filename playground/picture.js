// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What is on the canvas: ground, path, trucks, what is selected.

import {middle, wrap} from './geometry.js';
import * as paint from './paint.js';
import {paintBest, paintField} from './paint_costs.js';
import {paintGoalGround, paintGoals, paintSpeed, paintVias, paintZones} from './paint_places.js';
import {entriesOf, poseOf, posesOf} from './places.js';
import {centreAt, placeAt, polygonAt} from './scene.js';

/** Paints all of a page; `driven` is where its truck drives just now, or null. */
export function paintPage(page, colours, driven) {
  const {context, view, scene} = page;
  view.resize();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, page.canvas.width, page.canvas.height);
  view.enter(context);
  paint.paintGrid(context, view, colours);
  paint.paintBounds(context, view, scene, colours);
  const {isOn, made, fault, isMaking} = page.costs;
  const field = isOn && made && !fault ? made.field : null;
  if (field) paintField(context, view, field, colours, isMaking);
  paint.paintMasks(context, scene.masks, colours);
  paintZones(context, view, scene.zones, colours);
  paintGoalGround(context, view, scene, colours);
  if (scene.map) paint.paintMap(context, scene.map, colours);
  if (page.shown) paint.paintSwept(context, view, scene.vehicle, page.shown, colours, page.editor.dragging ? 3 : 1);
  paint.paintPolygons(context, view, scene, colours);
  if (page.shown) {
    paint.paintFootprints(context, view, scene.vehicle, page.shown, colours, scene.vehicle.trailers ? 5 : 2.5);
    if (field) paint.paintPath(context, view, page.shown.rows, {...colours, forward: colours.paper, reverse: colours.paper, 'accent-ink': colours.paper}, 6); // it stands out
    paint.paintPath(context, view, page.shown.rows, colours);
  }
  paintGoals(context, view, scene, colours);
  if (page.result?.hit) paint.paintHit(context, view, scene, page.result.hit, colours);
  paintTrucks(page, colours, driven);
  paintVias(context, view, scene, page.result?.via ?? [], colours, driven?.standsAt);
  if (driven) paintSpeed(context, view, scene.vehicle, driven, colours);
  if (page.clean) return;
  const best = field && !isMaking && page.at && !page.editor.dragging ? page.costs.bestAt(page.at) : null;
  if (best) paintBest(context, view, scene.vehicle, best, colours);
  paintSelection(page, colours);
  if (!page.moved) paintHint(page, colours);
}

/** Says what to do, until somebody has done it. */
function paintHint({context, view, scene}, colours) {
  const [x, y] = view.toPage(centreAt(scene, {kind: 'goal'}));
  const reach = ((scene.vehicle.wheelbase + 3) / 2) * view.scale;
  const text = 'Drag me';
  context.save();
  context.setTransform(view.ratio, 0, 0, view.ratio, 0, 0);
  context.font = '600 15px system-ui, sans-serif';
  const width = context.measureText(text).width + 22;
  const left = Math.min(x + 0.6 * reach + 16, view.width - width - 8);
  context.beginPath();
  context.roundRect(left, y - 15, width, 30, 15);
  context.fillStyle = colours['accent-ink'];
  context.fill();
  context.fillStyle = colours.paper;
  context.textBaseline = 'middle';
  context.fillText(text, left + 11, y + 1);
  context.restore();
}

/** How the vehicle stands at the end of a path, or at a goal. */
function lastPose({scene, result, shown, reached}) {
  const goals = entriesOf(scene.goal);
  if (!result?.goal || !shown) return poseOf(scene.vehicle, goals[reached] ?? goals[0]);
  const [heading] = shown.trail?.slice(-1) ?? [result.goal.heading];
  return {...result.goal, hitch_angles: [wrap(result.goal.heading - heading)]};
}

function paintTrucks(page, colours, driven) {
  const {context, view, scene, result} = page;
  const bad = result?.status;
  paint.paintTruck(context, view, scene.vehicle, lastPose(page), colours, {ghost: true, bad: bad === 'goal_in_collision'});
  if (page.parked) {
    context.beginPath();
    page.parked.trail.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    context.strokeStyle = colours.ink;
    context.lineWidth = 2 / view.scale;
    context.stroke();
    paint.paintTruck(context, view, scene.vehicle, page.parked.pose, colours, {curvature: page.parked.curvature, bad: page.parked.touched});
    return;
  }
  const curvature = driven?.curvature ?? page.shown?.rows[4] ?? 0;
  paint.paintMovers(context, view, scene.moving, driven?.t ?? 0, colours);
  paint.paintTruck(context, view, scene.vehicle, driven?.pose ?? scene.start, colours, {curvature, bad: bad === 'start_in_collision'});
}

function paintSelection(page, colours) {
  const {context, view, scene} = page;
  const {selected} = page.editor;
  for (const item of [{kind: 'start'}, {kind: 'goal'}, ...(selected?.index === undefined ? [] : [selected])]) {
    paint.paintHandle(context, view, paint.turnHandle(view, scene, item, centreAt(scene, item)), colours);
  }
  const polygon = selected && polygonAt(scene, selected);
  for (const pose of selected && !polygon ? posesOf(scene.vehicle, placeAt(scene, selected)) : []) {
    const [x, y] = middle(scene.vehicle, pose);
    context.beginPath();
    context.arc(x, y, 0.75 * (scene.vehicle.wheelbase + 3), 0, 2 * Math.PI);
    context.strokeStyle = colours.accent;
    context.globalAlpha = 0.35;
    context.lineWidth = 1.5 / view.scale;
    context.stroke();
    context.globalAlpha = 1;
  }
  if (!polygon) return;
  context.beginPath();
  paint.trace(context, polygon);
  context.strokeStyle = colours.accent;
  context.lineWidth = 2.5 / view.scale;
  context.stroke();
  if (polygon.length <= 40) for (const corner of polygon) paint.paintHandle(context, view, corner, colours, {square: true});
}
