// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Plans paths for trucks in a browser or in Node. Units are metres, radians and seconds; headings count
// counter-clockwise from the x axis. A pose is the midpoint of the rear axle and the heading.
//
//   import {load} from 'vandplan';
//   const vandplan = await load();
//   const {path, check} = vandplan.plan(scenario, {time_limit: 0.05});

/** Point [m]. */
export type Point = [x: number, y: number];

/** Pose of the rear-axle midpoint: x, y [m] and heading [rad]. */
export interface Pose {
  x: number;
  y: number;
  heading: number;
}

/** Pose at the start or goal of a path. */
export interface EndPose extends Pose {
  /** Curvature that the wheels are turned to [1/m]; only used with steering "continuous". */
  curvature?: number;
  /** Heading of the vehicle less that of its trailer [rad]. */
  hitch_angles?: [number];
}

/** Start or goal given by the pose of the trailer's axle. */
export interface TrailerEnd {
  trailer: Pose;
  curvature?: number;
  hitch_angles?: [number];
}

/** A number, or a range from the first to the second number; ranges of headings run counter-clockwise. */
export type Range = number | [number, number];

/** Set of poses where a path may end: every place with every heading. */
export interface GoalRegion {
  /** x of the rear-axle midpoint [m]. */
  x?: Range;
  /** y of the rear-axle midpoint [m]. */
  y?: Range;
  /** Simple polygon that replaces `x` and `y`. */
  area?: Point[];
  /** Heading [rad]. */
  heading: Range | 'any';
  /** Whether headings turned by half a turn are goals too. */
  either_way?: boolean;
  /** Curvature that the wheels are turned to [1/m]. */
  curvature?: number;
  /** Heading of the vehicle less that of its trailer [rad]. */
  hitch_angles?: 'any' | [Range];
  /** Length of the straight line with which the path ends, in either gear [m]. */
  straight?: number;
}

/** Set of goals given by place and heading of the trailer's axle. */
export interface TrailerRegion {
  trailer: Omit<GoalRegion, 'curvature' | 'hitch_angles' | 'straight'>;
  curvature?: number;
  hitch_angles?: 'any' | [Range];
  straight?: number;
}

/** A goal: a pose, a region, or several regions of which the cheapest is chosen. */
export type Goal =
  | EndPose | TrailerEnd | GoalRegion | TrailerRegion | {any_of: (GoalRegion | TrailerRegion)[]};

/** What a path passes before its goal: entries as a goal, without `curvature` and `straight`. */
export type Via = (Pose | GoalRegion | TrailerRegion | {any_of: (GoalRegion | TrailerRegion)[]}) & {
  /** Whether the vehicle stands there, so that its gear may change and its wheels may turn. */
  stop?: boolean;
};

/** Trailer, with the keys and units of vehicle files. */
export interface Trailer {
  /** Distance from the hitch to the axle [m]. */
  wheelbase: number;
  /** Distance from the hitch to the front of the body [m]. */
  front_overhang: number;
  /** Distance from the axle to the rear of the body [m]. */
  rear_overhang: number;
  /** Width of the body [m]. */
  width: number;
  /** Corners of a convex body in the frame of the axle's midpoint [m]. */
  outline?: Point[];
}

/** Obstacle that moves while the vehicle drives. */
export interface MovingObstacle {
  /** Corners in the obstacle's own frame [m]. */
  outline: Point[];
  /** Pose of that frame over time [s, m, rad], with increasing times. */
  trajectory: [t: number, x: number, y: number, heading: number][];
  /** What the obstacle does after the last row; 'stays' by default. */
  after?: 'stays' | 'leaves';
  /** Growth of the outline on all sides [m/s]. */
  inflate?: number;
}

/** Vehicle, with the keys and units of vehicle files. */
export interface Vehicle {
  /** Distance from rear axle to front axle [m]. */
  wheelbase: number;
  /** Distance from the front axle to the front of the body [m]. */
  front_overhang: number;
  /** Distance from the rear axle to the rear of the body [m]. */
  rear_overhang: number;
  /** Width of the body [m]. */
  width: number;
  /** Turning radius of the rear-axle midpoint [m]; this or `max_steering_angle` is required. */
  min_turning_radius?: number;
  /** Angle of the front wheel in a single-track model [rad]; in place of `min_turning_radius`. */
  max_steering_angle?: number;
  /** Width over the wheels [m]; the width of the body by default. */
  track_width?: number;
  /** Rate of the front wheel's angle [rad/s]. */
  max_steering_rate?: number;
  /** Change of curvature per metre driven [1/m^2]. */
  max_curvature_rate?: number;
  /** Largest speed in each gear [m/s]. */
  max_speed?: {forward?: number; reverse?: number};
  /** Largest acceleration along the path [m/s^2]. */
  max_acceleration?: number;
  /** Largest braking [m/s^2]; `max_acceleration` by default. */
  max_braking?: number;
  /** Largest speed^2 * |curvature| [m/s^2]. */
  max_lateral_acceleration?: number;
  /** Largest change of the acceleration [m/s^3]; unlimited by default. */
  max_jerk?: number;
  /** x of the hitch in the vehicle frame [m]. */
  hitch?: number;
  /** Largest absolute hitch angle [rad]. */
  max_hitch_angle?: number;
  trailers?: [Trailer];
  /** Corners of a convex body in the vehicle frame [m], in place of the rectangle. Overhangs and width may then be missing. */
  outline?: Point[];
}

/** Occupancy map of square cells. */
export interface OccupancyMap {
  /** Corner of the first cell; columns count along its heading, rows to the left. */
  origin: Pose;
  /** Side of a cell [m]. */
  resolution: number;
  columns: number;
  rows: number;
  /** Cells row by row: 0 free, 1 occupied, 2 unknown. */
  cells: Uint8Array;
  /** Makes unknown cells and the ground outside the map free; by default they are obstacles. */
  unknown?: 'free';
}

/** An area with rules for driving in it. The rules hold while the midpoint of the rear axle is in the area. */
export interface Zone {
  name?: string;
  /** Simple polygon; its edge belongs to it. */
  area: Point[];
  /** Whether the vehicle may not be there at all. */
  closed?: boolean;
  gears?: Gears;
  /** First and last allowed direction of travel, counter-clockwise [rad]: the heading, in reverse turned by half a turn. */
  direction?: Point;
  /** How many times as much a metre costs; 1 to 1000. */
  cost?: number;
  /** Largest speed there, in either gear [m/s]. */
  max_speed?: number;
  /** Whether the rules hold while any part of the vehicle or its trailer is there. */
  body?: boolean;
}

/** Further map, of which unknown cells say nothing. */
export type Mask = {
  map: OccupancyMap;
  /** Occupancy of each cell, 0 to 100; 255 is unknown. By default 100 for occupied and 0 for free ones. */
  percents?: Uint8Array;
} & (MaskRule | Nav2MaskRule);

/** What the cells of a mask say. */
export interface MaskRule {
  /** Occupied cells are obstacles; or cells limit the speed, or a metre costs more in them. */
  as: 'obstacles' | 'max_speed' | 'cost';
  /** In a cell occupied by p percent: largest speed (1 - p / 100) `of` [m/s], or cost 1 + p / 100 `of`. */
  of?: number;
}

/** What the cells of a mask say, with the keys of Nav2's costmap filters. */
export interface Nav2MaskRule {
  /** 0: occupied cells are obstacles. 1: `base + multiplier * percent` is a speed in percent of the vehicle's largest. 2: in m/s. */
  type: 0 | 1 | 2;
  /** 0 by default. */
  base?: number;
  /** 1 by default. */
  multiplier?: number;
}

/** Scenario, with the keys of scenario files. */
export interface Scenario {
  name?: string;
  description?: string;
  /** Lengths and limits, or a name of `vehicles()`. */
  vehicle?: Vehicle | string;
  /** Range of the rear-axle midpoint [m]; required without a map. */
  bounds?: {x: Point; y: Point};
  start: EndPose;
  goal: Goal;
  /** What the path passes before the goal, in this order. */
  via?: Via[];
  moving?: MovingObstacle[];
  /** Simple polygons that the vehicle must not touch. */
  obstacles?: Point[][];
  /** Simple polygons that only the wheels must not touch. */
  kerbs?: Point[][];
  /** Areas, in one of which the whole body must stay. */
  inside?: Point[][];
  zones?: Zone[];
  map?: OccupancyMap;
  masks?: Mask[];
}

/** Part of a path in one gear. */
export interface Segment {
  /** Curvature at its start [1/m]; positive to the left. */
  curvature: number;
  /** Length [m]; negative in reverse. */
  length: number;
  /** Change of curvature per metre driven [1/m^2]; 0 by default. */
  curvature_rate?: number;
}

/** Path: a start pose and the segments that follow. */
export interface Path {
  start: Pose;
  segments: Segment[];
}

/** Gears that may be driven. */
export type Gears = 'both' | 'forward' | 'reverse';

/**
 * Options of a plan: any key of `vandplan plan --set`, such as margin, gear_change_cost, steering, style, keep_tree.
 * Prices that are not set are those of a truck driver. They are smaller for a turning radius below 7 m.
 */
export interface PlanOptions {
  /** Time limit [s]. */
  time_limit?: number | null;
  max_iterations?: number | null;
  seed?: number;
  /** Distance that the vehicle keeps from obstacles [m]. */
  margin?: number;
  forward_weight?: number;
  reverse_weight?: number;
  gear_change_cost?: number;
  curvature_change_cost?: number;
  clearance_weight?: number;
  steering?: 'reeds-shepp' | 'continuous-between-stops' | 'continuous';
  style?: 'driver' | 'shortest';
  gears?: Gears;
  /**
   * Bytes of a table of the site, as `siteTable` makes and `vandplan table site` writes them (.vst). The default planner
   * begins with the way of the table; searches with the estimate "site" look up its costs. A yard reads the same array
   * once.
   */
  site?: Uint8Array;
  [key: string]: number | string | boolean | null | undefined | Uint8Array;
}

/** Prices of driving: docs/algorithms/anytime.md#styles. */
export interface Prices {
  /** Cost of a metre forward. */
  forward_weight: number;
  /** Cost of a metre in reverse. */
  reverse_weight: number;
  /** Cost of a gear change [m]. */
  gear_change_cost: number;
  /** Cost of turning the wheels [m per 1/m]. */
  curvature_change_cost: number;
  /** Added cost of a metre that touches an obstacle; it falls linearly to 0 at `clearance_distance`. */
  clearance_weight: number;
  /** Clearance from which on there is no added cost [m]. */
  clearance_distance: number;
}

/** Object that is hit: an obstacle, kerb, `inside` area, zone or mask by index, a map cell by its middle [m], or the bounds. */
export type Hit =
  | {what: 'obstacles' | 'kerbs' | 'inside' | 'zones' | 'masks'; index: number}
  | {what: 'map'; cell?: {x: number; y: number}}
  | {what: 'bounds'};

/** Verdict of the independent judge on a path. */
export interface Check {
  valid: boolean;
  /** First fault that was found; empty if valid. */
  reason: string;
  /** Object that is hit, or area that is left, if that is the fault. */
  hit: Hit | null;
  /** Pose at the fault, if it has a place. */
  at: Pose | null;
  /** Driven distance [m]. */
  length: number;
  /** Distance driven in reverse [m]. */
  reverse_length: number;
  gear_changes: number;
  /** Largest absolute hitch angle [rad]; 0 without a trailer. */
  largest_hitch_angle: number;
  /** Total variation of the curvature [1/m]. */
  curvature_change: number;
  /** Least distance from an obstacle [m]; Infinity without obstacles, null if a fault was found before. */
  clearance: number | null;
}

/** Result of a run. */
export interface Result {
  status:
    | 'solved' | 'start_in_collision' | 'goal_in_collision' | 'iteration_limit' | 'node_limit'
    | 'time_limit' | 'stopped' | 'no_path' | 'rejected';
  /** Why there is no path; empty if there is one. */
  reason: string;
  /** Object that a start or goal in collision hits. */
  hit: Hit | null;
  path: Path | null;
  /** Goal that the path ends at, with its index in `any_of`; null without a set of goals. */
  goal: ({index: number} & Pose) | null;
  /** Where the path passes each via, s metres from the start. */
  via: ({s: number} & Pose)[];
  /** Cost of the path [m], or [s] if the cost is the time; null without a path. */
  cost: number | null;
  /** Proven lower bound on the cost of all paths; null if nothing is proven. */
  lower_bound: number | null;
  iterations: number;
  /** Time in the planner [s]. */
  time: number;
  /** Times [s] and iterations at which a cheaper path was found. */
  anytime: {time: number; iteration: number; cost: number}[];
  /** Counters of the planner by name. */
  counters: Record<string, number>;
  /** Search tree, with the option keep_tree: rows x, y, heading, and the parent of each node (-1: a root). */
  tree: {poses: Float64Array; parents: Int32Array} | null;
  check: Check | null;
  /** Duration of the planned drive among moving obstacles [s]; null without them. */
  duration: number | null;
  /** Rows t, s, x, y, heading, curvature, speed of the planned drive, every 0.05 s. */
  drive: Float64Array | null;
  /** Steering that was in force. */
  steering: string;
}

/** Description of a planner. */
export interface PlannerInfo {
  name: string;
  /** What it does, in one line. */
  summary: string;
  /** Family of planners that are built alike, such as "rrt". */
  family: string;
  /** Estimate that ranks nodes, such as "hlut-2"; or empty. */
  estimate: string;
  /** What it can do, as `vandplan planners --json` names it: 'prices', 'gears', 'target_gap', ... */
  capabilities: string[];
  /** @deprecated `capabilities` has 'prices'. */
  honours_prices: boolean;
  /** @deprecated `capabilities` has 'gears'. */
  honours_gears: boolean;
  /** @deprecated `capabilities` has 'steering'. */
  honours_steering: boolean;
  /** @deprecated `capabilities` has 'target_gap'. */
  proves: boolean;
  /** Options of its own; `standard` is the default. */
  options: {name: string; summary: string; standard: string; range: string}[];
}

/** Rules that a checked path must obey. */
export interface Claims {
  /** Distance from obstacles [m]; 0 by default. */
  margin?: number;
  /** Length of the ramp around a start or goal with less clearance [m]; 0 by default. */
  margin_ramp?: number;
  /** 'reeds-shepp' by default. */
  steering?: string;
  /** Allowed gears, 'both' by default; a metre in another gear is a fault. */
  gears?: Gears;
}

/** Start, goal or vehicle that replace those of the scenario. */
export interface Ends {
  start?: EndPose;
  goal?: Goal;
  via?: Via[];
  vehicle?: Vehicle | string;
}

/** What a table of a site is made of. */
export interface SiteQuery {
  /** Goals of the table; by default the goal of the scenario, or the free poses of its `any_of`. */
  goals?: Pose[];
  /** Options of the plans that the table is for: prices, gears and margin count. */
  options?: PlanOptions;
  /** Headings of a full turn: 8 to 256, 36 by default. */
  headings?: number;
  /** Side of a cell of places [turning radii]: 0.01 to 1, 0.12 by default. */
  cell?: number;
}

/** What a table of a site holds. */
export interface SiteInfo {
  /** Goals of the table, as they were given. */
  goals: Pose[];
  /** Box of the places that the table knows, but for less than a cell [m]. */
  bounds: {x: Point; y: Point};
  /** Side of a cell of places [m]. */
  cell: number;
  /** Headings of a full turn. */
  headings: number;
}

/** Poses by columns of equal length, each an array or a typed one. */
export interface SitePoses {
  /** [m] */
  x: ArrayLike<number>;
  /** [m] */
  y: ArrayLike<number>;
  /** Headings [rad]. If they are missing, each cost is the least of all headings. */
  heading?: ArrayLike<number>;
}

/** Scenario whose world is built once, for many queries. */
export interface Yard {
  /** Plans a path. `warm_start`: path of a similar problem, along which the first path is sought; only for "anytime". */
  plan(query?: Ends & {planner?: string; options?: PlanOptions; warm_start?: Path}): Result;
  /** Checks a path with the judge. */
  check(query: Ends & Claims & {path: Path}): Check;
  /** Rows as those of `drive` of the module, of the fastest drive that obeys zones, masks and stops of vias. */
  drive(query: Ends & {path: Path; step?: number}): Float64Array;
  /** Whether vehicle and trailer keep the margin [m] at a pose. */
  isFree(query: {pose: EndPose; vehicle?: Vehicle | string; margin?: number}): boolean;
  /** Makes a table of the site, as `siteTable` of the module. */
  siteTable(query?: SiteQuery & {vehicle?: Vehicle | string}, onProgress?: (goals: number) => void): Uint8Array;
  /** Makes a table of the site that can be repaired, as `changingSiteTable` of the module. It outlives the yard. */
  changingSiteTable(query?: SiteQuery & {vehicle?: Vehicle | string}, onProgress?: (goals: number) => void): ChangingSiteTable;
  /** Frees the memory of the world. Later queries throw InputError. */
  close(): void;
}

/** Table of a site that is repaired where the site changes, not made anew. */
export interface ChangingSiteTable {
  /** Bytes of the table now, as `siteTable` makes them. After a repair there are others; the old ones stay as they are. */
  readonly site: Uint8Array;
  /**
   * Makes the table that of a scenario with the same vehicle and other obstacles, cells or zones. Its start does not
   * matter. The table keeps its box; a goal that is not free has no ways until it is free again.
   */
  repair(scenario: Scenario): void;
  /** Frees the table's memory, some 15 MB for each goal. Later calls throw InputError. */
  close(): void;
}

/** Functions of the module. All throw `InputError` for wrong input. */
export interface Vandplan {
  /** Version of the library, such as "0.1.0". */
  version: string;
  /** All planners, the default one first. */
  planners(): PlannerInfo[];
  /** Names of the catalogue's vehicles, such as "two-axle-truck". */
  vehicles(): string[];
  /** Default prices of a style. Those of 'driver' are smaller for a turning radius below 7 m. */
  prices(style: 'driver' | 'shortest', vehicle: Vehicle | string): Prices;
  /** Plans a path; the judge has checked it. A path that was not found is a `status`, no error. */
  plan(scenario: Scenario, options?: PlanOptions & {planner?: string}): Result;
  /** Checks a path with the judge. */
  check(scenario: Scenario, path: Path, claims?: Claims): Check;
  /** Builds the world of a scenario for many queries. */
  yard(scenario: Scenario): Yard;
  /**
   * Makes a table of what driving to the goals costs from everywhere, for plans with the option `site`. Its bytes are
   * those of a file (.vst). Without trailers and moving obstacles. `onProgress` gets the number of goals that are done.
   */
  siteTable(scenario: Scenario, query?: SiteQuery, onProgress?: (goals: number) => void): Uint8Array;
  /** Makes a table as `siteTable` does, and keeps what is needed to repair it. */
  changingSiteTable(scenario: Scenario, query?: SiteQuery, onProgress?: (goals: number) => void): ChangingSiteTable;
  /** Goals and cells of a table of a site. */
  siteInfo(site: Uint8Array): SiteInfo;
  /**
   * Approximate cost from each pose to a goal of a table, by number, 0 by default [m]: that of the pose that its cell
   * keeps. Infinity outside of the table, and where no way was found. The same array as before is not read again.
   */
  siteCosts(site: Uint8Array, poses: SitePoses, goal?: number): Float64Array;
  /** Rows s, x, y, heading, curvature, direction of a path, at most `step` metres apart (0.1 by default). */
  sample(path: Path, step?: number): Float64Array;
  /**
   * Rows t, s, x, y, heading, curvature, speed of the fastest drive, at most `step` seconds apart (0.05 by default). With
   * a scenario it obeys the speeds of zones and masks and the stops of vias; with a vehicle, its own limits alone.
   */
  drive(path: Path, of: Scenario | Vehicle | string, step?: number): Float64Array;
  /** Rows x, y, heading of the trailer, one for each row of `sample` with this step. `hitchAngle`: at the start [rad]. */
  trailer(path: Path, vehicle: Vehicle | string, hitchAngle?: number, step?: number): Float64Array;
  /** Pose and hitch angle after a segment. */
  advance(pose: EndPose, vehicle: Vehicle | string, segment: {curvature: number; length: number}): EndPose;
  /** Shortest path on open ground for a turning radius [m]: Reeds-Shepp, or Dubins without reverse. Headings are in radians. */
  steer(from: Pose, to: Pose, radius: number, options?: {reverse?: boolean}): Segment[];
  /** Paths of all words that join two poses, shortest first. */
  words(from: Pose, to: Pose, radius: number, options?: {reverse?: boolean}): Segment[][];
  /** Length from each node to the sample by a measure [m]. */
  distances(
    measure: 'euclid' | 'hlut-1' | 'hlut-2' | 'hlut-3' | 'hlut-4' | 'bound' | 'reeds-shepp',
    nodes: {x: Float32Array; y: Float32Array; heading: Float32Array},
    sample: Pose,
    radius: number,
  ): Float32Array;
  /** Hash of a path, as by `hashOf`. */
  hash(path: Path): string;
}

/** Wrong input. `where`: the wrong key ("vehicle.width"). `problem`: the fault and what was expected. */
export class InputError extends Error {
  constructor(said: {where: string; problem: string});
  where: string;
  problem: string;
}

/** Hash of a path: 16 hexadecimal digits. Paths with equal bits have equal hashes; others almost surely differ. */
export function hashOf(path: Path): string;

/** Loads the module, with memory of its own. It fetches nothing but the package's own `core.mjs`. */
export function load(): Promise<Vandplan>;
