// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Plans paths for trucks in a browser or in Node. Metres, radians, counter-clockwise from the x axis;
// a pose is the midpoint of the rear axle and the heading.
//
//   import {load} from './vandplan.mjs';
//   const vandplan = await load();
//   const {path, check} = vandplan.plan(scenario, {time_limit: 0.05});

/** A place in the plane [m]. */
export type Point = [x: number, y: number];

export interface Pose {
  x: number;
  y: number;
  heading: number;
}

/** Where a path begins or ends. */
export interface EndPose extends Pose {
  /** How far the wheels are turned [1/m]; of account for steering "continuous" alone. */
  curvature?: number;
  /** Heading of the vehicle less that of its trailer [rad]. */
  hitch_angles?: [number];
}

/** The axle of the trailer instead. */
export interface TrailerEnd {
  trailer: Pose;
  curvature?: number;
  hitch_angles?: [number];
}

/** A number, or all from the first to the second; headings counter-clockwise. */
export type Range = number | [number, number];

/** Poses where a path may end. */
export interface GoalRegion {
  x?: Range;
  y?: Range;
  /** Instead of `x` and `y`: anywhere in a simple polygon. */
  area?: Point[];
  heading: Range | 'any';
  /** Or turned by half a turn. */
  either_way?: boolean;
  curvature?: number;
  hitch_angles?: 'any' | [Range];
}

/** The same of the trailer's axle. */
export interface TrailerRegion {
  trailer: Omit<GoalRegion, 'curvature' | 'hitch_angles'>;
  curvature?: number;
  hitch_angles?: 'any' | [Range];
}

/** A pose, or whichever of several is cheapest. */
export type Goal =
  | EndPose | TrailerEnd | GoalRegion | TrailerRegion | {any_of: (GoalRegion | TrailerRegion)[]};

/** Keys and units as in vehicle files: hitch to axle, hitch to the front of the body, axle to rear. */
export interface Trailer {
  wheelbase: number;
  front_overhang: number;
  rear_overhang: number;
  width: number;
  /** As that of a vehicle, in the frame of the axle's midpoint. */
  outline?: Point[];
}

/** What moves while the vehicle drives: an outline in a frame of its own, and where that is when. */
export interface MovingObstacle {
  outline: Point[];
  trajectory: [t: number, x: number, y: number, heading: number][];
  after?: 'stays' | 'leaves';
  /** [m/s] */
  inflate?: number;
}

/** Keys and units as in vehicle files. */
export interface Vehicle {
  wheelbase: number;
  front_overhang: number;
  rear_overhang: number;
  width: number;
  /** Of the rear axle's midpoint [m]; this or `max_steering_angle` has to be given. */
  min_turning_radius?: number;
  /** Of the front wheels, in a single-track model [rad]; in place of `min_turning_radius`. */
  max_steering_angle?: number;
  track_width?: number;
  max_steering_rate?: number;
  max_curvature_rate?: number;
  max_speed?: {forward?: number; reverse?: number};
  max_acceleration?: number;
  max_braking?: number;
  max_lateral_acceleration?: number;
  max_jerk?: number;
  /** x of the hitch in the vehicle frame. */
  hitch?: number;
  max_hitch_angle?: number;
  trailers?: [Trailer];
  /** Corners of a convex body around the midpoint of the rear axle, in place of the rectangle; overhangs and width may be left out then. */
  outline?: Point[];
}

/** Square cells: 0 free, 1 occupied, 2 unknown, row by row from the corner at `origin`. */
export interface OccupancyMap {
  origin: Pose;
  resolution: number;
  columns: number;
  rows: number;
  cells: Uint8Array;
  /** "free": unknown cells and all ground outside are free; else they are obstacles. */
  unknown?: 'free';
}

/** Keys as in scenario files. */
export interface Scenario {
  name?: string;
  description?: string;
  /** Lengths, or a name of `vehicles()`. */
  vehicle?: Vehicle | string;
  /** Where the rear axle may be; without a map they have to be given. */
  bounds?: {x: Point; y: Point};
  start: EndPose;
  goal: Goal;
  moving?: MovingObstacle[];
  obstacles?: Point[][];
  kerbs?: Point[][];
  /** The whole body stays in one of these areas. */
  inside?: Point[][];
  map?: OccupancyMap;
}

/** Curvature at the start of the segment [1/m], driven metres (negative in reverse), change of curvature [1/m^2]. */
export interface Segment {
  curvature: number;
  length: number;
  curvature_rate?: number;
}

export interface Path {
  start: Pose;
  segments: Segment[];
}

/** Which gears may be driven at all. */
export type Gears = 'both' | 'forward' | 'reverse';

/**
 * Any key of `vandplan plan --set`, such as margin, gear_change_cost, steering, style, keep_tree. Prices that are not set
 * are a driver's in a truck; they shrink with a vehicle that turns on less than 7 m.
 */
export interface PlanOptions {
  time_limit?: number | null;
  max_iterations?: number | null;
  seed?: number;
  margin?: number;
  forward_weight?: number;
  reverse_weight?: number;
  gear_change_cost?: number;
  curvature_change_cost?: number;
  clearance_weight?: number;
  steering?: 'reeds-shepp' | 'continuous-between-stops' | 'continuous';
  style?: 'driver' | 'shortest';
  gears?: Gears;
  [key: string]: number | string | boolean | null | undefined;
}

/** What driving costs: docs/algorithms/anytime.md#styles. */
export interface Prices {
  forward_weight: number;
  reverse_weight: number;
  /** Of one gear change [m]. */
  gear_change_cost: number;
  /** Of turning the wheels [m per 1/m]. */
  curvature_change_cost: number;
  clearance_weight: number;
  /** Up to which being near things costs [m]. */
  clearance_distance: number;
}

/** What is hit: an obstacle, a kerb or an area of `inside` by its number, a cell of the map by its middle, or the edge of the bounds. */
export type Hit =
  | {what: 'obstacles' | 'kerbs' | 'inside'; index: number}
  | {what: 'map'; cell?: {x: number; y: number}}
  | {what: 'bounds'};

/** The independent judge's verdict. */
export interface Check {
  valid: boolean;
  /** The first thing found wrong; empty when valid. */
  reason: string;
  /** What is hit or left, if that is what is wrong. */
  hit: Hit | null;
  /** Where it is wrong, if at a place. */
  at: Pose | null;
  length: number;
  reverse_length: number;
  gear_changes: number;
  /** 0 without a trailer [rad]. */
  largest_hitch_angle: number;
  curvature_change: number;
  /** Least distance from anything [m]; Infinity on open ground. */
  clearance: number | null;
}

export interface Result {
  status:
    | 'solved' | 'start_in_collision' | 'goal_in_collision' | 'iteration_limit' | 'node_limit'
    | 'time_limit' | 'stopped' | 'no_path' | 'rejected';
  reason: string;
  /** What is in the way of a start or goal in collision. */
  hit: Hit | null;
  path: Path | null;
  /** The goal that the path ends at, by its number in `any_of`; null without a set of goals. */
  goal: ({index: number} & Pose) | null;
  cost: number | null;
  /** No path costs less; 0 where nothing is proven. */
  lower_bound: number;
  iterations: number;
  /** In the planner [s]. */
  time: number;
  /** When the cost of the best path fell. */
  anytime: {time: number; iteration: number; cost: number}[];
  counters: Record<string, number>;
  /** Rows x, y, heading, and the parent of each node (-1: a root), with the option keep_tree. */
  tree: {poses: Float64Array; parents: Int32Array} | null;
  check: Check | null;
  /** Of the drive among what moves [s]; null where nothing does. */
  duration: number | null;
  /** Rows t, s, x, y, heading, curvature, speed of that drive, every 0.05 s. */
  drive: Float64Array | null;
  steering: string;
}

export interface PlannerInfo {
  name: string;
  summary: string;
  family: string;
  estimate: string;
  honours_prices: boolean;
  honours_gears: boolean;
  honours_steering: boolean;
  /** Whether it proves that no path costs less than its bound. */
  proves: boolean;
  options: {name: string; summary: string; standard: string; range: string}[];
}

export interface Claims {
  margin?: number;
  margin_ramp?: number;
  steering?: string;
  /** 'both' (usual), 'forward' or 'reverse': a metre in another gear is a fault. */
  gears?: Gears;
}

/** Another start, goal or vehicle than the scenario's. */
export interface Ends {
  start?: EndPose;
  goal?: Goal;
  vehicle?: Vehicle | string;
}

/** A scenario whose world is built once, for many plans. */
export interface Yard {
  /** `warm_start`: a path that was good for a like problem, in whose way the first one is looked for; for "anytime". */
  plan(query?: Ends & {planner?: string; options?: PlanOptions; warm_start?: Path}): Result;
  check(query: Ends & Claims & {path: Path}): Check;
  isFree(query: {pose: EndPose; vehicle?: Vehicle | string; margin?: number}): boolean;
  close(): void;
}

export interface Vandplan {
  version: string;
  planners(): PlannerInfo[];
  /** Names of vehicles that may stand for their lengths, such as "two-axle-truck". */
  vehicles(): string[];
  /** What driving costs where no price is set: those of a driver shrink with a turning radius below 7 m. */
  prices(style: 'driver' | 'shortest', vehicle: Vehicle | string): Prices;
  plan(scenario: Scenario, options?: PlanOptions & {planner?: string}): Result;
  check(scenario: Scenario, path: Path, claims?: Claims): Check;
  yard(scenario: Scenario): Yard;
  /** Rows s, x, y, heading, curvature, direction, at most `step` metres apart. */
  sample(path: Path, step?: number): Float64Array;
  /** Rows t, s, x, y, heading, curvature, speed of the fastest drive, at most `step` seconds apart. */
  drive(path: Path, vehicle: Vehicle | string, step?: number): Float64Array;
  /** Rows x, y, heading of the trailer for each row that `sample` has with that step. */
  trailer(path: Path, vehicle: Vehicle | string, hitchAngle?: number, step?: number): Float64Array;
  /** Where the vehicle is after a segment, and how its trailer stands. */
  advance(pose: EndPose, vehicle: Vehicle | string, segment: {curvature: number; length: number}): EndPose;
  /** The shortest path on open ground, by Reeds and Shepp, or by Dubins without reverse. */
  steer(from: Pose, to: Pose, radius: number, options?: {reverse?: boolean}): Segment[];
  /** The path of every word that joins the poses, the shortest first. */
  words(from: Pose, to: Pose, radius: number, options?: {reverse?: boolean}): Segment[][];
  /** What a measure says of the way from every node to the sample [m]. */
  distances(
    measure: 'euclid' | 'hlut-1' | 'hlut-2' | 'hlut-3' | 'hlut-4' | 'bound' | 'reeds-shepp',
    nodes: {x: Float32Array; y: Float32Array; heading: Float32Array},
    sample: Pose,
    radius: number,
  ): Float32Array;
  hash(path: Path): string;
}

/** What was handed in cannot be used; `where` is the key that is wrong ("vehicle.width"). */
export class InputError extends Error {
  where: string;
  problem: string;
}

/** The hash of a path: equal if and only if, by all odds, start and segments are the same bit for bit. */
export function hashOf(path: Path): string;

/** Makes the module. It fetches nothing. */
export function load(): Promise<Vandplan>;
