// The page measures the sea as the native program does.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import { PAGE, PROGRAM } from "../lib/servers.mjs";
import { AT_SEA } from "../lib/views.mjs";

const TIME = "2026-11-20T12:00:00Z";
const SEA = "#bft=8&seed=7";
const PLACES = [[-14.25, 35.68], [-30, 20], [179.9999, -20]];

export function sampleSurfaceTests(site) {
  test("sampleSurface gives the native height and normal, and clear errors", async () => {
    const globe = await site.show(AT_SEA);
    const { found, errors } = await globe.page.evaluate(async ({ sea, places, time }) => {
      const program = await import(document.getElementById("program").href);
      const failure = (...args) => {
        try {
          return JSON.stringify(program.sampleSurface(...args));
        } catch (error) {
          return error.message;
        }
      };
      return {
        found: places.map(([lng, lat]) => program.sampleSurface(sea, lng, lat, time)),
        errors: [failure(sea, 0, 91, time), failure(sea, NaN, 0, time), failure(sea, 0, 0, "noon"), failure("#wind=fast", 0, 0, time)],
      };
    }, { sea: SEA, places: PLACES, time: TIME });

    for (const [index, [lng, lat]] of PLACES.entries()) {
      const { stdout } = await promisify(execFile)(PROGRAM, ["sample", `--at=${lat},${lng}`, "--state", SEA, "--time", TIME, "--data", join(PAGE, "data")]);
      // Of the open sea: the page's sampleSurface knows no land.
      const surface = JSON.parse(stdout).surface.open_sea;
      // The same amplitudes bit for bit; sines of the places may differ in the last digit, 1e-9 m on the earth's radius.
      assert.ok(Math.abs(found[index].height - surface.height_m) < 1e-5, `${found[index].height} against ${surface.height_m}`);
      found[index].normal.forEach((x, axis) => assert.ok(Math.abs(x - surface.normal_enu[axis]) < 1e-4));
    }
    assert.match(errors[0], /latitude/);
    assert.match(errors[1], /longitude/);
    assert.match(errors[2], /2026-11-20T12:00:00Z/);
    assert.match(errors[3], /wind/);
    assert.deepEqual(globe.errors(), []);
  });
}
