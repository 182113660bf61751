// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Plans, and makes tables of a site, in a thread of its own, so that a page stays responsive and both can be called off.
//
//   import {startWorker} from 'vandplan/worker';
//   const worker = startWorker();
//   const result = await worker.plan(scenario, {time_limit: 2}, {onProgress: show, signal: controller.signal});

import type {PlanOptions, Result, Scenario, SiteQuery} from 'vandplan';

/** What happens while a plan is made. */
export interface Watch {
  /**
   * Called with a result that has a path, of a run with 1/16 and then one with 1/4 of the budget: the whole run comes
   * after them. Together they take 31 % longer. These results are checked like the last one.
   */
  onProgress?: (result: Result) => void;
  /** Calls the plan off. The promise is rejected with the reason of the signal, which is an AbortError by default. */
  signal?: AbortSignal;
}

/** What happens while a table of a site is made. */
export interface SiteWatch {
  /** Called with the number of goals that are done. */
  onProgress?: (goals: number) => void;
  /** Calls the table off, as a plan. */
  signal?: AbortSignal;
}

/** Works in one thread, one plan or table after the other. */
export interface PlanningWorker {
  /**
   * Plans a path, as `plan` of the module does, with the same result. Wrong input rejects the promise with an
   * InputError. The thread starts with the first plan, and anew after a plan that was called off.
   */
  plan(scenario: Scenario, options?: PlanOptions & {planner?: string}, watch?: Watch): Promise<Result>;
  /** Makes a table of a site, as `siteTable` of the module does, with the same bytes. */
  siteTable(scenario: Scenario, query?: SiteQuery, watch?: SiteWatch): Promise<Uint8Array>;
  /** Ends the thread and rejects what is not done. Node does not exit before. */
  close(): void;
}

/** Makes a worker. A page may have several. */
export function startWorker(): PlanningWorker;
