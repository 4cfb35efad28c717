// Pictures as pixels, so that tests speak of what is seen.

import { PNG } from "pngjs";

/** A picture from PNG bytes: `width`, `height`, `data` (RGBA, rows from the top). */
export const decode = (bytes) => PNG.sync.read(Buffer.from(bytes));

/**
 * What a pixel shows, by colour: dark space, sea (water swallows red, so that it sends far more blue than red, deep or turquoise), land (not
 * so, but for the blue haze before it), or something between. Blue against red tells them apart in any light and any exposure.
 */
export function kindOf([r, g, b]) {
  if (r + g + b < 30) return "dark";
  if (b > 1.5 * r) return "sea";
  return b <= 1.2 * r ? "land" : "between";
}

/** The colour at a place given as a share of width and height. */
export function colourAt({ width, height, data }, x, y) {
  const at = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
  return [...data.subarray(at, at + 3)];
}

/** Share of each kind of pixel, 0 to 1. */
export function shares({ width, height, data }) {
  const counts = { dark: 0, sea: 0, land: 0, between: 0 };
  for (let at = 0; at < data.length; at += 4) counts[kindOf(data.subarray(at, at + 3))] += 1;
  for (const kind of Object.keys(counts)) counts[kind] /= width * height;
  return counts;
}

/** Mean difference of the colour values, and the share of pixels whose worst differs by more than `limit`; both of 255. */
export function difference(a, b, limit = 4) {
  if (a.width !== b.width || a.height !== b.height) {
    throw new Error(`sizes differ: ${a.width}x${a.height} and ${b.width}x${b.height}`);
  }
  let sum = 0;
  let beyond = 0;
  let worst = 0;
  for (let at = 0; at < a.data.length; at += 4) {
    const differences = [0, 1, 2].map((channel) => Math.abs(a.data[at + channel] - b.data[at + channel]));
    const largest = Math.max(...differences);
    sum += differences[0] + differences[1] + differences[2];
    beyond += largest > limit ? 1 : 0;
    worst = Math.max(worst, largest);
  }
  const pixels = a.width * a.height;
  return { mean: sum / (3 * pixels), beyond: beyond / pixels, worst };
}
