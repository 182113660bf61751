// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Threads of browsers. Bundlers find the thread's script by this very form of `new Worker`.

export const port = globalThis;

export function startThread(took, failed) {
  const thread = new Worker(new URL('./thread.mjs', import.meta.url), {type: 'module'});
  thread.onmessage = ({data}) => took(data);
  thread.onerror = ({message}) => failed(new Error(message ?? 'the thread did not start'));
  return {send: (query) => thread.postMessage(query), end: () => thread.terminate()};
}
