// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The planner in a thread of its own. Types and descriptions: worker.d.ts.

import {startThread} from 'threads';

import {InputError} from './vandplan.mjs';

const errorOf = ({where, problem, message}) => (where === undefined ? new Error(message) : new InputError({where, problem}));

/** Works in one thread, one job after the other. A job that is called off ends with its thread. */
class Planning {
  #thread = null;
  #jobs = []; // what is asked for; the thread works on the first one

  plan(scenario, options = {}, watch = {}) {
    return this.#ask({work: 'plan', scenario, options, rounds: Boolean(watch.onProgress)}, watch);
  }

  siteTable(scenario, query = {}, watch = {}) {
    return this.#ask({work: 'siteTable', scenario, query}, watch);
  }

  close() {
    this.#fail(new Error('the worker is closed'));
  }

  #ask(query, {onProgress, signal}) {
    return new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      const job = {query, resolve, reject, onProgress};
      const abort = () => this.#leave(job, () => reject(signal.reason));
      job.forget = () => signal?.removeEventListener('abort', abort);
      signal?.addEventListener('abort', abort);
      this.#jobs.push(job);
      if (this.#jobs.length === 1) this.#send();
    });
  }

  #send() {
    const [job] = this.#jobs;
    if (!job) return;
    this.#thread ??= this.#start();
    try {
      this.#thread.send(job.query);
    } catch (error) {
      this.#next(() => job.reject(error)); // a value that cannot be sent, such as a function
    }
  }

  #start() {
    // What a thread has said before it was ended may still come in.
    const ifCurrent = (act) => (said) => thread === this.#thread && act(said);
    const thread = startThread(ifCurrent((message) => this.#took(message)), ifCurrent((error) => this.#fail(error)));
    return thread;
  }

  #took({progress, result, error}) {
    const [job] = this.#jobs;
    if (progress) job.onProgress?.(progress);
    else this.#next(() => (error ? job.reject(errorOf(error)) : job.resolve(result)));
  }

  /** The first job is done: `tell` says so, and the next one begins. */
  #next(tell) {
    this.#jobs.shift().forget();
    tell();
    this.#send();
  }

  /** A job is called off. The thread cannot hear of it while it plans, so a new one takes its place. */
  #leave(job, tell) {
    if (job !== this.#jobs[0]) {
      this.#jobs.splice(this.#jobs.indexOf(job), 1);
      job.forget();
      tell();
      return;
    }
    this.#end();
    this.#next(tell);
  }

  #fail(error) {
    this.#end();
    for (const job of this.#jobs.splice(0)) {
      job.forget();
      job.reject(error);
    }
  }

  #end() {
    this.#thread?.end();
    this.#thread = null;
  }
}

export function startWorker() {
  return new Planning();
}
