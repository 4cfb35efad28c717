// Six of the contact sheets' pictures in the browser: places and heights where waves and mesh are laid out in ways of their own.

import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { assertSamePicture } from "../lib/same.mjs";

const views = JSON.parse(await readFile(new URL("../../sheets/views.json", import.meta.url)));

// Under its budget, so that the mesh at rest does not depend on how it came there.
const BISECT = "bisect,16,40000";
const SIX = [
  ["gulf_of_guinea", 2, BISECT],
  ["north_pole", 560, "grid"],
  ["antimeridian", 30_000, BISECT],
  ["cuboid_corner", 2, "grid"],
  ["cuboid_edge", 3_000_000, BISECT],
  ["south_pole", 30_000_000, BISECT],
];

export function sheetTests(site) {
  for (const [name, altitude, mesh] of SIX) {
    test(`browser and native draw the same: ${name} from ${altitude} m by mesh=${mesh}`, async (t) => {
      const { lat, lng, time } = views.places.find((place) => place.name === name);
      const { heading, tilt } = views.heights.find((height) => height.altitude_m === altitude);
      // Foam is compared at sea, by same-picture.mjs: its history takes a minute to replay.
      const link = `#view=${lat},${lng},${altitude},${heading},${tilt}&${views.sea}&foam=0&time=${time}&mesh=${mesh}`;
      await assertSamePicture(t, site, link, [320, 180]);
    });
  }
}
