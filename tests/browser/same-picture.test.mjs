// The browser's picture is the native one: the same core, the same sea, for the same link.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { decode, difference, shares } from "./lib/picture.mjs";
import { PAGE, PROGRAM } from "./lib/servers.mjs";
import { visit } from "./lib/site.mjs";
import { AT_SEA, COAST, FROM_ORBIT } from "./lib/views.mjs";

const site = visit();
let folder;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "ocean-globe-"));
});
after(async () => {
  if (folder) await rm(folder, { recursive: true });
});

for (const [name, fragment] of Object.entries({ FROM_ORBIT, COAST, AT_SEA })) {
  test(`browser and native draw the same: ${name}`, async (t) => {
    const file = join(folder, `${name}.png`);
    await promisify(execFile)(PROGRAM, ["render", "--state", fragment, "--size", "640x360", "--data", join(PAGE, "data"), "-o", file]);
    const native = decode(await readFile(file));
    assert.ok(shares(native).dark < 0.9, "the native picture is empty");

    const globe = await site.openLink(fragment);
    await globe.settled();
    const { mean, beyond, worst } = difference(native, await globe.picture());
    t.diagnostic(`mean ${mean.toFixed(4)}, worst ${worst} of 255; ${(100 * beyond).toFixed(3)} % beyond 4`);
    assert.ok(mean <= 1, `mean difference ${mean.toFixed(3)} of 255 (worst ${worst})`);
    assert.ok(beyond <= 0.005, `${(100 * beyond).toFixed(2)} % of the pixels differ by more than 4 of 255 (worst ${worst})`);
    await globe.close();
  });
}
