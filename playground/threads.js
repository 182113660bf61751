// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The page's other threads.

/** Another thread that runs a script, that of the page; none where the browser has none for a page from disk. */
export function second(script) {
  try {
    return new Worker(URL.createObjectURL(new Blob([script], {type: 'text/javascript'})));
  } catch {
    return null;
  }
}
