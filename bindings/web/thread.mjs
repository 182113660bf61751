// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What runs in the thread of worker.js: queries come in, {progress}, {result} or {error} go out.

import {port} from 'threads';

import {startCore} from './core.mjs'; // at once: a worker of a bundle may have one file
import {functionsOf} from './functions.js';

/** Parts of the budget that the runs before the whole one have. */
const parts = [1 / 16, 1 / 4];

const loading = startCore().then(functionsOf);

/** Options of a shorter run. Without any limit a run takes 1 s. */
function shortened(options, part) {
  const {time_limit: time, max_iterations: iterations} = options;
  const seconds = time ?? (iterations == null ? 1 : null);
  return {...options, time_limit: seconds && part * seconds, max_iterations: iterations && Math.ceil(part * iterations)};
}

async function plan(vandplan, {scenario, options, rounds}) {
  for (const part of rounds ? parts : []) {
    const result = vandplan.plan(scenario, shortened(options, part));
    if (result.path) port.postMessage({progress: result});
  }
  return vandplan.plan(scenario, options);
}

const siteTable = (vandplan, {scenario, query}) => vandplan.siteTable(scenario, query, (progress) => port.postMessage({progress}));

const works = {plan, siteTable};

port.onmessage = async ({data: {work, ...job}}) => {
  try {
    port.postMessage({result: await works[work](await loading, job)});
  } catch ({where, problem, message}) {
    port.postMessage({error: {where, problem, message}});
  }
};
