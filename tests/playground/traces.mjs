// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Ways of a mouse that drags [px], from where the goal is taken hold of, one place every 8 ms. They are made up, not
// recorded; written as changes in hexadecimal digits, of which 8 is none and each step three pixels.

/** There and back with haste, as somebody who tries what happens. */
const shake = 'a7c6e4f2f2e2c4a5878583748462525140506172849aacbddececdcacab9b8a7966450413143566798a9bacbbbcacaa9a8989898';
/** Slowly towards a place, then small moves, as somebody who parks. */
const park = '9898a8a7b7b7c6c6b6c6b7b7a8a8a8999899898889898a8a8a9a8a898a8978797879788878887888788988898889888988898988';
/** Around, as somebody who looks at all sides. */
const round = '8c9cacbbbacaca99c9c8c7c6b6b5b4a494848474646454544444434344343536363728292a2a3b3b4c4c5c6c6d7d7c8c8c8c9c9c';

/** Places of a hand, first the one where it takes hold. */
function placesOf(text) {
  const places = [[0, 0]];
  for (let i = 0; i + 1 < text.length; i += 2) {
    const [x, y] = places.at(-1);
    places.push([x + 3 * (parseInt(text[i], 16) - 8), y + 3 * (parseInt(text[i + 1], 16) - 8)]);
  }
  return places;
}

export const traces = [shake, park, round].map(placesOf);
