// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Threads of Node.

import {parentPort, Worker} from 'node:worker_threads';

export const port = parentPort;

export function startThread(took, failed) {
  const thread = new Worker(new URL('./thread.node.mjs', import.meta.url));
  thread.on('message', took);
  thread.on('error', failed);
  return {send: (query) => thread.postMessage(query), end: () => thread.terminate()};
}
