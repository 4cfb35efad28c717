// The browser's picture beside the native one of the same link.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import { decode, difference } from "./picture.mjs";
import { PAGE, PROGRAM } from "./servers.mjs";

const pictures = new Map();

/** The picture that the program draws of a link; drawn once, whichever browser asks. */
function renderNatively(fragment, size) {
  const key = `${size} ${fragment}`;
  if (!pictures.has(key)) pictures.set(key, render(fragment, size));
  return pictures.get(key);
}

async function render(fragment, [width, height]) {
  const folder = await mkdtemp(join(tmpdir(), "ocean-globe-"));
  try {
    const file = join(folder, "native.png");
    await promisify(execFile)(PROGRAM, ["render", "--state", fragment, "--size", `${width}x${height}`, "--data", join(PAGE, "data"), "-o", file]);
    return decode(await readFile(file));
  } finally {
    await rm(folder, { recursive: true });
  }
}

/**
 * How far a browser's picture may be from the native one: the mean difference of a colour value (of 255), and the share of pixels
 * that differ by more than `step`.
 */
const BOUNDS = {
  // Firefox and the native program take the same Vulkan driver, and shaders from the same compiler (naga).
  firefox: { mean: 0, step: 0, beyond: 0 },
  // SwiftShader is another implementation of Vulkan, with its own rounding, sines and filters.
  chromium: { mean: 1, step: 4, beyond: 0.005 },
};

/** Shows a link and requires the native picture of it, which is returned. */
export async function assertSamePicture(t, site, fragment, size = [640, 360]) {
  const bounds = BOUNDS[site.browserName];
  const [native, seen] = await Promise.all([renderNatively(fragment, size), site.pictureOf(fragment, size)]);
  const { mean, beyond, worst } = difference(native, seen, bounds.step);
  t.diagnostic(`mean ${mean.toFixed(4)}, worst ${worst} of 255; ${(100 * beyond).toFixed(3)} % beyond ${bounds.step}`);
  assert.ok(mean <= bounds.mean, `mean difference ${mean.toFixed(3)} of 255 (worst ${worst})`);
  assert.ok(beyond <= bounds.beyond, `${(100 * beyond).toFixed(2)} % of the pixels differ by more than ${bounds.step} of 255 (worst ${worst})`);
  return native;
}
