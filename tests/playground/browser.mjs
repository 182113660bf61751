// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A browser without a window, driven by its DevTools protocol through a pipe.

import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

export const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class Browser {
  #next = 0;
  #waiting = new Map();
  #listeners = [];

  static async open(program) {
    const browser = new Browser();
    browser.folder = mkdtempSync(join(tmpdir(), 'vandplan-browser-'));
    browser.process = spawn(program, [
      '--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', '--disable-quic',
      '--disable-renderer-backgrounding', '--disable-backgrounding-occluded-windows', '--disable-background-timer-throttling', `--user-data-dir=${browser.folder}`, '--remote-debugging-pipe', 'about:blank',
    ], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], env: {...process.env, HOME: browser.folder}});
    browser.#read();
    return browser;
  }

  #read() {
    let buffer = '';
    this.process.stdio[4].setEncoding('utf8').on('data', (chunk) => {
      buffer += chunk;
      for (let end = buffer.indexOf('\0'); end >= 0; end = buffer.indexOf('\0')) {
        this.#took(JSON.parse(buffer.slice(0, end)));
        buffer = buffer.slice(end + 1);
      }
    });
  }

  #took(message) {
    const waiting = this.#waiting.get(message.id);
    if (waiting) {
      this.#waiting.delete(message.id);
      if (message.error) waiting.reject(new Error(message.error.message));
      else waiting.resolve(message.result);
    }
    for (const listener of this.#listeners) listener(message);
  }

  send(method, params = {}, sessionId) {
    const id = ++this.#next;
    this.process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, {resolve, reject}));
  }

  /** A page of that size, once the expression `ready` holds on it, and what it complains of in `faults`. */
  async page(url, {width, height, touch = false, dark = false, ready = 'globalThis.vandplanPage?.painted'}) {
    const {targetId} = await this.send('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await this.send('Target.attachToTarget', {targetId, flatten: true});
    const page = new Page((method, params) => this.send(method, params, sessionId));
    this.#listeners.push((message) => message.sessionId === sessionId && page.took(message));
    await page.send('Page.enable');
    await page.send('Runtime.enable');
    await page.send('Log.enable');
    await page.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: touch ? 2 : 1, mobile: touch});
    await page.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
    if (touch) await page.send('Emulation.setTouchEmulationEnabled', {enabled: true});
    await page.send('Page.bringToFront');
    await page.send('Page.navigate', {url});
    await page.until(ready);
    return page;
  }

  async close() {
    await this.send('Browser.close').catch(() => {});
    await new Promise((resolve) => {
      if (this.process.exitCode !== null) resolve();
      this.process.once('exit', resolve);
      setTimeout(() => {
        this.process.kill('SIGKILL');
        resolve();
      }, 5000);
    });
    rmSync(this.folder, {recursive: true, force: true, maxRetries: 5});
  }
}

class Page {
  faults = [];

  constructor(send) {
    this.send = send;
  }

  took({method, params}) {
    if (method === 'Runtime.exceptionThrown') this.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(params.type)) this.faults.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.faults.push(params.entry.text);
  }

  /** The value of an expression on the page. */
  async value(expression) {
    const {result, exceptionDetails} = await this.send('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(expression, seconds = 60) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await pause(30)) {
      if (await this.value(expression).catch(() => false)) return;
    }
    throw new Error(`never: ${expression}; ${this.faults.join('; ')}`);
  }

  async mouse(type, [x, y], more = {}) {
    await this.send('Input.dispatchMouseEvent', {type, x, y, button: type === 'mouseMoved' && !more.buttons ? 'none' : 'left', clickCount: 1, ...more});
  }

  async drag(from, to, steps = 8) {
    await this.mouse('mouseMoved', from);
    await this.mouse('mousePressed', from, {buttons: 1});
    for (let i = 1; i <= steps; ++i) {
      await this.mouse('mouseMoved', [from[0] + ((to[0] - from[0]) * i) / steps, from[1] + ((to[1] - from[1]) * i) / steps], {buttons: 1});
    }
    await this.mouse('mouseReleased', to);
  }

  async touch(points, type) {
    await this.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
  }

  async key(key, modifiers = 0, code = '') {
    const text = key.length === 1 && !modifiers ? key : undefined;
    await this.send('Input.dispatchKeyEvent', {type: 'keyDown', key, code, text, modifiers});
    await this.send('Input.dispatchKeyEvent', {type: 'keyUp', key, code, modifiers});
  }

  async screenshot(file) {
    const {data} = await this.send('Page.captureScreenshot', {format: 'png'});
    writeFileSync(file, Buffer.from(data, 'base64'));
  }
}
