// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Where does a vehicle go, and what part of the ground is worth a look?

// Where an arc leads.
function advance([x, y, h], curvature, length) {
  const turn = curvature * length;
  const chord = Math.abs(turn) < 1e-9 ? length : Math.sin(turn / 2) / (curvature / 2);
  return [x + chord * Math.cos(h + turn / 2), y + chord * Math.sin(h + turn / 2), h + turn];
}

// A part of a clothoid as arcs of at most 10 cm: good enough to be drawn.
function advanceClothoid(pose, [curvature, length, rate], begin, end) {
  const count = Math.ceil((end - begin) / 0.1);
  const part = (end - begin) / count;
  for (let i = 0; i < count; ++i)
    pose = advance(pose, curvature + rate * (begin + (i + 0.5) * part), Math.sign(length) * part);
  return pose;
}

// Poses along [curvature, length] or [curvature, length, curvature rate] segments from a start,
// every `step` metres and at each end.
function drive(start, segments, step) {
  let first = start;
  const stretches = [];
  for (const segment of segments) {
    const [curvature, length, rate = 0] = segment;
    const pieces = Math.max(1, Math.ceil(Math.abs(length) / step));
    const poses = [first];
    for (let i = 1; i <= pieces; ++i) {
      const at = (k) => (Math.abs(length) * k) / pieces;
      poses.push(rate === 0 ? advance(first, curvature, (length * i) / pieces)
        : advanceClothoid(poses[i - 1], segment, at(i - 1), at(i)));
    }
    first = poses[pieces];
    stretches.push({forward: length >= 0, poses});
  }
  return stretches;
}

function outline([x, y, h], [rear, front, half]) {
  const [c, s] = [Math.cos(h), Math.sin(h)];
  return [[-rear, -half], [front, -half], [front, half], [-rear, half]]
    .map(([u, v]) => [x + u * c - v * s, y + u * s + v * c]);
}

const pointList = (points) => points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(' ');

function mapOutline({origin: [x, y, h], extent: [width, height]}) {
  const [c, s] = [Math.cos(h), Math.sin(h)];
  return [[0, 0], [width, 0], [width, height], [0, height]].map(([u, v]) => [x + u * c - v * s, y + u * s + v * c]);
}

function boxOf(points) {
  return [...d3.extent(points, (p) => p[0]), ...d3.extent(points, (p) => p[1])];
}

// The box around the path and what stands near it: what is further away than a third adds nothing.
function framed(points, things, [rear, front]) {
  const [x0, x1, y0, y1] = boxOf(points);
  const margin = 0.7 * (rear + front) + 0.3 * Math.max(x1 - x0, y1 - y0);
  const reach = [x0 - margin, x1 + margin, y0 - margin, y1 + margin];
  const seen = [x0, x1, y0, y1];
  for (const [a0, a1, b0, b1] of things.map(boxOf)) {
    if (a0 > reach[1] || a1 < reach[0] || b0 > reach[3] || b1 < reach[2]) continue;
    seen[0] = Math.min(seen[0], Math.max(a0, reach[0]));
    seen[1] = Math.max(seen[1], Math.min(a1, reach[1]));
    seen[2] = Math.min(seen[2], Math.max(b0, reach[2]));
    seen[3] = Math.max(seen[3], Math.min(b1, reach[3]));
  }
  return seen;
}
