// The page measures ground and sea as the native program does.

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

/** Surf at Zandvoort, the harbour of Marseille's lee, the Caspian, the Alps. */
const BY_LAND = [[4.5223, 52.372], [5.3, 43.28], [51, 42], [7.66, 45.98]];

async function native(lng, lat) {
  const { stdout } = await promisify(execFile)(PROGRAM, ["sample", `--at=${lat},${lng}`, "--state", SEA, "--time", TIME, "--data", join(PAGE, "data")]);
  return JSON.parse(stdout);
}

/** Numbers are equal but for last digits, as sines may differ in them: 1e-9 m on the earth's radius. All else is the same. */
function assertSame(found, expected, name) {
  if (typeof expected === "number") assert.ok(Math.abs(found - expected) < 1e-5, `${name}: ${found} against ${expected}`);
  else if (expected === null || typeof expected !== "object") assert.equal(found, expected, name);
  else {
    assert.deepEqual(Object.keys(found).sort(), Object.keys(expected).sort(), name);
    for (const key of Object.keys(expected)) assertSame(found[key], expected[key], `${name}.${key}`);
  }
}

export function sampleSurfaceTests(site) {
  test("measure and sampleSurface give what the native sample does, by shores, on lakes and on land, and clear errors", async () => {
    const globe = await site.show(AT_SEA);
    const { found, surfaces, errors } = await globe.page.evaluate(async ({ sea, places, time }) => {
      const { measure, sampleSurface } = await import(document.getElementById("program").href);
      const failure = (asked, ...args) => asked(...args).then(JSON.stringify, (error) => error.message);
      // All at once: none may hold up another.
      const found = await Promise.all(places.map(([lng, lat]) => measure("data/", sea, lng, lat, time)));
      const surfaces = await Promise.all(places.map(([lng, lat]) => sampleSurface("data/", sea, lng, lat, time)));
      const errors = [];
      for (const args of [["data/", sea, 0, 91, time], ["data/", "#wind=fast", 0, 0, time], ["nowhere/", sea, 0, 0, time]]) {
        errors.push(await failure(measure, ...args), await failure(sampleSurface, ...args));
      }
      return { found, surfaces, errors };
    }, { sea: SEA, places: BY_LAND, time: TIME });

    const classes = ["ocean", "ocean", "lake", "land"];
    for (const [index, [lng, lat]] of BY_LAND.entries()) {
      assert.equal(found[index].class, classes[index]);
      assertSame(found[index], await native(lng, lat), `${lat},${lng}`);
      // On the beach, in a lee and on a lake `sampleSurface` tells the same, and nothing on land.
      const { surface } = found[index];
      assert.deepEqual(surfaces[index], surface && { height: surface.height_m, normal: surface.normal_enu });
    }
    assert.deepEqual(surfaces.map((surface) => surface === null), [false, false, false, true]);
    // The beach has waves of its own.
    assert.notEqual(found[0].surface.height_m, found[0].surface.open_sea.height_m);
    for (const [index, why] of [/latitude/, /wind/, /nowhere.*404/].entries()) {
      // Each of the two asks on its own: which of the world's archives is missed first is chance.
      const [measuring, sampling] = errors.slice(2 * index, 2 * index + 2).map((error) => error.replaceAll(/\w+\.pmtiles/g, "an archive"));
      assert.match(measuring, why);
      assert.equal(sampling, measuring);
    }
  });

  test("sampleOpenSea gives the native height and normal, and clear errors", async () => {
    const globe = await site.show(AT_SEA);
    const { found, errors } = await globe.page.evaluate(async ({ sea, places, time }) => {
      const program = await import(document.getElementById("program").href);
      const failure = (...args) => {
        try {
          return JSON.stringify(program.sampleOpenSea(...args));
        } catch (error) {
          return error.message;
        }
      };
      return {
        found: places.map(([lng, lat]) => program.sampleOpenSea(sea, lng, lat, time)),
        errors: [failure(sea, 0, 91, time), failure(sea, NaN, 0, time), failure(sea, 0, 0, "noon"), failure("#wind=fast", 0, 0, time)],
      };
    }, { sea: SEA, places: PLACES, time: TIME });

    for (const [index, [lng, lat]] of PLACES.entries()) {
      const surface = (await native(lng, lat)).surface.open_sea;
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
