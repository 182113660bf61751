// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The planner for JavaScript. Types and descriptions: vandplan.d.ts.

import {functionsOf} from './functions.js';

export {hashOf, InputError} from './functions.js';

/** Loads the module; the core, which is large, only now. */
export async function load() {
  const {startCore} = await import('./core.mjs');
  return functionsOf(await startCore());
}
