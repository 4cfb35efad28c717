// What a server of the page must do: send parts of archives that any reader opens, and say whether a file has changed.

import assert from "node:assert/strict";
import { test } from "node:test";
import { VectorTile } from "@mapbox/vector-tile";
import { PbfReader } from "pbf";
import { PMTiles } from "pmtiles";

/** What maps say of places half a kilometre or more from a shore: latitude, longitude, and what they lie in. */
const PLACES = [
  ["Manhattan", 40.75, -73.985, "land"],
  ["the bay of New York", 40.62, -74.05, "sea"],
  ["the Giudecca's lagoon", 45.4, 12.3, "sea"],
  ["Tahiti", -17.62, -149.45, "land"],
  ["the sea off Tahiti", -17.45, -149.45, "sea"],
  ["Lake Geneva", 46.45, 6.55, "lake"],
  ["Lausanne", 46.53, 6.64, "land"],
  ["Manitoulin in Lake Huron", 45.75, -82.2, "island"],
  ["Lake Manitou on that island", 45.78, -82.0, "pond"],
  ["the Bosphorus's Asian side", 41.03, 29.07, "land"],
  ["the Black Sea off it", 41.4, 29.2, "sea"],
  ["the Dutch polders", 52.53, 5.6, "land"],
];
/** Layers of the archive, outermost first. */
const NESTED = ["land", "lake", "island", "pond"];

/** Whether a place in a tile lies within a layer's polygons, by the rule of even and odd. */
function isWithin(layer, [x, y]) {
  let within = false;
  for (let i = 0; i < (layer?.length ?? 0); i++) {
    for (const ring of layer.feature(i).loadGeometry()) {
      for (let k = 1; k < ring.length; k++) {
        const [a, b] = [ring[k - 1], ring[k]];
        if (a.y > y !== b.y > y && x < a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y)) within = !within;
      }
    }
  }
  return within;
}

export function serverTests(site) {
  test("the server sends parts of files, and says whether a file has changed", async () => {
    const part = await fetch(new URL("data/terrain.pmtiles", site.server.address), { headers: { Range: "bytes=0-6" } });
    assert.equal(part.status, 206);
    assert.match(part.headers.get("Content-Range"), /^bytes 0-6\/\d+$/);
    assert.equal(await part.text(), "PMTiles");

    const page = await fetch(site.server.address);
    assert.match(page.headers.get("Content-Type"), /^text\/html/);
    assert.equal(page.headers.get("Cache-Control"), "no-cache");
    const again = await fetch(site.server.address, { headers: { "If-None-Match": page.headers.get("ETag") } });
    assert.equal(again.status, 304);
  });

  test("common readers of PMTiles and of vector tiles find land, lakes and islands in the archive of coasts", async (t) => {
    const archive = new PMTiles(new URL("data/water.pmtiles", site.server.address).href);
    const { maxZoom: z } = await archive.getHeader();
    const layers = (await archive.getMetadata()).vector_layers.map(({ id }) => id);
    assert.deepEqual(layers.slice(0, 4), NESTED);
    let rivers = 0;
    for (const [name, lat, lon, wanted] of PLACES) {
      const phi = (lat * Math.PI) / 180;
      const at = [lon / 360 + 0.5, 0.5 - Math.asinh(Math.tan(phi)) / (2 * Math.PI)].map((part) => part * 2 ** z);
      const [x, y] = at.map(Math.floor);
      const { data } = await archive.getZxy(z, x, y);
      const tile = new VectorTile(new PbfReader(new Uint8Array(data)));
      for (const layer of Object.keys(tile.layers)) assert.ok(layers.includes(layer), layer);
      for (const layer of ["river", "tributary"]) rivers += tile.layers[layer]?.feature(0).loadGeometry().length ?? 0;
      const found = NESTED.findLast((layer) => {
        const { extent } = tile.layers[layer] ?? { extent: 0 };
        return isWithin(tile.layers[layer], [(at[0] - x) * extent, (at[1] - y) * extent]);
      });
      assert.equal(found ?? "sea", wanted, name);
    }
    t.diagnostic(`${PLACES.length} places, ${rivers} pieces of rivers`);
    assert.ok(rivers > 0);
  });
}
