// The browser's picture is the native one: the same core, the same sea, for the same link.

import assert from "node:assert/strict";
import { test } from "node:test";
import { shares } from "../lib/picture.mjs";
import { assertSamePicture } from "../lib/same.mjs";
import { AT_SEA, AT_THE_SURFACE, COAST, FROM_ORBIT, IN_THE_WATER, OVER_A_LAKE, OVER_CLOUDS, UNDER_CLOUDS } from "../lib/views.mjs";

export function samePictureTests(site) {
  // SwiftShader takes a minute for the foam's past on waves of the usual quality; smaller ones run the same kernels.
  // Nor do its rasterisers agree on the narrow triangles of caustics.
  const usual = (link) => (site.browserName === "chromium" ? `${link}&quality=low` : link);
  for (const [name, fragment] of Object.entries({ FROM_ORBIT, COAST, AT_SEA: usual(AT_SEA) })) {
    test(`browser and native draw the same: ${name}`, async (t) => {
      const native = await assertSamePicture(t, site, fragment);
      assert.ok(shares(native).dark < 0.9, "the picture is empty");
    });
  }
  for (const [name, fragment] of Object.entries({ UNDER_CLOUDS, OVER_CLOUDS, IN_THE_WATER: usual(IN_THE_WATER), AT_THE_SURFACE: usual(AT_THE_SURFACE), OVER_A_LAKE: usual(OVER_A_LAKE) })) {
    test(`browser and native draw the same: ${name}`, async (t) => {
      await assertSamePicture(t, site, fragment, [320, 180]);
    });
  }
}
