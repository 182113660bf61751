// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the drive that is shown obey the speeds of zones, and stop at vias?

/** `help`: {expect, found, click, choose, picture} of the test that opens the page. */
export async function showsDrives(page, help) {
  await showsStops(page, help);
}

/** The truck stands on the weighbridge of the depot for a while, and is slow on its ramp. */
async function showsStops(page, {expect, found, click, choose, picture}) {
  await choose(page, 'scenario', 'Depot');
  await found(page);
  await click(page, 'play');
  await page.until('vandplanPage.drive?.at > 70');
  const {stops, slow} = await page.value(`(() => { const {stops, rows} = vandplanPage.drive; let slow = 0;
    for (let i = 0; i < rows.length; i += 7) if (rows[i + 2] > 48 && rows[i + 2] < 78 && rows[i + 3] < 20) slow = Math.max(slow, Math.abs(rows[i + 6]));
    return {stops, slow}; })()`);
  expect(Math.abs(slow - 1.2) < 0.01, `the drive obeys the zone: ${slow} m/s on the ramp`);
  expect(stops.length === 1 && stops[0].via === 0, `the drive has a stop: ${JSON.stringify(stops)}`);
  const plate = () => page.value(`(() => { const p = vandplanPage, {x, y, heading} = p.scene.via[0], v = p.scene.vehicle, m = (v.wheelbase + v.front_overhang - v.rear_overhang) / 2;
    const [u, w] = p.view.toPage([x + m * Math.cos(heading), y + m * Math.sin(heading)]); return [...p.context.getImageData(Math.round((u + 7) * p.view.ratio), Math.round((w + 7) * p.view.ratio), 1, 1).data].slice(0, 3); })()`);
  const before = await plate();
  await page.value(`vandplanPage.drive.begin = performance.now() - 1000 * ${stops[0].t / 4 - 0.1}`);
  await page.until(`vandplanPage.drive.rows[vandplanPage.drive.at] >= ${stops[0].t}`);
  await page.value('vandplanPage.drawn(true)');
  const [red, , blue] = await plate();
  expect(red > blue + 40 && red > before[0] + 40, `the plate of the via is red while the truck stands there: ${before}, ${[red, blue]}`);
  await picture(page, 'desk-stop');
  const [begin, at] = await page.value('[performance.now(), vandplanPage.drive.at]');
  await page.until(`vandplanPage.drive?.at !== ${at}`);
  const stood = ((await page.value('performance.now()')) - begin) / 1000;
  expect(stood > 0.3 && stood < 5, `the truck stands there for ${stood} s`);
  await click(page, 'play');
}
