// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The compiled library, packed: a third of its size, in a script, as a page from disk may fetch no file.

import makeCore from 'vandplan-core.js';
import packed from 'vandplan-core.wasm.gz';

/** Makes a new core with memory of its own. */
export async function startCore() {
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return makeCore({wasmBinary: await new Response(unpacked).arrayBuffer()});
}
