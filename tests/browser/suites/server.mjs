// What a server of the page must do: send parts of archives, and say whether a file has changed.

import assert from "node:assert/strict";
import { test } from "node:test";

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
}
