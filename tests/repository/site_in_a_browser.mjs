// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does every page of the documentation open in a browser without an error, with a theme that can be
// switched, and with all of its code inside of the window, on a desk and on a phone?
// usage: node site_in_a_browser.mjs SITE CHROMIUM

import {readdirSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {Browser} from '../playground/browser.mjs';

const [site, chromium] = process.argv.slice(2);
const pages = readdirSync(site, {recursive: true}).filter((name) => name.endsWith('.html') && !name.startsWith('_'));
let faults = 0;

function expect(holds, what) {
  if (holds) return;
  console.log(`WRONG: ${what}`);
  ++faults;
}

// One tab opens all pages: a new tab for each takes half as long again.
async function open(page, name) {
  const url = pathToFileURL(resolve(join(site, name))).href;
  page.faults.length = 0;
  await page.send('Page.navigate', {url});
  await page.until(`document.readyState === 'complete' && location.href === ${JSON.stringify(url)}`);
}

async function look(page, name) {
  await open(page, name);
  expect(page.faults.length === 0, `${name}: ${page.faults.join('; ')}`);
  for (const width of [390, 1440]) {
    await page.send('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: false});
    const cut = await page.value(`[...document.querySelectorAll('.content pre')].find((box) => box.scrollWidth > box.clientWidth + 1)?.textContent`);
    expect(!cut, `${name}: code is cut off where the window has ${width} pixels: ${cut}`);
  }
}

async function switches(page) {
  await open(page, 'architecture.html');
  const theme = () => page.value('document.body.dataset.theme');
  const before = await theme();
  await page.value("document.querySelector('.theme-toggle').click()");
  expect((await theme()) !== before, 'the button switches the theme');
  await page.value("document.getElementById('stability').scrollIntoView()");
  await page.until("document.querySelector('.scroll-current')?.textContent.includes('Stability')", 10).catch(() => expect(false, 'the table of contents follows the page'));
  expect((await page.value("getComputedStyle(document.body).marginLeft")) === '0px', 'there is no white edge around the page');
}

expect(pages.length > 50, `the site has ${pages.length} pages`);
const browser = await Browser.open(chromium);
try {
  const page = await browser.page('about:blank', {width: 1440, height: 900, ready: 'true'});
  for (const name of pages) await look(page, name);
  await switches(page);
} finally {
  await browser.close();
}
process.exit(faults ? 1 : 0);
