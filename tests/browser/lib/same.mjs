// The browser's picture beside the native one of the same link.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import { decode, difference } from "./picture.mjs";
import { PAGE, PROGRAM } from "./servers.mjs";

/** The picture that the program draws of a link. */
export async function renderNatively(fragment, [width, height]) {
  const folder = await mkdtemp(join(tmpdir(), "ocean-globe-"));
  try {
    const file = join(folder, "native.png");
    await promisify(execFile)(PROGRAM, ["render", "--state", fragment, "--size", `${width}x${height}`, "--data", join(PAGE, "data"), "-o", file]);
    return decode(await readFile(file));
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** Opens a link and requires the native picture of it, which is returned: a mean of at most 1, and 0.5 % of pixels beyond 4, of 255. */
export async function assertSamePicture(t, site, fragment, size = [640, 360]) {
  const native = await renderNatively(fragment, size);
  const globe = await site.openLink(fragment, size);
  await globe.settled();
  const { mean, beyond, worst } = difference(native, await globe.picture());
  t.diagnostic(`mean ${mean.toFixed(4)}, worst ${worst} of 255; ${(100 * beyond).toFixed(3)} % beyond 4`);
  assert.ok(mean <= 1, `mean difference ${mean.toFixed(3)} of 255 (worst ${worst})`);
  assert.ok(beyond <= 0.005, `${(100 * beyond).toFixed(2)} % of the pixels differ by more than 4 of 255 (worst ${worst})`);
  await globe.close();
  return native;
}
